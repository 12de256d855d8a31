// Any bytes as a scene in TOML; what follows a zero byte is every file that the scene names.
#include <cstdint>

#include "pipeline/formats/toml/toml_scene.h"
#include "pipeline/scene/settings_table.h"
#include "tests/fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const fuzz::Input input({reinterpret_cast<const char*>(data), size});
    pipeline::looksLikeTomlScene(input.text);
    pipeline::readTomlTitle(input.text);
    const auto scene = pipeline::readTomlScene({input.text, "s.toml"}, input.loader());
    if (!scene) {
        fuzz::checkErrors(scene.errors());
        return 0;
    }
    for (const pipeline::Object& object : scene->objects) {
        fuzz::checkMesh(*object.mesh);
        fuzz::checkMaterial(object.material);
    }
    // Read without an error, every setting is in its range, and together they are right.
    for (const pipeline::SettingRef& ref : pipeline::settingsOf(*scene)) {
        const double value = ref.get(*scene);
        fuzz::require(value >= ref.setting->min && value <= ref.setting->max);
    }
    fuzz::require(pipeline::checkScene(*scene).empty());
    return 0;
}
