#pragma once
#include <array>
#include <optional>
#include <string>

#include "pipeline/scene/model_facts.h"

namespace pipeline {

// How shadePixelsInVectors evaluates the terms of a model at pixels.
enum class Kernel : unsigned char {
    Power,        // N·L, and a power of R·V or N·H: highlights.h
    Microfacets,  // microfacets.h
};
struct ModelKernel {
    Model model;
    Kernel kernel;
};
// A model without a row has no SIMD code at pixels. For every model the terms of polygons or vertices can be gathered.
inline constexpr std::array kModelKernels{ModelKernel{Model::Phong, Kernel::Power},
                                          ModelKernel{Model::BlinnPhong, Kernel::Power},
                                          ModelKernel{Model::CookTorrance, Kernel::Microfacets}};

constexpr std::optional<Kernel> kernelOf(Model model) {
    for (const ModelKernel& row : kModelKernels)
        if (row.model == model) return row.kernel;
    return {};
}

// The reason if pixels are not evaluated with SIMD; empty if they are.
inline std::string whyNoKernel(Model model) {
    if (kernelOf(model)) return {};
    return "In " + std::string(modelFacts(model).name) + " it shades by polygon or by vertex alone.";
}

}  // namespace pipeline
