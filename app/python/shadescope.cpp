#include <fmt/format.h>

#include <condition_variable>
#include <cstring>
#include <new>
#include <thread>

#include "lessons/pages/live_page.h"
#include "lessons/state/state_scene.h"
#include "pipeline/buffers/palette.h"
#include "pipeline/compare/report/compare_text.h"
#include "pipeline/core/text.h"
#include "pipeline/core/version.h"
#include "pipeline/export/buffers/png_file.h"
#include "pipeline/export/json/frame_json.h"
#include "pipeline/export/json/study_json.h"
#include "pipeline/export/study/study_text.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/text/text_scanner.h"
#include "pipeline/formats/toml/toml_writer.h"
#include "pipeline/plan/memory_limit.h"
#include "pipeline/plan/needs.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/hold/hold.h"
#include "pipeline/study/analysis.h"
#include "pipeline/study/machine.h"
#include "pipeline/study/run_study.h"

// Shadescope for Python, as C calls: scenes, frames and what is read of them.
//
// A handle is a scene, a frame, a buffer, a picture or a text, and immutable. The caller frees it, in any order and on any
// thread; it does not need the handles that it was made of. A call that cannot answer returns null; shade_error() of the
// same thread says why, in JSON: {"errors": [{file, line, column, found, expected, keys, text}]}, {"stopped": true} or
// {"memory": true}. Texts are UTF-8. No call throws, prints, or ends the process.

namespace foreign = pipeline::foreign;
using pipeline::AnyBuffer;
using pipeline::Errors;
using pipeline::FramePtr;
using pipeline::Json;
using pipeline::Scene;
using pipeline::Stop;
using ScenePtr = std::shared_ptr<const Scene>;
using Picture = pipeline::Buffer2D<pipeline::Color8>;
static_assert(sizeof(pipeline::Color8) == 3);

// A long call asks about every 20 ms on the caller's thread whether to stop: other than 0. Null: it never asks.
using ShadePoll = int (*)();

namespace {

// A scene with its reference, which comparisons share: a renderer's author compares again and again.
struct SceneHandle {
    struct Compared {
        std::mutex mutex;
        std::shared_ptr<const foreign::Reference> reference;
    };
    ScenePtr scene;
    std::shared_ptr<Compared> compared = std::make_shared<Compared>();
};

}  // namespace

struct Shade {
    std::variant<SceneHandle, FramePtr, AnyBuffer, Picture, std::string> content;
};

namespace {

thread_local std::string s_text;
thread_local const char* s_error = "";

struct Refused {
    Errors errors;
};
struct Stopped {};

[[noreturn]] void refuse(std::string found) { throw Refused{{pipeline::Error{{}, std::move(found)}}}; }

template <class T>
T valueOf(pipeline::Result<T> result) {
    if (!result) throw Refused{result.errors()};
    return std::move(result).value();
}

void tell(const Errors& errors) noexcept {
    try {
        s_text = errorsToJson(errors).dump();
        s_error = s_text.c_str();
    } catch (...) {  // a name that is no UTF-8
        s_error = R"({"errors": [{"text": "a text that is not UTF-8", "found": "a text that is not UTF-8"}]})";
    }
}

// What a call returns, with all that can go wrong on the way.
template <class Work>
Shade* guarded(Work work) noexcept {
    try {
        return new Shade{work()};
    } catch (const Refused& refused) {
        tell(refused.errors);
    } catch (const Stopped&) {
        s_error = R"({"stopped": true})";
    } catch (const std::bad_alloc&) {
        s_error = R"({"memory": true})";
    } catch (const std::exception& error) {
        tell({pipeline::Error{{}, error.what()}});
    }
    return nullptr;
}

// Runs the work on a thread of its own, while this one asks whether to go on.
template <class Work>
auto stoppable(ShadePoll poll, Work work) -> decltype(work(Stop())) {
    if (!poll) return work(Stop());
    std::optional<decltype(work(Stop()))> result;
    std::exception_ptr thrown;
    std::mutex mutex;
    std::condition_variable ended;
    bool isOver = false, asked = false;
    std::jthread worker([&](const Stop& stop) {
        try {
            result.emplace(work(stop));
        } catch (...) {
            thrown = std::current_exception();
        }
        const std::lock_guard lock(mutex);
        isOver = true;
        ended.notify_one();
    });
    for (std::unique_lock lock(mutex); !ended.wait_for(lock, std::chrono::milliseconds(20), [&] { return isOver; });) {
        lock.unlock();
        if (!asked && poll()) asked = worker.request_stop();
        lock.lock();
    }
    worker.join();
    if (asked) throw Stopped{};
    if (thrown) std::rethrow_exception(thrown);
    return std::move(*result);
}

template <class T>
const T& as(const Shade* handle) {
    if (!handle || !std::holds_alternative<T>(handle->content)) refuse("a handle of another kind");
    return std::get<T>(handle->content);
}
ScenePtr sceneOf(const Shade* handle) {
    if (handle && std::holds_alternative<FramePtr>(handle->content)) return as<FramePtr>(handle)->sharedScene();
    return as<SceneHandle>(handle).scene;
}

SceneHandle changed(Scene scene, std::string_view settings) {
    if (!settings.empty()) scene = valueOf(pipeline::withSettings(std::move(scene), settings));
    if (const Errors errors = checkScene(scene); !errors.empty()) throw Refused{errors};
    return {std::make_shared<const Scene>(std::move(scene))};
}

pipeline::BufferName nameOf(const Scene& scene, std::string_view text) {
    const auto name = pipeline::findBuffer(text);
    if (!name) refuse(fmt::format("no buffer {}; {}", pipeline::inQuotes(text), pipeline::insteadOfBuffer(text)));
    if (name->light >= int(scene.lights.size()))
        refuse(fmt::format("no buffer {}: the scene has {}", pipeline::inQuotes(text),
                           pipeline::plural(std::int64_t(scene.lights.size()), "light")));
    return *name;
}

AnyBuffer bufferOf(const pipeline::Frame& frame, std::string_view text) {
    const auto name = nameOf(frame.scene(), text);
    const auto buffer = frame.buffer(name);
    if (!buffer) refuse(frame.whyAbsent(name));
    return *buffer;
}

Picture pictureOf(const pipeline::Frame& frame, std::string_view name) {
    const AnyBuffer buffer = bufferOf(frame, name);
    Picture picture(glm::ivec2(int(buffer.columns()), int(buffer.rows())));
    if (buffer.name.id == pipeline::BufferId::Color) {
        const auto bytes = std::get<std::span<const std::uint8_t>>(buffer.data);
        std::memcpy(picture.pixels.data(), bytes.data(), bytes.size());
        return picture;
    }
    const auto range = fittingRange(buffer, statistics(buffer), frame.scene().settings.depthFormat);
    for (int y = 0; y < picture.size.y; ++y)
        for (int x = 0; x < picture.size.x; ++x)
            picture.at({x, y}) = elementColor(buffer, std::size_t(x), std::size_t(y), range);
    return picture;
}

std::vector<std::string> parts(std::string_view text, char separator) {
    std::vector<std::string> all;
    for (std::size_t end = 0; !text.empty(); text.remove_prefix(std::min(text.size(), end + 1))) {
        end = std::min(text.find(separator), text.size());
        if (end > 0) all.emplace_back(text.substr(0, end));
    }
    return all;
}

glm::ivec2 pixelOf(const Scene& scene, const std::string& text) {
    const auto numbers = parts(text, ',');
    const auto number = [&](std::size_t i) {
        return i < numbers.size() ? pipeline::parseNumber(numbers[i]).value_or(-1) : -1;
    };
    const double x = number(0), y = number(1);
    const pipeline::Settings& settings = scene.settings;
    if (x < 0 || y < 0 || x >= settings.width || y >= settings.height)
        refuse(fmt::format("no pixel {}: the picture has {} columns and {} rows, counted from 0", text, settings.width,
                           settings.height));
    return {int(x), int(y)};
}

std::string textOfScene(const Scene& scene, std::string_view what, const Stop& stop) {
    Json list = Json::array();
    if (what == "toml") return valueOf(pipeline::toTomlScene(scene));
    if (what == "live")
        return valueOf(makeLivePage(scene, scene.name, "", {}, valueOf(lessons::liveParts()), stop)).html;
    if (what == "buffers") {
        for (const pipeline::BufferName& name : pipeline::allBuffers(scene.lights.size()))
            list.push_back(bufferToJson(name, pipeline::stageInfo(pipeline::bufferInfo(name.id).stage).name,
                                        whyUseless(scene, name.id)));
        return list.dump();
    }
    if (what != "settings") refuse(fmt::format("nothing is called {}", pipeline::inQuotes(what)));
    for (const pipeline::SettingRef& ref : settingsOf(scene)) list.push_back(settingToJson(ref, scene));
    return list.dump();
}

std::string textOf(const Shade* of, std::string_view what, const char* argument, const Stop& stop) {
    if (what == "version") return std::string(pipeline::programVersion());
    if (!of || !std::holds_alternative<FramePtr>(of->content)) return textOfScene(*sceneOf(of), what, stop);
    const pipeline::Frame& frame = *as<FramePtr>(of);
    if (what == "plan") return planToJson(frame).dump();
    if (what == "mesh") return meshToJson(frame).dump();
    if (what == "png") return pngOf(pictureOf(frame, argument), pipeline::Packing::Fast);
    if (what != "inspect" && what != "text") return textOfScene(frame.scene(), what, stop);
    const auto report = inspectPixel(frame, pixelOf(frame.scene(), argument), stop);
    return what == "text" ? toText(frame, report) : toJson(frame, report).dump();
}

std::string reportOf(const foreign::Report& report) {
    Json json = reportJson(report, !report.agrees() ? 1 : report.in->errors.empty() ? 0 : 3);  // as the command ends
    std::string text;
    for (const foreign::TextLine& line : reportText(report, false, 100)) text += line.text + "\n";
    json["text"] = text;
    return json.dump();
}

std::string studyOf(const pipeline::StudyRequest& request, const Stop& stop) {
    pipeline::StudyReport report = beginStudy(request);
    pipeline::ErrorFinder finder(request);
    for (pipeline::StudyPoint& point : report.points)
        if (!finder.find(point, report, stop)) throw Stopped{};
    report.processes = 1, report.load = {pipeline::loadAverage()};
    if (!measureTimes(
            request, report.points, [](int, int) {}, stop))
        throw Stopped{};
    const auto there = choicesOf(report);
    if (!there.empty() && std::ranges::find(there, report.choice) == there.end()) report.choice = there.front();
    const auto analysis = analyse(report, report.choice);
    Json json = toJson(report), rows = Json::array();
    json["text"] = studyText(report, analysis, middleOfFront(analysis).value_or(pipeline::StudyLimits()));
    for (std::size_t i = 0; i < report.points.size(); ++i) {
        const auto& point = analysis.points[i];
        Json row = Json::object();
        for (std::size_t a = 0; a < report.axes.size(); ++a) row[report.axes[a].key] = report.points[i].values[a];
        row["milliseconds"] = point.time ? Json(*point.time) : Json();
        row["error"] = point.error ? Json(*point.error) : Json();
        row["best"] = point.onFront();
        rows.push_back(row);
    }
    json["rows"] = rows;
    json["unit"] = analysis.unit;
    return json.dump();
}

}  // namespace

#define SHADE_CALL extern "C" __attribute__((visibility("default")))

// The folder with scenes and the parts of a live page, where the package has its own. Once, before anything else.
SHADE_CALL void shade_resources(const char* folder) { pipeline::setResourceFolder(folder); }

// A file or a built-in scene, or the scene of a handle, with settings: "KEY=VALUE; KEY=VALUE".
SHADE_CALL Shade* shade_scene(const char* name, const char* settings, ShadePoll poll) {
    return guarded([&] {
        return stoppable(poll, [&](const Stop& stop) {
            auto read = lessons::readNamedScene(name, {}, {{}, stop});
            if (stop.stop_requested()) throw Stopped{};
            return changed(valueOf(std::move(read)), settings);
        });
    });
}
SHADE_CALL Shade* shade_with(const Shade* of, const char* settings) {
    return guarded([&] { return changed(*sceneOf(of), settings); });
}

// Reuses of `before`, which may be null, all that still holds; the bits are those of a frame made from nothing. wanted:
// names with commas between them, beside those that `before` was asked for. threads: 0 for all.
SHADE_CALL Shade* shade_frame(const Shade* scene, const Shade* before, const char* wanted, int threads,
                              ShadePoll poll) {
    return guarded([&] {
        const ScenePtr what = sceneOf(scene);
        const FramePtr old = before ? as<FramePtr>(before) : nullptr;
        pipeline::FrameRequest request;
        request.threads = threads;
        if (old) request.wanted = old->wanted();
        for (const std::string& name : parts(wanted, ',')) request.wanted.set(index(nameOf(*what, name).id));
        if (const Errors errors = checkMemory(*what, request.wanted); !errors.empty()) throw Refused{errors};
        return stoppable(poll, [&](const Stop& stop) -> FramePtr {
            request.stop = stop;
            FramePtr frame = runFrame(what, request, old);
            if (!frame) throw Stopped{};
            return frame;
        });
    });
}

// The numbers themselves, without a copy; null where the frame has left them out.
SHADE_CALL Shade* shade_buffer(const Shade* frame, const char* name) {
    return guarded([&] { return bufferOf(*as<FramePtr>(frame), name); });
}
// A buffer in the program's palette: bytes of red, green and blue.
SHADE_CALL Shade* shade_picture(const Shade* frame, const char* name) {
    return guarded([&] { return pictureOf(*as<FramePtr>(frame), name); });
}

// Of a scene: "toml", "live" (a page), "buffers", "settings". Of a frame also "plan", "mesh", "png" of a buffer, and of a
// pixel "X,Y" "inspect" and, as a text, "text". JSON where nothing else is said.
SHADE_CALL Shade* shade_ask(const Shade* of, const char* what, const char* argument, ShadePoll poll) {
    return guarded([&] { return stoppable(poll, [&](const Stop& stop) { return textOf(of, what, argument, stop); }); });
}

// What the files of another renderer have wrong: files in memory, "depth.npy" is one's name. As compare --json has it,
// and "text", the report for a terminal. known: whether known errors are looked for.
struct ShadeFile {
    const char* name;
    const void* bytes;
    std::size_t size;
};
SHADE_CALL Shade* shade_compare(const Shade* scene, const ShadeFile* files, int count, int known, ShadePoll poll) {
    return guarded([&] {
        const SceneHandle& handle = as<SceneHandle>(scene);
        return stoppable(poll, [&](const Stop& stop) {
            const std::lock_guard lock(handle.compared->mutex);
            auto& reference = handle.compared->reference;
            if (!reference) {
                auto made = foreign::makeReference(*handle.scene, {}, stop);
                if (!made) throw Stopped{};
                reference = std::make_shared<const foreign::Reference>(std::move(*made));
            }
            std::map<std::string, std::string_view> named;
            for (const ShadeFile& file : std::span(files, std::size_t(count)))
                named[file.name] = {static_cast<const char*>(file.bytes), file.size};
            foreign::CompareOptions options;
            options.known = known != 0, options.stop = stop;
            return reportOf(valueOf(compareRenderer(
                *handle.scene, reference, foreign::readHandedIn(named, *reference->frame), "arrays", options)));
        });
    });
}

// sweeps: as --sweep takes them, one a line. As study.json, and "text", "unit" and "rows", one for each point.
SHADE_CALL Shade* shade_study(const Shade* scene, const char* sweeps, int repeats, ShadePoll poll) {
    return guarded([&] {
        return stoppable(poll, [&](const Stop& stop) {
            pipeline::StudyRequest request;
            request.scene = sceneOf(scene);
            request.sweep = valueOf(parseSweeps(*request.scene, parts(sweeps, '\n')));
            if (repeats < 1 || repeats > 100000) refuse(fmt::format("repeat is {}, expected 1 to 100000", repeats));
            request.repeats = repeats;
            return studyOf(request, stop);
        });
    });
}

// What a buffer, a picture or a text holds, row by row, for as long as its handle lives. Of another handle 0.
struct ShadeView {
    const void* data;
    const char* dtype;  // "float32", "float64", "int32", "uint8"
    std::size_t shape[4];
    int dimensions;
};
SHADE_CALL int shade_view(const Shade* of, ShadeView* into) {
    const auto fill = [&](const void* data, const char* dtype, std::span<const std::size_t> shape) {
        *into = {data, dtype, {}, int(shape.size())};
        std::ranges::copy(shape, into->shape);
        return 1;
    };
    if (const auto* text = std::get_if<std::string>(&of->content))
        return fill(text->data(), "uint8", std::array{text->size()});
    if (const auto* picture = std::get_if<Picture>(&of->content))
        return fill(picture->pixels.data(), "uint8",
                    std::array{std::size_t(picture->size.y), std::size_t(picture->size.x), std::size_t(3)});
    const auto* buffer = std::get_if<AnyBuffer>(&of->content);
    if (!buffer || buffer->shape.size() > 4) return 0;
    const auto start = [](const auto& span) { return static_cast<const void*>(span.data()); };
    return fill(std::visit(start, buffer->data), buffer->dtype(), buffer->shape);
}

SHADE_CALL const char* shade_error() { return s_error; }
SHADE_CALL void shade_free(Shade* handle) { delete handle; }
