#pragma once
#include <string_view>
#include <vector>

#include "pipeline/core/real.h"
#include "pipeline/formats/gltf/gltf_value.h"
#include "pipeline/scene/scene.h"

// What the parts of the reader of glTF share (Khronos Group, glTF 2.0 Specification, 2021).
namespace pipeline {

struct GltfNode {
    GltfValue node;
    glm::dmat4 toWorld;  // +y up
};
// A node that draws a mesh.
struct GltfInstance : GltfNode {
    GltfValue mesh;
};

// The nodes of the file's scene, parents before children, and those that draw. The nodes must be a tree of at most 1024
// levels; what is not as it must be is reported.
std::vector<GltfNode> nodesOf(GltfFile& file);
std::vector<GltfInstance> instancesOf(GltfFile& file);

// Its factors come before those of pbrMetallicRoughness: k_d = diffuse, k_s = specular, roughness = 1 - glossiness.
inline constexpr std::string_view kSpecularGlossiness = "KHR_materials_pbrSpecularGlossiness";

// metallic-roughness as coefficients (appendix B.2): k_d = baseColor (1 - metallic),
// k_s = 0.04 (1 - metallic) + baseColor metallic, and for n the Blinn-Phong exponent 2 / α² - 2 that
// matches a microfacet roughness α = roughness² (B. Karis, Real Shading in Unreal Engine 4, 2013;
// B. Walter et al., Microfacet Models for Refraction through Rough Surfaces, 2007), within 1 to 10 000.
Material readGltfMaterial(const GltfValue& material);

}  // namespace pipeline
