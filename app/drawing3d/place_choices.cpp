#include "app/drawing3d/place_choices.h"

#include <cmath>
#include <numbers>

namespace app {

namespace {

// Pixels of the design.
constexpr double kBesideLine = 7, kBeside = 14, kAbove = 20;

glm::dvec2 unit(glm::dvec2 v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec2(0, -1);
}

// How far a text reaches from its middle in a direction.
double reach(const PlacedLabel& label, glm::dvec2 direction) {
    return std::abs(direction.x) * label.size.width() / 2 + std::abs(direction.y) * label.size.height() / 2;
}

// Beyond the tip, then around it, then farther away.
std::vector<Place> tipPlaces(const PlacedLabel& label, const Target& target, double scale) {
    constexpr int kDirections = 12;
    const glm::dvec2 along = unit(target.tip - target.foot), across{-along.y, along.x};
    std::vector<Place> places;
    for (const double away : {9, 17, 27, 40, 56})
        for (int i = 0; i < kDirections; ++i) {
            const int turn = (i + 1) / 2 * (i % 2 ? 1 : -1);  // 0, 1, −1, 2, −2 …
            const double angle = 2 * std::numbers::pi * turn / kDirections;
            const glm::dvec2 out = std::cos(angle) * along + std::sin(angle) * across;
            places.push_back({target.tip + (away * scale + reach(label, out)) * out, 10.0 * std::abs(turn)});
        }
    return places;
}

// On both sides of what leads out of the view, first above it.
std::vector<Place> exitPlaces(const PlacedLabel& label, const Target& target, double scale) {
    const glm::dvec2 along = unit(target.tip - target.foot);
    const glm::dvec2 above = along.x < 0 ? glm::dvec2(-along.y, along.x) : glm::dvec2(along.y, -along.x);
    const double aside = kBesideLine * scale + reach(label, above);
    std::vector<Place> places;
    for (const double back : {14, 30, 50, 75, 105})
        for (const double side : {1.0, -1.0})
            places.push_back(
                {target.tip + side * aside * above - back * scale * along, back - 14 + (side < 0 ? 5 : 0)});
    return places;
}

// Around a mark: above it and below it, then at its sides, inwards rather than outwards, then farther away.
std::vector<Place> captionPlaces(const PlacedLabel& caption, const ViewFrame& view) {
    const double s = view.scale, line = caption.size.height(), half = caption.size.width() / 2;
    const double inwards = caption.mark.x > view.size.x / 2 ? -1 : 1;
    const double outside = caption.mark.x > view.size.x / 2 ? view.size.x - caption.mark.x : caption.mark.x;
    const bool fitsOutwards = outside > 2 * half + (kBeside + 8) * s;
    std::vector<Place> places;
    const auto add = [&](double x, double y, double cost) {
        places.push_back({caption.mark + glm::dvec2(x, y), cost});
    };
    for (const double lines : {0, 1, 2, 3, 5})
        for (const double sign : {-1, 1})
            for (const double aside : {0, -1, 1})
                add(aside * (half - 8 * s), sign * (kAbove * s + lines * line),
                    (sign < 0 ? 0 : 5) + 20 * std::abs(aside) + (caption.atBorder ? 30 : 0));
    for (const double side : {-1, 1})
        for (const double away : {0, 40, 80})
            for (const double lines : {0, -1, 1, -2, 2, -3, 3, -4, 4, -6, 6, -8, 8})
                add(side * (half + (kBeside + away) * s), lines * line,
                    (side == inwards ? 10 : 15) + (side == inwards || fitsOutwards || !caption.atBorder ? 0 : 1e4));
    return places;
}

// Up or down by lines and farther away, on its own side of the corner or on the other one.
std::vector<Place> planePlaces(const PlacedLabel& plane, double scale) {
    std::vector<Place> places;
    for (const double side : {1, -1})
        for (const double away : {0, 50, 100, 150})
            for (const int lines : {0, -1, 1, -2, 2, -3, 3, -5, 5, -7, 7}) {
                const glm::dvec2 own = plane.at - plane.mark;
                const double x = own.x + std::copysign(away * scale, own.x);
                places.push_back(
                    {plane.mark + glm::dvec2(side * x, own.y + lines * plane.size.height()), side < 0 ? 60.0 : 0});
            }
    return places;
}

// At the middle of its arc, then farther away on all sides.
std::vector<Place> anglePlaces(const PlacedLabel& angle, double scale) {
    constexpr int kDirections = 16, kStep = 10, kFarthest = 140;
    std::vector<Place> places{{angle.mark}};
    for (int away = kStep; away <= kFarthest; away += kStep)
        for (int i = 0; i < kDirections; ++i) {
            const double a = 2 * std::numbers::pi * i / kDirections;
            places.push_back({angle.mark + away * scale * glm::dvec2(std::cos(a), std::sin(a)), 2.0 * away});
        }
    return places;
}

}  // namespace

std::vector<Place> placesOf(const PlacedLabel& label, const Target& target, const ViewFrame& view) {
    switch (label.label.kind) {
        case Label::Kind::Letter:
        case Label::Kind::Axis: return (target.isTip ? tipPlaces : exitPlaces)(label, target, view.scale);
        case Label::Kind::Plane: return planePlaces(label, view.scale);
        case Label::Kind::Angle: return anglePlaces(label, view.scale);
        case Label::Kind::Caption: return captionPlaces(label, view);
        case Label::Kind::Note: break;
    }
    return {{label.mark}};
}

}  // namespace app
