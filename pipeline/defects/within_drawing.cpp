// Defects within stages 1 and 5.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

// The weights of the corners, those of the first two vertices exchanged. The last corner stands for a vertex that clipping
// has cut off.
template <class Real>
Vec3<Real> exchanged(const RasterTriangle<Real>& triangle, Vec3<Real> l) {
    const auto cornerOf = [&](int vertex) {
        int corner = 0;
        while (corner < 2 && triangle.weights[std::size_t(corner)][vertex] != 1) ++corner;
        return corner;
    };
    std::swap(l[cornerOf(0)], l[cornerOf(1)]);
    return l;
}

// A depth of 0 to 1, or −1 to 1, that is divided by z again, as who reads it takes it for z_view.
double dividedTwice(const DepthCode& code, double z, bool ndc) {
    const double n = code.near, f = code.far, depth = f / (f - n) * (1 - n / z);
    const double again = std::clamp(ndc ? ((2 * depth - 1) / z + 1) / 2 : depth / z, 0.0, 1.0);
    return f * n / (f - again * (f - n));
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
    const std::uint8_t way = out.planted.way;
    if (out.planted.defect != Defect::ZAffine || !(code.perspective || way == kExchangedDepths)) return;
    const Vec3<Real> l = Vec3<Real>(Real(e[0]), Real(e[1]), Real(e[2])) * triangle.inverseArea2;
    const Vec3<Real> z = Real(1) / Vec3<Real>(triangle.w[0], triangle.w[1], triangle.w[2]);
    switch (way) {
        case 0: fragment.z = glm::dot(l, z); break;  // z_view itself, linear in the picture
        case kExchangedDepths: interpolateWith(triangle, exchanged(triangle, l), code.perspective, fragment); break;
        case kDividedTwice:
        case kNdcDividedTwice:  // Linear stores what is divided by nothing
            if (!linear) fragment.z = Real(dividedTwice(code, double(fragment.z), way == kNdcDividedTwice));
            break;
        default: fragment.z = (z.x + z.y + z.z) / 3;
    }
    fragment.inverseZ = code.perspective ? 1 / fragment.z : Real(0);
    const AtLeastDouble<Real> exact(fragment.z);
    depth = code.encode(exact, 1 / exact);
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
