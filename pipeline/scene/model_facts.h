#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "pipeline/scene/settings.h"

namespace pipeline {

// What is known of an illumination model: one row a model. Callers ask what it reads and does, never which model it is.
// What needs a text of its own for each model is a list keyed by model on its own floor, and a model without an entry has
// a reason there: what computes its terms (pipeline/illumination/model_table.h), kernels (pipeline/simd/model_kernels.h),
// rays (pipeline/study/ray_light.h), OpenGL's calls (pipeline/export/buffers/gl_calls.h). The algorithm's lines say
// "formula=" and the model's word (pipeline/steps/algorithm_table.cpp).

// Whether something holds, and if not why, one sentence.
struct Fact {
    std::string_view whyNot{};
    constexpr explicit operator bool() const { return whyNot.empty(); }
};

// What a formula is written with, for one of the three colours; of light k where that has an index.
enum class Quantity : std::uint8_t {
    Emission,      // k_e
    Ambient,       // k_a
    AmbientLight,  // I_a
    Diffuse,       // k_r, k_g, k_b
    Specular,      // k_s
    Exponent,      // n, times exponent_factor where the model reads that
    Shadow,        // S_k
    Fading,        // F_k: attenuation times spot
    Intensity,     // I_k: the light's intensity times its colour
    GlDiffuse,     // d_k: the same as OpenGL calls it
    GlAmbient,     // a_k
    GlSpecular,    // s_k
    NDotL,         // as all cosines 0 where it is below 0
    Mirror,        // R·V or N·H, as the material says
    NDotV,
    NDotH,
    VDotH,
    LDotV,   // also below 0
    Factor,  // of the model's own: ModelFacts::factors
    Number,
};

// A formula as a tree.
struct Term {
    enum class Kind : std::uint8_t { Leaf, Sum, Difference, Product, Power, Fraction, Root, Largest };
    Kind kind = Kind::Leaf;
    Quantity quantity = Quantity::Number;
    double number = 0;  // Number; the index of a Factor
    std::span<const Term> parts{};
};
using Factors = std::span<const Term>;  // of a product

// What light k adds: before [ambient + shadowed (diffuse + specular)]. Each is a product; an empty one of these three is
// not there.
struct LightFormula {
    Factors before{}, ambient{}, shadowed{}, diffuse{}, specular{};
};

// A factor of the formula that a model computes for itself: LightSample::factors.
struct ModelFactor {
    std::string_view letter;   // "D"
    std::string_view meaning;  // "distribution of the normals, GGX": behind its line in the equation
    Term definition;           // of quantities and of the factors before it
};
inline constexpr std::size_t kMostFactors = 5;

// Which vectors a term reads beside N and L.
struct VectorsRead {
    bool V = false, R = false, H = false;
};

enum class Lobe : std::uint8_t {
    None,
    Reflection,
    Halfway
};                                                     // whether the specular term is a power, and of which cosine
enum class White : std::uint8_t { Maximum, One };      // what 255 stands for: maximumIntensity(), or 1
enum class Viewer : std::uint8_t { Camera, Setting };  // what V points to; Setting: as local_viewer says

struct ModelFacts {
    std::string_view word;   // of the setting: "blinn-phong"
    std::string_view label;  // "Blinn–Phong"
    std::string_view name;   // for sentences: "Blinn–Phong's model"

    // Per colour: the sum of `base` is there without any light, and light k adds `light`.
    std::span<const Term> base{};
    LightFormula light{};
    std::span<const ModelFactor> factors{};

    Lobe lobe = Lobe::None;
    Fact choosesLobe{};         // a material's highlight may be of the other kind
    Fact exponentFactor{};      // exponent_factor counts, where the lobe is that of H
    bool dullWithoutKs = true;  // there is no specular term where k_s is 0
    Fact shadows{};
    Viewer viewer = Viewer::Camera;
    bool twoSided = false;     // two_sided counts
    bool firstVertex = false;  // flat shading evaluates a polygon at its first vertex, else at the vertices' mean
    bool clamps = false;       // the intensities of polygons and vertices, to [0, 1]
    White white = White::One;
    double ambientByDefault = 0;  // I_a where a scene gives none
    int decimals = 3;             // of intensities in tables: up to some hundreds in lecture 1's model
    std::optional<int> mostLights{};
    std::optional<double> mostExponent{};
    bool fixedFunctions = false;  // OpenGL 1.x has it built in: its calls alone draw the same picture

    // What the formula says: see completed().
    struct Found {
        bool emission = false;
        bool ownAmbient = false;                       // ambient light is reflected by k_a, else by k_d
        bool glLights = false;                         // Light::gl counts, also that a light may be in eye space
        VectorsRead diffuse{}, specular{}, halfway{};  // by the diffuse and by the specular term, with R·V or N·H
    } found{};
    // halfway: the lobe of the material.
    constexpr const VectorsRead& specularReads(bool halfway) const { return halfway ? found.halfway : found.specular; }
};
// A row with what its formula says.
constexpr ModelFacts completed(ModelFacts row);

// The row of a model.
const ModelFacts& modelFacts(Model model);
std::span<const ModelFacts, kModelCount> modelTable();
// The words of the setting, in the order of the enumerators.
extern const std::array<std::string_view, kModelCount> kModelWords;

// A row beyond the table, that of Model(kModelCount): tests set it to try a model.
inline constexpr Model kTriedModel = Model(kModelCount);
extern const ModelFacts* triedModel;

// "OpenGL's model", "Phong's model or OpenGL's model": those of the table of which a condition holds.
std::string namesOfModels(const std::function<bool(const ModelFacts&)>& holds);

constexpr bool reads(std::span<const Term> terms, Quantity quantity) {
    for (const Term& term : terms)
        if (term.kind == Term::Kind::Leaf ? term.quantity == quantity : reads(term.parts, quantity)) return true;
    return false;
}
constexpr void collectVectors(const ModelFacts& row, std::span<const Term> terms, bool halfway, VectorsRead& read) {
    using enum Quantity;
    for (const Term& term : terms) {
        collectVectors(row, term.parts, halfway, read);
        const Quantity q = term.quantity;
        if (term.kind != Term::Kind::Leaf) continue;
        if (q == Factor)
            collectVectors(row, std::span(&row.factors[std::size_t(term.number)].definition, 1), halfway, read);
        read.R = read.R || (q == Mirror && !halfway);
        read.H = read.H || (q == Mirror && halfway) || q == NDotH || q == VDotH;
        read.V = read.V || q == Mirror || q == NDotV || q == NDotH || q == VDotH || q == LDotV;
    }
}
constexpr ModelFacts completed(ModelFacts row) {
    row.found.emission = reads(row.base, Quantity::Emission);
    row.found.ownAmbient = reads(row.base, Quantity::Ambient);
    row.found.glLights = reads(row.light.before, Quantity::Fading);
    collectVectors(row, row.light.diffuse, false, row.found.diffuse);
    collectVectors(row, row.light.specular, false, row.found.specular);
    collectVectors(row, row.light.specular, true, row.found.halfway);
    return row;
}

}  // namespace pipeline
