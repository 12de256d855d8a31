#include "pipeline/stages/normals.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "pipeline/core/numerics.h"
#include "pipeline/stages/area_vector.h"

namespace pipeline {

namespace {

// NormalsOutput::areaScale of an object. All areas of one that is scaled are less than smallestArea.
template <class Real>
int areaScale(const TransformOutput<Real>& in, std::size_t object) {
    const std::size_t first = in.topology->firstVertex[object], end = in.topology->firstVertex[object + 1];
    Real largest = 0;
    for (std::size_t i = first; i < end; ++i)
        largest = std::max(largest, largestComponent(in.world[i] - in.world[first]));
    if (!(largest > 0) || largest >= ldexp(Real(1), std::numeric_limits<Real>::min_exponent / 4 - 3)) return 0;
    int exponent;
    frexp(largest, &exponent);
    return exponent;
}

}  // namespace

template <class Real>
NormalsOutput<Real> prepareNormals(const NormalsInputs& inputs, const TransformOutput<Real>& in) {
    NormalsOutput<Real> out;
    if (inputs.polygonNormals) out.polygon.resize(in.topology->polygonCount());
    if (inputs.vertexNormals) {
        if (inputs.asGiven) {
            const std::shared_ptr<const Mesh>& mesh = in.topology->meshes[0];
            out.vertex.give(mesh, mesh->normals.in<Real>());
        } else {
            out.vertex.makeOwn(in.topology->vertexCount());
        }
        if (inputs.polygonNormals && inputs.weight == NormalWeight::Area) {
            out.weighted.resize(in.topology->polygonCount());
            for (std::size_t i = 0; i < in.topology->meshes.size(); ++i) out.areaScale.push_back(areaScale(in, i));
        }
    }
    return out;
}

template <class Real>
Vec3<Real> polygonNormal(const TransformOutput<Real>& in, std::size_t polygon) {
    return normalized(alongNormal(PolygonNormalForm::Newell, in, polygon));
}

template <class Real>
Vec3<Real> triangleNormal(const TransformOutput<Real>& in, std::size_t triangle) {
    const Topology& topology = *in.topology;
    const auto& v = topology.triangles[triangle].vertices;
    const Vec3<Real> sum = alongNormal<Real>(PolygonNormalForm::Newell, in.world, v);
    return normalized(in.mirrored[topology.objectOfPolygon(topology.polygonOf(triangle))] ? -sum : sum);
}

template <class Real>
void polygonNormals(const NormalsInputs& inputs, const TransformOutput<Real>& in, std::size_t begin, std::size_t end,
                    NormalsOutput<Real>& out) {
    for (std::size_t polygon = begin; polygon < end; ++polygon) {
        const bool isStable = inputs.unit == UnitForm::Scaled;
        out.polygon[polygon] = normalized(
            isStable ? alongNormal(inputs.form, in, polygon) : areaVector(inputs.form, in, polygon), inputs.unit);
        if (!out.weighted.empty())
            out.weighted[polygon] =
                areaVector(inputs.form, in, polygon, out.areaScale[in.topology->objectOfPolygon(polygon)]);
    }
}

namespace {

// The angle of a polygon at its i-th corner, radians.
template <class Real>
Real cornerAngle(CornerAngleForm form, const TransformOutput<Real>& in, const Topology::Corners& corners,
                 std::size_t i) {
    const std::size_t n = corners.size();
    const Vec3<Real> here = in.world[corners[i]];
    return angleBetween(normalized(in.world[corners[(i + 1) % n]] - here),
                        normalized(in.world[corners[(i + n - 1) % n]] - here), form);
}

// What the polygon adds to the sum at its i-th corner.
template <class Real>
Vec3<Real> termAt(const NormalsInputs& inputs, const TransformOutput<Real>& in, const Topology::Corners& corners,
                  std::size_t i, Vec3<Real> normal) {
    return inputs.weight == NormalWeight::Angle ? cornerAngle(inputs.angle, in, corners, i) * normal : normal;
}

// Sums that rounding alone may have left of terms that oppose each other become 0. Each term is off by some eps of its
// length, so that a sum of at most kOpposed · eps · Σ |N_i| says nothing; lengths by their largest components, whose
// squares cannot underflow.
template <class Real>
void dropOpposed(const NormalsInputs& inputs, const TransformOutput<Real>& in, std::size_t object,
                 std::span<const Vec3<Real>> normals, std::span<Vec3<Real>> sums) {
    constexpr Real kOpposed = 4;
    const Topology& topology = *in.topology;
    const std::span<Vec3<Real>> here =
        sums.subspan(topology.firstVertex[object], topology.meshes[object]->positions.size());
    // Of unit vectors a sum that is not small is fine: the mean of fewer than a million.
    const bool areUnit = inputs.weight != NormalWeight::Area;
    if (areUnit && std::ranges::none_of(here, [](Vec3<Real> sum) { return largestComponent(sum) < Real(0.5); })) return;
    std::vector<Real> lengths(here.size(), Real(0));
    for (std::size_t p = topology.firstPolygon[object]; p < topology.firstPolygon[object + 1]; ++p) {
        const Topology::Corners corners = topology.corners(p);
        for (std::size_t i = 0; i < corners.size(); ++i)
            lengths[corners[i] - topology.firstVertex[object]] +=
                largestComponent(termAt(inputs, in, corners, i, normals[p]));
    }
    const Real bound = kOpposed * std::numeric_limits<Real>::epsilon();
    for (std::size_t i = 0; i < here.size(); ++i)
        if (largestComponent(here[i]) <= bound * lengths[i]) here[i] = Vec3<Real>(0);
}

}  // namespace

template <class Real>
void sumAroundVertices(const NormalsInputs& inputs, const TransformOutput<Real>& in, std::size_t object,
                       NormalsOutput<Real>& out) {
    const Topology& topology = *in.topology;
    const Mesh& mesh = *topology.meshes[object];
    const RawVector<Vec3<Real>>& normals = inputs.weight == NormalWeight::Area ? out.weighted : out.polygon;
    const std::span<Vec3<Real>> sums = out.vertex.own();
    std::fill_n(sums.begin() + topology.firstVertex[object], mesh.positions.size(), Vec3<Real>(0));
    for (std::size_t p = 0, count = mesh.polygonCount(); p < count; ++p) {
        const Topology::Corners corners{mesh.polygon(p), topology.firstVertex[object]};
        const Vec3<Real> normal = normals[topology.firstPolygon[object] + p];
        for (std::size_t i = 0; i < corners.size(); ++i) sums[corners[i]] += termAt(inputs, in, corners, i, normal);
    }
    dropOpposed<Real>(inputs, in, object, normals, sums);
}

template <class Real>
void unitVertexNormals(const NormalsInputs& inputs, const TransformOutput<Real>& in, std::size_t object,
                       std::size_t begin, std::size_t end, NormalsOutput<Real>& out) {
    const VertexVectors& given = in.topology->meshes[object]->normals;
    const bool asGiven = inputs.weight == NormalWeight::Given && !given.empty();
    const auto unit = [&](Vec3d normal) {
        const bool stays = inputs.unit == UnitForm::Scaled && offUnit(normal) <= kOffUnit<Real>;
        return Vec3<Real>(stays ? normal : normalized(normal, inputs.unit));
    };
    const std::span<Vec3<Real>> normals = out.vertex.own().subspan(in.topology->firstVertex[object]);
    for (std::size_t i = begin; i < end; ++i) {
        Vec3<Real>& normal = normals[i];
        const Vec3<Real> own = asGiven ? unit(in.normalMatrix[object] * given[i]) : Vec3<Real>(0);
        normal = own != Vec3<Real>(0) ? own : normalized(normal, inputs.unit);
    }
}

template <class Real>
void replaceVanishing(const TransformOutput<Real>& in, std::size_t object, NormalsOutput<Real>& out) {
    const Topology& topology = *in.topology;
    const std::span<Vec3<Real>> normals = out.vertex.own();
    const auto vanishes = [&](std::size_t vertex) { return normals[vertex] == Vec3<Real>(0); };
    std::size_t vertex = topology.firstVertex[object];
    while (vertex < topology.firstVertex[object + 1] && !vanishes(vertex)) ++vertex;
    if (vertex == topology.firstVertex[object + 1]) return;
    for (std::size_t polygon = topology.firstPolygon[object]; polygon < topology.firstPolygon[object + 1]; ++polygon) {
        const Topology::Corners corners = topology.corners(polygon);
        const Vec3<Real> normal = out.polygon[polygon];
        for (std::size_t i = 0; i < corners.size() && normal != Vec3<Real>(0); ++i)
            if (vanishes(corners[i])) normals[corners[i]] = normal, ++out.vanishing;
    }
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                              \
    template NormalsOutput<Real> prepareNormals(const NormalsInputs&, const TransformOutput<Real>&);              \
    template Vec3<Real> polygonNormal(const TransformOutput<Real>&, std::size_t);                                 \
    template Vec3<Real> triangleNormal(const TransformOutput<Real>&, std::size_t);                                \
    template void polygonNormals(const NormalsInputs&, const TransformOutput<Real>&, std::size_t, std::size_t,    \
                                 NormalsOutput<Real>&);                                                           \
    template void sumAroundVertices(const NormalsInputs&, const TransformOutput<Real>&, std::size_t,              \
                                    NormalsOutput<Real>&);                                                        \
    template void unitVertexNormals(const NormalsInputs&, const TransformOutput<Real>&, std::size_t, std::size_t, \
                                    std::size_t, NormalsOutput<Real>&);                                           \
    template void replaceVanishing(const TransformOutput<Real>&, std::size_t, NormalsOutput<Real>&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
