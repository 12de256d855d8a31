#pragma once
#include <QObject>
#include <new>

#include "pipeline/core/result.h"

namespace app {

// Says that work beside the window was given up for lack of memory: what it was for shows what it had. Of a frame the
// document says so itself.
class MemoryNotice : public QObject {
    Q_OBJECT
public:
    static MemoryNotice& instance();  // in the window's thread

signals:
    void gaveUp();
};

// What work() gives, a Result, or an error that says that there is not enough memory for it.
template <class Work>
auto withinMemory(Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return pipeline::Error{{}, "not enough memory; a smaller picture and fewer buffers need less"};
    }
}

}  // namespace app
