#pragma once
#include <cmath>
#include <optional>
#include <vector>

#include "pipeline/defects/hooks.h"
#include "pipeline/defects/own.h"

// What the hooks make of a student's function: they gather its arguments, call it, and take over its result. Where the
// result is the right one to the last bit, nothing changes: the pipeline's own value may have been computed in another form.
namespace pipeline {

// The arguments of one call.
class OwnCall {
public:
    explicit OwnCall(const Own& own) : m_own(own) {}
    OwnCall& operator<<(double x) { return m_in.push_back(x), *this; }
    OwnCall& operator<<(glm::dvec2 p) { return *this << p.x << p.y; }
    template <class Real>
    OwnCall& operator<<(const Vec3<Real>& v) {
        return *this << double(v.x) << double(v.y) << double(v.z);
    }
    // Nothing where the result is the right one.
    std::optional<OwnValue> result(OwnPlace kind = OwnPlace::Unknown, std::size_t place = 0) const;

private:
    const Own& m_own;
    std::vector<double> m_in;
};

template <class Real>
Vec3<Real> vectorOf(const OwnValue& value) {
    return {Real(value.at[0]), Real(value.at[1]), Real(value.at[2])};
}

// z_view and weights in space for weights in the picture.
template <class Real>
void interpolateWith(const RasterTriangle<Real>& t, Vec3<Real> l, bool perspective, Fragment<Real>& fragment) {
    const Real w = l.x * t.w[0] + l.y * t.w[1] + l.z * t.w[2];
    fragment.z = perspective ? 1 / w : w;
    Vec3<Real> b(0);
    for (std::size_t i = 0; i < 3; ++i) b += (perspective ? l[int(i)] * t.w[i] * fragment.z : l[int(i)]) * t.weights[i];
    fragment.barycentric = b;
}

// Whether a polygon is a back face; isBack: as the stage has found.
template <class Real>
bool ownIsBack(const Own& own, const TransformOutput<Real>& in, std::size_t polygon, bool isBack);
template <class Real>
void ownPolygonNormals(const Own& own, const TransformOutput<Real>& in, std::size_t polygons, NormalsOutput<Real>& out);
template <class Real>
void ownTest(const DepthCode& code, const RasterTriangle<Real>& triangle, const std::array<std::int64_t, 3>& e,
             ZBufferOutput<Real>& out, std::size_t at, Fragment<Real>& fragment, double& depth, bool& won);
// Whether L has changed, and what depends on it has to follow.
template <class Real>
bool ownDirections(const Own& own, const Light& light, const Surface<Real>& at, LightSample<Real>& s);
// Whether the vector that the function returned has not length 1: the stable form of the power is of unit vectors.
template <class Real>
bool isOwnVectorOff(const Own& own, const Surface<Real>& at, const LightSample<Real>& s);
template <class Real>
void ownTerms(const Own& own, const Illumination& illumination, const Light& light, const Material& material,
              const Surface<Real>& at, LightSample<Real>& s);
template <class Real>
void ownSurface(const ShadingInputs& inputs, Surface<Real>& surface);
template <class Real>
void ownPixel(const Own& own, const ShadingSources<Real>& in, const VertexWeights<Real>& weights,
              Surface<Real>& surface);
void ownFrameBuffer(const Own& own, Vec3d intensity, double iMax, Color8& value);

}  // namespace pipeline
