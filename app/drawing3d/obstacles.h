#pragma once
#include <QRectF>
#include <optional>
#include <vector>

#include "app/drawing3d/drawing.h"
#include "app/drawing3d/view_content.h"
#include "app/drawing3d/view_options.h"

namespace app {

// What a content shows beside the lines of its drawing.
std::vector<Obstacle> obstaclesOf(const ViewContent& content, const ViewOptions& options, const ViewFrame& view);

// The same as it appears: a convex polygon, logical pixels. Nothing where less than a line of it lies before the observer.
struct Outline {
    std::vector<glm::dvec2> corners;
    QRectF bounds;
};
std::optional<Outline> outlineOf(const Obstacle& obstacle, const ViewFrame& view);
// The part of a line from a to b that the view shows, on the screen; nothing where it shows none of it.
struct SeenLine {
    glm::dvec2 a{0.0}, b{0.0};
    bool isWhole = true;  // up to b
};
std::optional<SeenLine> seenPart(Vec3d a, Vec3d b, const ViewFrame& view);
Outline lineOutline(glm::dvec2 a, glm::dvec2 b, double width);
// How much of a box it covers, square pixels.
double covered(const Outline& outline, const QRectF& box);

}  // namespace app
