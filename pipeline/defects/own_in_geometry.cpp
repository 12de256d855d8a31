// A student's functions in stages 1 to 3.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "pipeline/buffers/buffer_table.h"
#include "pipeline/core/numerics.h"
#include "pipeline/defects/own_hooks.h"
#include "pipeline/stages/cull.h"
#include "pipeline/stages/normals.h"

namespace pipeline {

namespace {

thread_local std::pair<OwnPlace, std::size_t> t_place{OwnPlace::Unknown, 0};

}  // namespace

void setOwnPlace(Domain kind, std::size_t index) {
    t_place = {kind == Domain::Pixel     ? OwnPlace::Pixel
               : kind == Domain::Polygon ? OwnPlace::Polygon
                                         : OwnPlace::Vertex,
               index};
}
void forgetOwnPlace() { t_place = {OwnPlace::Unknown, 0}; }

std::optional<OwnValue> OwnCall::result(OwnPlace kind, std::size_t place) const {
    if (kind == OwnPlace::Unknown) std::tie(kind, place) = t_place;
    constexpr double kMost = 1e18;  // what no scene within its ranges comes near, and what float still squares
    const OwnContract& contract = ownContract(m_own.function);
    OwnValue out;
    m_own.call(kind, place, m_in, std::span(out.at).first(contract.size()));
    if (out.at == valueOf(contract, contract.right, m_in).at) return {};
    for (double& x : out.at) x = std::isnan(x) ? 0 : std::clamp(x, -kMost, kMost);
    return out;
}

template <class Real>
void spoilPlaces(const TransformInputs& inputs, TransformOutput<Real>& out) {
    const Own* const own = inputs.planted.own;
    if (!own || out.world.areGiven()) return;
    const View& view = out.view;
    const std::span<Vec3<Real>> world = out.world.own();
    for (std::size_t object = 0; object < inputs.transforms.size(); ++object) {
        const ObjectTransform& t = inputs.transforms[object];
        const bool isTurnedAboutZ = t.rotation.x == 0 && t.rotation.y == 0 && t.turns.empty() && t.up == UpAxis::Z;
        if (own->function == OwnFunction::Place && !isTurnedAboutZ) continue;
        const std::size_t first = out.topology->firstVertex[object];
        for (std::size_t i = first; i < out.topology->firstVertex[object + 1]; ++i) {
            OwnCall call(*own);
            const Vec3d seen = toView(view, Vec3d(world[i]));
            switch (own->function) {
                case OwnFunction::Place:
                    call << Vec3d(inputs.topology->meshes[object]->positions[i - first]) << t.scale << t.rotation.z
                         << t.translation;
                    if (const auto p = call.result(OwnPlace::Vertex, i)) world[i] = vectorOf<Real>(*p);
                    break;
                case OwnFunction::Camera:
                    call << Vec3d(world[i]) << view.pivotDepth << inputs.planted.value << inputs.planted.second;
                    if (const auto p = call.result(OwnPlace::Vertex, i))
                        world[i] = Vec3<Real>(fromView(view, vectorOf<double>(*p)));
                    break;
                case OwnFunction::Project:
                    if (!view.perspective || view.scale.x != view.scale.y) return;
                    if (!(seen.z > 0)) break;
                    call << seen << view.scale.x << double(view.size.x) << double(view.size.y);
                    if (const auto p = call.result(OwnPlace::Vertex, i))
                        world[i] = Vec3<Real>(worldPoint(view, {p->at[0], p->at[1]}, seen.z));
                    break;
                default: return;
            }
        }
    }
}

template <class Real>
bool ownIsBack(const Own& own, const TransformOutput<Real>& in, std::size_t polygon, bool isBack) {
    const Topology::Corners corners = in.topology->corners(polygon);
    const bool mirrored = in.mirrored[in.topology->objectOfPolygon(polygon)] != 0;
    OwnCall call(own);
    if (own.function == OwnFunction::FacesEye) {
        if (!in.view.perspective) return isBack;
        call << polygonNormal(in, polygon) << Vec3d(in.world[corners[0]]) << in.view.eye << in.view.forward;
    } else if (own.function == OwnFunction::IsVisible) {
        call << double(corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec3d v(in.viewSpace(corners[mirrored ? corners.size() - 1 - i : i]));
            if (v.z < in.view.near) return isBack;
            const double spread = in.view.perspective ? v.z : 1;
            call << in.view.centre + in.view.scale * glm::dvec2(v.x, -v.y) / spread;
        }
    } else {
        return isBack;
    }
    const auto visible = call.result(OwnPlace::Polygon, polygon);
    return visible ? visible->at[0] == 0 : isBack;
}

template <class Real>
void ownPolygonNormals(const Own& own, const TransformOutput<Real>& in, std::size_t polygons,
                       NormalsOutput<Real>& out) {
    const bool three = own.function == OwnFunction::CalcNormal;
    if (!three && own.function != OwnFunction::PolygonNormal) return;
    for (std::size_t polygon = 0; polygon < polygons; ++polygon) {
        if (out.polygon[polygon] == Vec3<Real>(0)) continue;  // without area
        const Topology::Corners corners = in.topology->corners(polygon);
        const bool mirrored = in.mirrored[in.topology->objectOfPolygon(polygon)] != 0;
        const std::size_t count = three ? 3 : corners.size();
        OwnCall call(own);
        if (!three) call << double(count);
        for (std::size_t i = 0; i < count; ++i) call << in.world[corners[mirrored ? count - 1 - i : i]];
        const auto normal = call.result(OwnPlace::Polygon, polygon);
        if (!normal) continue;
        out.polygon[polygon] = vectorOf<Real>(*normal);
        if (!out.weighted.empty()) {
            Vec3<Real>& weighted = out.weighted[polygon];
            weighted = Real(sqrt(glm::dot(weighted, weighted))) * out.polygon[polygon];
        }
    }
}

template <class Real>
void spoilVertexNormals(const NormalsInputs& inputs, const TransformOutput<Real>& in, std::size_t object,
                        NormalsOutput<Real>& out) {
    const Own* const own = inputs.planted.own;
    const bool isMean = inputs.planted.defect == Defect::NormalShort;  // left as it is
    if (inputs.weight != NormalWeight::Mean || !(isMean || (own && own->function == OwnFunction::VertexNormal))) return;
    if (!inputs.ownNormals.empty() && inputs.ownNormals[object]) return;
    const Topology& topology = *in.topology;
    const std::size_t first = topology.firstVertex[object], end = topology.firstVertex[object + 1];
    std::vector<std::vector<Vec3<Real>>> around(end - first);
    for (std::size_t p = topology.firstPolygon[object]; p < topology.firstPolygon[object + 1]; ++p) {
        const Topology::Corners corners = topology.corners(p);
        for (std::size_t i = 0; i < corners.size() && out.polygon[p] != Vec3<Real>(0); ++i)
            around[corners[i] - first].push_back(out.polygon[p]);
    }
    for (std::size_t i = first; i < end; ++i) {
        if (around[i - first].empty() || out.vertex[i] == around[i - first][0])
            continue;  // a vanishing sum, or one normal
        if (isMean) {
            const auto count = Real(around[i - first].size());
            out.vertex.own()[i] =
                std::accumulate(around[i - first].begin(), around[i - first].end(), Vec3<Real>(0)) / count;
            continue;
        }
        OwnCall call(*own);
        call << double(around[i - first].size());
        for (const Vec3<Real>& normal : around[i - first]) call << normal;
        if (const auto normal = call.result(OwnPlace::Vertex, i)) out.vertex.own()[i] = vectorOf<Real>(*normal);
    }
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                              \
    template void spoilPlaces(const TransformInputs&, TransformOutput<Real>&);                                    \
    template bool ownIsBack(const Own&, const TransformOutput<Real>&, std::size_t, bool);                         \
    template void ownPolygonNormals(const Own&, const TransformOutput<Real>&, std::size_t, NormalsOutput<Real>&); \
    template void spoilVertexNormals(const NormalsInputs&, const TransformOutput<Real>&, std::size_t,             \
                                     NormalsOutput<Real>&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
