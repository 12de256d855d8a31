#include "pipeline/core/memory.h"

#include <cstdlib>  // says whether the library is glibc
#include <memory>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace pipeline {

void keepFreedMemory() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the most it takes; what is larger still goes back
    mallopt(M_TRIM_THRESHOLD, 512 << 20);
    mallopt(M_TOP_PAD, 128 << 20);
    // Small pieces are joined as they are freed. A million of them, joined in one go by whoever asks for a large piece
    // next, hold up every thread that shares their arena for some tenths of a second.
    mallopt(M_MXFAST, 0);
    // One heap for all threads: what one gives back the next may take. They ask for few pieces, most of them large.
    mallopt(M_ARENA_MAX, 1);
#endif
}

void giveBackFreedMemory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

void preferLargePages([[maybe_unused]] void* piece, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
    // More than a buffer of 1920 × 1080 pixels, not all of whose tiles are written.
    constexpr std::size_t kLeast = 9'000'000;
    if (bytes < kLeast) return;
    constexpr std::size_t kPage = std::size_t(2) << 20;
    // Where it is refused, the pages are small ones.
    if (std::align(kPage, kPage, piece, bytes)) madvise(piece, bytes / kPage * kPage, MADV_HUGEPAGE);
#endif
}

}  // namespace pipeline
