#pragma once
#include <QRectF>
#include <vector>

#include "app/drawing3d/drawing.h"

namespace app {

// A label's place on the screen, logical pixels.
struct PlacedLabel {
    Label label;
    glm::dvec2 at{0.0};    // middle of the text
    glm::dvec2 mark{0.0};  // what it belongs to: its point, or of a caption what stands in for it at the border
    bool atBorder = false;
    QSizeF size{};          // of the text
    std::size_t place = 0;  // which of the places that a label of its kind may take
    bool led = false;       // away from its mark, so that a line leads there
};

// Every label stands beside what it belongs to, where it covers no other one, no mark and least of what is drawn: arrows,
// arcs and rays before faces. Captions of marks outside the view stand at its border. A vector or an axis that leads out
// of the view has its letter where it leaves it; one that the view does not show has none. All of them stand inside the
// view, and beside what is `taken`.
// `before`: where they stood a moment ago, in a view that moves; a place that is nearly as good as another one is kept.
std::vector<PlacedLabel> placeLabels(const Drawing& drawing, const ViewFrame& view,
                                     const std::vector<QRectF>& taken = {},
                                     const std::vector<PlacedLabel>& before = {});
// The space that a label takes.
QRectF boxOf(const PlacedLabel& placed);
glm::dvec2 nearest(const QRectF& box, glm::dvec2 point);  // of its points

}  // namespace app
