#include "pipeline/steps/moment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include "pipeline/core/index_words.h"
#include "pipeline/core/text.h"

namespace pipeline {
namespace {

constexpr std::array<std::string_view, kStepLevelCount> kLevels{"stage",    "object", "polygon",
                                                                "scanline", "pixel",  "line"};

// The keys that may precede a number, for each stage.
struct Key {
    std::string_view word;
    ElementKind kind;
    std::array<bool, kStageCount> in;  // transform, cull, normals, shadow buffer, z-buffer, shading
};
constexpr std::array<Key, 5> kKeys{{
    {"vertex", ElementKind::Vertex, {true, false, true, false, false, false}},
    {"polygon", ElementKind::Polygon, {false, true, true, true, true, true}},
    {"piece", ElementKind::Piece, {false, false, false, false, true, false}},
    {"polygon-terms", ElementKind::PolygonTerms, {false, false, false, false, false, true}},
    {"vertex-terms", ElementKind::VertexTerms, {false, false, false, false, false, true}},
}};

bool hasPixels(StageId stage) { return stage == StageId::ZBuffer || stage == StageId::Shading; }

std::string known(StageId stage) {
    std::string keys = "start, object=";
    for (const Key& key : kKeys)
        if (key.in[index(stage)]) keys += fmt::format(", {}=", key.word);
    if (stage == StageId::ShadowBuffer) keys += ", light=";
    if (hasPixels(stage)) keys += ", row=, x=";
    if (stage == StageId::Shading) keys += ", layers, samples";
    keys += ", line=";
    return keys;
}

std::vector<std::string_view> split(std::string_view text) {
    std::vector<std::string_view> parts;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t slash = std::min(text.find('/', at), text.size());
        parts.push_back(text.substr(at, slash - at));
        at = slash + 1;
    }
    return parts;
}

// A number from 0 to 2³¹ − 1 that is the whole text, else -1.
int number(std::string_view digits) {
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || value < 0) return -1;
    return value;
}

// Reads one part, "polygon=2". Returns the error, or an empty string.
std::string take(std::string_view part, Place& place) {
    using What = Place::What;
    const bool unset = place.what == What::End;
    if (part == "start" && unset) return place.what = What::Start, "";
    if (place.stage == StageId::Shading && unset && (part == "layers" || part == "samples")) {
        place.what = What::Element;
        place.kind = part == "layers" ? ElementKind::Layers : ElementKind::Samples;
        return "";
    }
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string_view word = part.substr(0, equals);
    const int value = equals < part.size() ? number(part.substr(equals + 1)) : -1;
    std::string wrong = fmt::format("found {} in a place in {}", inQuotes(part), stageInfo(place.stage).name);
    if (value < 0) return wrong;
    if (word == "light" && place.stage == StageId::ShadowBuffer && place.light < 0) return place.light = value, "";
    if (word == "object" && unset) return place.what = What::Object, place.number = value, "";
    const auto key = std::ranges::find(kKeys, word, &Key::word);
    if (key != kKeys.end() && key->in[index(place.stage)] && unset) {
        place.what = What::Element, place.kind = key->kind, place.number = value;
        return "";
    }
    const bool rows = hasPixels(place.stage) && place.what == What::Element &&
                      (place.kind == ElementKind::Polygon || place.kind == ElementKind::Piece);
    if (word == "row" && rows && !place.row && !place.line) return place.row = value, "";
    if (word == "x" && place.row && !place.x && !place.line) return place.x = value, "";
    const bool counted = value > 0 && place.what == Place::What::Element;  // counted from 1
    if (word == "line" && counted && !place.line) return place.line = value, "";
    if (word == "time" && counted && place.line && place.time == 1) return place.time = value, "";
    return wrong;
}

}  // namespace

std::string_view name(StepLevel level) { return kLevels[std::size_t(level)]; }

std::optional<StepLevel> findStepLevel(std::string_view name) {
    const auto found = std::ranges::find(kLevels, name);
    if (found == kLevels.end()) return std::nullopt;
    return StepLevel(found - kLevels.begin());
}

std::string_view name(ElementKind kind) {
    if (kind == ElementKind::Layers) return "layers";
    if (kind == ElementKind::Samples) return "samples";
    return std::ranges::find(kKeys, kind, &Key::kind)->word;
}

std::string text(const Place& place) {
    std::string text(stageInfo(place.stage).name);
    if (place.light >= 0) text += fmt::format("/light={}", place.light);
    switch (place.what) {
        case Place::What::End: return text;
        case Place::What::Start: return text + "/start";
        case Place::What::Object: return text + fmt::format("/object={}", place.number);
        case Place::What::Element: break;
    }
    text += fmt::format("/{}", name(place.kind));
    if (place.kind != ElementKind::Layers && place.kind != ElementKind::Samples)
        text += fmt::format("={}", place.number);
    if (place.row) text += fmt::format("/row={}", *place.row);
    if (place.x) text += fmt::format("/x={}", *place.x);
    if (place.line) text += fmt::format("/line={}", *place.line);
    if (place.time > 1) text += fmt::format("/time={}", place.time);
    return text;
}

Result<Place> parsePlace(std::string_view text) {
    const std::vector<std::string_view> parts = split(text);
    const std::optional<StageId> stage = findStage(parts[0]);
    if (!stage) {
        std::vector<std::string> names;
        names.reserve(kStages.size());
        for (const StageId id : kStages) names.emplace_back(stageInfo(id).name);
        return Error{{}, fmt::format("no stage {}", inQuotes(parts[0])), fmt::format("{}", fmt::join(names, ", "))};
    }
    Place place;
    place.stage = *stage;
    for (std::size_t i = 1; i < parts.size(); ++i)
        if (std::string wrong = take(parts[i], place); !wrong.empty())
            return Error{{}, std::move(wrong), known(*stage)};
    return place;
}

Result<Place> parsePlace(std::string_view text, const Scene& scene) {
    Result<Place> place = parsePlace(text);
    if (!place) return place;
    std::int64_t vertices = 0, polygons = 0;
    for (const Object& object : scene.objects)
        vertices += std::int64_t(object.mesh->positions.size()), polygons += std::int64_t(object.mesh->polygonCount());
    std::optional<Error> wrong;
    const auto need = [&](std::string_view what, std::int64_t number, std::int64_t count) {
        if (number >= count && !wrong)
            wrong = Error{{},
                          fmt::format("found {}, and the scene has {} {}", inQuotes(text), count, what),
                          count == 0 ? "another place" : indexWords(std::size_t(count))};
    };
    if (place->stage == StageId::ShadowBuffer) need("lights", place->light, std::int64_t(scene.lights.size()));
    if (place->what == Place::What::Object) need("objects", place->number, std::int64_t(scene.objects.size()));
    if (place->what == Place::What::Element) {
        const ElementKind kind = place->kind;
        if (kind == ElementKind::Vertex || kind == ElementKind::VertexTerms) need("vertices", place->number, vertices);
        if (kind == ElementKind::Polygon || kind == ElementKind::PolygonTerms)
            need("polygons", place->number, polygons);
    }
    if (place->row) need("rows of pixels", *place->row, scene.settings.height);
    if (place->x) need("columns of pixels", *place->x, scene.settings.width);
    if (wrong) return *wrong;
    return place;
}

}  // namespace pipeline
