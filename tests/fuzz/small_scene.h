#pragma once
#include "pipeline/formats/toml/toml_scene.h"
#include "tests/fuzz/promises.h"

namespace fuzz {

// A box before the eye, 16 × 12 pixels: what a text may speak of, drawn in next to no time.
inline pipeline::Scene smallScene() {
    constexpr std::string_view kText =
        "width = 16\nheight = 12\n"
        "[camera]\nkind = \"look-at\"\neye = [3, -5, 2]\n"
        "[[light]]\nposition = [4, -4, 4]\nintensity = 100\n"
        "[[object]]\nshape = \"box\"\n";
    const auto scene = pipeline::readTomlScene({kText, "small.toml"}, [](std::string_view name) {
        return pipeline::Result<pipeline::NamedFile>(pipeline::Error{{}, "no file " + std::string(name)});
    });
    require(bool(scene));
    return *scene;
}

}  // namespace fuzz
