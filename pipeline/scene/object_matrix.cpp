#include "pipeline/scene/object_matrix.h"

#include <algorithm>
#include <cmath>

#include "pipeline/core/angles.h"
#include "pipeline/core/numerics.h"

namespace pipeline {

namespace {

// glRotate's matrix: c I + (1 - c) a aᵀ + s [a]×, with the unit axis a.
// OpenGL 2.1 specification, section 2.11.2.
glm::dmat3 aboutAxis(const AxisTurn& turn) {
    const double s = sinDegrees(turn.angle), c = cosDegrees(turn.angle);
    const Vec3d a = normalized(turn.axis);
    const glm::dmat3 cross{{0, a.z, -a.y}, {-a.z, 0, a.x}, {a.y, -a.x, 0}};  // glm takes columns
    return c * glm::dmat3(1.0) + (1 - c) * glm::outerProduct(a, a) + s * cross;
}

}  // namespace

ObjectMatrix makeObjectMatrix(const ObjectTransform& t) {
    const Vec3d sin{sinDegrees(t.rotation.x), sinDegrees(t.rotation.y), sinDegrees(t.rotation.z)};
    const Vec3d cos{cosDegrees(t.rotation.x), cosDegrees(t.rotation.y), cosDegrees(t.rotation.z)};
    // glm takes columns.
    const glm::dmat3 scale{{t.scale.x, 0, 0}, {0, t.scale.y, 0}, {0, 0, t.scale.z}};
    const glm::dmat3 aboutX{{1, 0, 0}, {0, cos.x, sin.x}, {0, -sin.x, cos.x}};
    const glm::dmat3 aboutY{{cos.y, 0, -sin.y}, {0, 1, 0}, {sin.y, 0, cos.y}};
    const glm::dmat3 aboutZ{{cos.z, sin.z, 0}, {-sin.z, cos.z, 0}, {0, 0, 1}};
    glm::dmat3 rotation = aboutZ * aboutY * aboutX;
    if (!t.turns.empty()) rotation = glm::dmat3(1.0);
    for (const AxisTurn& turn : t.turns) rotation = rotation * aboutAxis(turn);
    // The sign of the determinant from the factors: their product may underflow.
    const bool mirrors = (t.scale.x < 0) != ((t.scale.y < 0) != (t.scale.z < 0));
    const glm::dmat3 linear = rotation * scale;
    // The columns are where the mesh's axes go: upright, y goes where z went, and z where -y did.
    if (t.up == UpAxis::Y) return {{linear[0], linear[2], 0.0 - linear[1]}, t.translation, mirrors};
    return {linear, t.translation, mirrors};
}

Vec3d toWorld(const ObjectMatrix& matrix, Vec3d position) { return matrix.linear * position + matrix.translation; }

glm::dmat3 normalMatrix(const ObjectMatrix& matrix, NormalMatrixForm form) {
    if (form == NormalMatrixForm::InverseTranspose) return glm::transpose(glm::inverse(matrix.linear));
    // Scaled by a power of two first: products of two entries stay in range. To between 1 and 2, that of a rotation is the
    // rotation.
    double largest = 0;
    for (int c = 0; c < 3; ++c) largest = std::max(largest, largestComponent(matrix.linear[c]));
    int exponent = 0;
    std::frexp(largest, &exponent);
    const glm::dmat3 m = matrix.linear * std::ldexp(1.0, 1 - exponent);
    const double sign = matrix.mirrors ? -1 : 1;
    return {sign * glm::cross(m[1], m[2]), sign * glm::cross(m[2], m[0]), sign * glm::cross(m[0], m[1])};
}

}  // namespace pipeline
