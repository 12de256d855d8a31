// Shading: directions and cosines.
#include <algorithm>

#include "pipeline/contracts/contract_data.h"

namespace pipeline {
namespace {

using Found = std::optional<ContractFinding>;
using B = BufferId;

std::string notTowardsLight(const Scene& scene, std::size_t k) {
    const Light& light = scene.lights[k];
    if (modelFacts(scene.settings.model).found.glLights && light.gl.space == LightSpace::Eye)
        return "The light moves with the eye.";
    if (scene.settings.shading != Shading::Phong && light.kind != LightKind::AtInfinity)
        return "Only Phong shading looks from the pixel's point to the light.";
    return whyNotLit(scene);
}
std::string notTowardsEye(const Scene& scene, std::size_t) {
    if (modelFacts(scene.settings.model).viewer == Viewer::Setting) return "The model has a viewer of its own.";
    if (scene.settings.shading == Shading::Flat) return "Flat shading looks from the polygon's middle.";
    return whyNotLit(scene);
}

template <B id>
Found unit(const ContractData& data, std::size_t pixel) {
    if (!data.drawn(pixel) || (!data.knowsDrawn() && data.vector(id, pixel) == Vec3d(0))) return {};
    return unitLength(data.vector(id, pixel), 4 * data.u());
}
// L of a light in the surface, and H where L = −V, have no direction: (0, 0, 0).
template <B id>
Found unitOrNone(const ContractData& data, std::size_t pixel) {
    if (!data.drawn(pixel) || data.vector(id, pixel) == Vec3d(0)) return {};
    return unitLength(data.vector(id, pixel), 4 * data.u());
}
template <B id, B a, B b>
Found dot(const ContractData& data, std::size_t pixel) {
    if (!data.drawn(pixel)) return {};
    return equals(data.number(id, pixel), glm::dot(data.vector(a, pixel), data.vector(b, pixel)), 4 * data.u());
}
template <B id>
Found cosine(const ContractData& data, std::size_t pixel) {
    if (!data.drawn(pixel)) return {};
    return within(data.number(id, pixel), -1, 1, 20 * data.u());
}

Found towardsTheEye(const ContractData& data, std::size_t pixel) {
    if (!data.drawn(pixel)) return {};
    const View& view = data.view();
    const Vec3d v = data.vector(B::ViewVector, pixel), p = data.vector(B::Position, pixel);
    if (!view.perspective) return direction(v + view.forward, 4 * data.u());
    const Vec3d towards = view.eye - p;
    const double distance = glm::length(towards), id = data.number(B::PolygonId, pixel);
    if (!(distance > 0) || !(id >= 0) || !(id < double(data.topology().polygonCount()))) return {};
    const Topology::Corners corners = data.topology().corners(std::size_t(id));
    double size = 0, reach = glm::length(view.eye);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3d q = data.vector(B::VerticesWorld, corners[i]);
        size = std::max(size, glm::length(q - data.vector(B::VerticesWorld, corners[0])));
        reach = std::max(reach, glm::length(q) + glm::length(view.eye));
    }
    const double snapped = std::sqrt(2.0) * std::ldexp(1.0, -1 - data.scene().settings.subPixelBits);
    const double bound =
        snapped / std::min(view.scale.x, view.scale.y) + data.u() * (12 + (40 * size + 20 * reach) / distance);
    return direction(v - towards / distance, bound);
}

Found towardsTheLight(const ContractData& data, std::size_t pixel) {
    if (!data.drawn(pixel)) return {};
    const Light& light = data.scene().lights[std::size_t(data.light())];
    const bool isFar = light.kind == LightKind::AtInfinity;
    const Vec3d p = data.vector(B::Position, pixel), l = data.vector(B::LightVector, pixel);
    const Vec3d towards = isFar ? light.position : light.position - p;
    const double distance = glm::length(towards);
    if (!(distance > 0) || (!data.knowsDrawn() && l == Vec3d(0))) return {};
    const double reach = isFar ? 0 : 2 * (glm::length(light.position) + glm::length(p)) / distance;
    return direction(l - towards / distance, data.u() * (6 + reach));
}

Found reflection(const ContractData& data, std::size_t pixel) {
    if (!data.drawn(pixel)) return {};
    const Vec3d n = data.vector(B::Normal, pixel), l = data.vector(B::LightVector, pixel);
    const Vec3d r = data.vector(B::ReflectionVector, pixel);
    return equals(glm::length(r - (2 * glm::dot(n, l) * n - l)), 0, 12 * data.u());
}

Found halfway(const ContractData& data, std::size_t pixel) {
    if (!data.drawn(pixel)) return {};
    const Vec3d sum = data.vector(B::LightVector, pixel) + data.vector(B::ViewVector, pixel);
    const Vec3d h = data.vector(B::HalfwayVector, pixel);
    const double length = glm::length(sum);
    if (!(length > 0)) return {};
    return direction(h - sum / length, 6 * data.u());
}

}  // namespace

std::span<const Contract> vectorContracts() {
    static constexpr std::string_view kUnit = "4 u: v / √(v·v) rounds each component by 3.5 u";
    static constexpr std::string_view kDot = "4 u: three products and two sums of numbers up to 1";
    static constexpr std::string_view kCosine = "20 u: two lengths round by 4 u each, R by 12 u, the product by 4 u";
    static constexpr std::string_view kPhong = "Lecture 1, Phong illumination";
    static constexpr std::string_view kBlinn = "Lecture 2, Blinn–Phong";
    static const Contract kRows[]{
        Contract{"unit-normals",
                 StageId::Shading,
                 "Interpolated normals have length 1.",
                 "|N| = 1",
                 {B::Normal},
                 "world",
                 "",
                 "1",
                 kUnit,
                 kPhong,
                 unit<B::Normal>,
                 whyNotLit},
        Contract{"unit-view",
                 StageId::Shading,
                 "V has length 1.",
                 "|V| = 1",
                 {B::ViewVector},
                 "world",
                 "",
                 "1",
                 kUnit,
                 kPhong,
                 unit<B::ViewVector>,
                 whyNotLit},
        Contract{
            "view-vector",
            StageId::Shading,
            "V points to the eye.",
            "V = (E − p) / |E − p|",
            {B::ViewVector, B::Position, B::PolygonId, B::VerticesWorld},
            "world",
            "",
            "0",
            "√2 · 2^-(bits+1) / d + u (12 + (40 l + 20 (|p| + |E|)) / |E − p|): snapped vertices move the point in the "
            "picture, the weights' 40 u over the polygon's length l, and what the difference rounds",
            kPhong,
            towardsTheEye,
            notTowardsEye},
        Contract{"unit-light",
                 StageId::Shading,
                 "L has length 1.",
                 "|L| = 1",
                 {B::LightVector},
                 "world",
                 "",
                 "1",
                 kUnit,
                 kPhong,
                 unitOrNone<B::LightVector>,
                 whyNotLit},
        Contract{"light-vector",
                 StageId::Shading,
                 "L points from the surface to the light.",
                 "L = (P − p) / |P − p|, at infinity P / |P|",
                 {B::LightVector, B::Position},
                 "world",
                 "",
                 "0",
                 "u (6 + 2 (|P| + |p|) / |P − p|): the length, and what the difference rounds",
                 kPhong,
                 towardsTheLight,
                 notTowardsLight},
        Contract{"reflection",
                 StageId::Shading,
                 "R is L mirrored at N.",
                 "R = 2 (N·L) N − L",
                 {B::ReflectionVector, B::Normal, B::LightVector},
                 "world",
                 "",
                 "0",
                 "12 u: N·L rounds by 4 u and counts twice, the product by 2 u, the difference by u",
                 kPhong,
                 reflection,
                 whyNotAtOnePoint},
        Contract{"unit-halfway",
                 StageId::Shading,
                 "H has length 1.",
                 "|H| = 1",
                 {B::HalfwayVector},
                 "world",
                 "",
                 "1",
                 kUnit,
                 kBlinn,
                 unitOrNone<B::HalfwayVector>,
                 whyNotLit},
        Contract{"halfway",
                 StageId::Shading,
                 "H is halfway between L and V.",
                 "H = (L + V) / |L + V|",
                 {B::HalfwayVector, B::LightVector, B::ViewVector},
                 "world",
                 "",
                 "0",
                 "6 u: the sum rounds each component by u, its length and the quotient by 3.5 u",
                 kBlinn,
                 halfway,
                 whyNotAtOnePoint},
        Contract{"n-dot-l",
                 StageId::Shading,
                 "N·L is the product of N and L.",
                 "N·L = N_x L_x + N_y L_y + N_z L_z",
                 {B::NDotL, B::Normal, B::LightVector},
                 "",
                 "",
                 "−1 to 1",
                 kDot,
                 kPhong,
                 dot<B::NDotL, B::Normal, B::LightVector>,
                 whyNotAtOnePoint},
        Contract{"r-dot-v",
                 StageId::Shading,
                 "R·V is the product of R and V.",
                 "R·V = R_x V_x + R_y V_y + R_z V_z",
                 {B::RDotV, B::ReflectionVector, B::ViewVector},
                 "",
                 "",
                 "−1 to 1",
                 kDot,
                 kPhong,
                 dot<B::RDotV, B::ReflectionVector, B::ViewVector>,
                 whyNotAtOnePoint},
        Contract{"n-dot-h",
                 StageId::Shading,
                 "N·H is the product of N and H.",
                 "N·H = N_x H_x + N_y H_y + N_z H_z",
                 {B::NDotH, B::Normal, B::HalfwayVector},
                 "",
                 "",
                 "−1 to 1",
                 kDot,
                 kBlinn,
                 dot<B::NDotH, B::Normal, B::HalfwayVector>,
                 whyNotAtOnePoint},
        Contract{"range-n-dot-l",
                 StageId::Shading,
                 "N·L is a cosine.",
                 "−1 ≤ N·L ≤ 1",
                 {B::NDotL},
                 "",
                 "",
                 "−1 to 1",
                 kCosine,
                 kPhong,
                 cosine<B::NDotL>,
                 whyNotLit},
        Contract{"range-r-dot-v",
                 StageId::Shading,
                 "R·V is a cosine.",
                 "−1 ≤ R·V ≤ 1",
                 {B::RDotV},
                 "",
                 "",
                 "−1 to 1",
                 kCosine,
                 kPhong,
                 cosine<B::RDotV>,
                 whyNotLit},
        Contract{"range-n-dot-h",
                 StageId::Shading,
                 "N·H is a cosine.",
                 "−1 ≤ N·H ≤ 1",
                 {B::NDotH},
                 "",
                 "",
                 "−1 to 1",
                 kCosine,
                 kBlinn,
                 cosine<B::NDotH>,
                 whyNotLit},
    };
    return kRows;
}

}  // namespace pipeline
