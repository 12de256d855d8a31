#include "pipeline/formats/format_table.h"

#include <algorithm>
#include <array>

#include "pipeline/core/text.h"
#include "pipeline/formats/lecture/lecture_formats.h"
#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/model_scene.h"
#include "pipeline/formats/png_scene.h"
#include "pipeline/formats/toml/toml_scene.h"

namespace pipeline {
namespace {

// Models are known by their extension alone: a binary one may begin with any bytes.
bool hasNoMark(std::string_view) { return false; }

constexpr auto kFormats = std::to_array<Format>({
    // Before the scene: numbers alone are an object rather than a scene without objects, unless the extension says so.
    {"object description", ".des", looksLikeLectureObject, readLectureObject},
    {"scene description", ".scene", looksLikeLectureScene, readLectureScene},
    {"TOML scene", ".toml", looksLikeTomlScene, readTomlScene},
    {"Wavefront model", ".obj", hasNoMark, readModelScene},
    {"polygon file", ".ply", hasNoMark, readModelScene},
    {"stereolithography file", ".stl", hasNoMark, readModelScene},
    {"Object File Format", ".off", hasNoMark, readModelScene},
    {"glTF model", ".gltf", hasNoMark, readModelScene},
    {"binary glTF model", ".glb", hasNoMark, readModelScene},
    {"picture that carries its scene", ".png", looksLikePng, readPngScene},
});

}  // namespace

std::span<const Format> formatTable() { return kFormats; }

const Format* findFormat(std::string_view start, std::string_view extension) {
    const Format* first = nullptr;
    const Format* named = nullptr;
    for (const Format& format : kFormats) {
        const bool fits = format.looksLike(start), isNamed = sameLetters(format.extension, extension);
        if (isNamed && (fits || isModel(extension))) return &format;
        if (fits && !first) first = &format;
        if (isNamed) named = &format;
    }
    return first ? first : named;
}

std::string knownFormats() {
    std::string text;
    for (const Format& format : kFormats) {
        if (!text.empty()) text += &format == &kFormats.back() ? " or " : ", ";
        text += std::string("aeiou").find(format.name[0]) == std::string::npos ? "a " : "an ";
        text += std::string(format.name) + " (" + std::string(format.extension) + ")";
    }
    return text;
}

}  // namespace pipeline
