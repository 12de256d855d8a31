#pragma once
#include <QString>
#include <vector>

#include "pipeline/inspect/formula.h"
#include "pipeline/scene/settings_table.h"

namespace app {

// What the symbols of the equation stand for.

// The vectors of a vector buffer or of a dot product: "n_dot_l.0" gives N and L. Empty for anything else.
std::vector<pipeline::VectorCode> vectorsOf(const QString& refers);

// A setting's label with the letters of the equation: I_p of light 1 is I_1.
QString labelOf(const pipeline::SettingRef& setting);
// The short symbol: n for "n exponent", k_r for "k_r red", "L y" unchanged; other labels in words.
QString symbolOf(const pipeline::SettingRef& setting);

// The meaning of the equation's I_max and its parts in this scene.
QString maximumText(const pipeline::Scene& scene, double iMax);

}  // namespace app
