// Shading: terms, their sum and the frame buffer.
#include <algorithm>

#include "pipeline/contracts/contract_data.h"
#include "pipeline/core/elementary.h"
#include "pipeline/core/numerics.h"
#include "pipeline/scene/mesh/topology.h"
#include "pipeline/scene/model_facts.h"

namespace pipeline {
namespace {

using Found = std::optional<ContractFinding>;
using B = BufferId;

// The terms of both lectures: k_d I (N·L), and k_s I times a power of a cosine.
std::string notOfOneCoefficient(const Scene& scene) {
    return hasVertexColors(scene) ? "Colours of vertices change k_d and k_a from pixel to pixel." : "";
}
std::string notOfLecture(const Scene& scene, std::size_t k) {
    const ModelFacts& facts = modelFacts(scene.settings.model);
    if (facts.lobe == Lobe::None || facts.found.glLights) return "Another model than the lectures' has other terms.";
    return whyNotAtOnePoint(scene, k);
}
std::string notAboveZero(const Scene& scene, std::size_t k) {
    bool negative = scene.lights[k].intensity < 0;
    for (int c = 0; c < 3; ++c) {
        negative = negative || scene.lights[k].color[c] < 0 || scene.lights[k].gl.specular[c] < 0;
        for (const Object& object : scene.objects)
            negative = negative || object.material.diffuse[c] < 0 || object.material.specular[c] < 0;
    }
    return negative ? "A coefficient or an intensity is below 0." : whyNotLit(scene);
}
std::string noHighlightBelowZero(const Scene& scene, std::size_t k) {
    // Only a power of a cosine is at most 1.
    if (scene.settings.shading == Shading::Gouraud && modelFacts(scene.settings.model).lobe == Lobe::None)
        return "Gouraud shading interpolates highlights of any size, with weights that rounding may bring below 0.";
    return notAboveZero(scene, k);
}

Found shadowFactor(const ContractData& data, std::size_t pixel) {
    if (!data.drawn(pixel)) return {};
    return within(data.number(B::Shadow, pixel), 0, 1, 0);
}

// Gouraud shading interpolates with weights that rounding may bring below 0, by 40 u at most: that much of the largest term
// a vertex may have.
template <B id>
Found notBelowZero(const ContractData& data, std::size_t pixel) {
    if (!data.drawn(pixel)) return {};
    const Vec3d term = data.vector(id, pixel);
    const double least = std::min({term.x, term.y, term.z});
    double bound = 0;
    if (data.scene().settings.shading == Shading::Gouraud) {
        const Light& light = data.scene().lights[std::size_t(data.light())];
        Vec3d largest(0);
        const auto take = [&](const Material& m) {
            largest = glm::max(largest, id == B::Diffuse ? m.diffuse : m.specular);
        };
        for (const Object& object : data.scene().objects) {
            take(object.material);
            if (object.backMaterial) take(*object.backMaterial);
        }
        const bool fades = modelFacts(data.scene().settings.model).found.glLights;  // by at least its constant part
        const double gain = fades ? 1 / std::min(1.0, light.gl.constant) : 1;
        bound = 40 * data.u() * gain *
                largestComponent(light.intensity * glm::max(light.color, light.gl.specular) * largest);
    }
    return within(least, 0, std::numeric_limits<double>::infinity(), bound);
}

const Material* materialAt(const ContractData& data, std::size_t pixel) {
    const double id = data.number(B::ObjectId, pixel);
    const auto& objects = data.scene().objects;
    return id >= 0 && id < double(objects.size()) ? &objects[std::size_t(id)].material : nullptr;
}

// A term against what it should be: the component that is farthest off.
Found term(const Vec3d& is, const Vec3d& expected, double bound) {
    Found worst;
    for (int c = 0; c < 3; ++c) {
        const Found here = equals(is[c], expected[c], bound * std::abs(expected[c]));
        if (!worst || !(here->error - here->bound <= worst->error - worst->bound)) worst = here;
    }
    return worst;
}

Found ambientTerm(const ContractData& data, std::size_t pixel) {
    const Material* material = materialAt(data, pixel);
    if (!material) return {};
    const Model model = data.scene().settings.model;
    const Vec3d expected = ambientCoefficient(model, *material) * data.scene().ambient.lightIn(model);
    return term(data.vector(B::Ambient, pixel), expected, 4 * data.u());
}
std::string notAmbient(const Scene& scene, std::size_t) {
    if (modelFacts(scene.settings.model).found.glLights)
        return "In OpenGL's model lights have ambient parts of their own.";
    if (std::string why = notOfOneCoefficient(scene); !why.empty()) return why;
    return whyNotLit(scene);
}

// S I k without its cosine.
Vec3d reflected(const ContractData& data, std::size_t pixel, const Vec3d& coefficient) {
    const Light& light = data.scene().lights[std::size_t(data.light())];
    return data.number(B::Shadow, pixel) * light.intensity * light.color * coefficient;
}

std::string notLambert(const Scene& scene, std::size_t k) {
    const std::string why = notOfOneCoefficient(scene);
    return why.empty() ? notOfLecture(scene, k) : why;
}
Found diffuseTerm(const ContractData& data, std::size_t pixel) {
    const Material* material = materialAt(data, pixel);
    if (!material) return {};
    const double cosine = std::max(data.number(B::NDotL, pixel), 0.0);
    return term(data.vector(B::Diffuse, pixel), cosine * reflected(data, pixel, material->diffuse), 8 * data.u());
}

// S I k_s c^n where N·L > 0 and c > 0. c may err by `cosine` u: by its own rounding, and where a power is found from the
// difference of two vectors by what their lengths differ from 1. Its power errs by n times that. A power below the
// smallest normal number may be 0.
Found specularTerm(const ContractData& data, std::size_t pixel, const Material& material, B cosineId, double cosine) {
    const double c = data.number(cosineId, pixel), nDotL = data.number(B::NDotL, pixel), u = data.u();
    const Settings& settings = data.scene().settings;
    const double n = effectiveExponent(settings.model, settings.exponentFactor, material);
    const Vec3d is = data.vector(B::Specular, pixel), whole = reflected(data, pixel, material.specular);
    const bool lit = nDotL > 0 && c > 0;
    const bool isClose = std::abs(nDotL) <= 4 * u || std::abs(c) <= 4 * u;
    if (isClose && is == Vec3d(0)) return equals(0, 0, 0);
    const double power = lit ? pow(std::min(c, 1.0), n) : 0;
    const double logPower = lit ? n * std::abs(log(std::min(c, 1.0))) : 0;
    // e^x − 1, which is at most x + x² up to 1.
    const double x = lit ? u * (12 + cosine * n / c + 8 * logPower) : 0;
    const double grown = x < 1 ? x + x * x : exp(std::min(x, 700.0));
    const double smallest = u > 0x1p-40 ? 0x1p-125 : 0x1p-1021;
    Found worst;
    for (int i = 0; i < 3; ++i) {
        const double size = std::abs(whole[i]);
        const Found here = equals(is[i], power * whole[i], lit ? (grown * power + smallest) * size : 0);
        if (!worst || !(here->error - here->bound <= worst->error - worst->bound)) worst = here;
    }
    return worst;
}
Found specularOfReflection(const ContractData& data, std::size_t pixel) {
    const Material* material = materialAt(data, pixel);
    if (!material || usesHalfway(data.scene().settings.model, *material)) return {};
    return specularTerm(data, pixel, *material, B::RDotV, 40);  // |R| within 32 u, |V| within 4 u
}
Found specularOfHalfway(const ContractData& data, std::size_t pixel) {
    const Material* material = materialAt(data, pixel);
    if (!material || !usesHalfway(data.scene().settings.model, *material)) return {};
    return specularTerm(data, pixel, *material, B::NDotH, 12);  // |N| and |H| within 4 u
}
std::string notPowered(const Scene& scene, std::size_t k) {
    if (scene.settings.forms.power != PowerForm::Log1p) return "The power has another form than that of the lecture.";
    return notOfLecture(scene, k);
}

Found specularWhereLit(const ContractData& data, std::size_t pixel) {
    if (!data.drawn(pixel) || !(data.number(B::NDotL, pixel) <= -4 * data.u())) return {};
    const Vec3d is = data.vector(B::Specular, pixel);
    const double most = std::max({std::abs(is.x), std::abs(is.y), std::abs(is.z)});
    return ContractFinding{most, is.x != is.x || is.y != is.y || is.z != is.z ? is.x + is.y + is.z : most, 0};
}

// Transparent layers lie over pixels in which nothing is drawn, too.
Found sumOfTerms(const ContractData& data, std::size_t pixel) {
    if (!data.has(B::Emission) && modelFacts(data.scene().settings.model).found.emission) return {};
    if (data.isTranslucent() && !(data.has(B::Transmittance) && data.has(B::Translucent))) return {};
    Vec3d sum = data.vector(B::Ambient, pixel), size = glm::abs(sum);
    const auto add = [&](const Vec3d& more) { sum += more, size += glm::abs(more); };
    if (data.has(B::Emission)) add(data.vector(B::Emission, pixel));
    const int lights = int(data.scene().lights.size());
    for (int k = 0; k < lights; ++k) {
        add(data.vector(B::Diffuse, k, pixel));
        add(data.vector(B::Specular, k, pixel));
    }
    if (data.has(B::Transmittance)) {
        const double left = data.number(B::Transmittance, pixel);
        sum *= left, size *= std::abs(left);
    }
    if (data.has(B::Translucent)) add(data.vector(B::Translucent, pixel));
    const Vec3d is = data.vector(B::Intensity, pixel);
    if (is == Vec3d(0) && sum == Vec3d(0)) return data.drawn(pixel) ? equals(0, 0, 0) : Found{};
    Found worst;
    for (int c = 0; c < 3; ++c) {
        const Found here = equals(is[c], sum[c], (2 * lights + 5) * data.u() * size[c]);
        if (!worst || !(here->error - here->bound <= worst->error - worst->bound)) worst = here;
    }
    return worst;
}

Found scaledIntensity(const ContractData& data, std::size_t pixel) {
    const Vec3d is = data.vector(B::Color, pixel);
    const B of = data.scene().settings.antialiasing > 1 && data.has(B::Antialiased) ? B::Antialiased : B::Intensity;
    const Vec3d intensity = data.vector(of, pixel);
    if (!data.drawn(pixel) && intensity == Vec3d(0)) return {};  // the background's colour is free
    Found worst;
    for (int c = 0; c < 3; ++c) {
        const double share = data.iMax() > 0 ? std::clamp(intensity[c] / data.iMax(), 0.0, 1.0) : 0;
        const Found here = equals(is[c], 255 * share, 1 + 255 * 4 * data.u());
        if (!worst || !(here->error <= worst->error)) worst = here;
    }
    return worst;
}

}  // namespace

std::span<const Contract> termContracts() {
    static constexpr std::string_view kPhong = "Lecture 1, Phong illumination";
    static constexpr std::string_view kBlinn = "Lecture 2, Blinn–Phong";
    static const Contract kRows[]{
        Contract{"shadow-factor",
                 StageId::Shading,
                 "S is between dark and lit.",
                 "0 ≤ S ≤ 1",
                 {B::Shadow},
                 "",
                 "",
                 "0 to 1",
                 "0: a count of lit samples over all of them",
                 "Lecture 2, shadow buffer",
                 shadowFactor,
                 whyNotLit},
        Contract{"ambient-term",
                 StageId::Shading,
                 "The ambient term is the same for all pixels of a material.",
                 "k_a I_a, in lecture 1 k_d I_a",
                 {B::Ambient, B::ObjectId},
                 "",
                 "intensity",
                 "0 to ∞",
                 "4 u of the term: the numbers of the scene and their products",
                 kPhong,
                 ambientTerm,
                 notAmbient},
        Contract{"diffuse-positive",
                 StageId::Shading,
                 "The diffuse term of a light is never negative.",
                 "I_d ≥ 0",
                 {B::Diffuse},
                 "",
                 "intensity",
                 "0 to ∞",
                 "0: a product of what is not below 0; of Gouraud shading 40 u I k_d",
                 kPhong,
                 notBelowZero<B::Diffuse>,
                 notAboveZero},
        Contract{"diffuse-term",
                 StageId::Shading,
                 "The diffuse term is Lambert's.",
                 "S I k_d max(0, N·L)",
                 {B::Diffuse, B::NDotL, B::Shadow, B::ObjectId},
                 "",
                 "intensity",
                 "0 to ∞",
                 "8 u of the term: four factors and as many products",
                 "Lecture 1, diffuse reflection",
                 diffuseTerm,
                 notLambert},
        Contract{"specular-positive",
                 StageId::Shading,
                 "The specular term of a light is never negative.",
                 "I_s ≥ 0",
                 {B::Specular},
                 "",
                 "intensity",
                 "0 to ∞",
                 "0: a product of what is not below 0; of Gouraud shading 40 u I k_s",
                 kPhong,
                 notBelowZero<B::Specular>,
                 noHighlightBelowZero},
        Contract{"specular-where-lit",
                 StageId::Shading,
                 "There is no highlight where the surface faces away from the light.",
                 "I_s = 0 where N·L ≤ 0",
                 {B::Specular, B::NDotL},
                 "",
                 "intensity",
                 "0",
                 "0; N·L within 4 u of 0 is not asked",
                 kPhong,
                 specularWhereLit,
                 whyNotAtOnePoint},
        Contract{"specular-term",
                 StageId::Shading,
                 "The specular term is Phong's.",
                 "S I k_s (R·V)^n where N·L > 0, R·V > 0",
                 {B::Specular, B::RDotV, B::NDotL, B::Shadow, B::ObjectId},
                 "",
                 "intensity",
                 "0 to ∞",
                 "e^x − 1 of the term, x = u (12 + 40 n / R·V + 8 n |log R·V|): R·V rounds by 4 u and the lengths of R "
                 "and V by 36 u, "
                 "the power n times that",
                 kPhong,
                 specularOfReflection,
                 notPowered},
        Contract{"specular-term-halfway",
                 StageId::Shading,
                 "The specular term is Blinn's.",
                 "S I k_s (N·H)^n where N·L > 0, N·H > 0",
                 {B::Specular, B::NDotH, B::NDotL, B::Shadow, B::ObjectId},
                 "",
                 "intensity",
                 "0 to ∞",
                 "e^x − 1 of the term, x = u (12 + 12 n / N·H + 8 n |log N·H|): N·H rounds by 4 u and the lengths of N "
                 "and H by 8 u, "
                 "the power n times that",
                 kBlinn,
                 specularOfHalfway,
                 notPowered},
        Contract{"sum-of-terms",
                 StageId::Shading,
                 "The intensity is the sum of its terms.",
                 "I = I_e + I_a + Σ (I_d + I_s)",
                 {B::Intensity, B::Ambient, B::Diffuse, B::Specular},
                 "",
                 "intensity",
                 "0 to ∞",
                 "(2 lights + 5) u of the terms' magnitudes: as many sums",
                 kPhong,
                 sumOfTerms,
                 whyNotLit,
                 true},
        Contract{"scaled-intensity",
                 StageId::Shading,
                 "The frame buffer holds the scaled intensity.",
                 "C = 255 I / I_max, from 0 to 255",
                 {B::Color, B::Intensity},
                 "",
                 "of 255",
                 "0 to 255",
                 "1: rounded or cut off, either is right",
                 "Lecture 1, frame buffer",
                 scaledIntensity,
                 whyNotLit},
    };
    return kRows;
}

}  // namespace pipeline
