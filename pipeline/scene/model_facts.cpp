#include "pipeline/scene/model_facts.h"

namespace pipeline {
namespace {

using enum Quantity;
using TermKind = Term::Kind;

constexpr Term leaf(Quantity quantity) { return {TermKind::Leaf, quantity}; }
constexpr Term of(TermKind kind, std::span<const Term> parts) { return {kind, Number, 0, parts}; }

constexpr Term kMirror[]{leaf(Mirror), leaf(Exponent)};

// Lecture 1: k_d I_a + Σ S_k I_k [k_d (N·L) + k_s (R·V)^n].
constexpr Term kDiffuseOfAmbient[]{leaf(Diffuse), leaf(AmbientLight)};
constexpr Term kPhongBase[]{of(TermKind::Product, kDiffuseOfAmbient)};
constexpr Term kShadowed[]{leaf(Shadow), leaf(Intensity)};
constexpr Term kLambert[]{leaf(Diffuse), leaf(NDotL)};
constexpr Term kHighlight[]{leaf(Specular), of(TermKind::Power, kMirror)};
constexpr LightFormula kPhongLight{{}, {}, kShadowed, kLambert, kHighlight};

// Lecture 2: k_a I_a instead, and N·H.
constexpr Term kAmbientOfAmbient[]{leaf(Ambient), leaf(AmbientLight)};
constexpr Term kBlinnBase[]{of(TermKind::Product, kAmbientOfAmbient)};

// OpenGL 1.5, section 2.14.1: k_e + k_a I_a + Σ F_k [k_a a_k + S_k (d_k k_d (N·L) + s_k k_s (N·H)^n)].
constexpr Term kGlBase[]{leaf(Emission), of(TermKind::Product, kAmbientOfAmbient)};
constexpr Term kGlBefore[]{leaf(Fading)};
constexpr Term kGlAmbient[]{leaf(Ambient), leaf(GlAmbient)};
constexpr Term kGlShadowed[]{leaf(Shadow)};
constexpr Term kGlDiffuse[]{leaf(GlDiffuse), leaf(Diffuse), leaf(NDotL)};
constexpr Term kGlSpecular[]{leaf(GlSpecular), leaf(Specular), of(TermKind::Power, kMirror)};

// In the order of the enumerators.
constexpr std::array<ModelFacts, kModelCount> kTable{{
    completed({.word = "phong",
               .label = "Phong (L1)",
               .name = "Phong's model",
               .base = kPhongBase,
               .light = kPhongLight,
               .lobe = Lobe::Reflection,
               .white = White::Maximum}),
    completed({.word = "blinn-phong",
               .label = "Blinn–Phong",
               .name = "Blinn–Phong's model",
               .base = kBlinnBase,
               .light = kPhongLight,
               .lobe = Lobe::Halfway}),
    completed({.word = "opengl",
               .label = "OpenGL",
               .name = "OpenGL's model",
               .base = kGlBase,
               .light = {kGlBefore, kGlAmbient, kGlShadowed, kGlDiffuse, kGlSpecular},
               .lobe = Lobe::Halfway,
               .choosesLobe = {"OpenGL's model has a highlight of its own."},
               .exponentFactor = {"OpenGL's model takes the exponent as it is."},
               .shadows = {"OpenGL's model has no shadows."},
               .viewer = Viewer::Setting,
               .twoSided = true,
               .firstVertex = true,
               .clamps = true,
               .ambientByDefault = 0.2,
               .decimals = 4,
               .mostLights = 8,
               .mostExponent = 128}),
}};

constexpr auto wordsOf() {
    std::array<std::string_view, kModelCount> words;
    for (std::size_t i = 0; i < kModelCount; ++i) words[i] = kTable[i].word;
    return words;
}

}  // namespace

constinit const std::array<std::string_view, kModelCount> kModelWords = wordsOf();
const ModelFacts* triedModel = nullptr;

const ModelFacts& modelFacts(Model model) {
    const auto i = static_cast<std::size_t>(model);
    return i < kModelCount ? kTable[i] : *triedModel;
}
std::span<const ModelFacts, kModelCount> modelTable() { return kTable; }

std::string namesOfModels(const std::function<bool(const ModelFacts&)>& holds) {
    std::string names;
    for (const ModelFacts& model : kTable)
        if (holds(model)) names.append(names.empty() ? "" : " or ").append(model.name);
    return names;
}

}  // namespace pipeline
