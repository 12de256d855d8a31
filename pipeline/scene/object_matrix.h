#pragma once
#include "pipeline/core/forms.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// world = linear · object + translation: upright, scale, rotation about x, y, z, translation.
struct ObjectMatrix {
    glm::dmat3 linear{1.0};
    Vec3d translation{0.0};
    bool mirrors = false;  // the determinant is negative: windings turn round
};
ObjectMatrix makeObjectMatrix(const ObjectTransform& transform);
Vec3d toWorld(const ObjectMatrix& matrix, Vec3d position);

// Takes a normal of the object to the same side of the surface in world space, at some length: the
// matrix of cofactors, |M| times the inverse transpose, without its division; or with it, not finite
// where the object is flattened to a plane.
glm::dmat3 normalMatrix(const ObjectMatrix& matrix, NormalMatrixForm form = NormalMatrixForm::Cofactors);

}  // namespace pipeline
