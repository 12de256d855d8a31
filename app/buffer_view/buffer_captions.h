#pragma once
#include "app/buffer_view/buffer_feature.h"

namespace app {

class BufferCompare;

// The texts over the picture of a buffer view: notices, and the buffer's name if the view has no header.
class BufferCaptions : public BufferFeature {
public:
    BufferCaptions(BufferView& view, const BufferCompare& compare);

    void setTitle(const QString& name);
    void setBare(bool bare) { m_bare = bare; }
    bool isBare() const { return m_bare; }
    QLabel& notices() { return *m_notice; }

    void show() override;
    void place(CanvasRoom& room) override;

private:
    const BufferCompare& m_compare;  // whose pictures have names of their own
    QLabel *m_notice, *m_title;
    bool m_bare = false;
};

}  // namespace app
