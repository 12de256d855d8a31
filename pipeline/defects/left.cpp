// Defects that rewrite what a stage has left.
#include <cmath>

#include "pipeline/core/angles.h"
#include "pipeline/core/numerics.h"
#include "pipeline/defects/defect_ways.h"
#include "pipeline/defects/hooks.h"
#include "pipeline/defects/own_hooks.h"
#include "pipeline/stages/cull.h"
#include "pipeline/stages/normals.h"

namespace pipeline {
namespace {

// Which of near and far a polygon that stage 2 has tested reaches beyond.
struct Reaching {
    bool near = false, far = false;
};
template <class Real>
Reaching reachOf(const TransformOutput<Real>& in, const Topology::Corners& corners) {
    Reaching beyond;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double z = double(in.viewSpace(corners[i]).z);
        beyond.near = beyond.near || z < in.view.near;
        beyond.far = beyond.far || z > in.view.far;
    }
    return beyond;
}

// The way that everything is taken to be looked at: the camera's, or away from a light.
Vec3d axisOf(const Planted& planted, const View& view) {
    if (planted.way != kAlongTheLight) return view.forward;
    const double across = cosDegrees(planted.second);
    return -Vec3d(across * cosDegrees(planted.value), across * sinDegrees(planted.value), sinDegrees(planted.second));
}

// Whether a polygon faces along an axis, whatever the line of sight to it.
template <class Real>
bool facesAlong(Vec3d axis, const TransformOutput<Real>& in, std::size_t polygon) {
    const Topology::Corners corners = in.topology->corners(polygon);
    const Vec3<Real> first = in.world[corners[0]];
    Vec3<Real> sum(0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += glm::cross(in.world[corners[i - 1]] - first, in.world[corners[i]] - first);
    const bool along = glm::dot(sum, Vec3<Real>(axis)) > 0;
    return along != (in.mirrored[in.topology->objectOfPolygon(polygon)] != 0);
}

}  // namespace

template <class Real>
void spoilVerdicts(const CullInputs& inputs, const TransformOutput<Real>& in, std::size_t polygons, Culled& out) {
    const Own* const own = inputs.planted.own;
    const Vec3d axis = axisOf(inputs.planted, in.view);
    for (std::size_t polygon = 0; polygon < polygons; ++polygon) {
        Verdict& verdict = out.verdicts[polygon];
        if (!goesOn(verdict) && verdict != Verdict::BackFacing) continue;
        const Reaching beyond = reachOf(in, in.topology->corners(polygon));
        if (inputs.planted.defect == Defect::NearDrop) {
            if (verdict == Verdict::Clipped && beyond.near) verdict = Verdict::OutsideNear;
            continue;
        }
        std::uint8_t& marks = out.marks[polygon];
        const bool isBack = own ? ownIsBack(*own, in, polygon, out.isBack(polygon))
                            : inputs.planted.defect == Defect::CullSign ? !out.isBack(polygon)
                                                                        : facesAlong(axis, in, polygon);
        if (own && isBack == out.isBack(polygon)) continue;
        marks = std::uint8_t(isBack ? marks | CullMark::kBack : marks & ~CullMark::kBack);
        if (isBack && inputs.mode == CullMode::Back)
            verdict = Verdict::BackFacing;
        else
            verdict = beyond.near || beyond.far ? Verdict::Clipped : Verdict::Kept;
    }
}

template <class Real>
void spoilPolygonNormals(const Planted& planted, const TransformOutput<Real>& in, std::size_t polygons,
                         NormalsOutput<Real>& out) {
    if (planted.own) return ownPolygonNormals(*planted.own, in, polygons, out);
    if (planted.defect == Defect::NormalShort) return;  // those of vertices alone
    const View& view = in.view;
    const auto inView = [&](Vec3<Real> n) {
        const Real along = glm::dot(Vec3<Real>(view.forward), n);
        return Vec3<Real>(glm::dot(Vec3<Real>(view.right), n), glm::dot(Vec3<Real>(view.up), n),
                          planted.way > 0 ? along : -along);
    };
    // As the file's vertices have it.
    const auto ofTheFile = [&](Vec3<Real> n, std::size_t polygon) {
        const std::size_t object = in.topology->objectOfPolygon(polygon);
        const Mesh& mesh = *in.topology->meshes[object];
        const auto corners = mesh.polygon(polygon - in.topology->firstPolygon[object]);
        Vec3d sum(0);
        for (std::size_t i = 2; i < corners.size(); ++i)
            sum += glm::cross(mesh.positions[corners[i - 1]] - mesh.positions[corners[0]],
                              mesh.positions[corners[i]] - mesh.positions[corners[0]]);
        const Vec3d there = normalized(sum);
        return std::isfinite(glm::dot(there, there)) ? Vec3<Real>(there) : n;
    };
    // The normal of a polygon in its own space is along Mᵀ N; the wrong matrix, which stage 1 has left, takes it back.
    const auto throughMatrix = [&](Vec3<Real> n, std::size_t polygon) {
        if (planted.way == kUntouched) return ofTheFile(n, polygon);
        const glm::dmat3& wrong = in.normalMatrix[in.topology->objectOfPolygon(polygon)];
        const glm::dmat3 linear = planted.way % 3 == 0   ? wrong
                                  : planted.way % 3 == 1 ? glm::inverse(wrong)
                                                         : glm::transpose(wrong);
        const Vec3d there = normalized(wrong * normalized(glm::transpose(linear) * Vec3d(n)));
        return std::isfinite(glm::dot(there, there)) ? Vec3<Real>(there) : n;
    };
    const auto spoil = [&](Vec3<Real>& normal, std::size_t polygon) {
        const Vec3<Real> wrong = planted.defect == Defect::NormalFlip     ? -normal
                                 : planted.defect == Defect::NormalMatrix ? throughMatrix(normal, polygon)
                                                                          : inView(normal);
        normal = wrong + Vec3<Real>(0);  // never -0, which a buffer would show
    };
    for (std::size_t polygon = 0; polygon < polygons; ++polygon) {
        spoil(out.polygon[polygon], polygon);
        if (!out.weighted.empty()) spoil(out.weighted[polygon], polygon);
    }
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                    \
    template void spoilVerdicts(const CullInputs&, const TransformOutput<Real>&, std::size_t, Culled&); \
    template void spoilPolygonNormals(const Planted&, const TransformOutput<Real>&, std::size_t, NormalsOutput<Real>&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
