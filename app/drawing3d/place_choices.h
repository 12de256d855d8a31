#pragma once
#include <vector>

#include "app/drawing3d/label_places.h"

namespace app {

// A place that a label may take, and what it costs where nothing is in its way, in square pixels of the design.
struct Place {
    glm::dvec2 at{0.0};  // middle of the text, logical pixels; it may lie outside of the view
    double cost = 0;
};

// What belongs to a label before it has its place.
struct Target {
    glm::dvec2 foot{0.0}, tip{0.0};  // of the part of a vector or an axis that the view shows
    bool isTip = true;               // false: it goes on beyond the view
};

// The places of each kind of label, the best first. `scale`: of all marks, as in ViewFrame.
std::vector<Place> placesOf(const PlacedLabel& label, const Target& target, const ViewFrame& view);

}  // namespace app
