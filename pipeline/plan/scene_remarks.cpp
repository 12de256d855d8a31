#include "pipeline/plan/scene_remarks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <mutex>
#include <string_view>

#include <fmt/format.h>

#include "pipeline/core/angles.h"
#include "pipeline/core/numerics.h"
#include "pipeline/core/text.h"
#include "pipeline/illumination/illumination.h"
#include "pipeline/plan/black.h"
#include "pipeline/scene/alike_remarks.h"
#include "pipeline/scene/mesh/closed_mesh.h"
#include "pipeline/scene/opacity.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/stages/transform.h"

namespace pipeline {
namespace {

constexpr double kFarthest = 1e10;  // beyond what checkScene admits; false for what is not finite

// Slivers of a mesh, looked at once while it lives; of a mesh of more than 4 million polygons 0.
std::size_t sliversOf(const std::shared_ptr<const Mesh>& mesh) {
    constexpr std::size_t kMostPolygons = 4'000'000, kMostKnown = 64;
    struct Known {
        std::weak_ptr<const Mesh> mesh;
        std::size_t slivers;
    };
    static std::mutex mutex;
    static std::deque<Known> known;
    if (mesh->polygonCount() > kMostPolygons) return 0;
    {
        const std::scoped_lock lock(mutex);
        for (const Known& one : known)
            if (one.mesh.lock() == mesh) return one.slivers;
    }
    std::size_t slivers = 0;
    for (std::size_t i = 0; i < mesh->polygonCount(); ++i) slivers += isSliver(*mesh, i) ? 1 : 0;
    const std::scoped_lock lock(mutex);
    known.push_back({mesh, slivers});
    if (known.size() > kMostKnown) known.pop_front();
    return slivers;
}

class Remarks {
public:
    explicit Remarks(const Scene& scene)
        : m_scene(scene), m_isBlack(maximumIntensity(scene) <= 0 || isBlack(scene)), m_list(scene.remarks) {
        std::erase_if(m_list, [&](Remark& remark) { return isOver(remark); });
    }

    std::vector<Remark> collect() {
        if (m_scene.settings.defect != Defect::None)
            add("defect", std::string(kDefectIsPlanted) + " The picture is wrong on purpose.");
        ofCamera();
        ofChosenNearPlane();
        ofLights();
        ofShadowTexels();
        m_alike.moveTo(m_list);
        for (std::size_t i = 0; i < m_scene.objects.size(); ++i) ofObject(i);
        m_alike.moveTo(m_list);
        ofNearPlane();
        if (m_scene.objects.empty())
            add("object", "The scene has no object: every pixel is background.");
        else if (m_isBlack)
            ofBlack();
        if (m_list.size() > kMaxRemarks) {
            const std::size_t more = m_list.size() - (kMaxRemarks - 1);
            m_list.resize(kMaxRemarks - 1);
            add("", fmt::format("{} more remarks are not listed.", more));
        }
        return std::move(m_list);
    }

private:
    // Of a remark about "KEY=VALUE", which a reader has chosen: whether the setting has another value. Else it is about KEY.
    bool isOver(Remark& remark) const {
        const std::size_t sign = remark.about.find('=');
        const auto setting = findSetting(m_scene, std::string_view(remark.about).substr(0, sign));
        if (sign == remark.about.npos || !setting) return false;  // the name of an object may have the sign too
        if (remark.about.substr(sign + 1) != formatSetting(*setting, setting->get(m_scene))) return true;
        remark.about.resize(sign);
        return false;
    }
    void add(std::string about, std::string text) { m_list.push_back({std::move(about), std::move(text)}); }
    // Of one light or object among many; kind and name: as AlikeRemarks has them.
    void addOf(std::string_view kind, const std::string& name, std::string about, std::string text) {
        m_alike.add(kind, name, {std::move(about), std::move(text)});
    }

    void ofBlack() {
        const Remark why = whyBlack(m_scene);
        const bool isScaled = maximumIntensity(m_scene) > 0;
        add(why.about, fmt::format("{}o light and no material gives any intensity: the picture is black. {}",
                                   isScaled ? "N" : "I_max is 0, for n", why.text));
    }

    void ofCamera() {
        const Camera& camera = m_scene.camera;
        if (camera.kind == CameraKind::Spherical) {
            const bool alongZ = sinDegrees(camera.phi) == 0;
            if (alongZ && m_scene.settings.forms.cameraBasis == CameraBasisForm::CrossProduct)
                add("numerics.camera_basis",
                    "The camera looks along z: its axes as cross products with z vanish, and with them the picture.");
            if (camera.rho != 0) return;
            add("camera.rho", "ρ is 0: the eye stands in the world's origin. It looks where θ and φ say all the same.");
            if (camera.projection == ProjectionKind::Orthographic)
                add("camera.rho",
                    "ρ is 0, which gives an orthographic picture no scale: it is shown as large as from ρ = 1.");
            return;
        }
        const Vec3d forward = normalized(camera.target - camera.eye), up = normalized(camera.up);
        if (forward == Vec3d(0))
            add("camera.target_x",
                "The camera's eye and target are the same point: it looks along the axis that is least aligned with "
                "up.");
        if (up == Vec3d(0))
            add("camera.up_x",
                "The camera's up is (0, 0, 0): the axis least aligned with the viewing direction takes "
                "its place.");
        else if (forward != Vec3d(0) && normalized(glm::cross(forward, up)) == Vec3d(0))
            add("camera.up_x",
                "The camera's up is parallel to the viewing direction: the axis least aligned with that "
                "takes its place.");
    }

    // What a depth format that cannot hold it hides.
    void ofChosenNearPlane() {
        const Camera& camera = m_scene.camera;
        const DepthFormat format = m_scene.settings.depthFormat;
        if (camera.near != 0 || camera.projection != ProjectionKind::Perspective ||
            nearestShare(format) < nearestShare(DepthFormat::Fixed32))
            return;
        const View view = makeView(m_scene);
        std::size_t before = 0;
        for (const Object& object : m_scene.objects) {
            if (isTransparent(object, m_scene.settings)) continue;
            const ObjectMatrix matrix = makeObjectMatrix(object.transform);
            before += std::ranges::any_of(object.mesh->positions, [&](Vec3d position) {
                const double z = toView(view, toWorld(matrix, position)).z;
                return z > 0 && z < view.near;
            });
        }
        if (before == 0) return;
        add("camera.near",
            fmt::format("{} object{} nearer than {}, where the near plane is chosen for this depth format: what lies "
                        "before it is not drawn. Set depth_format to linear, reversed or infinite, or set camera.near.",
                        before, before == 1 ? " is" : "s are", shortestText(view.near)));
    }

    void ofLights() {
        if (m_scene.lights.empty())
            add("light", "The scene has no light: surfaces show ambient light and emission alone.");
        const double ambient = m_scene.ambient.intensityIn(m_scene.settings.model);
        if (ambient < 0) add("ambient.intensity", negative("I_a", ambient));
        ofColor("ambient", {"red", "green", "blue"}, "the ambient light", m_scene.ambient.color);
        for (std::size_t k = 0; k < m_scene.lights.size(); ++k) {
            const Light& light = m_scene.lights[k];
            const std::string key = fmt::format("light.{}", k), name = fmt::format("light {}", k);
            if (light.intensity < 0)
                addOf("intensity", name, key + ".intensity", negative("The intensity of " + name, light.intensity));
            ofColor(key, {"red", "green", "blue"}, name, light.color);
            if (modelFacts(m_scene.settings.model).found.glLights) ofOpenGl(light, key, name);
        }
    }

    // A face of a point light's buffer sees a right angle: at a distance d its N texels are 2 d wide together.
    void ofShadowTexels() {
        constexpr double kFewest = 32;  // texels across the scene
        Vec3d low(std::numeric_limits<double>::infinity()), high = -low;
        for (const Object& object : m_scene.objects)
            forEachCorner(object, [&](Vec3d p) { low = glm::min(low, p), high = glm::max(high, p); });
        const double size = glm::length(high - low);
        if (m_scene.settings.visibility == Visibility::None || !(size > 0) || !(size < kFarthest)) return;
        for (std::size_t k = 0; k < m_scene.lights.size(); ++k) {
            const Light& light = m_scene.lights[k];
            const double distance = glm::length(light.position - (low + high) / 2.0);
            const double texel = 2 * distance / std::max(1, m_scene.settings.shadowSize);
            if (!light.castsShadow || light.kind == LightKind::AtInfinity || size >= kFewest * texel) continue;
            addOf("texel", fmt::format("light {}", k), "shadow.size",
                  fmt::format(
                      "A texel of the shadow buffer of light {} is {:.2g} world units wide at the scene, which is "
                      "{:.2g} large: cast shadows are coarse or lost. Set a larger shadow.size, move the light "
                      "nearer, or set its kind to at-infinity.",
                      k, texel, size));
        }
    }

    static std::string negative(const std::string& what, double value) {
        return fmt::format(
            "{} is {}, below 0: it takes light away. Computed as written; what falls below 0 is shown "
            "as 0.",
            what, shortestText(value));
    }

    // One remark a colour, about its first strange part.
    void ofColor(const std::string& key, std::array<std::string_view, 3> parts, const std::string& of, Vec3d color) {
        for (int c = 0; c < 3; ++c) {
            if (color[c] >= 0 && color[c] <= 1) continue;
            const bool below = color[c] < 0;
            addOf(fmt::format("{} {}", parts[std::size_t(c)], below), of,
                  fmt::format("{}.{}", key, parts[std::size_t(c)]),
                  fmt::format("The {} part of {} is {}, {}. Computed as written.", parts[std::size_t(c)], of,
                              shortestText(color[c]),
                              below ? "below 0: it takes light of that colour away"
                                    : "above 1: the light is stronger than its intensity"));
            return;
        }
    }

    void ofOpenGl(const Light& light, const std::string& key, const std::string& name) {
        const OpenGlLight& gl = light.gl;
        if (light.kind != LightKind::AtInfinity && gl.constant == 0 && gl.linear == 0 && gl.quadratic == 0)
            addOf("constant", name, key + ".constant",
                  fmt::format("The attenuation of {} divides by 0 everywhere: the light adds nothing.", name));
        ofColor(key, {"ambient_red", "ambient_green", "ambient_blue"}, name, gl.ambient);
        ofColor(key, {"specular_red", "specular_green", "specular_blue"}, name, gl.specular);
        if (gl.spotCutoff == 0)
            addOf("spot_cutoff", name, key + ".spot_cutoff",
                  fmt::format("The spot of {} is a cone of 0 degrees: it lights its axis alone.", name));
    }

    void ofObject(std::size_t i) {
        const Object& object = m_scene.objects[i];
        ofTransform(i);
        ofMaterial(i, object.material, false);
        if (object.backMaterial && lightsBacks(m_scene.settings)) ofMaterial(i, *object.backMaterial, true);
        const MeshFacts& facts = object.mesh->facts;
        const std::string name = inQuotes(object.name);
        if (facts.nonPlanar > 0)
            addOf("nonplanar", name, object.name,
                  fmt::format("{} not planar. Each such polygon is drawn as the triangles that it is split "
                              "into, with one normal, the sum of theirs.",
                              polygonsAre(object, facts.nonPlanar)));
        if (facts.concave > facts.unsplit)
            addOf("concave", name, object.name,
                  fmt::format("{} concave. Each such polygon is split into triangles that cover no more than it.",
                              polygonsAre(object, facts.concave - facts.unsplit)));
        if (facts.unsplit > 0)
            addOf("unsplit", name, object.name,
                  fmt::format("{} concave and not split: the outline crosses itself, or takes too long. The "
                              "triangles of such a polygon overlap and may cover more than it.",
                              polygonsAre(object, facts.unsplit)));
        if (facts.degenerate > 0)
            addOf("degenerate", name, object.name,
                  fmt::format("{} without area. Nothing of such a polygon is drawn.",
                              polygonsAre(object, facts.degenerate)));
        const std::size_t slivers = m_scene.settings.precision == Precision::Float ? sliversOf(object.mesh) : 0;
        if (slivers > 0)
            addOf("sliver", name, object.name,
                  fmt::format(
                      "{} slivers, less than 1/65536 as high as long: in float, rounding turns the normal of such a "
                      "polygon, and with it those of its vertices. Set precision=double, or normal_weight=area.",
                      polygonsAre(object, int(slivers))));
        ofDistance(object);
    }

    // visit(place) for the corners of the box around an object's mesh, world space.
    template <class Visit>
    static void forEachCorner(const Object& object, Visit visit) {
        const ObjectMatrix matrix = makeObjectMatrix(object.transform);
        const Vec3d sides[2]{object.mesh->facts.low, object.mesh->facts.high};
        for (unsigned corner = 0; corner < 8; ++corner)
            visit(toWorld(matrix, {sides[corner & 1].x, sides[corner >> 1 & 1].y, sides[corner >> 2].z}));
    }

    // Float has 24 bits: of a mesh farther off than 2^20 times its size fewer than 4 are left for its shape.
    void ofDistance(const Object& object) {
        if (m_scene.settings.precision != Precision::Float || object.mesh->positions.empty()) return;
        constexpr double kLeast = 0x1p-20;
        const auto share = [](Vec3d low, Vec3d high) {
            const double offset = std::max(largestComponent(low), largestComponent(high));
            return offset > 0 ? largestComponent(high - low) / offset : 1.0;
        };
        Vec3d low(std::numeric_limits<double>::infinity()), high = -low;
        forEachCorner(object, [&](Vec3d p) { low = glm::min(low, p), high = glm::max(high, p); });
        const MeshFacts& facts = object.mesh->facts;
        // Rounded as the mesh gives them, and once more where they stand in the world.
        const double of = std::min(share(facts.low, facts.high), share(low, high));
        if (!(of < kLeast) || facts.low == facts.high) return;
        addOf("distance", inQuotes(object.name), object.name,
              fmt::format("{} is {} times as far from the origin as it is large: float rounds its vertices to "
                          "{} steps along its size. Move it to the origin, or set precision to double.",
                          inQuotes(object.name), shortestText(std::round(1 / of)),
                          shortestText(std::max(1.0, std::round(of * 0x1p24)))));
    }

    // A plane that is given hides what is before it without a trace.
    void ofNearPlane() {
        const Camera& camera = m_scene.camera;
        if (camera.near == 0) return;
        Scene empty;
        empty.settings = m_scene.settings, empty.camera = camera;  // no object is looked at for its extent
        const View view = makeView(empty);
        std::size_t before = 0;
        const std::string* first = nullptr;
        for (const Object& object : m_scene.objects) {
            if (object.mesh->positions.empty() || isTransparent(object, m_scene.settings)) continue;
            double farthest = -std::numeric_limits<double>::infinity();
            forEachCorner(object,
                          [&](Vec3d p) { farthest = std::max(farthest, glm::dot(view.forward, p - view.eye)); });
            const bool isBehindEye = view.perspective && !(farthest > 0);
            if (!(farthest < view.near) || isBehindEye) continue;
            ++before;
            if (!first) first = &object.name;
        }
        if (before == 0) return;
        add("camera.near",
            fmt::format("{} before the near plane, which is {} from the eye: nothing of {} is drawn. Set camera.near "
                        "lower, or to 0 for a plane that is chosen.",
                        before == 1 ? inQuotes(*first) + " lies"
                                    : fmt::format("{} objects, {} the first of them, lie", before, inQuotes(*first)),
                        shortestText(camera.near), before == 1 ? "it" : "them"));
    }

    static std::string polygonsAre(const Object& object, int count) {
        return fmt::format("{} polygon{} of {} {}", count, count == 1 ? "" : "s", inQuotes(object.name),
                           count == 1 ? "is" : "are");
    }

    void ofTransform(std::size_t i) {
        const Vec3d& scale = m_scene.objects[i].transform.scale;
        const std::string key = fmt::format("object.{}.s", i), name = inQuotes(m_scene.objects[i].name);
        const int zeros = (scale.x == 0) + (scale.y == 0) + (scale.z == 0);
        const char axis = scale.x == 0 ? 'x' : scale.y == 0 ? 'y' : 'z';
        if (zeros == 1)
            addOf("flat", name, key + axis,
                  fmt::format("The scale of {} is 0 along {}: it is flat. Polygons across the plane have no "
                              "area, and nothing of them is drawn.",
                              name, axis));
        else if (zeros > 1)
            addOf("gone", name, key + axis,
                  fmt::format("The scale of {} is 0 along {} axes: nothing of it is drawn.", name, zeros));
        else if ((scale.x < 0) != ((scale.y < 0) != (scale.z < 0)))
            addOf("mirrored", name,
                  key + (scale.x < 0   ? 'x'
                         : scale.y < 0 ? 'y'
                                       : 'z'),
                  fmt::format("{} is mirrored: its outside stays outside.", name));
    }

    // One remark a coefficient, about its first strange part.
    void ofMaterial(std::size_t i, const Material& material, bool back) {
        const std::string key = fmt::format("{}.{}.", back ? "back_material" : "material", i),
                          side = back ? "back " : "";
        const ModelFacts& model = modelFacts(m_scene.settings.model);
        const std::string name = inQuotes(m_scene.objects[i].name);
        const auto ofCoefficient = [&](std::string_view symbol, std::string_view rest, Vec3d value) {
            for (int c = 0; c < 3; ++c) {
                if (value[c] >= 0 && value[c] <= 1) continue;
                addOf(fmt::format("{}{} {}", side, symbol, value[c] < 0), name,
                      fmt::format("{}{}{}", key, rest, "rgb"[c]),
                      fmt::format("{} of the {}material of {} is {}, {}. Computed as written.", symbol, side, name,
                                  shortestText(value[c]),
                                  value[c] < 0 ? "below 0: it takes light away"
                                               : "above 1: it gives more light than it receives"));
                return;
            }
        };
        ofCoefficient("k_d", "k", material.diffuse);
        ofCoefficient("k_s", "ks", material.specular);
        if (model.found.ownAmbient) ofCoefficient("k_a", "ka", material.ambient);
        if (model.found.emission)
            ofCoefficient("The emission", "ke", material.emission);
        else if (material.emission != Vec3d(0) && !m_isBlack)
            addOf(side + "emission", name, "model",
                  fmt::format("The {}material of {} gives off light, which {} does not read; {} does.", side, name,
                              model.name, namesOfModels([](const ModelFacts& one) { return one.found.emission; })));
        if (material.alpha < 0 || material.alpha > 1)
            addOf(fmt::format("{}alpha {}", side, material.alpha < 0), name, key + "alpha",
                  fmt::format("α of the {}material of {} is {}, beyond [0, 1]: it acts as {}.", side, name,
                              shortestText(material.alpha), material.alpha < 0 ? 0 : 1));
        if (material.exponent == 0 && material.specular != Vec3d(0) && model.lobe != Lobe::None)
            addOf(side + "n", name, key + "n",
                  fmt::format("n of the {}material of {} is 0: the highlight is as bright wherever it counts.", side,
                              name));
    }

    const Scene& m_scene;
    bool m_isBlack;
    std::vector<Remark> m_list;
    AlikeRemarks m_alike;
};

}  // namespace

std::vector<Remark> sceneRemarks(const Scene& scene) { return Remarks(scene).collect(); }

}  // namespace pipeline
