#include <cmath>

#include "lessons/library.h"
#include "lessons/pages/live_data.h"
#include "lessons/pages/live_page.h"
#include "pipeline/buffers/palette.h"
#include "pipeline/core/version.h"
#include "pipeline/export/buffers/png_file.h"
#include "pipeline/export/folder/gzip.h"
#include "pipeline/export/html/html_text.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/settings_table.h"

namespace lessons {

namespace fs = std::filesystem;
using pipeline::Error;
using pipeline::Errors;
using pipeline::Json;
using pipeline::Result;

namespace {

// The picture of a scene, small, as the source of an <img>; empty where it was stopped.
std::string thumbnailOf(const pipeline::Scene& scene, const pipeline::Stop& stop) {
    constexpr int kWidth = 160;
    const double share = double(kWidth) / scene.settings.width;
    pipeline::Scene small = scene;
    for (const pipeline::SettingRef& ref : settingsOf(small))
        if (ref.key() == "camera.scale") ref.set(small, ref.get(small) * share);
    small.settings.width = kWidth, small.settings.height = std::max(1, int(std::lround(scene.settings.height * share)));
    pipeline::FrameRequest request;
    request.wanted = pipeline::setOf({pipeline::BufferId::Color});
    request.stop = stop;
    const auto frame = runFrame(std::make_shared<const pipeline::Scene>(std::move(small)), request, nullptr);
    const auto color = frame ? frame->buffer({pipeline::BufferId::Color}) : std::nullopt;
    if (!color) return {};
    pipeline::Buffer2D<pipeline::Color8> picture({int(color->columns()), int(color->rows())}, pipeline::Color8(0));
    for (std::size_t y = 0; y < color->rows(); ++y)
        for (std::size_t x = 0; x < color->columns(); ++x)
            picture.at({int(x), int(y)}) = elementColor(*color, x, y, {0, 255});
    return pipeline::imageSource("png", pngOf(picture));
}

// What the header of the whole program's page begins with.
constexpr std::string_view kPlaces =
    "<a class=\"home always\" href=\"#start\">Shadescope</a><nav id=\"places\" class=\"always\" aria-label=\"Places\">"
    "<a href=\"#start\">Scenes and lessons</a><a href=\"#mine\">My renderer</a><a href=\"#bug\">Wrong "
    "picture</a><a href=\"#check\">Stiff cases</a><a href=\"#study\">Study</a></nav>"
    "<button type=\"button\" class=\"instrument\" id=\"contractskey\">Contracts <kbd>K</kbd></button>"
    "<button type=\"button\" class=\"instrument\" id=\"savekey\">Save…</button>"
    "<button type=\"button\" class=\"always\" id=\"copylink\">Copy link</button>"
    "<span class=\"note always\" id=\"copied\" role=\"status\"></span>";

}  // namespace

Result<std::string> makeWholePage(const LiveParts& parts, const pipeline::Stop& stop, const PageProgress& progress,
                                  const PageSurroundings& beside) {
    const fs::path folder = pipeline::resourceFolder();
    Errors errors, leftOut;
    const auto take = [&](const auto& result) {
        if (!result) errors.insert(errors.end(), result.errors().begin(), result.errors().end());
        return bool(result);
    };
    const auto texts = [&](const char* name) {
        std::map<std::string, std::string> found;
        std::error_code ignored;
        for (const auto& entry : fs::directory_iterator(folder / name, ignored))
            if (entry.path().stem() == "stage")
                continue;  // functions of a student's own, which a page does not run
            else if (const auto text = pipeline::readFile(entry.path()); take(text))
                found[entry.path().filename().string()] = *text;
        return found;
    };
    const auto scenes = texts("scenes"), starter = texts("starter");
    const std::vector<pipeline::BuiltInScene> known = pipeline::builtInScenes();
    const std::vector<std::string> names = lessonNames();
    std::size_t done = 0;
    const auto isStopped = [&](const std::string& what) {
        if (progress) progress(done++, known.size() + names.size(), what);
        return stop.stop_requested();
    };
    Json ofScenes = Json::array(), ofLessons = Json::object();
    for (const pipeline::BuiltInScene& one : known) {
        if (isStopped(one.name)) return Error{{}, "stopped", {}};
        const auto scene = pipeline::readScene(one.file);
        if (!take(scene)) continue;
        const LessonText text = sceneAsLesson(*scene, one.title, one.look, {}, stop);
        auto read = readLive(text, {});
        if (!take(read)) continue;
        LiveLesson live = std::move(read).value();
        const auto data = liveData(live, text, {}, leftOut);
        if (!take(data)) continue;
        ofScenes.push_back({{"name", one.name},
                            {"file", one.file.filename().string()},
                            {"title", one.title},
                            {"look", one.look},
                            {"picture", thumbnailOf(*scene, stop)},
                            {"page", *data}});
    }
    for (const std::string& name : names) {
        if (isStopped(name)) return Error{{}, "stopped", {}};
        const auto text = otherLesson(name, stop);
        if (!take(text)) continue;
        auto read = readLive(*text, name);
        if (!take(read)) continue;
        LiveLesson live = std::move(read).value();
        const auto data = liveData(live, *text, "#lesson=" + live.lesson.next, leftOut);
        if (take(data)) ofLessons[name] = *data;
    }
    if (!errors.empty()) return errors;
    const Json all{{"version", pipeline::programVersion()},
                   {"scenes", scenes},
                   {"known", ofScenes},
                   {"lessons", ofLessons},
                   {"starter", starter},
                   {"beside", beside.lists}};
    const std::string packed = pipeline::base85(pipeline::gzipped(all.dump()));
    return filledPage(
        parts, "Shadescope", Json::object(),
        {{"PAPER", beside.paper},
         {"NOSCRIPT", "Open it in a browser with scripts."},
         {"PLACES", parts.places + "<script type=\"application/octet-stream\" id=\"packed\">" + packed + "</script>\n"},
         {"INDEX", std::string(kPlaces)}});
}

}  // namespace lessons
