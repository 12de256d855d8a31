#pragma once
#include "app/buffer_view/buffer_feature.h"

namespace app {

class PinnedPixels;
class PixelReadout;

// Shows the document's pinned pixels and their values in this buffer.
class PinMarks : public BufferFeature {
public:
    PinMarks(BufferView& view, const PixelReadout& readout);

    bool press(const QKeyEvent& key) override;
    void show() override;
    void place(CanvasRoom& room) override;

private:
    void toggle();
    void goTo(int number);
    void copy() const;

    PinnedPixels& m_pins;
    const PixelReadout& m_readout;
    QLabel* m_label;
};

}  // namespace app
