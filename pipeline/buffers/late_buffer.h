#pragma once
#include <functional>
#include <memory>
#include <mutex>

#include "pipeline/buffers/buffer2d.h"

namespace pipeline {

// A buffer whose rows are made when somebody first reads them, where they stand in another form until then; any thread
// may be the first. A copy has rows of its own.
template <class T>
class LateBuffer2D {
public:
    LateBuffer2D() = default;
    LateBuffer2D(Buffer2D<T> rows) : m_rows(std::move(rows)) {}
    explicit LateBuffer2D(std::function<Buffer2D<T>()> make) : m_making(std::make_unique<Making>()) {
        m_making->make = std::move(make);
    }
    LateBuffer2D(const LateBuffer2D& other) : m_rows(*other) {}
    LateBuffer2D(LateBuffer2D&&) noexcept = default;
    LateBuffer2D& operator=(LateBuffer2D other) noexcept {
        m_rows = std::move(other.m_rows), m_making = std::move(other.m_making);
        return *this;
    }
    ~LateBuffer2D() = default;

    const Buffer2D<T>& operator*() const {
        // Where there is no memory for the rows the next reader tries again.
        if (m_making) std::call_once(m_making->once, [this] { m_rows = m_making->make(), m_making->make = {}; });
        return m_rows;
    }
    const Buffer2D<T>* operator->() const { return &**this; }
    // To write into; before anybody else reads.
    Buffer2D<T>& operator*() { return const_cast<Buffer2D<T>&>(*std::as_const(*this)); }
    Buffer2D<T>* operator->() { return &**this; }

private:
    struct Making {
        std::once_flag once;
        std::function<Buffer2D<T>()> make;
    };
    mutable Buffer2D<T> m_rows;
    std::unique_ptr<Making> m_making;  // null where the rows have been there from the start
};

}  // namespace pipeline
