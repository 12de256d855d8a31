#include "app/document/scene_outline.h"

#include <algorithm>
#include <iterator>

#include "app/look/numbers.h"
#include "app/look/shown_name.h"

namespace app {
namespace {

using pipeline::Scene;
using pipeline::SettingGroup;
using pipeline::SettingRef;

QString plural(std::size_t n, const QString& one, const QString& many) {
    return QStringLiteral("%1 %2").arg(count(qint64(n)), n == 1 ? one : many);
}

SettingGroup groupOf(SceneItem::Kind kind) {
    switch (kind) {
        case SceneItem::Kind::Object: return SettingGroup::Object;
        case SceneItem::Kind::Material: return SettingGroup::Material;
        case SceneItem::Kind::Light: return SettingGroup::Light;
        case SceneItem::Kind::Ambient: return SettingGroup::Ambient;
        case SceneItem::Kind::Camera: return SettingGroup::Camera;
        case SceneItem::Kind::Scene: break;
    }
    return SettingGroup::Picture;
}

}  // namespace

bool isIn(const Scene& scene, const SceneItem& item) {
    switch (item.kind) {
        case SceneItem::Kind::Object:
        case SceneItem::Kind::Material: return item.index < scene.objects.size();
        case SceneItem::Kind::Light: return item.index < scene.lights.size();
        case SceneItem::Kind::Scene:
        case SceneItem::Kind::Ambient:
        case SceneItem::Kind::Camera: break;
    }
    return true;
}

std::vector<OutlineRow> outline(const Scene& scene) {
    using Kind = SceneItem::Kind;
    std::vector<OutlineRow> rows;
    rows.push_back({{Kind::Scene, 0},
                    onOneLine(scene.name),
                    QStringLiteral("%1 × %2").arg(scene.settings.width).arg(scene.settings.height)});
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const pipeline::Object& object = scene.objects[i];
        rows.push_back({{Kind::Object, i},
                        onOneLine(object.name),
                        plural(object.mesh->positions.size(), "vertex", "vertices") + ", " +
                            plural(object.mesh->polygonCount(), "polygon", "polygons")});
        rows.push_back({{Kind::Material, i}, QStringLiteral("material %1").arg(i), "of " + onOneLine(object.name)});
    }
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const pipeline::Light& light = scene.lights[i];
        const QString kind = light.kind == pipeline::LightKind::AtInfinity ? "at infinity"
                             : light.kind == pipeline::LightKind::Area     ? "area"
                                                                           : "point";
        rows.push_back({{Kind::Light, i}, QStringLiteral("light %1").arg(i), kind + ", " + sixDigits(light.intensity)});
    }
    rows.push_back({{Kind::Ambient, 0}, "ambient light", sixDigits(scene.ambient.intensityIn(scene.settings.model))});
    rows.push_back(
        {{Kind::Camera, 0}, "camera", scene.camera.kind == pipeline::CameraKind::Spherical ? "spherical" : "look-at"});
    return rows;
}

std::vector<SettingRef> settingsOf(const Scene& scene, SettingGroup group) {
    std::vector<SettingRef> settings;
    for (const SettingRef& setting : pipeline::settingsOf(scene))
        if (setting.setting->group == group) settings.push_back(setting);
    return settings;
}

std::vector<SettingRef> settingsOf(const Scene& scene, const SceneItem& item) {
    std::vector<SettingRef> settings = settingsOf(scene, groupOf(item.kind));
    std::erase_if(settings, [&](const SettingRef& setting) { return setting.index != item.index; });
    if (item.kind == SceneItem::Kind::Scene)
        for (const SettingGroup group : {SettingGroup::Numerics, SettingGroup::LeavingOut})
            std::ranges::copy(settingsOf(scene, group), std::back_inserter(settings));
    return settings;
}

}  // namespace app
