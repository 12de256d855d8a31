#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"
#include "pipeline/scene/settings_table.h"

namespace lessons {

// Spot the technique: pictures of one scene that differ in one setting alone. Somebody names the value behind each. The
// questions are made from the scenes that come with the program and the table of settings; nothing is typed.

// What a round may be about: a setting of which a picture can tell the value.
struct DrillKind {
    std::string_view name, key, asked;  // "shadow", "light.#.shadow", "Which picture has the shadow?"
};
std::span<const DrillKind> drillKinds();

struct DrillRound {
    const DrillKind* kind = nullptr;
    std::string scene, title;  // its name, and what it is called
    pipeline::SettingRef setting;
    struct Picture {
        std::string value;  // of the setting, as --set takes it
        pipeline::FramePtr frame;
    };
    std::vector<Picture> pictures;  // 2 or 3, in the order in which they are shown
    glm::ivec2 pixel{0};            // that gives it away: where two of their colours differ most
    double share = 0;               // the least share of drawn pixels that differ visibly between two of the pictures
};

// A difference that is seen: 8 of 255 in some channel, at 0.5 % of the pixels that either picture draws. A design figure.
inline constexpr int kSeenStep = 8;
inline constexpr double kSeenShare = 0.005;

// Of these kinds, by their names; none: all. The same seed gives the same rounds on every machine, and no scene with the
// same setting comes twice before all have come. Errors: an unknown kind, with the nearest; that no scene shows a
// difference which is seen; "stopped".
pipeline::Result<std::vector<DrillRound>> makeDrill(std::uint64_t seed, std::size_t rounds,
                                                    const std::vector<std::string>& kinds,
                                                    const pipeline::Stop& stop = {},
                                                    const std::function<void(std::size_t round)>& progress = {});

// On paper: drill.html with the pictures, drill-answers.html with the names, the pixel and its equation in each picture.
struct DrillPages {
    std::string questions, answers;
};
DrillPages drillPages(std::uint64_t seed, std::span<const DrillRound> rounds);
std::vector<std::string> drillFiles();  // their names
// Both or none. Gives their names.
pipeline::Result<std::vector<std::string>> writeDrill(const DrillPages& pages, const std::filesystem::path& folder);

}  // namespace lessons
