#pragma once
#include <span>
#include <string_view>
#include <type_traits>

#include "pipeline/scene/framing.h"
#include "pipeline/scene/settings_table.h"

// How a row of the table of settings is made from a member of the scene; settings_table.cpp alone
// reads it.
namespace pipeline::settings_rows {

using Names = std::span<const std::string_view>;
using Idle = std::string_view (*)(const Scene&);

// The parts of a scene that have settings.
struct OfPicture {
    static constexpr auto group = SettingGroup::Picture;
    static auto& part(auto& scene, std::size_t) { return scene.settings; }
    static std::size_t count(const Scene&) { return 1; }
};
struct OfShading : OfPicture {
    static constexpr auto group = SettingGroup::Shading;
};
struct OfDepth : OfPicture {
    static constexpr auto group = SettingGroup::Depth;
};
struct OfShadow : OfPicture {
    static constexpr auto group = SettingGroup::Shadow;
};
struct OfNumerics : OfPicture {
    static constexpr auto group = SettingGroup::Numerics;
};
struct OfForms : OfNumerics {
    static auto& part(auto& scene, std::size_t) { return scene.settings.forms; }
};
struct OfDefect : OfPicture {
    static constexpr auto group = SettingGroup::Defect;
};
struct OfLeavingOut : OfPicture {
    static constexpr auto group = SettingGroup::LeavingOut;
};
struct OfCamera : OfPicture {
    static constexpr auto group = SettingGroup::Camera;
    static auto& part(auto& scene, std::size_t) { return scene.camera; }
};
struct OfAmbient : OfPicture {
    static constexpr auto group = SettingGroup::Ambient;
    static auto& part(auto& scene, std::size_t) { return scene.ambient; }
};
struct OfLight {
    static constexpr auto group = SettingGroup::Light;
    static auto& part(auto& scene, std::size_t i) { return scene.lights[i]; }
    static std::size_t count(const Scene& scene) { return scene.lights.size(); }
};
struct OfOpenGlLight : OfLight {
    static auto& part(auto& scene, std::size_t i) { return scene.lights[i].gl; }
};
struct OfAreaLight : OfLight {
    static auto& part(auto& scene, std::size_t i) { return scene.lights[i].area; }
};
struct OfObject {
    static constexpr auto group = SettingGroup::Object;
    static auto& part(auto& scene, std::size_t i) { return scene.objects[i].transform; }
    static std::size_t count(const Scene& scene) { return scene.objects.size(); }
};
struct OfMaterial : OfObject {
    static constexpr auto group = SettingGroup::Material;
    static auto& part(auto& scene, std::size_t i) { return scene.objects[i].material; }
};

inline std::string_view neverIdle(const Scene&) { return {}; }

struct Words {
    std::string_view key, label, unit, meaning;
};
struct Range {
    double min, max, low, high;
};

// A number, an integer, a switch or a choice, by the type of the member.
template <class Of, auto Member>
constexpr Setting row(Words words, Range range, Names choices = {}, Idle idle = neverIdle) {
    using Part = std::remove_reference_t<decltype(Of::part(std::declval<Scene&>(), 0))>;
    using T = std::remove_reference_t<decltype(std::declval<Part&>().*Member)>;
    constexpr SettingKind kind = std::is_same_v<T, bool> ? SettingKind::Switch
                                 : std::is_enum_v<T>     ? SettingKind::Choice
                                 : std::is_integral_v<T> ? SettingKind::Integer
                                                         : SettingKind::Number;
    return {words.key,
            words.label,
            words.unit,
            words.meaning,
            Of::group,
            kind,
            range.min,
            range.max,
            range.low,
            range.high,
            choices,
            Of::count,
            [](const Scene& scene, std::size_t i) { return static_cast<double>(Of::part(scene, i).*Member); },
            [](Scene& scene, std::size_t i, double value) { Of::part(scene, i).*Member = static_cast<T>(value); },
            idle};
}

template <class Of, auto Member>
constexpr Setting choice(Words words, Names choices, Idle idle = neverIdle) {
    const double last = static_cast<double>(choices.size() - 1);
    return row<Of, Member>(words, {0, last, 0, last}, choices, idle);
}

// One component of a vector member.
template <class Of, auto Member, int axis>
constexpr Setting component(Words words, Range range, Idle idle = neverIdle) {
    return {words.key,
            words.label,
            words.unit,
            words.meaning,
            Of::group,
            SettingKind::Number,
            range.min,
            range.max,
            range.low,
            range.high,
            {},
            Of::count,
            [](const Scene& scene, std::size_t i) { return (Of::part(scene, i).*Member)[axis]; },
            [](Scene& scene, std::size_t i, double value) { (Of::part(scene, i).*Member)[axis] = value; },
            idle};
}

// A side of the picture: the camera of a framed model follows.
template <auto Member>
constexpr Setting side(Words words, Range range) {
    Setting setting = row<OfPicture, Member>(words, range);
    setting.set = [](Scene& scene, std::size_t, double value) {
        Settings sized = scene.settings;
        sized.*Member = static_cast<int>(value);
        setSize(scene, {sized.width, sized.height});
    };
    return setting;
}

// The up axis of a whole file, which is that of all its objects.
constexpr Setting upAxis(Words words, Names choices) {
    Setting setting = choice<OfObject, &ObjectTransform::up>(words, choices);
    setting.group = OfPicture::group;
    setting.count = OfPicture::count;
    setting.get = [](const Scene& scene, std::size_t) { return static_cast<double>(upOf(scene)); };
    setting.set = [](Scene& scene, std::size_t, double value) { setUp(scene, static_cast<UpAxis>(value)); };
    setting.absent = [](const Scene& scene, std::size_t) -> std::string_view {
        return scene.framed ? "" : "the scene is no model that was opened by itself; object.0.up is that of an object";
    };
    return setting;
}

// I_a: what the model has by itself until it is set.
constexpr Setting ambientIntensity(Words words, Range range) {
    Setting setting = component<OfAmbient, &AmbientLight::color, 0>(words, range);
    setting.get = [](const Scene& scene, std::size_t) { return scene.ambient.intensityIn(scene.settings.model); };
    setting.set = [](Scene& scene, std::size_t, double value) { scene.ambient.intensity = value; };
    return setting;
}

// Remakes the mesh of a built-in shape; a mesh that was read from a file has none.
constexpr Setting tessellation(Words words, Range range, Idle idle) {
    constexpr auto get = [](const Scene& scene, std::size_t i) {
        return static_cast<double>(scene.objects[i].shape.value_or(Shape()).tessellation);
    };
    constexpr auto set = [](Scene& scene, std::size_t i, double value) {
        Object& object = scene.objects[i];
        if (!object.shape || object.shape->tessellation == static_cast<int>(value)) return;
        object.shape->tessellation = static_cast<int>(value);
        object.mesh = makeShape(*object.shape);
    };
    constexpr auto absent = [](const Scene& scene, std::size_t i) -> std::string_view {
        return scene.objects[i].shape ? "" : "the object is a mesh, not a built-in shape";
    };
    return {words.key,
            words.label,
            words.unit,
            words.meaning,
            SettingGroup::Object,
            SettingKind::Integer,
            range.min,
            range.max,
            range.low,
            range.high,
            {},
            OfObject::count,
            get,
            set,
            idle,
            absent};
}

}  // namespace pipeline::settings_rows
