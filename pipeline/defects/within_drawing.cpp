// Defects within stages 1 and 5.
#include <cmath>
#include <limits>

#include "pipeline/core/numerics.h"
#include "pipeline/defects/defect_ways.h"
#include "pipeline/defects/hooks.h"
#include "pipeline/defects/own_hooks.h"
#include "pipeline/scene/object_matrix.h"
#include "pipeline/stages/z_buffer.h"

namespace pipeline {
namespace {

// Rows right, up and towards the viewer: OpenGL's eye space; or away.
glm::dmat3 eyeFromWorld(const View& view, bool away = false) {
    return glm::transpose(glm::dmat3(view.right, view.up, away ? view.forward : -view.forward));
}

// P of OpenGL's model, whose inverse transpose some take normals through.
glm::dmat4 projectionOf(const View& view) {
    const double n = view.near, f = view.far;
    glm::dmat4 p(0);
    p[0][0] = view.scale.x / view.centre.x, p[1][1] = view.scale.y / view.centre.y;
    p[2][2] = (f + n) / (n - f), p[3][2] = 2 * f * n / (n - f), p[2][3] = -1;
    return p;
}

glm::dmat3 throughClipSpace(const View& view, const ObjectMatrix& matrix) {
    const glm::dmat3 eye = eyeFromWorld(view), linear = eye * matrix.linear;
    glm::dmat4 modelView(linear);
    modelView[3] = glm::dvec4(eye * (matrix.translation - view.eye), 1);
    return glm::dmat3(glm::transpose(glm::inverse(projectionOf(view) * modelView)));
}

// Of matrix that is none, nothing: then the right one stays.
bool isFinite(const glm::dmat3& m) {
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(m[i].x) || !std::isfinite(m[i].y) || !std::isfinite(m[i].z)) return false;
    return true;
}

}  // namespace

void spoilNormalMatrix(const Planted& planted, const View& view, const ObjectMatrix& matrix, glm::dmat3& normalMatrix) {
    glm::dmat3 wrong = normalMatrix;
    if (planted.defect == Defect::NormalSpace) wrong = eyeFromWorld(view, planted.way > 0) * normalMatrix;
    if (planted.defect == Defect::ClipNormals) wrong = throughClipSpace(view, matrix);
    if (planted.defect == Defect::NormalMatrix && planted.way >= kUntouched)
        wrong = glm::dmat3(1);
    else if (planted.defect == Defect::NormalMatrix)
        wrong = planted.way % 3 == 0   ? matrix.linear
                : planted.way % 3 == 1 ? glm::inverse(matrix.linear)
                                       : glm::transpose(matrix.linear);
    if (isFinite(wrong)) normalMatrix = wrong;
}

template <class Real>
void spoilCleared(ZBufferOutput<Real>& out) {
    if (!out.depth.empty()) return;  // with other formats whatever is first there wins
    if (out.planted.defect == Defect::ZClear) out.zView = Buffer2D<Real>(out.zView->size, Real(out.planted.value));
    if (out.planted.defect == Defect::ZFlip) out.zView = Buffer2D<Real>(out.zView->size, Real(0));
}

template <class Real>
void spoilTest(const DepthCode& code, const RasterTriangle<Real>& triangle, const std::array<std::int64_t, 3>& e,
               ZBufferOutput<Real>& out, std::size_t at, Fragment<Real>& fragment, double& depth, bool& won) {
    if (out.planted.own) return ownTest(code, triangle, e, out, at, fragment, depth, won);
    const bool linear = code.format == DepthFormat::Linear;
    const bool first = out.triangle->pixels[at] == kNoTriangle;
    const auto isNearer = [&](bool flipped) {
        if (linear) return flipped ? fragment.z > out.zView->pixels[at] : fragment.z < out.zView->pixels[at];
        const double stored = out.depth.pixels[at];
        return first || (flipped ? code.nearer(stored, depth) : code.nearer(depth, stored));
    };
    if (out.planted.defect == Defect::ZFlip) won = isNearer(true);
    if (out.planted.defect == Defect::ZNoWrite && out.planted.way > 0) won = true;  // painted without a test
    if (out.planted.defect != Defect::ZAffine || !code.perspective) return;
    // z_view itself, linear in the picture; or the mean of the vertices.
    const Vec3<Real> l = out.planted.way > 0 ? Vec3<Real>(Real(1) / 3)
                                             : Vec3<Real>(Real(e[0]), Real(e[1]), Real(e[2])) * triangle.inverseArea2;
    fragment.z = l.x / triangle.w[0] + l.y / triangle.w[1] + l.z / triangle.w[2];
    fragment.inverseZ = 1 / fragment.z;
    const AtLeastDouble<Real> z(fragment.z);
    depth = code.encode(z, 1 / z);
    won = isNearer(false);
}

template <class Real>
void spoilWritten(const DepthCode& code, ZBufferOutput<Real>& out, std::size_t at) {
    if (out.planted.defect != Defect::ZNoWrite || out.planted.way > 0) return;
    out.zView->pixels[at] = std::numeric_limits<Real>::infinity();
    if (!out.depth.empty()) out.depth.pixels[at] = DepthCode::cleared(code.format);
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                           \
    template void spoilCleared(ZBufferOutput<Real>&);                                                          \
    template void spoilTest(const DepthCode&, const RasterTriangle<Real>&, const std::array<std::int64_t, 3>&, \
                            ZBufferOutput<Real>&, std::size_t, Fragment<Real>&, double&, bool&);               \
    template void spoilWritten(const DepthCode&, ZBufferOutput<Real>&, std::size_t);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
