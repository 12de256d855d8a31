// What a single setting's range cannot say.
#include <algorithm>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "pipeline/core/text.h"
#include "pipeline/scene/any_exponent.h"
#include "pipeline/scene/key_places.h"
#include "pipeline/scene/settings_table.h"

namespace pipeline {

namespace {

constexpr double kFarthest = 1e9;  // world units, as in the settings' ranges: a normal's squared length stays a float

void refuse(Errors& errors, std::vector<std::string> keys, std::string found, std::string expected) {
    errors.emplace_back(SourceLocation(), std::move(found), std::move(expected)).keys = std::move(keys);
}

// The keys of one light, object or material: "light.3.x" …
std::vector<std::string> keysOf(std::string_view kind, std::size_t index, std::span<const std::string_view> names) {
    std::vector<std::string> keys;
    for (const std::string_view name : names) keys.push_back(fmt::format("{}.{}.{}", kind, index, name));
    return keys;
}

void checkRanges(const Scene& scene, Errors& errors) {
    for (const SettingRef& ref : settingsOf(scene)) {
        const double value = ref.get(scene), min = ref.setting->min, max = ref.setting->max;
        if (value >= min && value <= max) continue;  // false for NaN
        refuse(errors, {ref.key()}, fmt::format("{} is {}", ref.key(), shortestText(value)),
               fmt::format("a value from {} to {}", shortestText(min), shortestText(max)));
    }
}

void checkCamera(const Camera& camera, Errors& errors) {
    for (const auto& [key, plane] : {std::pair("camera.near", camera.near), {"camera.far", camera.far}})
        if (plane < 0 && camera.projection == ProjectionKind::Perspective)
            refuse(errors, {key, "camera.projection"}, fmt::format("{} is {}", key, shortestText(plane)),
                   "a distance above 0 in perspective, or 0 for one that is chosen");
    if (camera.near != 0 && camera.far != 0 && camera.near >= camera.far)
        refuse(errors, {"camera.near", "camera.far"}, fmt::format("camera.near is {}", shortestText(camera.near)),
               fmt::format("less than camera.far, which is {}", shortestText(camera.far)));
}

void checkLights(const Scene& scene, Errors& errors) {
    constexpr std::string_view kPlace[] = {"x", "y", "z", "kind"};
    constexpr std::string_view kFacing[] = {"facing_x", "facing_y", "facing_z", "kind"};
    for (std::size_t k = 0; k < scene.lights.size(); ++k)
        if (scene.lights[k].kind == LightKind::AtInfinity && scene.lights[k].position == Vec3d(0.0))
            refuse(errors, keysOf("light", k, kPlace),
                   fmt::format("light {} is at infinity in the direction (0, 0, 0)", k),
                   "a direction that is not zero");
        else if (scene.lights[k].kind == LightKind::Area && scene.lights[k].area.facing == Vec3d(0.0))
            refuse(errors, keysOf("light", k, kFacing), fmt::format("area light {} faces the direction (0, 0, 0)", k),
                   "a direction that is not zero");
}

thread_local int anyExponents = 0;

// What the model refuses.
void checkModel(const Scene& scene, Errors& errors) {
    const ModelFacts& model = modelFacts(scene.settings.model);
    constexpr std::string_view kSpot[] = {"spot_x", "spot_y", "spot_z", "spot_cutoff"};
    const auto withModel = [&](std::vector<std::string> keys, std::string found, std::string expected) {
        keys.emplace_back(tableOf(keys.front()));
        keys.emplace_back("model");
        refuse(errors, std::move(keys), std::move(found), std::move(expected));
    };
    for (std::size_t k = 0; model.found.glLights && k < scene.lights.size(); ++k) {
        const OpenGlLight& gl = scene.lights[k].gl;
        const std::string cutoff = fmt::format("light.{}.spot_cutoff", k);
        if (gl.spotCutoff > 90 && gl.spotCutoff != 180)
            withModel({cutoff}, fmt::format("{} is {}", cutoff, shortestText(gl.spotCutoff)),
                      "an angle from 0 to 90, or 180 for no spot");
        if (gl.spotCutoff != 180 && gl.spotDirection == Vec3d(0))
            withModel(keysOf("light", k, kSpot), fmt::format("the spot of light {} points nowhere", k),
                      "a direction that is not zero");
    }
    if (model.mostLights && scene.lights.size() > std::size_t(*model.mostLights))
        withModel({fmt::format("light.{}", *model.mostLights)}, fmt::format("{} lights", scene.lights.size()),
                  fmt::format("at most {} in {}", *model.mostLights, model.name));
    const auto checkExponent = [&](const std::string& key, const Material& material) {
        if (anyExponents == 0 && model.mostExponent && material.exponent > *model.mostExponent)
            withModel({key}, fmt::format("{} is {}", key, shortestText(material.exponent)),
                      fmt::format("at most {} in {}", shortestText(*model.mostExponent), model.name));
    };
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        checkExponent(fmt::format("material.{}.n", i), scene.objects[i].material);
        if (const auto& back = scene.objects[i].backMaterial)
            checkExponent(fmt::format("back_material.{}.n", i), *back);
    }
}

// No vertex may end up so far away that the squares of the stages overflow.
void checkExtent(const Scene& scene, Errors& errors) {
    constexpr std::string_view kScale[] = {"sx", "sy", "sz"}, kTranslation[] = {"tx", "ty", "tz"};
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const Vec3d largest = glm::max(glm::abs(object.mesh->facts.low), glm::abs(object.mesh->facts.high));
        const double size = glm::length(largest * object.transform.scale);
        const double away = glm::length(object.transform.translation);
        if (size + away <= kFarthest) continue;  // false for NaN
        std::vector<std::string> keys = keysOf("object", i, away > size ? kTranslation : kScale);
        std::ranges::move(keysOf("object", i, away > size ? kScale : kTranslation), std::back_inserter(keys));
        refuse(errors, std::move(keys),
               fmt::format("object {} reaches {} world units", i, textBeyond(size + away, kFarthest)),
               fmt::format("at most {}", shortestText(kFarthest)));
    }
}

}  // namespace

AnyExponent::AnyExponent() { ++anyExponents; }
AnyExponent::~AnyExponent() { --anyExponents; }

Errors checkScene(const Scene& scene) {
    Errors errors;
    checkRanges(scene, errors);
    checkCamera(scene.camera, errors);
    checkLights(scene, errors);
    checkModel(scene, errors);
    checkExtent(scene, errors);
    if (errors.size() > kMaxErrors) errors.resize(kMaxErrors);
    return errors;
}

}  // namespace pipeline
