#include <algorithm>
#include <span>

#include "pipeline/formats/gltf/gltf_formats.h"
#include "pipeline/formats/model_formats.h"

namespace pipeline {
namespace {

constexpr std::string_view kNoTextures = "Pictures on surfaces are not read; the materials' factors stand alone.";

// What nothing of ours reads, with the remark that says so.
void remarkOn(const GltfValue& material) {
    const GltfValue pbr = material["pbrMetallicRoughness"];
    for (const GltfValue& texture :
         {pbr["baseColorTexture"], pbr["metallicRoughnessTexture"], material["normalTexture"],
          material["occlusionTexture"], material["emissiveTexture"]})
        if (texture.isThere()) remark(material.file(), std::string(kNoTextures), "picture");
    if (!material["doubleSided"].truth().value_or(false)) return;
    material.file().doubleSided = true;
    remark(
        material.file(),
        "A material is double-sided: its back faces are seen with cull=none, and lit as front faces only by OpenGL's "
        "two-sided lighting.",
        "material");
}

// A factor from 0 to 1. One beyond, often by a rounding, counts as the nearer of the two.
double factor(const GltfValue& value, double otherwise) {
    const double number = value.number(-kFarthestVertex, kFarthestVertex).value_or(otherwise);
    if (number < 0 || number > 1)
        remark(value.file(), "A factor of a material lies beyond 0 to 1; it counts as the nearer of the two.",
               "factor");
    return std::clamp(number, 0.0, 1.0);
}
void factors(const GltfValue& value, std::span<double> to) {
    if (!value.numbers(to, -kFarthestVertex, kFarthestVertex)) return;
    for (std::size_t i = 0; value.isThere() && i < to.size(); ++i) to[i] = factor(value.at(i), to[i]);
}

// What the alpha of the base colour comes to: nothing when opaque, which is the default; all or nothing when masked.
double readAlpha(const GltfValue& material, double base) {
    const GltfValue mode = material["alphaMode"];
    const std::string_view name = mode.isThere() ? mode.text().value_or("OPAQUE") : "OPAQUE";
    if (name == "BLEND") return base;
    if (name == "MASK") return base < material["alphaCutoff"].number(0, 1e9).value_or(0.5) ? 0 : 1;
    if (name != "OPAQUE") mode.refuse("OPAQUE, MASK or BLEND");
    return 1;
}

}  // namespace

Material readGltfMaterial(const GltfValue& value) {
    const std::size_t errors = value.file().errors.size();
    remarkOn(value);
    const GltfValue pbr = value["pbrMetallicRoughness"];
    double color[4] = {1, 1, 1, 1}, emission[3] = {0, 0, 0};
    factors(pbr["baseColorFactor"], color);
    // The factor multiplies a picture that is dark almost everywhere: alone it would be too much.
    if (value["emissiveTexture"].isThere())
        remark(value.file(), "What a picture gives off is not read, and the emissive factor with it.", "material");
    else
        factors(value["emissiveFactor"], emission);
    double roughness = factor(pbr["roughnessFactor"], 1);
    constexpr double kDielectric = 0.04, kLeastExponent = 1, kLargestExponent = 10000;
    Material material;
    Vec3d base{color[0], color[1], color[2]};
    if (const GltfValue glossy = value["extensions"][kSpecularGlossiness]; glossy.isThere()) {
        double specular[3] = {1, 1, 1};
        std::ranges::fill(color, 1.0);
        factors(glossy["diffuseFactor"], color);
        factors(glossy["specularFactor"], specular);
        if (glossy["diffuseTexture"].isThere() || glossy["specularGlossinessTexture"].isThere())
            remark(value.file(), std::string(kNoTextures), "picture");
        roughness = 1 - factor(glossy["glossinessFactor"], 1);
        material.diffuse = base = {color[0], color[1], color[2]};
        material.specular = {specular[0], specular[1], specular[2]};
    } else {
        const double metallic = factor(pbr["metallicFactor"], 1);
        material.diffuse = base * (1 - metallic);
        material.specular = Vec3d(kDielectric * (1 - metallic)) + base * metallic;
    }
    const double alpha = roughness * roughness;
    // At n = 0 a highlight would be as bright everywhere; a rough metal's is not.
    material.exponent =
        alpha > 0 ? std::clamp(2 / (alpha * alpha) - 2, kLeastExponent, kLargestExponent) : kLargestExponent;
    material.ambient = base;
    material.emission = {emission[0], emission[1], emission[2]};
    material.alpha = readAlpha(value, color[3]);
    dropErrors(value.file(), errors, "what the material has there is not read", "material");
    return material;
}

}  // namespace pipeline
