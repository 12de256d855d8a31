#pragma once
#include <QString>
#include <vector>

#include "pipeline/inspect/formula.h"
#include "pipeline/scene/settings_table.h"

namespace app {

// What a part of the equation stands for, in other views.

// The vectors whose buffer it is, or whose dot product: "n_dot_l.0" gives N and L. None for anything else.
std::vector<pipeline::VectorCode> vectorsOf(const QString& refers);

// The settings that two scenes do not agree on, in the order of the table; those that only one of them has are left
// out.
std::vector<pipeline::SettingRef> differingSettings(const pipeline::Scene& a, const pipeline::Scene& b);

// A setting's words with the letters that the equation has: I_p of light 1 is I_1.
QString labelOf(const pipeline::SettingRef& setting);
// "n exponent" is known as n, "k_r red" as k_r, "L y" as it stands; another label by its words.
QString symbolOf(const pipeline::SettingRef& setting);

// What the equation's I_max is, and what it is made of in this scene.
QString maximumText(const pipeline::Scene& scene, double iMax);

}  // namespace app
