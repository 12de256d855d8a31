#include <algorithm>

#include "pipeline/formats/gltf_formats.h"

namespace pipeline {
namespace {

// What nothing of ours reads, with the remark that says so.
void remarkOn(const GltfValue& material) {
    const GltfValue pbr = material["pbrMetallicRoughness"];
    for (const GltfValue& texture :
         {pbr["baseColorTexture"], pbr["metallicRoughnessTexture"], material["normalTexture"],
          material["occlusionTexture"], material["emissiveTexture"]})
        if (texture.isThere())
            remark(material.file(), "Pictures on surfaces are not read; the materials' factors stand alone.");
    if (material["doubleSided"].truth().value_or(false))
        remark(material.file(),
               "A material is double-sided. Its back faces are seen where the scene does not cull them, and lit "
               "as front faces only by OpenGL's two-sided lighting.");
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
    remarkOn(value);
    const GltfValue pbr = value["pbrMetallicRoughness"];
    double color[4] = {1, 1, 1, 1}, emission[3] = {0, 0, 0};
    pbr["baseColorFactor"].numbers(color, 0, 1);
    value["emissiveFactor"].numbers(emission, 0, 1);
    const double metallic = pbr["metallicFactor"].number(0, 1).value_or(1);
    const double roughness = pbr["roughnessFactor"].number(0, 1).value_or(1);
    const double alpha = roughness * roughness;
    const Vec3d base{color[0], color[1], color[2]};

    constexpr double kDielectric = 0.04, kLeastExponent = 1, kLargestExponent = 10000;
    Material material;
    material.diffuse = base * (1 - metallic);
    material.specular = Vec3d(kDielectric * (1 - metallic)) + base * metallic;
    // At n = 0 a highlight would be as bright everywhere; a rough metal's is not.
    material.exponent =
        alpha > 0 ? std::clamp(2 / (alpha * alpha) - 2, kLeastExponent, kLargestExponent) : kLargestExponent;
    material.ambient = base;
    material.emission = {emission[0], emission[1], emission[2]};
    material.alpha = readAlpha(value, color[3]);
    return material;
}

}  // namespace pipeline
