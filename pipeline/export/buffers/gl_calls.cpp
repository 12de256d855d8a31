#include "pipeline/export/buffers/gl_calls.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "pipeline/run/frame_data.h"
#include "pipeline/scene/mesh/topology.h"
#include "pipeline/stages/translucent.h"

namespace pipeline {
namespace {

using Names = std::vector<std::string_view>;
using Numbers = std::vector<double>;

constexpr std::array<std::string_view, 8> kLights{"GL_LIGHT0", "GL_LIGHT1", "GL_LIGHT2", "GL_LIGHT3",
                                                  "GL_LIGHT4", "GL_LIGHT5", "GL_LIGHT6", "GL_LIGHT7"};

class Calls {
public:
    std::vector<GlCall> list;

    // The next call begins a step of that name.
    void step(std::string name) { m_step = std::move(name); }
    void add(std::string_view function, Names names, Numbers numbers = {}) {
        list.push_back({function, std::move(names), std::move(numbers), std::exchange(m_step, {})});
    }
    void vector(std::string_view function, Vec3d v) { add(function, {}, {v.x, v.y, v.z}); }
    void color(std::string_view function, Names names, Vec3d c, double alpha = 1) {
        add(function, std::move(names), {c.r, c.g, c.b, alpha});
    }
    void enable(std::string_view what, bool on) { add(on ? "glEnable" : "glDisable", {what}); }

private:
    std::string m_step;
};

void addPicture(const Settings& settings, Calls& calls) {
    calls.step("The picture, cleared");
    calls.add("glViewport", {}, {0, 0, double(settings.width), double(settings.height)});
    calls.add("glClearColor", {}, {0, 0, 0, 1});
    calls.add("glClear", {"GL_COLOR_BUFFER_BIT", "GL_DEPTH_BUFFER_BIT"});
    calls.enable("GL_DITHER", false);

    calls.step("Visibility: the z-buffer, back-face culling");
    calls.enable("GL_DEPTH_TEST", true);
    calls.add("glDepthFunc", {"GL_LESS"});
    calls.add("glDepthRange", {}, {0, 1});
    calls.enable("GL_CULL_FACE", settings.cull == CullMode::Back);
    calls.add("glCullFace", {"GL_BACK"});
}

// Screen x = 0 and width, y = height and 0 are the sides of the picture; at z_view = near in perspective.
void addCamera(const View& view, Calls& calls) {
    const double distance = view.perspective ? view.near : 1;
    const glm::dvec2 low = -view.centre / view.scale * distance;
    const glm::dvec2 high = (glm::dvec2(view.size) - view.centre) / view.scale * distance;
    calls.step("The projection: left, right, bottom, top, near, far");
    calls.add("glMatrixMode", {"GL_PROJECTION"});
    calls.add("glLoadIdentity", {});
    calls.add(view.perspective ? "glFrustum" : "glOrtho", {}, {low.x, high.x, -high.y, -low.y, view.near, view.far});

    // Columns: what the world's axes and origin are in eye space.
    const std::array<Vec3d, 3> rows{view.right, view.up, -view.forward};
    Numbers matrix;
    for (int column = 0; column < 3; ++column) {
        for (const Vec3d& row : rows) matrix.push_back(row[column]);
        matrix.push_back(0);
    }
    const Vec3d origin = toView(view, Vec3d(0));  // z away from the viewer
    for (const double coordinate : {origin.x, origin.y, -origin.z}) matrix.push_back(coordinate + 0.0);
    matrix.push_back(1);
    calls.step("The camera: x right, y up, z towards the viewer");
    calls.add("glMatrixMode", {"GL_MODELVIEW"});
    calls.add("glLoadMatrixd", {}, std::move(matrix));
}

void addLight(const Light& light, std::size_t k, Calls& calls) {
    const std::string_view name = kLights[k];
    const OpenGlLight& gl = light.gl;
    const bool point = light.kind != LightKind::AtInfinity;
    const char* kind = light.kind == LightKind::Area ? "an area light, which OpenGL knows as a point alone"
                       : point                       ? "at a point"
                                                     : "at infinity";
    calls.step(fmt::format("Light {}, {}{}", k, kind, gl.space == LightSpace::Eye ? ", in eye space" : ""));
    if (gl.space == LightSpace::Eye) {
        calls.add("glPushMatrix", {});
        calls.add("glLoadIdentity", {});
    }
    const Vec3d& p = light.position;
    calls.add("glLightfv", {name, "GL_POSITION"}, {p.x, p.y, p.z, point ? 1.0 : 0.0});
    calls.add("glLightfv", {name, "GL_SPOT_DIRECTION"}, {gl.spotDirection.x, gl.spotDirection.y, gl.spotDirection.z});
    if (gl.space == LightSpace::Eye) calls.add("glPopMatrix", {});
    calls.add("glLightf", {name, "GL_SPOT_CUTOFF"}, {gl.spotCutoff});
    calls.add("glLightf", {name, "GL_SPOT_EXPONENT"}, {gl.spotExponent});
    calls.add("glLightf", {name, "GL_CONSTANT_ATTENUATION"}, {gl.constant});
    calls.add("glLightf", {name, "GL_LINEAR_ATTENUATION"}, {gl.linear});
    calls.add("glLightf", {name, "GL_QUADRATIC_ATTENUATION"}, {gl.quadratic});
    calls.color("glLightfv", {name, "GL_AMBIENT"}, light.intensity * gl.ambient);
    calls.color("glLightfv", {name, "GL_DIFFUSE"}, light.intensity * light.color);
    calls.color("glLightfv", {name, "GL_SPECULAR"}, light.intensity * gl.specular);
    calls.enable(name, true);
}

void addLighting(const Scene& scene, Calls& calls) {
    const auto truth = [](bool on) -> std::string_view { return on ? "GL_TRUE" : "GL_FALSE"; };
    calls.step("Lighting, per vertex");
    calls.add("glShadeModel", {scene.settings.shading == Shading::Flat ? "GL_FLAT" : "GL_SMOOTH"});
    calls.enable("GL_LIGHTING", true);
    calls.enable("GL_NORMALIZE", true);
    calls.color("glLightModelfv", {"GL_LIGHT_MODEL_AMBIENT"}, scene.ambient.lightIn(scene.settings.model));
    calls.add("glLightModeli", {"GL_LIGHT_MODEL_LOCAL_VIEWER", truth(scene.settings.localViewer)});
    calls.add("glLightModeli", {"GL_LIGHT_MODEL_TWO_SIDE", truth(scene.settings.twoSided)});
    for (std::size_t k = 0; k < scene.lights.size(); ++k) addLight(scene.lights[k], k, calls);
    for (std::size_t k = scene.lights.size(); k < kLights.size(); ++k) calls.enable(kLights[k], false);
}

void addMaterial(std::string_view face, const Material& material, Calls& calls) {
    calls.color("glMaterialfv", {face, "GL_AMBIENT"}, material.ambient);
    // The alpha of a lit colour is that of the diffuse coefficient alone.
    calls.color("glMaterialfv", {face, "GL_DIFFUSE"}, material.diffuse, opacity(material));
    calls.color("glMaterialfv", {face, "GL_SPECULAR"}, material.specular);
    calls.color("glMaterialfv", {face, "GL_EMISSION"}, material.emission);
    calls.add("glMaterialf", {face, "GL_SHININESS"}, {material.exponent});
}

void addTransform(const ObjectTransform& t, Calls& calls) {
    calls.vector("glTranslated", t.translation);
    for (const AxisTurn& turn : t.turns)
        calls.add("glRotated", {}, {turn.angle, turn.axis.x, turn.axis.y, turn.axis.z});
    if (t.turns.empty()) {
        if (t.rotation.z != 0) calls.add("glRotated", {}, {t.rotation.z, 0, 0, 1});
        if (t.rotation.y != 0) calls.add("glRotated", {}, {t.rotation.y, 0, 1, 0});
        if (t.rotation.x != 0) calls.add("glRotated", {}, {t.rotation.x, 1, 0, 0});
    }
    if (t.scale != Vec3d(1)) calls.vector("glScaled", t.scale);
    if (t.up == UpAxis::Y) calls.add("glRotated", {}, {90, 1, 0, 0});
}

// Whether the pieces of a polygon are the fan from its first corner, as GL_POLYGON draws it.
bool isFan(const Mesh& mesh, std::size_t polygon) {
    const auto corners = mesh.polygon(polygon);
    const std::size_t first = mesh.firstTriangleOf(polygon);
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        const auto& v = mesh.triangles[first + i].vertices;
        if (v[0] != corners[0] || v[1] != corners[i + 1] || v[2] != corners[i + 2]) return false;
    }
    return true;
}

// An object's polygons, with normals of the frame. OpenGL brings a normal to eye space by the
// inverse transpose of the object's matrix: the transpose undoes that.
template <class Real>
class Polygons {
public:
    // flat: one normal for all corners of a polygon.
    Polygons(const FrameData<Real>& data, const Topology& topology, std::size_t object, bool flat, Calls& calls)
        : m_normals(*data.normals),
          m_mesh(*topology.meshes[object]),
          m_firstVertex(topology.firstVertex[object]),
          m_firstPolygon(topology.firstPolygon[object]),
          m_flat(flat),
          m_byFirstVertex(data.keys.shading.firstVertexNormal && !m_mesh.normals.empty()),
          m_calls(calls) {
        const ObjectMatrix matrix = makeObjectMatrix(data.keys.transform.transforms[object]);
        m_objectFromWorldNormal = glm::transpose(matrix.linear);
    }

    void add(std::size_t polygon) {
        if (isFan(m_mesh, polygon)) return addOutline("GL_POLYGON", polygon, m_mesh.polygon(polygon));
        // OpenGL leaves open what a concave GL_POLYGON is: its pieces instead.
        for (std::size_t t = m_mesh.firstTriangleOf(polygon); t < m_mesh.firstTriangleOf(polygon + 1); ++t)
            addOutline("GL_POLYGON", polygon, m_mesh.triangles[t].vertices);
    }

private:
    void addOutline(std::string_view kind, std::size_t polygon, std::span<const std::uint32_t> corners) {
        m_calls.add("glBegin", {kind});
        // A piece of a polygon need not have its first corner, whose normal lights all of it.
        if (m_flat)
            addNormal(m_byFirstVertex ? m_normals.vertex[m_firstVertex + m_mesh.polygon(polygon)[0]]
                                      : m_normals.polygon[m_firstPolygon + polygon]);
        for (const std::uint32_t corner : corners) {
            if (!m_flat) addNormal(m_normals.vertex[m_firstVertex + corner]);
            m_calls.vector("glVertex3d", m_mesh.positions[corner]);
        }
        m_calls.add("glEnd", {});
    }
    void addNormal(Vec3<Real> world) { m_calls.vector("glNormal3d", m_objectFromWorldNormal * Vec3d(world)); }

    const NormalsOutput<Real>& m_normals;
    const Mesh& m_mesh;
    std::size_t m_firstVertex, m_firstPolygon;
    bool m_flat, m_byFirstVertex;
    Calls& m_calls;
    glm::dmat3 m_objectFromWorldNormal;
};

// Polygons of object i, as numbers within it.
template <class Real>
void addObject(const Scene& scene, const FrameData<Real>& data, std::size_t i, std::span<const std::uint32_t> polygons,
               Calls& calls) {
    const Object& object = scene.objects[i];
    calls.step(fmt::format("Object {}: {}", i, object.name));
    const bool ownBack = scene.settings.twoSided && object.backMaterial;
    addMaterial(ownBack ? "GL_FRONT" : "GL_FRONT_AND_BACK", object.material, calls);
    if (ownBack) addMaterial("GL_BACK", *object.backMaterial, calls);
    // A mirror turns windings round; what was outside stays outside.
    calls.add("glFrontFace", {data.transform->mirrored[i] ? "GL_CW" : "GL_CCW"});
    calls.add("glPushMatrix", {});
    addTransform(object.transform, calls);
    Polygons<Real> drawing(data, *data.transform->topology, i, scene.settings.shading == Shading::Flat, calls);
    for (const std::uint32_t polygon : polygons) drawing.add(polygon);
    calls.add("glPopMatrix", {});
}

// Lecture 2's order: after the opaque surfaces, by the mean depth of the polygons, the farthest first.
template <class Real>
void addTranslucent(const Scene& scene, const FrameData<Real>& data, const std::vector<std::uint8_t>& drawn,
                    Calls& calls) {
    const Topology& topology = *data.transform->topology;
    std::vector<std::uint32_t> polygons;
    std::vector<double> mean(drawn.size());
    for (std::uint32_t p = 0; p < drawn.size(); ++p) {
        if (!drawn[p]) continue;
        polygons.push_back(p);
        const Topology::Corners corners = topology.corners(p);
        for (std::size_t i = 0; i < corners.size(); ++i) mean[p] += double(data.transform->viewSpace(corners[i]).z);
        mean[p] /= double(corners.size());
    }
    if (polygons.empty()) return;
    std::ranges::stable_sort(polygons, [&](std::uint32_t a, std::uint32_t b) { return mean[a] > mean[b]; });
    calls.step("Translucent surfaces, the farthest polygon first: wrong where polygons overlap in a cycle or cross");
    calls.enable("GL_BLEND", true);
    calls.add("glBlendFunc", {"GL_SRC_ALPHA", "GL_ONE_MINUS_SRC_ALPHA"});
    calls.add("glDepthMask", {"GL_FALSE"});
    for (auto first = polygons.begin(); first != polygons.end();) {
        const std::uint32_t object = topology.objectOfPolygon(*first);
        const auto last =
            std::find_if(first, polygons.end(), [&](std::uint32_t p) { return topology.objectOfPolygon(p) != object; });
        std::for_each(first, last, [&](std::uint32_t& p) { p -= topology.firstPolygon[object]; });
        addObject(scene, data, object, {first, last}, calls);
        first = last;
    }
    calls.step("Opaque again");
    calls.add("glDepthMask", {"GL_TRUE"});
    calls.enable("GL_BLEND", false);
}

template <class Real>
void addObjects(const Scene& scene, const FrameData<Real>& data, Calls& calls) {
    const Topology& topology = *data.transform->topology;
    const std::vector<std::uint8_t>& transparent = data.transform->transparent;
    const std::vector<TranslucentSides> sides = translucentSides(scene);
    const auto drawn = drawnIn(Pass::Opaque, topology, transparent, sides, data.cull.get());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        std::vector<std::uint32_t> polygons(scene.objects[i].mesh->polygonCount());
        std::iota(polygons.begin(), polygons.end(), 0u);
        if (!drawn.empty()) std::erase_if(polygons, [&](auto p) { return !drawn[topology.firstPolygon[i] + p]; });
        // What remains to be drawn of an object is nothing where all of it is translucent.
        if (drawn.empty() || !polygons.empty()) addObject<Real>(scene, data, i, polygons, calls);
    }
    if (!sides.empty())
        addTranslucent(scene, data, drawnIn(Pass::Translucent, topology, transparent, sides, data.cull.get()), calls);
}

template <class Real>
Result<std::vector<GlCall>> callsOf(const Scene& scene, const FrameData<Real>& data) {
    const bool flat = scene.settings.shading == Shading::Flat;
    const bool any = data.transform && data.transform->topology->polygonCount() > 0;
    const bool givesAll =
        flat && data.keys.shading.firstVertexNormal &&
        std::ranges::all_of(scene.objects, [](const Object& object) { return !object.mesh->normals.empty(); });
    if (!data.transform || !data.normals ||
        (any && (flat && !givesAll ? data.normals->polygon.empty() : data.normals->vertex.empty())))
        return Error{{}, fmt::format("OpenGL needs the normals, which this run did not compute"), {}};
    Calls calls;
    addPicture(scene.settings, calls);
    addCamera(data.transform->view, calls);
    addLighting(scene, calls);
    addObjects(scene, data, calls);
    return std::move(calls.list);
}

// Whether a plane surface with one normal is lit differently from place to place.
bool placeMatters(const Scene& scene) {
    return std::ranges::any_of(scene.lights, [&](const Light& light) {
        return light.kind != LightKind::AtInfinity || scene.settings.localViewer;
    });
}

bool drawsPieces(const Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.polygonCount(); ++i)
        if (!isFan(mesh, i)) return true;
    return false;
}

}  // namespace

std::string glRefuses(const Scene& scene) {
    if (!modelFacts(scene.settings.model).fixedFunctions) {
        const auto drawn = std::ranges::find_if(modelTable(), &ModelFacts::fixedFunctions)->word;
        return fmt::format("OpenGL's calls draw the illumination model {0} alone: set model to {0}", drawn);
    }
    if (scene.settings.shading == Shading::Phong)
        return "OpenGL 1.x shades flat or smooth, not per pixel: set shading to flat or gouraud";
    if (scene.settings.shading == Shading::Gouraud && scene.settings.interpolation != Interpolation::Perspective)
        return "OpenGL interpolates perspective-correct: set interpolation to perspective";
    if (scene.settings.forms != Forms())
        return "OpenGL's calls know one form of each formula: set numerics to its defaults";
    if (hasVertexColors(scene)) return "OpenGL's calls have one material an object, and no colours of vertices";
    if (scene.settings.antialiasing > 1) return "OpenGL's calls draw one sample a pixel: set antialiasing to 1";
    if (scene.settings.visibility == Visibility::None)
        return "OpenGL's calls fill polygons: set visibility to z-buffer";
    if (scene.settings.visibility == Visibility::Painter)
        return "OpenGL's calls test depths, which the painter's algorithm does not: set visibility to z-buffer";
    if (scene.lights.size() > kLights.size())
        return fmt::format("OpenGL has {} lights, the scene {}", kLights.size(), scene.lights.size());
    for (const Object& object : scene.objects)
        if (const Vec3d s = object.transform.scale; s.x == 0 || s.y == 0 || s.z == 0)
            return fmt::format("{} is scaled by 0, which leaves its normals undefined in OpenGL", object.name);
    // With flat shading a polygon is as bright as its first corner, and not each of its pieces has that.
    if (scene.settings.shading == Shading::Flat && placeMatters(scene))
        for (const Object& object : scene.objects)
            if (drawsPieces(*object.mesh))
                return fmt::format(
                    "{} has a concave polygon, each of whose pieces OpenGL shades by a corner of its own: "
                    "set shading to gouraud",
                    object.name);
    return {};
}

Result<std::vector<GlCall>> glCalls(const Frame& frame) {
    if (const std::string refused = glRefuses(frame.scene()); !refused.empty()) return Error{{}, refused, {}};
    return readStages(frame, [&](const auto& data) { return callsOf(frame.scene(), data); });
}

}  // namespace pipeline
