#pragma once
#include <QString>
#include <vector>

#include "pipeline/inspect/formula.h"
#include "pipeline/scene/settings_table.h"

namespace app {

// The views' counterparts of a part of the equation.

// The vectors of a vector buffer or of a dot product: "n_dot_l.0" gives N and L. Empty for anything else.
std::vector<pipeline::VectorCode> vectorsOf(const QString& refers);

// The settings with different values in two scenes, in the order of the table. Settings that only one scene has are
// left out.
std::vector<pipeline::SettingRef> differingSettings(const pipeline::Scene& a, const pipeline::Scene& b);

// A setting's label with the letters of the equation: I_p of light 1 is I_1.
QString labelOf(const pipeline::SettingRef& setting);
// The short symbol: n for "n exponent", k_r for "k_r red", "L y" unchanged; other labels in words.
QString symbolOf(const pipeline::SettingRef& setting);

// The meaning of the equation's I_max and its parts in this scene.
QString maximumText(const pipeline::Scene& scene, double iMax);

}  // namespace app
