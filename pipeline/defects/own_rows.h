#pragma once
#include <cmath>

#include "pipeline/defects/own.h"

// The rows of the table of contracts. Only own.cpp puts them together.
namespace pipeline {

std::span<const OwnContract> ownOfGeometry();  // Place to NormalColor
std::span<const OwnContract> ownOfDrawing();   // ToLight to DepthCode
std::span<const OwnContract> ownOfShading();   // LightVector to BlendLayers

namespace own {

using A = const OwnArguments&;
using R = OwnValue;
using enum OwnKind;

inline Vec3d unit(Vec3d v) { return v / std::sqrt(glm::dot(v, v)); }
inline Vec3d mirrored(Vec3d n, Vec3d l) { return 2 * glm::dot(n, l) * n - l; }

}  // namespace own
}  // namespace pipeline
