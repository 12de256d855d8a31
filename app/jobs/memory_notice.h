#pragma once
#include <QObject>
#include <new>

#include "pipeline/core/result.h"

namespace app {

// Reports that background work was dropped for lack of memory; its view keeps the old picture. The document itself
// reports this for frames.
class MemoryNotice : public QObject {
    Q_OBJECT
public:
    static MemoryNotice& instance() {  // in the window's thread
        static MemoryNotice notice;
        return notice;
    }

signals:
    void gaveUp();
};

// The result of work(), or an error that says that there is not enough memory for it.
template <class Work>
auto withinMemory(Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return pipeline::Error{{}, "not enough memory; a smaller picture and fewer buffers need less"};
    }
}

}  // namespace app
