#pragma once
#include <algorithm>
#include <array>
#include <string>

#include "pipeline/scene/model_facts.h"

namespace pipeline {

// The models that shadePixelsInVectors evaluates at pixels: Phong's and Blinn's terms alone are written in vectors. Of any
// model it gathers what polygons or vertices have.
inline constexpr std::array kKernelModels{Model::Phong, Model::BlinnPhong};

// Why pixels are not evaluated in vectors; empty where they are.
inline std::string whyNoKernel(Model model) {
    if (std::ranges::find(kKernelModels, model) != kKernelModels.end()) return {};
    return "In " + std::string(modelFacts(model).name) + " it shades by polygon or by vertex alone.";
}

}  // namespace pipeline
