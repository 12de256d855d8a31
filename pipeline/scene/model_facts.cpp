#include "pipeline/scene/model_facts.h"

namespace pipeline {
namespace {

using enum Quantity;
using TermKind = Term::Kind;

constexpr Term leaf(Quantity quantity) { return {TermKind::Leaf, quantity}; }
constexpr Term number(double value) { return {TermKind::Leaf, Number, value, {}}; }
constexpr Term factor(int i) { return {TermKind::Leaf, Factor, double(i), {}}; }
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

// Microscopic mirrors: pipeline/illumination/cook_torrance.h. Its factors are α, T, f, D and G.
constexpr Term kOne = number(1), kTwo = number(2), kFive = number(5);
constexpr Term kAlpha = factor(0), kThrough = factor(1), kGrazing = factor(2), kDensity = factor(3), kSeen = factor(4);
constexpr Term kOneMinusKs[]{kOne, leaf(Specular)};
constexpr Term kEntering[]{of(TermKind::Difference, kOneMinusKs), kTwo};
constexpr Term kMatte[]{leaf(Diffuse), of(TermKind::Power, kEntering), kThrough, leaf(NDotL)};
constexpr Term kRestOfFresnel[]{of(TermKind::Difference, kOneMinusKs), kGrazing};
constexpr Term kFresnel[]{leaf(Specular), of(TermKind::Product, kRestOfFresnel)};
constexpr Term kMirrors[]{of(TermKind::Sum, kFresnel), kDensity, kSeen};

constexpr Term kNPlus2[]{leaf(Exponent), kTwo};
constexpr Term kSquareOfAlpha[]{kTwo, of(TermKind::Sum, kNPlus2)};
constexpr Term kUnderRoot[]{of(TermKind::Fraction, kSquareOfAlpha)};
// (1 − x)^5
constexpr Term kRestOfL[]{kOne, leaf(NDotL)}, kRestOfV[]{kOne, leaf(NDotV)}, kRestOfH[]{kOne, leaf(VDotH)};
constexpr Term kFifthOfL[]{of(TermKind::Difference, kRestOfL), kFive};
constexpr Term kFifthOfV[]{of(TermKind::Difference, kRestOfV), kFive};
constexpr Term kFifthOfH[]{of(TermKind::Difference, kRestOfH), kFive};
constexpr Term kIn[]{kOne, of(TermKind::Power, kFifthOfL)}, kOut[]{kOne, of(TermKind::Power, kFifthOfV)};
constexpr Term kInAndOut[]{of(TermKind::Difference, kIn), of(TermKind::Difference, kOut)};
// α² / ((N·H)² (α² − 1) + 1)²
constexpr Term kAlphaSquared[]{kAlpha, kTwo}, kSquareOfH[]{leaf(NDotH), kTwo};
constexpr Term kAlphaSquaredLess1[]{of(TermKind::Power, kAlphaSquared), kOne};
constexpr Term kSpreadProduct[]{of(TermKind::Power, kSquareOfH), of(TermKind::Difference, kAlphaSquaredLess1)};
constexpr Term kSpread[]{of(TermKind::Product, kSpreadProduct), kOne};
constexpr Term kSpreadSquared[]{of(TermKind::Sum, kSpread), kTwo};
constexpr Term kGgx[]{of(TermKind::Power, kAlphaSquared), of(TermKind::Power, kSpreadSquared)};
// N·L / (2 ((N·L) √(α² + (1 − α²) (N·V)²) + (N·V) √(α² + (1 − α²) (N·L)²)))
constexpr Term k1LessAlphaSquared[]{kOne, of(TermKind::Power, kAlphaSquared)};
constexpr Term kSquareOfL[]{leaf(NDotL), kTwo}, kSquareOfV[]{leaf(NDotV), kTwo};
constexpr Term kRestL[]{of(TermKind::Difference, k1LessAlphaSquared), of(TermKind::Power, kSquareOfL)};
constexpr Term kRestV[]{of(TermKind::Difference, k1LessAlphaSquared), of(TermKind::Power, kSquareOfV)};
constexpr Term kSumL[]{of(TermKind::Power, kAlphaSquared), of(TermKind::Product, kRestL)};
constexpr Term kSumV[]{of(TermKind::Power, kAlphaSquared), of(TermKind::Product, kRestV)};
constexpr Term kUnderL[]{of(TermKind::Sum, kSumL)}, kUnderV[]{of(TermKind::Sum, kSumV)};
constexpr Term kTimesL[]{leaf(NDotL), of(TermKind::Root, kUnderV)}, kTimesV[]{leaf(NDotV), of(TermKind::Root, kUnderL)};
constexpr Term kBoth[]{of(TermKind::Product, kTimesL), of(TermKind::Product, kTimesV)};
constexpr Term kTwice[]{kTwo, of(TermKind::Sum, kBoth)};
constexpr Term kSmith[]{leaf(NDotL), of(TermKind::Product, kTwice)};
constexpr ModelFactor kCookTorranceFactors[]{
    {"α", "roughness: a highlight as wide as that of n", of(TermKind::Root, kUnderRoot)},
    {"T", "light that enters the surface and leaves it again", of(TermKind::Product, kInAndOut)},
    {"f", "Fresnel's rise towards grazing angles (Schlick)", of(TermKind::Power, kFifthOfH)},
    {"D", "mirrors that face H, times π (GGX)", of(TermKind::Fraction, kGgx)},
    {"G", "of them seen by L and V, over 4 (N·V) (Smith)", of(TermKind::Fraction, kSmith)},
};

// In the order of the enumerators.
constexpr std::array<ModelFacts, kModelCount> kTable{{
    completed({.word = "phong",
               .label = "Phong (L1)",
               .name = "Phong's model",
               .base = kPhongBase,
               .light = kPhongLight,
               .lobe = Lobe::Reflection,
               .twoSided = true,
               .white = White::Maximum}),
    completed({.word = "blinn-phong",
               .label = "Blinn–Phong",
               .name = "Blinn–Phong's model",
               .base = kBlinnBase,
               .light = kPhongLight,
               .lobe = Lobe::Halfway,
               .twoSided = true}),
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
               .mostExponent = 128,
               .fixedFunctions = true}),
    completed({.word = "cook-torrance",
               .label = "Cook–Torrance (GGX)",
               .name = "Cook–Torrance's model",
               .base = kBlinnBase,
               .light = {{}, {}, kShadowed, kMatte, kMirrors},
               .factors = kCookTorranceFactors,
               .choosesLobe = {"Cook–Torrance's model has a highlight of its own."},
               .exponentFactor = {"Cook–Torrance's model takes the exponent as it is."},
               .dullWithoutKs = false,
               .twoSided = true}),
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
