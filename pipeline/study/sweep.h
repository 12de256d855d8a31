#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/study/study.h"

namespace pipeline {

// Which settings a study varies, and over what.

// More points than this are refused.
inline constexpr std::size_t kMaxStudyPoints = 10'000;

// The settings that a sweep's key stands for in a scene: one, or with '#' for the index the same one of every light or
// object. What stands before "#." may be left out where nothing else has that name: "tessellation" is
// "object.#.tessellation".
Result<std::vector<SettingRef>> sweptSettings(const Scene& scene, std::string_view key);

// "KEY=VALUES": values by comma, each one as --set takes it, or of numbers a range
//   4..7     4, 5, 6, 7
//   0..1+0.25   in steps
//   4..64*2  4, 8, 16, 32, 64
// or "all" of a choice. Values come out as formatSetting writes them; the same one twice is refused.
Result<SweepAxis> parseSweep(const Scene& scene, std::string_view text);

// What a study is to go through.
struct Sweep {
    std::vector<SweepAxis> axes;
    std::optional<ErrorChoice> choice;  // of a ready-made sweep
};
// Several of them, each once, or the name of one ready-made sweep and axes to add to it. Refused as well: more points
// than kMaxStudyPoints, a setting that two keys stand for, and an axis without effect, whatever choice the other axes make.
Result<Sweep> parseSweeps(const Scene& scene, std::span<const std::string> texts);

// Points of a sweep: the product of the axes, the last one fastest.
std::size_t pointCount(std::span<const SweepAxis> axes);
std::vector<std::string> valuesOf(std::span<const SweepAxis> axes, std::size_t number);

// The scene with an axis' settings at these values, or what checkScene says against it.
Result<Scene> sceneAt(const Scene& scene, std::span<const SweepAxis> axes, std::span<const std::string> values);

// A sweep that has a name, made for a scene.
struct NamedSweep {
    std::string_view name;     // "shading"
    std::string_view meaning;  // one sentence
    ErrorChoice choice;        // what it is about; of lights the first, see choiceOf
    std::vector<std::string> (*sweeps)(
        const Scene&);       // as --sweep takes them; none where the scene has nothing to vary
    std::string_view needs;  // what the scene lacks then
};
std::span<const NamedSweep> namedSweeps();
const NamedSweep* findNamedSweep(std::string_view name);
// What it is about in this scene: of lights the first that the sweep changes anything of.
ErrorChoice choiceOf(const NamedSweep& sweep, const Scene& scene);

}  // namespace pipeline
