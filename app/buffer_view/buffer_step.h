#pragma once
#include <QPolygonF>
#include <QSize>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "app/buffer_view/buffer_feature.h"

class QPushButton;

namespace app {

class Stepper;

// Whether the algorithm is shown line by line, so that its pixel, polygon or vertex is marked; and the pixel.
bool isAtLine(const Stepper& stepper);
std::optional<glm::ivec2> stepPixel(const Stepper& stepper);

// Marks the pixel, polygon or vertex that the algorithm is at, and keeps it in the middle, so large that the numbers in
// the pixels can be read; what only has names is shown whole. A view that somebody moves stays until Follow is pressed.
class StepMark : public BufferFeature {
public:
    explicit StepMark(BufferView& view);

    void show() override;
    void place(CanvasRoom& room) override;
    void write(lessons::BufferShown& state) const override;
    pipeline::Errors read(const lessons::BufferShown& state) override;

private:
    class Layer;
    void follow();
    void paint(class QPainter& painter) const;

    Layer* m_layer;  // over the canvas
    QPushButton* m_button;
    QSize m_size;  // of the canvas, when the step was last put into its middle
    std::optional<QPoint> m_pixel;
    std::vector<QPolygonF> m_outlines;  // a single corner is a vertex
    bool m_isStepping = false, m_follows = true, m_moves = false;
};

}  // namespace app
