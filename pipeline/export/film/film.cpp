#include "pipeline/export/film/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <system_error>

#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/buffers/byte_file.h"
#include "pipeline/export/buffers/png_file.h"
#include "pipeline/export/film/film_text.h"
#include "pipeline/export/film/gif_file.h"
#include "pipeline/export/folder/contents.h"
#include "pipeline/export/folder/staging.h"
#include "pipeline/export/json/json.h"

namespace pipeline {
namespace {

constexpr int kCaptionHeight = 30, kLetters = 15, kMargin = 10;  // pixels

std::string groups(std::int64_t number) {
    std::string text = std::to_string(number);
    for (std::ptrdiff_t i = std::ptrdiff_t(text.size()) - 3; i > 0; i -= 3) text.insert(std::size_t(i), 1, ' ');
    return text;
}

struct Caption {
    std::string left, right;
};
Caption captionOf(const Steps& steps, Moment moment, StepLevel level) {
    const std::string stage(stageInfo(moment.stage).label), words = steps.words(moment, level);
    const Steps::Progress made = steps.progress(moment);
    return {words.starts_with(stage) ? words : fmt::format("{}: {}", stage, words),
            fmt::format("{} of {} {}", groups(made.done), groups(made.of), made.unit)};
}

// Writes the caption into the rows from `top` on. The right half gives way where both have no room.
void write(const Caption& caption, int top, Buffer2D<Color8>& picture) {
    const int width = picture.size.x;
    FilmText strip(width, kCaptionHeight);
    strip.setFace(FilmText::Face::Words, kLetters);
    const double base = kCaptionHeight / 2.0 + 0.35 * kLetters;
    strip.write(kMargin, base, caption.left);
    const double right = width - kMargin - strip.widthOf(caption.right);
    if (right > 2 * kMargin + strip.widthOf(caption.left)) strip.write(right, base, caption.right);
    strip.copyTo(picture, top);
}

struct Look {
    glm::ivec2 size;
    PaletteRange range;
    std::size_t lines;  // of the longest algorithm; 0: none is shown
    int below = 0;      // the picture, pixels
};
Look lookOf(const Steps& steps, const FilmRequest& request) {
    const AnyBuffer whole = *steps.frame()->buffer(request.buffer);
    Look look{{int(whole.columns()), int(whole.rows())},
              fittingRange(whole, statistics(whole), steps.frame()->scene().settings.depthFormat),
              0};
    if (request.algorithm)
        for (const Algorithm& algorithm : steps.algorithms()) look.lines = std::max(look.lines, algorithm.lines.size());
    look.below = (look.lines > 0 ? algorithmStripHeight(look.lines) : 0) + (request.captions ? kCaptionHeight : 0);
    return look;
}

Buffer2D<Color8> picture(const Steps& steps, Moment moment, const FilmRequest& request, const Look& look) {
    Buffer2D<Color8> out({look.size.x, look.size.y + look.below}, Color8(0));
    const FramePtr frame = steps.frameAt(moment);
    if (const auto buffer = frame->buffer(request.buffer))
        for (int y = 0; y < look.size.y; ++y)
            for (int x = 0; x < look.size.x; ++x)
                out.at({x, y}) = elementColor(*buffer, std::size_t(x), std::size_t(y), look.range);
    if (look.lines > 0) drawAlgorithmStrip(steps.algorithmAt(moment), look.lines, look.size.y, out);
    if (request.captions) write(captionOf(steps, moment, request.level), out.size.y - kCaptionHeight, out);
    return out;
}

// The lines between moments that are ends of steps, where all of them are at most so many pictures; else the moments.
std::vector<Moment> withLines(const Steps& steps, const std::vector<Moment>& moments, std::size_t most) {
    std::vector<Moment> all{moments.front()};
    while (all.back() < moments.back() && all.size() <= most) {
        const auto next = steps.next(all.back(), StepLevel::Line);
        if (!next) break;
        all.push_back(std::min(*next, moments.back()));
    }
    return all.size() <= most ? all : moments;
}

std::string pictureName(std::size_t number) { return fmt::format("step_{:04}.png", number); }

// step_ and four digits or more.
bool isPictureName(std::string_view name) {
    constexpr std::string_view kBefore = "step_", kAfter = ".png";
    if (name.size() < kBefore.size() + 4 + kAfter.size() || !name.starts_with(kBefore) || !name.ends_with(kAfter))
        return false;
    name = name.substr(kBefore.size(), name.size() - kBefore.size() - kAfter.size());
    return std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
}

constexpr const char* kFilm = "film.json";

// What film.json says of a film whose pictures are in `folder`.
std::string filmText(const Steps& steps, const FilmRequest& request, const std::vector<Moment>& moments,
                     const std::filesystem::path& folder) {
    std::vector<std::string> names;
    Json places = Json::array();
    for (std::size_t i = 0; i < moments.size(); ++i) {
        names.push_back(pictureName(i + 1));
        places.push_back(text(steps.placeOf(moments[i])));
    }
    const Scene& scene = steps.frame()->scene();
    const Json film{{"program", programMark()},
                    {"scene", sceneToJson(scene)},
                    {"settings", settingsToJson(scene)},
                    {"buffer", request.buffer.text()},
                    {"by", name(request.level)},
                    {"places", places},
                    {"contents", contentsOf(folder, names)}};
    return film.dump(2) + '\n';
}

// The pictures of the film before that the new one does not write.
std::vector<std::string> picturesToGo(const std::filesystem::path& folder, const Json& earlier, std::size_t pictures) {
    std::vector<std::string> names = namesIn(earlier);
    const std::vector<std::string> onTheirWay = namesIn(readIndex(folder, unfinishedName(kFilm)));
    names.insert(names.end(), onTheirWay.begin(), onTheirWay.end());
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    std::erase_if(names, [&](const std::string& name) {
        std::error_code ignored;
        const bool isNew = name.size() == pictureName(1).size() && name <= pictureName(pictures);
        return !isPictureName(name) || isNew || !std::filesystem::is_regular_file(folder / name, ignored);
    });
    return names;
}

// How many pictures the folder goes on with behind its first `pictures`.
std::size_t countBehind(const std::filesystem::path& folder, std::size_t pictures) {
    std::size_t behind = 0;
    std::error_code error;
    while (std::filesystem::exists(folder / pictureName(pictures + behind + 1), error)) ++behind;
    return behind;
}

}  // namespace

std::vector<Moment> filmMoments(const Steps& steps, const FilmRequest& request) {
    const Moment to = steps.fitting(request.to);
    std::vector<Moment> all{steps.fitting(request.from)};
    for (std::size_t stage = index(all[0].stage); stage <= index(to.stage); ++stage) {
        const StageId id = kStages[stage];
        std::vector<std::int64_t> ends = steps.ends(id, request.level, std::numeric_limits<std::int64_t>::max());
        if (steps.runs(id) && steps.total(id) == 0) ends.push_back(0);  // as `next` has it
        for (const std::int64_t end : ends)
            if (const Moment moment{id, end}; all.back() < moment && moment < to) all.push_back(moment);
    }
    if (all.back() < to) all.push_back(to);
    const std::size_t most = std::max<std::size_t>(2, request.pictures);
    if (request.level == StepLevel::Line) all = withLines(steps, all, most);
    if (all.size() <= most) return all;
    std::vector<Moment> some;
    for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * (all.size() - 1) / (most - 1)]);
    return some;
}

std::vector<std::string> filmFiles(const Steps& steps, const FilmRequest& request) {
    std::vector<std::string> names;
    for (std::size_t i = 0, count = filmMoments(steps, request).size(); i < count; ++i)
        names.push_back(pictureName(i + 1));
    names.emplace_back(kFilm);
    return names;
}

bool isGif(const std::filesystem::path& target) { return sameLetters(target.extension().string(), ".gif"); }

std::filesystem::path firstFileOf(const std::filesystem::path& target) {
    return isGif(target) ? target : target / pictureName(1);
}

Buffer2D<Color8> filmPicture(const Steps& steps, Moment moment, const FilmRequest& request) {
    return picture(steps, moment, request, lookOf(steps, request));
}

Result<FilmSummary> writeFilm(const Steps& steps, const FilmRequest& request, const std::filesystem::path& target,
                              const FilmProgress& progress) {
    const std::vector<Moment> moments = filmMoments(steps, request);
    const Look look = lookOf(steps, request);
    const bool single = isGif(target);
    const auto parent = target.parent_path().empty() ? std::filesystem::path(".") : target.parent_path();
    auto staging = Staging::begin(single ? parent : target);
    if (!staging) return staging.errors();
    Staging hidden = std::move(staging).value();
    FilmSummary summary;
    const auto goOn = [&](std::size_t i) { return !progress || progress(i, moments.size()); };
    const auto cancelled = [] { return FilmSummary{.cancelled = true}; };
    std::optional<GifFile> gif;
    if (single) gif.emplace(hidden.folder() / target.filename(), look.size + glm::ivec2(0, look.below));
    for (std::size_t i = 0; i < moments.size(); ++i) {
        if (!goOn(i)) return cancelled();
        const Buffer2D<Color8> image = picture(steps, moments[i], request, look);
        ++summary.pictures;
        if (gif) {
            gif->add(image, request.milliseconds * (i + 1 == moments.size() ? 10 : 1));
            continue;
        }
        ByteFile file(hidden.folder() / pictureName(i + 1));
        file.write(pngOf(image));
        const auto bytes = file.close();
        if (!bytes) return inFolder(bytes.errors(), target);
        summary.bytes += *bytes;
    }
    if (gif) {
        const auto bytes = gif->close();
        if (!bytes) return inFolder(bytes.errors(), target.parent_path());
        summary.bytes = *bytes;
        if (const auto done = hidden.publish(); !done) return done.errors();
        return summary;
    }
    ByteFile index(hidden.folder() / kFilm);
    index.write(filmText(steps, request, moments, hidden.folder()));
    const auto bytes = index.close();
    if (!bytes) return inFolder(bytes.errors(), target);
    summary.bytes += *bytes;
    hidden.waitForOthers();
    const Json earlier = readIndex(target, kFilm);
    summary.inDoubt = whyInDoubt(target, kFilm, earlier);
    summary.removed = picturesToGo(target, earlier, summary.pictures);
    if (const auto done = hidden.publish(summary.removed, kFilm); !done) return done.errors();
    summary.behind = countBehind(target, summary.pictures);
    return summary;
}

}  // namespace pipeline
