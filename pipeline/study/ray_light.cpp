#include "pipeline/study/ray_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace pipeline::rays {
namespace {

template <class Real>
Vec3<Real> viewVector(const RayLighting<Real>& lighting, Vec3<Real> position) {
    if (modelFacts(lighting.model).viewer == Viewer::Camera) return lighting.camera.fromSurface(position);
    // Its local viewer is the eye, also where the view is orthographic.
    return lighting.infiniteViewer ? -lighting.camera.forward : unit(lighting.camera.eye - position);
}

// Attenuation and spot; 1 outside OpenGL's model.
template <class Real>
Real fading(const RayLight<Real>& light, Vec3<Real> position, Vec3<Real> L) {
    Real factor = 1;
    if (light.kind != LightKind::AtInfinity) {
        const Real d = glm::length(light.place - position);
        const Real denominator = light.constant + light.linear * d + light.quadratic * d * d;
        factor = denominator > 0 ? 1 / denominator : Real(0);
    }
    if (!light.isSpot) return factor;
    const Real cosine = -glm::dot(L, light.spotDirection);
    if (cosine < light.spotCosine) return 0;
    return light.spotExponent == 0 ? factor : factor * std::pow(cosine, light.spotExponent);
}

template <class Real>
RayLight<Real> makeLight(const Light& light, const RayCamera<Real>& camera, const ModelFacts& model) {
    const bool openGl = model.found.glLights;
    RayLight<Real> out;
    const auto turned = [&](Vec3d v) {
        if (!openGl || light.gl.space == LightSpace::World) return Vec3<Real>(v);
        return Real(v.x) * camera.right + Real(v.y) * camera.up - Real(v.z) * camera.forward;
    };
    out.kind = light.kind;
    out.place = turned(light.position);
    if (light.kind == LightKind::AtInfinity)
        out.place = unit(out.place);
    else if (openGl && light.gl.space == LightSpace::Eye)
        out.place += camera.eye;
    if (light.kind == LightKind::Area) {
        const Vec3<Real> facing = unit(Vec3<Real>(light.area.facing));
        Vec3<Real> across = unit(glm::cross(Vec3<Real>(0, 0, 1), facing));
        if (across == Vec3<Real>(0)) across = {1, 0, 0};
        out.width = Real(light.area.width) * across;
        out.height = Real(light.area.height) * glm::cross(facing, across);
    }
    const Real intensity = Real(light.intensity);
    out.color = out.specular = intensity * Vec3<Real>(light.color);
    out.castsShadow = light.castsShadow && model.shadows;
    if (!openGl) return out;
    out.specular = intensity * Vec3<Real>(light.gl.specular);
    out.ambient = intensity * Vec3<Real>(light.gl.ambient);
    out.constant = Real(light.gl.constant), out.linear = Real(light.gl.linear),
    out.quadratic = Real(light.gl.quadratic);
    out.isSpot = light.gl.spotCutoff != 180;
    out.spotDirection = unit(turned(light.gl.spotDirection));
    out.spotCosine = sinCos<Real>(light.gl.spotCutoff).cos;
    out.spotExponent = Real(light.gl.spotExponent);
    return out;
}

// The part of a square whose corners, in order around it, are lit or not; edge(i) is how far the boundary lies along
// the side from corner i to the next, 0..1. W. Lorensen and H. Cline, "Marching cubes", SIGGRAPH 1987, in the plane.
template <class Real, class Edge>
Real litPart(const std::array<bool, 4>& lit, Edge edge) {
    const std::array<Vec2<Real>, 5> corner{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
    std::array<Vec2<Real>, 8> outline;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        if (lit[i]) outline[count++] = corner[i];
        if (lit[i] != lit[(i + 1) % 4]) outline[count++] = corner[i] + edge(i) * (corner[i + 1] - corner[i]);
    }
    Real twice = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2<Real> a = outline[i], b = outline[(i + 1) % count];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

// The part of the unit square where isLit(u, v).
template <class Real, class IsLit>
Real litShare(int cells, IsLit isLit) {
    const auto at = [&](int i) { return Real(i) / Real(cells); };
    const std::size_t across = std::size_t(cells) + 1;
    std::vector<std::uint8_t> lit(across * across);
    for (std::size_t j = 0; j < across; ++j)
        for (std::size_t i = 0; i < across; ++i) lit[j * across + i] = isLit(at(int(i)), at(int(j)));
    Real sum = 0;
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const std::array<std::array<int, 2>, 5> grid{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}, {i, j}}};
            std::array<bool, 4> corners{};
            for (std::size_t c = 0; c < 4; ++c)
                corners[c] = lit[std::size_t(grid[c][1]) * across + std::size_t(grid[c][0])] != 0;
            sum += litPart<Real>(corners, [&](std::size_t c) {
                const Vec2<Real> a{at(grid[c][0]), at(grid[c][1])}, b{at(grid[c + 1][0]), at(grid[c + 1][1])};
                Real near = 0, far = 1;
                for (int step = 0; step < 20; ++step) {
                    const Real middle = (near + far) / 2;
                    const Vec2<Real> p = a + middle * (b - a);
                    (isLit(p.x, p.y) == corners[c] ? near : far) = middle;
                }
                return (near + far) / 2;
            });
        }
    return sum / Real(cells * cells);
}

}  // namespace

template <class Real>
RayLighting<Real> makeLighting(const Scene& scene) {
    RayLighting<Real> out;
    const Settings& settings = scene.settings;
    out.model = settings.model;
    const ModelFacts& model = modelFacts(out.model);
    if (model.exponentFactor) out.exponentFactor = Real(settings.exponentFactor);
    out.infiniteViewer = model.viewer == Viewer::Setting && !settings.localViewer;
    out.twoSided = lightsBacks(settings);
    out.ambient = Real(scene.ambient.intensityIn(out.model)) * Vec3<Real>(scene.ambient.color);
    out.camera = makeCamera<Real>(scene);
    for (const Light& light : scene.lights) out.lights.push_back(makeLight<Real>(light, out.camera, model));
    for (const Object& object : scene.objects) {
        out.materials.push_back(object.material);
        out.backMaterials.push_back(object.backMaterial.value_or(object.material));
    }
    return out;
}

template <class Real>
Vec3<Real> towards(const RayLight<Real>& light, Vec3<Real> position) {
    return light.kind == LightKind::AtInfinity ? light.place : unit(light.place - position);
}

template <class Real>
Vec3<Real> unshadowed(const RayLighting<Real>& lighting, const Material& material, const LitPoint<Real>& at) {
    const ModelFacts::Found& found = modelFacts(lighting.model).found;
    Vec3<Real> sum = lighting.ambient * Vec3<Real>(found.ownAmbient ? material.ambient : material.diffuse);
    if (found.emission) sum += Vec3<Real>(material.emission);
    if (!found.glLights) return sum;
    for (const RayLight<Real>& light : lighting.lights)
        sum += fading(light, at.position, towards(light, at.position)) * light.ambient * Vec3<Real>(material.ambient);
    return sum;
}

namespace {

// Unit L and V at a point, and N·L, above 0.
template <class Real>
struct Directions {
    Vec3<Real> N, L, V;
    Real facing;
};

// k_d (N·L) + k_s (R·V)^n, or (N·H)^n as the material says.
template <class Real>
Vec3<Real> ofPower(const RayLighting<Real>& lighting, const RayLight<Real>& light, const Material& material,
                   const Directions<Real>& at) {
    const bool halfway = usesHalfway(lighting.model, material);
    const Real cosine = halfway ? glm::dot(at.N, unit(at.L + at.V)) : glm::dot(Real(2) * at.facing * at.N - at.L, at.V);
    const Real exponent = Real(material.exponent);
    const Real power = cosine > 0 ? std::pow(cosine, halfway ? lighting.exponentFactor * exponent : exponent) : Real(0);
    return light.color * Vec3<Real>(material.diffuse) * at.facing +
           light.specular * Vec3<Real>(material.specular) * power;
}

// The same with N·H; n = 0 is 1 whatever N·H is.
template <class Real>
Vec3<Real> ofOpenGl(const RayLighting<Real>& lighting, const RayLight<Real>& light, const Material& material,
                    const Directions<Real>& at) {
    if (material.exponent != 0) return ofPower(lighting, light, material, at);
    return light.color * Vec3<Real>(material.diffuse) * at.facing + light.specular * Vec3<Real>(material.specular);
}

// Microfacets after B. Walter et al., EGSR 2007, written with angles: D = α² / (cos⁴ (α² + tan²)²), equation 33; Smith's
// G from Λ = (−1 + √(1 + α² tan²)) / 2 as 1 / (1 + Λ(L) + Λ(V)), E. Heitz, JCGT 2014, equations 72 and 99.
template <class Real>
Vec3<Real> ofCookTorrance(const RayLighting<Real>&, const RayLight<Real>& light, const Material& material,
                          const Directions<Real>& at) {
    const Real square = Real(2) / (Real(material.exponent) + 2);
    const auto tan2 = [](Real cosine) { return (1 - cosine * cosine) / (cosine * cosine); };
    const auto lambda = [&](Real cosine) { return (std::sqrt(1 + square * tan2(cosine)) - 1) / 2; };
    const Real l = std::min(Real(1), at.facing), v = std::clamp(glm::dot(at.N, at.V), Real(1e-9), Real(1));
    const Vec3<Real> H = unit(at.L + at.V);
    const Real h = std::clamp(glm::dot(at.N, H), Real(1e-9), Real(1));
    const auto schlick = [](const Vec3<Real>& k, Real cosine) {
        return k + (Vec3<Real>(1) - k) * std::pow(1 - std::clamp(cosine, Real(0), Real(1)), Real(5));
    };
    const Real spread = h * h * (square + tan2(h));
    const Real mirrors = square / (spread * spread) / (1 + lambda(l) + lambda(v)) / (4 * v);
    const Vec3<Real> ks(material.specular);
    const Vec3<Real> matte = (Vec3<Real>(1) - schlick(ks, l)) * (Vec3<Real>(1) - schlick(ks, v));
    return light.color * (Vec3<Real>(material.diffuse) * matte * l + schlick(ks, glm::dot(at.V, H)) * mirrors);
}

template <class Real>
struct RayModel {
    Model model;
    Vec3<Real> (*reflected)(const RayLighting<Real>&, const RayLight<Real>&, const Material&, const Directions<Real>&);
};
// The models that rays evaluate.
template <class Real>
constexpr std::array kRayModels{
    RayModel<Real>{Model::Phong, ofPower<Real>}, RayModel<Real>{Model::BlinnPhong, ofPower<Real>},
    RayModel<Real>{Model::OpenGl, ofOpenGl<Real>}, RayModel<Real>{Model::CookTorrance, ofCookTorrance<Real>}};

}  // namespace

std::string whyNoRayModel(Model model) {
    if (std::ranges::find(kRayModels<double>, model, &RayModel<double>::model) != kRayModels<double>.end()) return {};
    return fmt::format("rays have no formula of their own for {}", modelFacts(model).name);
}

template <class Real>
Vec3<Real> bracket(const RayLighting<Real>& lighting, std::size_t k, const Material& material,
                   const LitPoint<Real>& at) {
    const RayLight<Real>& light = lighting.lights[k];
    const Vec3<Real> L = towards(light, at.position), V = viewVector(lighting, at.position);
    const Real facing = glm::dot(at.N, L);
    if (!(facing > 0)) return Vec3<Real>(0);
    const auto model = std::ranges::find(kRayModels<Real>, lighting.model, &RayModel<Real>::model);
    const Vec3<Real> reflected = model->reflected(lighting, light, material, {at.N, L, V, facing});
    return modelFacts(lighting.model).found.glLights ? fading(light, at.position, L) * reflected : reflected;
}

template <class Real>
Vec3<Real> shade(const RayLighting<Real>& lighting, const Material& material, const LitPoint<Real>& at,
                 std::span<const Real> shadow) {
    Vec3<Real> sum = unshadowed(lighting, material, at);
    for (std::size_t k = 0; k < lighting.lights.size(); ++k)
        if (shadow[k] != 0) sum += shadow[k] * bracket(lighting, k, material, at);
    return sum;
}

template <class Real>
Real lightSeen(const RayScene<Real>& scene, const RayLighting<Real>& lighting, std::size_t k,
               const SurfacePoint<Real>& at, int cells) {
    const RayLight<Real>& light = lighting.lights[k];
    if (!light.castsShadow) return 1;
    const auto isLit = [&](Vec3<Real> direction, Real end, const Blockers* among = nullptr) {
        return glm::dot(at.plane, direction) > 0 &&
               !isBlocked(scene, at, Ray<Real>{at.position, direction}, end, among);
    };
    if (light.kind == LightKind::AtInfinity) return isLit(light.place, kInfinity<Real>) ? Real(1) : Real(0);
    // What the lamp itself stands on is not before it: the way ends before, by what rounding may do to the place.
    const auto isLitFrom = [&](Vec3<Real> place, const Blockers* among = nullptr) {
        const Vec3<Real> way = place - at.position;
        return isLit(way, Real(1) - 8 * at.rounding / glm::length(way), among);
    };
    if (light.kind == LightKind::Point) return isLitFrom(light.place) ? Real(1) : Real(0);
    const auto placeAt = [&](Real u, Real v) {
        return light.place + (u - Real(0.5)) * light.width + (v - Real(0.5)) * light.height;
    };
    const std::array<Vec3<Real>, 4> corners{placeAt(0, 0), placeAt(1, 0), placeAt(1, 1), placeAt(0, 1)};
    const auto isFaced = [&](Vec3<Real> corner) { return glm::dot(at.plane, corner - at.position) > 0; };
    if (std::ranges::none_of(corners, isFaced)) return 0;
    const Blockers among = blockersBefore(scene, at, corners);
    if (among.empty() && std::ranges::all_of(corners, isFaced)) return 1;
    return litShare<Real>(cells, [&](Real u, Real v) { return isLitFrom(placeAt(u, v), &among); });
}

#define SHADESCOPE_INSTANTIATE(Real)                                                                                 \
    template RayLighting<Real> makeLighting(const Scene&);                                                           \
    template Vec3<Real> towards(const RayLight<Real>&, Vec3<Real>);                                                  \
    template Vec3<Real> unshadowed(const RayLighting<Real>&, const Material&, const LitPoint<Real>&);                \
    template Vec3<Real> bracket(const RayLighting<Real>&, std::size_t, const Material&, const LitPoint<Real>&);      \
    template Vec3<Real> shade(const RayLighting<Real>&, const Material&, const LitPoint<Real>&,                      \
                              std::span<const Real>);                                                                \
    template Real lightSeen(const RayScene<Real>&, const RayLighting<Real>&, std::size_t, const SurfacePoint<Real>&, \
                            int);
SHADESCOPE_INSTANTIATE(double)
SHADESCOPE_INSTANTIATE(long double)
#undef SHADESCOPE_INSTANTIATE

}  // namespace pipeline::rays
