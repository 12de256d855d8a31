#pragma once
#include <array>
#include <cmath>
#include <numbers>

#include "pipeline/scene/hold/hold.h"
#include "pipeline/scene/view.h"

// Each kind of hold is a row, in a file with its like; hold.cpp has the table of them. Only these files include this one.
// Places are pixels of the picture, values are always finite.

namespace pipeline {

// A hand's drag; of a number in shares of its track.
struct Drag {
    glm::dvec2 place;     // of the hold when the drag began
    glm::dvec2 from, to;  // of the pointer
    bool isCoarse = false;
    glm::dvec2 moved() const { return to - from; }
    glm::dvec2 target() const { return place + moved(); }
};

// The functions of hold.h, as a kind has them; dragged is valuesAt where the hold has a place.
struct HoldKindRow {
    std::string_view name;
    std::optional<HoldPlace> (*place)(const Scene& scene, const Hold& hold);
    Assignments (*dragged)(const Scene& start, const Hold& hold, const Drag& drag);
    Assignments (*nudged)(const Scene& scene, const Hold& hold, glm::ivec2 by, bool coarse);
    std::string (*words)(const Scene& scene, const Hold& hold);  // with ASCII minus signs
    bool movesObject = false;
    bool hasEnds = false;
};
extern const HoldKindRow kLampAtInfinity, kLampFoot, kLampTop;  // hold_lamp.cpp
extern const HoldKindRow kEye, kTurn, kAlong;                   // hold_turn.cpp
extern const HoldKindRow kVertex;                               // hold_vertex.cpp
extern const HoldKindRow kRim;                                  // hold_rim.cpp
extern const HoldKindRow kNumber;                               // hold_number.cpp

inline constexpr double kDegrees = 180 / std::numbers::pi;

double powerBelow(double unit);               // the largest power of ten that is at most `unit`
double roundedTo(double value, double step);  // to the nearest multiple of `step`, a power of ten
double valueOf(const Scene& scene, const std::string& key);
std::string valueText(const Scene& scene, const Hold& hold, std::size_t key);  // to 1e-6
// 1 to the right and upwards, -1 to the left and downwards.
int onward(glm::ivec2 by);

Vec3d middleOf(const Scene& scene, std::size_t object);  // of its vertices, world space
// How far the vertices of an object, or of all, reach around a point, in the picture; within limits that a hand can use.
double radiusAround(const Scene& scene, const View& view, Vec3d point, std::optional<std::size_t> only = {});
double reachOf(const Scene& scene);  // twice the diagonal of the box around all vertices and the origin
std::optional<HoldPlace> placeInPicture(const Scene& scene, const Vec3d& world);

// "n = 0.05" where the hold has a symbol, else "2 pieces".
std::string numberWords(const Scene& scene, const Hold& hold);
// Rounded: on a logarithmic track to two digits, on a linear one to a power of ten of at most a hundredth of it; coarse: to
// one digit, to a tenth. Whole where the setting is.
double numberNear(const Scene& scene, const Hold& hold, double value, bool coarse);

}  // namespace pipeline
