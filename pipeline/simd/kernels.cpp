#include "pipeline/simd/kernels.h"

#include <fmt/format.h>

#include "pipeline/scene/scene.h"
#include "pipeline/simd/model_kernels.h"

namespace pipeline {
namespace {

// Buffers of a pixel's surface in Phong shading, where each pixel has its own.
BufferSet ofSurfaces() {
    using enum BufferId;
    return setOf(
        {DiffuseCoefficient, Normal, ViewVector, LightVector, ReflectionVector, HalfwayVector, NDotL, RDotV, NDotH});
}
// Buffers in every shading; the last four are computed from the intensity.
BufferSet always() {
    using enum BufferId;
    return setOf({Position, Shadow, Ambient, Diffuse, Specular, Emission, Intensity, Color, Translucent, Transmittance,
                  Layers, Antialiased});
}

}  // namespace

std::string whyNotDrawnInVectors(const Settings& settings) {
    if (settings.isPlanted()) return kDefectIsPlanted;
    if (settings.precision != Precision::Float) return "They draw in float alone.";
    if (settings.visibility != Visibility::ZBuffer) return "They have the z-buffer alone.";
    return settings.depthFormat == DepthFormat::Linear ? "" : "They store linear depth alone.";
}

std::string whyNotShadedInVectors(const Settings& settings, BufferSet wanted) {
    if (settings.isPlanted()) return kDefectIsPlanted;
    if (settings.precision != Precision::Float) return "It computes in float alone.";
    if (settings.visibility == Visibility::None) return "Outlines are not shaded.";
    if (settings.shading == Shading::Phong && settings.interpolation != Interpolation::Perspective)
        return "It interpolates normals in perspective alone.";
    if (settings.shading == Shading::Gouraud && settings.interpolation == Interpolation::Scanline)
        return "It does not interpolate along rows.";
    if (std::string why = whyNoKernel(settings.model); !why.empty() && settings.shading == Shading::Phong) return why;
    if (lightsBacks(settings)) return "It lights one side alone.";
    if (settings.forms.power != PowerForm::Log1p || settings.forms.unit != UnitForm::Scaled)
        return "It has the stable forms of formulas alone.";
    for (const BufferInfo& info : bufferTable()) {
        if (!wanted[index(info.id)] || info.stage != StageId::Shading || info.domain != Domain::Pixel) continue;
        if (always()[index(info.id)] || (settings.shading == Shading::Phong && ofSurfaces()[index(info.id)])) continue;
        return fmt::format("The buffer {} is asked for, which it leaves {}.", info.name,
                           ofSurfaces()[index(info.id)] ? "in Phong shading alone" : "to others");
    }
    return {};
}

}  // namespace pipeline
