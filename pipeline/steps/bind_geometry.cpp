// The values of a step of the transform, cull, normals and shadow buffer stages.
#include <algorithm>

#include "pipeline/stages/area_vector.h"
#include "pipeline/stages/shadow_buffer.h"
#include "pipeline/steps/bindings.h"

namespace pipeline {
namespace {

Vec3d valueAt(const Frame& frame, BufferId id, std::size_t row) {
    const auto buffer = frame.buffer({id});
    if (!buffer) return Vec3d(0);
    return {buffer->value(0, row, 0), buffer->value(0, row, 1), buffer->value(0, row, 2)};
}

std::string anglesOf(const ObjectTransform& transform) {
    if (transform.turns.empty())
        return fmt::format("{}°, {}°, {}°", shortest(transform.rotation.x), shortest(transform.rotation.y),
                           shortest(transform.rotation.z));
    std::string words;
    for (const auto& turn : transform.turns)
        words += fmt::format("{}{}° about ({}, {}, {})", words.empty() ? "" : ", then ", shortest(turn.angle),
                             shortest(turn.axis.x), shortest(turn.axis.y), shortest(turn.axis.z));
    return words;
}

template <class Real>
void bindTransform(const Frame& frame, const FrameData<Real>& data, const BoundStep& step, Bindings& out) {
    bindElement(step, "vertex", out);
    const TransformOutput<Real>& in = *data.transform;
    const std::uint32_t vertex = step.number();
    const ObjectTransform& transform = frame.scene().objects[in.topology->objectOfVertex(vertex)].transform;
    const Vec3d &scale = transform.scale, &by = transform.translation;
    out.word("sx, sy, sz", fmt::format("{}, {}, {}", shortest(scale.x), shortest(scale.y), shortest(scale.z)));
    out.word("αx, αy, αz", anglesOf(transform));
    out.vector("xw, yw, zw", Vec3d(in.world[vertex]), 4,
               fmt::format("moved by {}, {}, {}", shortest(by.x), shortest(by.y), shortest(by.z)));
    const Vec3d view(in.viewSpace(vertex)), screen = valueAt(frame, BufferId::VerticesScreen, vertex);
    out.number("xv", view.x), out.number("yv", view.y), out.number("zv", view.z);
    out.number("near", in.view.near, 4, "the near plane");
    out.number("xs", screen.x), out.number("ys", screen.y);
    out.tests["in front"] = !in.view.perspective || view.z >= in.view.near;
}

template <class Real>
void bindCull(const FrameData<Real>& data, const BoundStep& step, Bindings& out) {
    bindElement(step, "polygon", out);
    const Verdict verdict = data.cull->verdicts[step.number()];
    const auto area = signedArea(*data.transform, *data.cull, step.number());
    out.tests["inside"] = area.has_value();
    out.tests["back-facing"] = verdict == Verdict::BackFacing;
    out.tests["degenerate"] = verdict == Verdict::Degenerate;
    if (area) out.number("A", *area, 1, "px², on the screen");
    out.word("visibility", std::string(name(verdict)));
}

// So many that a product of edges shows seven digits.
int decimalsOf(Vec3d v) {
    int decimals = 6;
    for (double largest = largestComponent(v); largest >= 10 && decimals > 0; largest /= 10) --decimals;
    return std::min(decimals, 4);
}

// The sum of areaVector() as it grows: a turn for each triangle or edge of the polygon.
template <class Real>
void bindNormalSum(PolygonNormalForm form, const TransformOutput<Real>& in, const Topology::Corners& corners,
                   Bindings& out) {
    const bool isOfEdges = form == PolygonNormalForm::FromOrigin;
    const std::size_t n = corners.size();
    const auto at = [&](std::size_t i) { return in.world[corners[i % n]]; };
    Vec3<Real> sum(0);
    std::vector<Bindings>& turns = out.loops["parts"];
    for (std::size_t i = isOfEdges ? 0 : 1; i + (isOfEdges ? 0 : 1) < n; ++i) {
        const Vec3<Real> a = isOfEdges ? at(i) : at(i) - at(0), b = isOfEdges ? at(i + 1) : at(i + 1) - at(0);
        const Vec3<Real> c = glm::cross(a, b);
        sum += c;
        Bindings& turn = turns.emplace_back();
        turn.whole("i", std::int64_t(i));
        turn.vector("a", Vec3d(a)), turn.vector("b", Vec3d(b));
        turn.vector("c", Vec3d(c), decimalsOf(Vec3d(c)), isOfEdges ? "" : "twice the triangle's area along its normal");
        turn.vector("n", Vec3d(sum), decimalsOf(Vec3d(sum)));
    }
}

template <class Real>
void bindPolygonNormal(const FrameData<Real>& data, const BoundStep& step, Bindings& out) {
    bindElement(step, "polygon", out);
    const TransformOutput<Real>& in = *data.transform;
    const Topology::Corners corners = in.topology->corners(step.number());
    const PolygonNormalForm form = data.keys.normals.form;
    const Vec3d area(areaVector<Real>(form, in, step.number()));
    if (form == PolygonNormalForm::ThreeCorners) {
        const Vec3<Real> a = in.world[corners[1]] - in.world[corners[0]],
                         b = in.world[corners[2]] - in.world[corners[0]];
        out.vector("a", Vec3d(a)), out.vector("b", Vec3d(b));
        const Vec3d product(glm::cross(a, b));
        out.vector("a × b", product, decimalsOf(product));
    } else {
        bindNormalSum(form, in, corners, out);
    }
    const bool mirrored = in.mirrored[in.topology->objectOfPolygon(step.number())] != 0;
    out.number("length", glm::length(area), 4, "twice the area");
    out.vector("n", Vec3d(data.normals->polygon[step.number()]), 4,
               mirrored ? "turned round: the object is mirrored" : "");
}

template <class Real>
void bindVertexNormal(const FrameData<Real>& data, const BoundStep& step, Bindings& out) {
    bindElement(step, "vertex", out);
    const Topology& topology = *data.transform->topology;
    const std::uint32_t vertex = step.number();
    const std::size_t object = topology.objectOfVertex(vertex);
    const VertexVectors& own = topology.meshes[object]->normals;
    const Vec3d given = own.empty() ? Vec3d(0) : Vec3d(own[vertex - topology.firstVertex[object]]);
    const bool isGiven = data.keys.normals.weight == NormalWeight::Given && given != Vec3d(0);
    out.tests["given"] = isGiven, out.tests["summed"] = !isGiven;
    out.vector("normal", given, 4, own.empty() ? "the mesh has none" : "");
    out.vector("N", Vec3d(data.normals->vertex[vertex]));
    std::vector<Bindings>& around = out.loops["around"];
    if (isGiven || data.normals->polygon.empty()) return;
    for (std::uint32_t p = topology.firstPolygon[object]; p < topology.firstPolygon[object + 1]; ++p) {
        const Topology::Corners corners = topology.corners(p);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (corners[i] != vertex) continue;
            around.emplace_back().whole("polygon", p);
            around.back().vector("Ni", Vec3d(data.normals->polygon[p]), 4, fmt::format("of polygon {}", p));
        }
    }
}

template <class Real>
void bindShadowBuffer(const FrameData<Real>& data, const BoundStep& step, Bindings& out) {
    bindElement(step, "polygon", out);
    out.whole("light", step.phase->light);
    const TransformOutput<Real>& in = *data.transform;
    const View& face = data.shadowBuffer->lights[std::size_t(step.phase->light)].front().faces.front();
    const Topology::Corners corners = in.topology->corners(step.number());
    double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        // A point light sees the polygon in several of its faces; the distance is the same in all of them.
        const Vec3d p = Vec3d(in.world[corners[i]]);
        const double z = face.perspective ? glm::distance(p, face.eye) : double(toView(face, in.world[corners[i]]).z);
        nearest = std::min(nearest, z), farthest = std::max(farthest, z);
    }
    out.word("z'", fmt::format("{} to {}", depthText(nearest), depthText(farthest)),
             face.perspective ? "distance of its vertices" : "at its vertices");
}

}  // namespace

template <class Real>
void bindGeometry(const Frame& frame, const FrameData<Real>& data, StageId stage, const BoundStep& step,
                  Bindings& out) {
    const bool isVertex = step.phase->kind == ElementKind::Vertex;
    switch (stage) {
        case StageId::Transform: return bindTransform(frame, data, step, out);
        case StageId::Cull: return bindCull(data, step, out);
        case StageId::Normals: return isVertex ? bindVertexNormal(data, step, out) : bindPolygonNormal(data, step, out);
        case StageId::ShadowBuffer: return bindShadowBuffer(data, step, out);
        case StageId::ZBuffer:
        case StageId::Shading: return;
    }
}

#define SHADESCOPE_INSTANTIATE(Real) \
    template void bindGeometry(const Frame&, const FrameData<Real>&, StageId, const BoundStep&, Bindings&);
SHADESCOPE_FOR_EVERY_REAL(SHADESCOPE_INSTANTIATE)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline
