#include "lessons/games/drill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <fmt/format.h>

#include "pipeline/core/text.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/run/runner.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::Result;
using pipeline::SettingRef;

constexpr std::array<DrillKind, 8> kDrillKinds{{
    {"shading", "shading", "Which shading has drawn which picture?"},
    {"model", "model", "Which illumination model has lit which picture?"},
    {"cull", "cull", "Which picture is drawn with which culling?"},
    {"visibility", "visibility", "Which algorithm has decided what is in front in which picture?"},
    {"precision", "depth_format", "Which number does the z-buffer of which picture store?"},
    {"interpolation", "interpolation", "How are values interpolated in which picture?"},
    {"shadow", "light.#.shadow", "In which picture does the light cast a shadow?"},
    {"bias", "shadow.bias", "Which bias has the shadow comparison of which picture?"},
}};
constexpr std::size_t kMostPictures = 3;

// A scene with one of its settings.
struct Candidate {
    const DrillKind* kind = nullptr;
    pipeline::BuiltInScene scene;
};

// The library's distributions are not the same on every machine.
template <class T>
void shuffled(std::vector<T>& values, std::mt19937_64& random) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random() % i]);
}

std::optional<SettingRef> settingOf(const DrillKind& kind, const pipeline::Scene& scene) {
    std::string key(kind.key);
    if (const std::size_t at = key.find('#'); at != key.npos) key[at] = '0';
    const auto found = pipeline::findSetting(scene, key);
    return found && found->setting->idle(scene).empty() ? std::optional(*found) : std::nullopt;
}

pipeline::FramePtr pictureOf(pipeline::Scene scene, const pipeline::Stop& stop) {
    scene.settings.leaveOut = true;
    pipeline::FrameRequest request;
    request.wanted.set(index(pipeline::BufferId::Color));
    request.wanted.set(index(pipeline::BufferId::PolygonId));
    request.stop = stop;
    return runFrame(std::make_shared<const pipeline::Scene>(std::move(scene)), request, nullptr);
}

// Of two pictures: at which share of what they draw they differ visibly, and where most.
struct Seen {
    double share = 0;
    int most = 0;
    glm::ivec2 pixel{0};
};
Seen seenBetween(const pipeline::Frame& a, const pipeline::Frame& b) {
    const auto colorA = a.buffer({pipeline::BufferId::Color}), colorB = b.buffer({pipeline::BufferId::Color});
    const auto idA = a.buffer({pipeline::BufferId::PolygonId}), idB = b.buffer({pipeline::BufferId::PolygonId});
    Seen seen;
    if (!colorA || !colorB || !idA || !idB) return seen;
    const std::size_t width = colorA->columns(), height = colorA->rows();
    std::vector<int> apart(width * height);  // where both draw: an equation needs a surface; else 0
    std::size_t drawn = 0, differing = 0;
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const bool inA = idA->value(x, y) >= 0, inB = idB->value(x, y) >= 0;
            int most = 0;
            for (int c = 0; c < 3; ++c)
                most = std::max(most, std::abs(int(colorA->value(x, y, c)) - int(colorB->value(x, y, c))));
            drawn += inA || inB;
            differing += (inA || inB) && most >= kSeenStep;
            if (inA && inB) apart[y * width + x] = most;
        }
    if (drawn > 0) seen.share = double(differing) / double(drawn);
    // One inside of what differs, where there is such a pixel: its neighbours differ too.
    bool isInside = false;
    for (std::size_t y = 1; y + 1 < height; ++y)
        for (std::size_t x = 1; x + 1 < width; ++x) {
            const int* const at = &apart[y * width + x];
            const int around = std::min({at[-1], at[1], *(at - width), at[width]});
            const bool inside = *at >= kSeenStep && around >= kSeenStep;
            if (std::pair(inside, *at) > std::pair(isInside, seen.most))
                isInside = inside, seen.most = *at, seen.pixel = {int(x), int(y)};
        }
    return seen;
}
// White where it draws, at more than half of it: brighter than it can show, which tells nothing but that.
bool isWhite(const pipeline::Frame& frame) {
    const auto color = frame.buffer({pipeline::BufferId::Color});
    const auto id = frame.buffer({pipeline::BufferId::PolygonId});
    std::size_t drawn = 0, white = 0;
    for (std::size_t y = 0; color && id && y < color->rows(); ++y)
        for (std::size_t x = 0; x < color->columns(); ++x) {
            if (!(id->value(x, y) >= 0)) continue;
            ++drawn;
            white += color->value(x, y, 0) == 255 && color->value(x, y, 1) == 255 && color->value(x, y, 2) == 255;
        }
    return 2 * white > drawn;
}
bool isSeen(const Seen& seen) { return seen.share >= kSeenShare && seen.most >= kSeenStep; }

// Nothing where no two values of the setting make a difference that is seen, or when stopped.
std::optional<DrillRound> roundOf(const Candidate& candidate, std::mt19937_64& random, const pipeline::Stop& stop) {
    const auto scene = pipeline::readScene(candidate.scene.file, {{}, stop});
    if (!scene) return {};
    const auto setting = settingOf(*candidate.kind, *scene);
    if (!setting) return {};
    std::vector<std::string_view> values(setting->setting->choices.begin(), setting->setting->choices.end());
    shuffled(values, random);
    DrillRound round{candidate.kind, candidate.scene.name, candidate.scene.title, *setting, {}, {}, 1};
    int most = 0;
    for (const std::string_view value : values) {
        if (round.pictures.size() == kMostPictures || stop.stop_requested()) break;
        auto changed = pipeline::withSetting(*scene, fmt::format("{}={}", setting->key(), value));
        if (!changed || !pipeline::checkScene(*changed).empty()) continue;
        pipeline::FramePtr frame = pictureOf(std::move(changed).value(), stop);
        if (!frame) return {};
        if (isWhite(*frame)) continue;
        std::vector<Seen> all;
        for (const DrillRound::Picture& other : round.pictures) all.push_back(seenBetween(*other.frame, *frame));
        if (!std::ranges::all_of(all, isSeen)) continue;
        for (const Seen& seen : all) {
            round.share = std::min(round.share, seen.share);
            if (seen.most > most) most = seen.most, round.pixel = seen.pixel;
        }
        round.pictures.push_back({std::string(value), std::move(frame)});
    }
    return round.pictures.size() < 2 || stop.stop_requested() ? std::nullopt : std::optional(std::move(round));
}

}  // namespace

std::span<const DrillKind> drillKinds() { return kDrillKinds; }

Result<std::vector<DrillRound>> makeDrill(std::uint64_t seed, std::size_t rounds, const std::vector<std::string>& kinds,
                                          const pipeline::Stop& stop,
                                          const std::function<void(std::size_t)>& progress) {
    std::vector<std::string> names;
    for (const DrillKind& kind : kDrillKinds) names.emplace_back(kind.name);
    for (const std::string& kind : kinds)
        if (std::ranges::find(names, kind) == names.end())
            return Error{{}, "no kind " + pipeline::inQuotes(kind) + "; " + pipeline::insteadOf(kind, names), {}};
    std::vector<Candidate> candidates;
    for (const DrillKind& kind : kDrillKinds)
        if (kinds.empty() || std::ranges::find(kinds, kind.name) != kinds.end())
            for (const pipeline::BuiltInScene& scene : pipeline::builtInScenes()) candidates.push_back({&kind, scene});
    std::mt19937_64 random(seed);
    shuffled(candidates, random);
    std::vector<DrillRound> made;
    std::size_t before = 0;  // rounds that were there when the candidates began again
    for (std::size_t i = 0; made.size() < rounds; ++i) {
        if (i > 0 && i % candidates.size() == 0 && made.size() == std::exchange(before, made.size()))
            return Error{{}, "no scene shows a difference of this kind that is seen", "another --kind"};
        if (progress) progress(made.size());
        auto round = roundOf(candidates[i % candidates.size()], random, stop);
        if (stop.stop_requested()) return Error{{}, "stopped", {}};
        if (round) made.push_back(*std::move(round));
    }
    return made;
}

}  // namespace lessons
