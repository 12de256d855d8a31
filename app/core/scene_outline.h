#pragma once
#include <QString>
#include <vector>

#include "pipeline/scene/settings_table.h"

namespace app {

// A thing of the scene that can be selected.
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

// The scene's rows from top to bottom; the first is the scene itself, the others are its parts.
std::vector<OutlineRow> outline(const pipeline::Scene& scene);

// The settings of one thing, in the order of the table. Of the scene itself: those of the picture,
// and what is left out of it.
std::vector<pipeline::SettingRef> settingsOf(const pipeline::Scene& scene, const SceneItem& item);
// The settings of a group that belongs to the scene as a whole: shading, depth, shadow.
std::vector<pipeline::SettingRef> settingsOf(const pipeline::Scene& scene, pipeline::SettingGroup group);

}  // namespace app
