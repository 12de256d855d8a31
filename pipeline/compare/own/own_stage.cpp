#include "pipeline/compare/own/own_stage.h"

#include <algorithm>
#include <cmath>

#include "pipeline/run/frame_data.h"
#include "pipeline/run/runner.h"

namespace pipeline::foreign {

namespace {

constexpr double kLargest = 1e9;  // world units and pixels: beyond it a stage's numbers mean nothing

bool isSafe(const Values& values, std::size_t i) {
    if (!values.there[i]) return false;
    for (int c = 0; c < values.channels; ++c)
        if (!std::isfinite(values.at(i)[c]) || std::abs(values.at(i)[c]) > kLargest) return false;
    return true;
}

Vec3d vectorAt(const Values& values, std::size_t i) { return {values.at(i)[0], values.at(i)[1], values.at(i)[2]}; }

// Their vertices in world space, from the first of the three buffers that was handed in; or, as what is drawn depends on
// their places in the picture, from those, at the depths that the others have.
class OwnVertices {
public:
    OwnVertices(const Conventions& conventions, const Reference& reference, bool drawn)
        : m_view(reference.context.view), m_world(reference.values.at("vertices.world")) {
        const auto take = [&](const char* name, auto place) {
            const Values* const theirs = handedValues(conventions, name);
            const bool isScreen = std::string_view(name) == "vertices.screen";
            if (!theirs || (!from.empty() && !(drawn && isScreen))) return;
            if (drawn && isScreen) from.clear();
            from.emplace_back(name);
            const Values right = m_world;
            for (std::size_t i = 0; i < m_world.count(); ++i) {
                if (!isSafe(*theirs, i)) continue;
                const Vec3d p = place(vectorAt(*theirs, i), vectorAt(right, i));
                for (int c = 0; c < 3; ++c) m_world.at(i)[c] = p[c];
            }
        };
        take("vertices.world", [](Vec3d p, Vec3d) { return p; });
        take("vertices.view", [&](Vec3d p, Vec3d) { return fromView(m_view, p); });
        take("vertices.screen", [&](Vec3d p, Vec3d was) {
            const glm::dvec2 at = glm::dvec2(p.x, p.y) + reference.context.sampleShift;
            return worldPoint(m_view, at, toView<double>(m_view, was).z);  // at the depth of the reference
        });
    }
    std::vector<std::string> from;
    Vec3d operator[](std::size_t i) const { return vectorAt(m_world, i); }

private:
    const View& m_view;
    Values m_world;
};

// The scene with their vertices, verdicts and normals in the place of what the stages before leave.
class TheirScene {
public:
    TheirScene(const Conventions& conventions, const Reference& reference)
        : m_reference(reference),
          m_vertices(conventions, reference, false),
          m_drawn(conventions, reference, true),
          m_verdicts(handedValues(conventions, "polygons.verdict")),
          m_normals(handedValues(conventions, "vertices.normal")) {
        if (!m_verdicts) m_verdicts = handedValues(conventions, "polygons.visible");
    }
    const OwnVertices& vertices() const { return m_vertices; }
    const OwnVertices& drawnVertices() const { return m_drawn; }
    bool hasVerdicts() const { return m_verdicts != nullptr; }
    bool hasNormals() const { return m_normals != nullptr; }

    // dropped: whether polygons that they have dropped are left away; else all are kept, so that polygons keep their
    // numbers.
    std::shared_ptr<const Scene> scene(bool drops) {
        Scene out = m_reference.frame->scene();
        const auto& data = *dataOf<double>(*m_reference.frame);
        const Values& verdicts = m_verdicts ? *m_verdicts : m_reference.values.at("polygons.verdict");
        std::size_t firstVertex = 0, firstPolygon = 0;
        m_polygons.clear();
        for (std::size_t o = 0; o < out.objects.size(); ++o) {
            const Mesh& mesh = *out.objects[o].mesh;
            const bool mirrored = data.transform->mirrored[o] != 0;
            Mesh theirs;
            theirs.colors = mesh.colors;
            for (std::size_t v = 0; v < mesh.positions.size(); ++v)
                theirs.positions.push_back((drops ? m_drawn : m_vertices)[firstVertex + v]);
            const Values& normals = m_normals ? *m_normals : m_reference.values.at("vertices.normal");
            for (std::size_t v = 0; v < mesh.positions.size() && normals.count() > 0; ++v) {
                const std::size_t at = firstVertex + v;
                theirs.normals.push_back(
                    vectorAt(isSafe(normals, at) ? normals : m_reference.values.at("vertices.normal"), at));
            }
            for (std::size_t p = 0; p < mesh.polygonCount(); ++p) {
                if (drops && verdicts.at(firstPolygon + p)[0] == 0) continue;
                std::vector<std::uint32_t> corners(mesh.polygon(p).begin(), mesh.polygon(p).end());
                if (mirrored) std::ranges::reverse(corners);
                theirs.addPolygon(corners);
                m_polygons.push_back(int(firstPolygon + p));
            }
            firstVertex += mesh.positions.size(), firstPolygon += mesh.polygonCount();
            out.objects[o].mesh = makeMesh(std::move(theirs));
            out.objects[o].transform = {};
        }
        if (drops) out.settings.cull = CullMode::None;
        out.settings.normalWeight = NormalWeight::Given;
        return std::make_shared<const Scene>(std::move(out));
    }
    // Polygons of that scene as the reference counts them.
    int polygon(int own) const { return own < 0 ? own : m_polygons[std::size_t(own)]; }

private:
    const Reference& m_reference;
    OwnVertices m_vertices, m_drawn;
    const Values* m_verdicts;
    const Values* m_normals;
    std::vector<int> m_polygons;
};

// What culling says of their vertices: the sign of the area in the picture.
Values ownVerdicts(const Conventions& conventions, const Reference& reference, const OwnVertices& vertices) {
    Values out = reference.values.at("polygons.verdict");
    const auto& data = *dataOf<double>(*reference.frame);
    if (data.keys.cull.mode == CullMode::None) return out;
    const Values* const screen = handedValues(conventions, "vertices.screen");
    const View& view = reference.context.view;
    const Topology& topology = *data.transform->topology;
    for (std::size_t p = 0; p < out.count(); ++p) {
        double area = 0;
        bool placed = true;
        std::vector<glm::dvec2> corners;
        const auto polygon = topology.corners(p);
        for (std::size_t n = 0; n < polygon.size(); ++n) {
            const std::size_t vertex = polygon[n];
            if (screen) {
                placed = placed && isSafe(*screen, vertex);
                corners.push_back({screen->at(vertex)[0], screen->at(vertex)[1]});
                continue;
            }
            const Vec3d at = toView<double>(view, vertices[vertex]);
            placed = placed && (!view.perspective || at.z >= view.near);
            const double z = view.perspective ? at.z : 1;
            corners.push_back({view.centre.x + view.scale.x * at.x / z, view.centre.y - view.scale.y * at.y / z});
        }
        if (!placed) continue;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
            area += (b.x - a.x) * (a.y + b.y) / 2;  // rows run down
        }
        if (data.transform->mirrored[topology.objectOfPolygon(std::uint32_t(p))]) area = -area;
        if (std::abs(area) > 0.01) out.at(p)[0] = area > 0 ? 1 : 0;
    }
    return out;
}

// z_view, ids and overdraw of a frame of their scene, ids as the reference counts.
std::optional<Values> ownPicture(const Frame& frame, const BufferName& name, const TheirScene& theirs) {
    auto values = valuesIn(frame, name);
    if (values && name.id == BufferId::PolygonId)
        for (double& id : values->numbers) id = theirs.polygon(int(id));
    return values;
}

// Per pixel whether another polygon is seen there than should be, by the files of the z-buffer: materials and shadows are
// those of the reference, so that nothing can be made of their normals and depths.
std::vector<std::uint8_t> otherPolygons(const std::vector<Finding>& findings) {
    std::vector<std::uint8_t> out;
    for (const Finding& finding : findings) {
        if (finding.stage != StageId::ZBuffer || !finding.isPicture()) continue;
        if (finding.name.buffer.id == BufferId::Overdraw) continue;
        out.resize(finding.classes.size());
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = out[i] || isBad(finding.classes[i]);
    }
    return out;
}

}  // namespace

const Values* handedValues(const Conventions& conventions, const std::string& name) {
    for (const ReadFile& file : conventions.files)
        if (file.file->name.buffer.text() == name) return &file.mine;
    return nullptr;
}

std::vector<std::optional<OwnResult>> compareOwn(const Conventions& conventions, const std::vector<Finding>& findings,
                                                 const Reference& reference, const Stop& stop) {
    std::vector<std::optional<OwnResult>> out(findings.size());
    TheirScene theirs(conventions, reference);
    const OwnVertices& vertices = theirs.vertices();
    FramePtr drawn, lit;  // of their scene, made when they are first asked for
    BufferSet wanted = setOf({BufferId::PolygonId});
    for (const Finding& finding : findings)
        if (!finding.agrees) wanted.set(index(finding.name.buffer.id));
    const auto frame = [&](FramePtr& kept, bool drops) {
        if (!kept) {
            kept = runFrame(theirs.scene(drops), {wanted, StageId::Shading, 0, stop}, nullptr);
        }
        return kept;
    };
    for (std::size_t i = 0; i < findings.size() && !stop.stop_requested(); ++i) {
        if (findings[i].agrees) continue;
        const BufferName& name = findings[i].name.buffer;
        std::vector<std::string> from;
        std::optional<Values> right;
        using enum BufferId;
        const Values* const world = handedValues(conventions, "vertices.world");
        const Values* const view = handedValues(conventions, "vertices.view");
        if (name.id == VerticesView && world) {
            right = reference.values.at(name.text()), from = {"vertices.world"};
            for (std::size_t v = 0; v < right->count(); ++v) {
                if (!isSafe(*world, v)) continue;
                const Vec3d p = toView<double>(reference.context.view, vectorAt(*world, v));
                for (int c = 0; c < 3; ++c) right->at(v)[c] = p[c];
            }
        } else if (name.id == VerticesScreen && (view || world)) {
            right = reference.values.at(name.text()), from = {view ? "vertices.view" : "vertices.world"};
            const View& camera = reference.context.view;
            for (std::size_t v = 0; v < right->count(); ++v) {
                if (!isSafe(view ? *view : *world, v)) continue;
                const Vec3d p = view ? vectorAt(*view, v) : toView<double>(camera, vectorAt(*world, v));
                right->there[v] = p.z >= camera.near;
                const double z = camera.perspective ? p.z : 1;
                const glm::dvec2 centre = camera.centre - reference.context.sampleShift;
                right->at(v)[0] = centre.x + camera.scale.x * p.x / z;
                right->at(v)[1] = centre.y - camera.scale.y * p.y / z;
            }
        } else if (name.id == PolygonsVerdict && !vertices.from.empty()) {
            right = ownVerdicts(conventions, reference, vertices), from = vertices.from;
            if (handedValues(conventions, "vertices.screen")) from = {"vertices.screen"};
        } else if (name.id == PolygonsNormal && (world || view)) {
            if (const FramePtr made = frame(lit, false)) right = valuesIn(*made, name), from = vertices.from;
        } else if (findings[i].stage == StageId::ZBuffer && (!vertices.from.empty() || theirs.hasVerdicts())) {
            if (const FramePtr made = frame(drawn, true)) right = ownPicture(*made, name, theirs);
            from = theirs.drawnVertices().from;
            if (theirs.hasVerdicts()) from.emplace_back("polygons.verdict");
        } else if (name.id == Normal && theirs.hasNormals()) {
            if (const FramePtr made = frame(drawn, true)) right = valuesIn(*made, name);
            from = {"vertices.normal"};
            if (theirs.hasVerdicts()) from.emplace_back("polygons.verdict");
        } else if (findings[i].stage == StageId::Shading) {
            right = reference.values.at(name.text());
            from = ownShading(conventions, reference, name, *right);
            if (from.empty() && (theirs.hasNormals() || theirs.hasVerdicts())) {
                if (const FramePtr made = frame(drawn, true)) right = valuesIn(*made, name);
                if (theirs.hasNormals()) from.emplace_back("vertices.normal");
                if (theirs.hasVerdicts()) from.emplace_back("polygons.verdict");
            }
        }
        if (!right || from.empty() || !right->isSameSize(reference.values.at(name.text()))) continue;
        const auto file = std::ranges::find_if(conventions.files,
                                               [&](const ReadFile& f) { return f.file->name == findings[i].name; });
        out[i] = OwnResult{std::move(from), compareValues(*file, *right, reference)};
        if (findings[i].stage == StageId::Shading && findings[i].isPicture())
            leaveOut(otherPolygons(findings), out[i]->finding);
    }
    return out;
}

}  // namespace pipeline::foreign
