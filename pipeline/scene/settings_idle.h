#pragma once
#include <string_view>

#include "pipeline/scene/scene.h"

// Why a setting has no effect in a scene, one sentence, or empty; the table of settings names one
// of these in every row that needs it.
namespace pipeline::settings_idle {

std::string_view onlySpherical(const Scene& scene);
std::string_view onlyLookAt(const Scene& scene);
std::string_view onlyLookAtPerspective(const Scene& scene);
std::string_view onlyLookAtOrthographic(const Scene& scene);
std::string_view onlyVertexNormals(const Scene& scene);
std::string_view notOutlines(const Scene& scene);
std::string_view notFlat(const Scene& scene);
std::string_view onlyZBuffer(const Scene& scene);
std::string_view onlyPainter(const Scene& scene);
std::string_view onlyTranslucent(const Scene& scene);
std::string_view onlyShadow(const Scene& scene);
std::string_view onlyArea(const Scene& scene);
std::string_view onlyBias(const Scene& scene);
std::string_view onlySpecular(const Scene& scene);
std::string_view onlyShapes(const Scene& scene);
std::string_view onlyPower(const Scene& scene);
std::string_view onlyFactored(const Scene& scene);
std::string_view onlyChosenLobe(const Scene& scene);
std::string_view onlyViewer(const Scene& scene);
std::string_view onlyTwoSided(const Scene& scene);
std::string_view onlyEmission(const Scene& scene);
std::string_view onlyGlLights(const Scene& scene);
std::string_view onlyFading(const Scene& scene);
std::string_view onlyOwnAmbient(const Scene& scene);
std::string_view onlyAntialiased(const Scene& scene);
std::string_view onlyFloat(const Scene& scene);
std::string_view onlyGivenNormals(const Scene& scene);
std::string_view onlyAngleWeights(const Scene& scene);
std::string_view onlyWithDefect(const Scene& scene);
std::string_view onlyLeavingOut(const Scene& scene);

}  // namespace pipeline::settings_idle
