#include "pipeline/plan/own_normals.h"

#include <algorithm>
#include <cmath>

#include "pipeline/core/numerics.h"
#include "pipeline/illumination/illumination.h"
#include "pipeline/stages/transform.h"

namespace pipeline {
namespace {

// No direction comes close to vanishing under a matrix, and none overflows. With N scaled so that its largest entry is
// about 1, its smallest singular value is above |det N| / |N|², for the product of the other two is below |N|² / 2.
// 2^-30 of it is far above the rounding of N n, and no square of 2^-100 · 2^-30 · 2^-100 underflows, so that any form of
// n / |n| gives a direction.
bool keepsEveryDirection(const glm::dmat3& n) {
    double largest = 0, squares = 0;
    for (int c = 0; c < 3; ++c) {
        if (!std::isfinite(n[c].x + n[c].y + n[c].z)) return false;
        largest = std::max(largest, largestComponent(n[c]));
    }
    if (!(largest > 0x1p-100 && largest < 0x1p100)) return false;
    const glm::dmat3 scaled = n / largest;
    for (int c = 0; c < 3; ++c) squares += glm::dot(scaled[c], scaled[c]);
    return std::abs(glm::determinant(scaled)) > 0x1p-30 * squares;
}

}  // namespace

std::vector<bool> objectsOfOwnNormals(const Scene& scene) {
    if (scene.settings.normalWeight != NormalWeight::Given) return {};
    std::vector<bool> own;
    for (const Object& object : scene.objects)
        own.push_back(
            object.mesh->facts.ownNormals &&
            keepsEveryDirection(normalMatrix(makeObjectMatrix(object.transform), scene.settings.forms.normalMatrix)));
    return own;
}

namespace {
bool givesNormals(const Object& object) { return !object.mesh->normals.empty(); }
}  // namespace

bool allLitByFirstVertex(const Scene& scene) {
    return lightsFirstVertex(scene.settings) && std::ranges::all_of(scene.objects, givesNormals);
}
bool anyLitByFirstVertex(const Scene& scene) {
    return lightsFirstVertex(scene.settings) && std::ranges::any_of(scene.objects, givesNormals);
}

}  // namespace pipeline
