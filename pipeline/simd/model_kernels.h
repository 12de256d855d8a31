#pragma once
#include <algorithm>
#include <array>
#include <string>

#include "pipeline/scene/model_facts.h"

namespace pipeline {

// The models that shadePixelsInVectors evaluates at pixels: only Phong's and Blinn's terms have SIMD code. For every
// model it can gather the terms of polygons or vertices.
inline constexpr std::array kKernelModels{Model::Phong, Model::BlinnPhong};

// The reason if pixels are not evaluated with SIMD; empty if they are.
inline std::string whyNoKernel(Model model) {
    if (std::ranges::find(kKernelModels, model) != kKernelModels.end()) return {};
    return "In " + std::string(modelFacts(model).name) + " it shades by polygon or by vertex alone.";
}

}  // namespace pipeline
