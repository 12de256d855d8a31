#pragma once
#include <QString>
#include <vector>

#include "pipeline/scene/settings_table.h"

namespace app {

// A selectable part of the scene.
struct SceneItem {
    enum class Kind : unsigned char { Scene, Object, Material, Light, Ambient, Camera };
    Kind kind = Kind::Scene;
    std::size_t index = 0;  // of the object or light
    bool operator==(const SceneItem&) const = default;
};

// Whether a scene has that object or light.
bool isIn(const pipeline::Scene& scene, const SceneItem& item);

// A row of the scene tree.
struct OutlineRow {
    SceneItem item;
    QString name;    // "light 0"
    QString detail;  // "at infinity, 100"
};

// The scene's rows from top to bottom: first the scene itself, then its parts.
std::vector<OutlineRow> outline(const pipeline::Scene& scene);

// The settings of one part, in the order of the table. For the scene itself: the settings of the picture and the rules
// for leaving out.
std::vector<pipeline::SettingRef> settingsOf(const pipeline::Scene& scene, const SceneItem& item);
// The settings of a group of the whole scene: shading, depth, shadow.
std::vector<pipeline::SettingRef> settingsOf(const pipeline::Scene& scene, pipeline::SettingGroup group);

}  // namespace app
