#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pipeline/inspect/pixel_report.h"
#include "pipeline/run/frame_data.h"

namespace pipeline {

// What lecture 1's shadow z-buffer does at a fragment that is nearer than all before it: transform
// it to each light's space, compare z' with Z'[x'][y'], and leave only the ambient term of a light
// that is in the way of something. One line a casting light, in its own words of numbers; none in
// OpenGL's model. The frame must have shaded: it does once for each pixel what the lecture's loop
// does for every fragment that wins.
template <class Real>
std::vector<std::string> shadowEvents(const FrameData<Real>& data, std::uint32_t triangle, glm::ivec2 pixel);

// What is said of a light that adds nothing, for which nobody looks.
inline constexpr const char* kNotLookedFor = "not looked for: the light adds nothing";

// Where a surface is in a light: "turned away" where N·L is above 0 in none of its evaluations, else as shadowPlace says.
std::string placeInLight(const std::vector<Evaluation>& evaluations, const Light& light, std::size_t k, double factor);

// The two depths that say whether a point of a triangle is lit, in the same numbers: "z' 2.000000 > Z'[12][44] 0.000000 +
// 0.02". Nothing where it faces away, where a light has no shadow buffer, and where S is a mean of several answers.
template <class Real>
std::optional<std::string> shadowComparison(const FrameData<Real>& data, std::size_t light, std::uint32_t triangle,
                                            Vec3<Real> position);

// The numbers of the same.
struct ShadowDepths {
    double z, stored, bias;  // in shadow where z > stored + bias; stored: +infinity where nothing is
    glm::ivec2 texel;
    bool shadowed;
};
template <class Real>
std::optional<ShadowDepths> shadowDepths(const FrameData<Real>& data, std::size_t light, std::uint32_t triangle,
                                         Vec3<Real> position);

}  // namespace pipeline
