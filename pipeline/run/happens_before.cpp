#include "pipeline/run/happens_before.h"

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>

// Called by the sanitizer, which gives the name. It does not see what oneTBB does among its own threads either.
extern "C" const char* __tsan_default_suppressions() { return "called_from_lib:libtbb.so\n"; }
#endif

namespace pipeline {

void HappensBefore::give() {
#ifdef __SANITIZE_THREAD__
    __tsan_release(this);
#endif
}

void HappensBefore::take() {
#ifdef __SANITIZE_THREAD__
    __tsan_acquire(this);
#endif
}

}  // namespace pipeline
