#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

enum class SettingKind : std::uint8_t { Number, Integer, Switch, Choice };

// Where a setting stands in the window and in the manual.
enum class SettingGroup : std::uint8_t {
    Picture,
    Camera,
    Shading,
    Depth,
    Shadow,
    Numerics,
    Ambient,
    Light,
    Object,
    Material,
    Defect,
    LeavingOut
};
std::string_view name(SettingGroup group);

// One row makes the --set key, the control in the window, the line of the manifest and of the
// manual. Every value is one number: a switch is 0 or 1, a choice the index into `choices`.
struct Setting {
    std::string_view key;      // "shading"; with '#' for the index of a light or an object: "light.#.x"
    std::string_view label;    // for a control: "k_r red"
    std::string_view unit;     // "degrees", "world units"; empty for a pure number
    std::string_view meaning;  // one sentence
    SettingGroup group;
    SettingKind kind;
    double min, max;                            // inclusive; what is outside is refused
    double low, high;                           // the range of a slider, within [min, max]
    std::span<const std::string_view> choices;  // for Choice; {"off", "on"} for Switch
    std::size_t (*count)(const Scene&);         // 1, or how many lights or objects there are
    double (*get)(const Scene&, std::size_t index);
    void (*set)(Scene&, std::size_t index, double value);
    // Why the setting has no effect in this scene, or empty. It may be changed all the same.
    std::string_view (*idle)(const Scene&);
    // Why this one of the lights or objects does not have the setting, or empty.
    std::string_view (*absent)(const Scene&, std::size_t index) = [](const Scene&, std::size_t) {
        return std::string_view();
    };
};

std::span<const Setting> settingsTable();

// A row with the index that stands for its '#'.
struct SettingRef {
    const Setting* setting = nullptr;
    std::size_t index = 0;
    std::string key() const;  // "light.0.x"
    double get(const Scene& scene) const { return setting->get(scene, index); }
    void set(Scene& scene, double value) const { setting->set(scene, index, value); }
    bool operator==(const SettingRef&) const = default;
};
// Whether a scene has the light or the object that the setting is of.
inline bool isIn(const Scene& scene, const SettingRef& ref) { return ref.index < ref.setting->count(scene); }

// Every setting that a scene has, lights and objects counted out, without what is absent.
std::vector<SettingRef> settingsOf(const Scene& scene);

// A key that does not exist is answered with the nearest one that does.
Result<SettingRef> findSetting(const Scene& scene, std::string_view key);

// Text and value of a setting: "gouraud", "on", "0.25". parse refuses what is out of range,
// not a number, NaN or infinite. format gives the shortest text that parses to the same value.
Result<double> parseSetting(const SettingRef& setting, std::string_view text);
std::string formatSetting(const SettingRef& setting, double value);

// "KEY=VALUE", as --set and lessons write it; assignedKey gives KEY.
std::string_view assignedKey(std::string_view assignment);
Result<Scene> withSetting(Scene scene, std::string_view assignment);

// What a single setting's range cannot say: near < far, sizes within limits. The errors have keys, and no place.
Errors checkScene(const Scene& scene);

}  // namespace pipeline
