#include "pipeline/run/memory.h"

#include <cstdlib>  // says whether the library is glibc

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace pipeline {

void keepFreedMemory() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the most it takes; what is larger still goes back
    mallopt(M_TRIM_THRESHOLD, 512 << 20);
    mallopt(M_TOP_PAD, 64 << 20);
    // Small pieces are joined as they are freed. A million of them, joined in one go by whoever asks for a large piece
    // next, hold up every thread that shares their arena for some tenths of a second.
    mallopt(M_MXFAST, 0);
#endif
}

}  // namespace pipeline
