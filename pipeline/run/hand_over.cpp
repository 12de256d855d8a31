#include "pipeline/run/hand_over.h"

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace pipeline {

void HandOver::give() {
#ifdef __SANITIZE_THREAD__
    __tsan_release(this);
#endif
}

void HandOver::take() {
#ifdef __SANITIZE_THREAD__
    __tsan_acquire(this);
#endif
}

}  // namespace pipeline
