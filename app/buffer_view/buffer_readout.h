#pragma once
#include <glm/glm.hpp>

#include "app/buffer_view/buffer_feature.h"

namespace app {

class BufferCompare;

// Picking and hovering: the marks of both pixels, and the value at one of them in words.
class PixelReadout : public BufferFeature {
public:
    PixelReadout(BufferView& view, const BufferCompare& compare);

    QString at(QPoint pixel) const;  // "x 3 y 4 → 0.5"; empty outside the picture

    void show() override;
    void place(CanvasRoom& room) override;

private:
    void hover(std::optional<QPoint> pixel);
    void nudge(QPoint by);
    QRect pixelOnCanvas() const;
    // The pixel of the label: the hovered one, else the algorithm's, else the picked one.
    std::optional<QPoint> saidPixel() const;
    // The texel of the shadow buffer on show that holds a pixel's point.
    std::optional<QPoint> texelOf(std::optional<glm::ivec2> pixel) const;

    const BufferCompare& m_compare;
    QLabel* m_label;
    std::optional<QPoint> m_localHover;  // of a picture that is not the document's
};

}  // namespace app
