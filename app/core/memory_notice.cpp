#include "app/core/memory_notice.h"

namespace app {

MemoryNotice& MemoryNotice::instance() {
    static MemoryNotice notice;
    return notice;
}

}  // namespace app
