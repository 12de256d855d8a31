// Our frames against OpenGL's, drawn in turns on the same processors, and what that says of their speed.
//   compare_opengl                    every workload, 1 processor and 2
//   compare_opengl --only 70k --json
//   compare_opengl --model bunny.obj --parts phong
// OpenGL is Mesa's llvmpipe, which draws on the processor, where the environment does not choose another driver.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "pipeline/core/memory.h"
#include "pipeline/core/text.h"
#include "pipeline/export/json/json_value.h"
#include "pipeline/run/runner.h"
#include "pipeline/study/memory_share.h"
#include "tests/bench/gl_scene.h"
#include "tests/bench/rounds.h"
#include "tests/bench/workloads.h"
#include "tests/twin/gl_context.h"

namespace bench {
namespace {

using pipeline::Json;

struct Options {
    std::vector<std::string> only, parts;
    std::string model;  // a file, instead of the workloads
    std::vector<int> size{1920, 1080};
    int shadowSize = 2048;
    int threads = 0;  // 0: 1 and 2
    Turns turns;
    bool json = false, stages = false;
};

std::string key(Part part) { return part == Part::Depth ? "depth" : part == Part::Phong ? "phong" : "shadow"; }

// One row of the table.
struct Point {
    const Workload& workload;
    Part part;
    int threads;
};

// A renderer of ours: every frame computes every stage anew from the same meshes.
class Ours {
public:
    Ours(const Point& point, const std::shared_ptr<const pipeline::Mesh>& mesh, pipeline::Arithmetic arithmetic) {
        for (const bool moved : {false, true})
            m_scenes[std::size_t(moved)] =
                std::make_shared<const pipeline::Scene>(sceneOf(point.workload, point.part, mesh, moved, arithmetic));
        const bool depth = point.part == Part::Depth;
        m_request.wanted.set(index(depth ? pipeline::BufferId::ZView : pipeline::BufferId::Color));
        m_request.until = depth ? pipeline::StageId::ZBuffer : pipeline::StageId::Shading;
        m_request.threads = point.threads;
    }
    void draw() {
        m_frame.reset();  // as OpenGL draws into the picture before
        m_frame = runFrame(m_scenes[m_next], m_request, nullptr);
        m_next = 1 - m_next;
        for (const pipeline::StageId stage : pipeline::kStages)
            if (m_frame->plan()[index(stage)].action == pipeline::Action::Run)
                m_stages[index(stage)].push_back(m_frame->run(stage).milliseconds);
    }
    const pipeline::Frame& frame() const { return *m_frame; }
    Json stages() const {  // medians, ms
        Json json = Json::object();
        for (const pipeline::StageId stage : pipeline::kStages)
            if (!m_stages[index(stage)].empty())
                json[std::string(stageInfo(stage).name)] = median(m_stages[index(stage)]);
        return json;
    }

private:
    std::array<std::shared_ptr<const pipeline::Scene>, 2> m_scenes;
    std::size_t m_next = 0;
    pipeline::FrameRequest m_request;
    pipeline::FramePtr m_frame;
    std::array<std::vector<double>, pipeline::kStageCount> m_stages;
};

// How many of the pixels that either side draws are alike: within 3 of 255, or in depth within 1/10000 of the range.
double shareAlike(const pipeline::Frame& frame, GlScene& gl, bool colored) {
    std::size_t drawn = 0, alike = 0;
    const auto depth = gl.depth();
    const auto distance = frame.buffer({pipeline::BufferId::ZView});
    const auto shades = colored ? gl.color() : std::vector<pipeline::Color8>();
    const auto buffer = frame.buffer({pipeline::BufferId::Color});
    const double n = frame.scene().camera.near, f = frame.scene().camera.far;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        const double z = distance->flat(i);
        const bool here = std::isfinite(z), there = depth[i] < 1;
        if (!here && !there) continue;
        ++drawn;
        if (here != there) continue;
        bool same = std::abs(f / (f - n) * (1 - n / z) - double(depth[i])) < 1e-4;
        for (int c = 0; c < 3 && colored; ++c) {
            const int mine = int(buffer->flat(3 * i + std::size_t(c)));
            same = same && std::abs(mine - int(shades[i][c])) <= 3;
        }
        alike += same;
    }
    return drawn > 0 ? double(alike) / double(drawn) : 0;
}

Json ratiosJson(const std::vector<double>& gl, const std::vector<double>& ours) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < gl.size(); ++i) ratios.push_back(gl[i] / ours[i]);
    const auto [low, high] = std::ranges::minmax(ratios);
    return {{"median", median(ratios)}, {"min", low}, {"max", high}};
}

// In a process of its own: the driver reads how many threads it may have when it starts.
Json measure(const Point& point, const Options& options) {
    if (!useProcessors(point.threads)) return {{"error", fmt::format("not {} processors", point.threads)}};
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
    setenv("GALLIUM_DRIVER", "llvmpipe", 0);
    // Vertices are transformed in the calling thread. With 0 it does everything else as well, on one processor.
    setenv("LP_NUM_THREADS", point.threads == 1 ? "0" : std::to_string(point.threads).c_str(), 1);

    const auto read = meshOf(point.workload);
    if (!read) return {{"error", format(read.errors().front())}};
    const auto& mesh = *read;
    const double meshMegabytes = peakMegabytes();
    Ours exact(point, mesh, pipeline::Arithmetic::Exact);
    exact.draw(), exact.draw();
    const double oursMegabytes = peakMegabytes();

    std::string whyNot;
    const auto context = twin::GlContext::make(whyNot);
    if (!context) return {{"error", whyNot}};
    const auto indexed = GlScene::make(exact.frame(), Geometry::Indexed, whyNot);
    const auto unshared = GlScene::make(exact.frame(), Geometry::Unshared, whyNot);
    if (!indexed || !unshared) return {{"error", whyNot}};
    indexed->draw(), unshared->draw();
    const bool colored = point.part != Part::Depth;
    Ours fast(point, mesh, pipeline::Arithmetic::Fast);
    fast.draw();
    const double alike =
        std::min(shareAlike(exact.frame(), *unshared, colored), shareAlike(fast.frame(), *unshared, colored));

    const auto medians = takeTurns({{"indexed", [&] { indexed->draw(); }},
                                    {"unshared", [&] { unshared->draw(); }},
                                    {"exact", [&] { exact.draw(); }},
                                    {"fast", [&] { fast.draw(); }}},
                                   options.turns, point.threads == 1 ? Watch::Processor : Watch::Wall);
    const std::size_t better = median(medians[1]) < median(medians[0]) ? 1 : 0;
    const double bandwidth = pipeline::memsetBandwidth(point.threads);
    const auto share = [&](const Ours& ours, double milliseconds) {
        return pipeline::bufferBytes(ours.frame()) / (bandwidth * milliseconds / 1000);
    };
    return {{"workload", point.workload.name},
            {"triangles", mesh->triangles.size()},
            {"width", point.workload.width},
            {"height", point.workload.height},
            {"part", name(point.part, point.workload)},
            {"threads", point.threads},
            {"opengl", context->renderer()},
            {"opengl_version", context->version()},
            {"opengl_ms", median(medians[better])},
            {"opengl_geometry", better == 1 ? "unshared" : "indexed"},
            {"opengl_indexed_ms", median(medians[0])},
            {"opengl_unshared_ms", median(medians[1])},
            {"exact_ms", median(medians[2])},
            {"exact_ratio", ratiosJson(medians[better], medians[2])},
            {"exact_stages_ms", exact.stages()},
            {"fast_ms", median(medians[3])},
            {"fast_ratio", ratiosJson(medians[better], medians[3])},
            {"fast_stages_ms", fast.stages()},
            {"memset_bytes_per_second", bandwidth},
            {"exact_share_of_memset", share(exact, median(medians[2]))},
            {"fast_share_of_memset", share(fast, median(medians[3]))},
            {"pixels_alike", alike},
            {"mesh_megabytes", meshMegabytes},
            {"peak_megabytes", oursMegabytes}};
}

// The child's answer, or what became of it.
Json inChild(const Point& point, const Options& options) {
    int ends[2];
    if (pipe(ends) != 0) return {{"error", "no pipe"}};
    const pid_t child = fork();
    if (child < 0) return {{"error", "no process"}};
    if (child == 0) {
        close(ends[0]);
        const std::string text = measure(point, options).dump();
        std::size_t written = 0;
        while (written < text.size()) {
            const ssize_t n = write(ends[1], text.data() + written, text.size() - written);
            if (n <= 0) break;
            written += std::size_t(n);
        }
        _exit(0);  // without the driver's own end, which takes its time
    }
    close(ends[1]);
    std::string text;
    std::array<char, 4096> buffer{};
    for (ssize_t n; (n = read(ends[0], buffer.data(), buffer.size())) > 0;) text.append(buffer.data(), std::size_t(n));
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return Json::read(text).value_or(Json{{"error", "the process that measures ended early"}});
}

std::string ratioText(const Json& ratio) {
    return fmt::format("{:.2f} ({:.2f} to {:.2f})", ratio["median"].get<double>(), ratio["min"].get<double>(),
                       ratio["max"].get<double>());
}

// "llvmpipe, Mesa 22.3.6": the first word of the renderer's name, and the version of who made it.
std::string driverText(const Json& row) {
    const auto renderer = row["opengl"].get<std::string>(), version = row["opengl_version"].get<std::string>();
    const auto maker = version.find("Mesa");
    return renderer.substr(0, renderer.find(' ')) + ", " + (maker == version.npos ? version : version.substr(maker));
}

void printHead(const Options& options) {
    fmt::print(
        "{}, {} processors; medians of {} rounds in turns, ms a frame (of one thread: its "
        "CPU time); ratio: OpenGL's time over ours; memset: how much of that time a memset of the buffers that "
        "our frame keeps takes\n\n",
        processorName(), processorCount(), options.turns.rounds);
    fmt::print(
        "| polygons | picture | drawn | threads | driver | OpenGL | its geometry | exact | ratio (min to max) | memset "
        "| fast | "
        "ratio (min to max) | memset | alike | peak MB "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void printRow(const Json& row, const Options& options) {
    const auto number = [&](const char* key) { return row[key].get<double>(); };
    fmt::print(
        "| {} | {}×{} | {} | {} | {} | {:.2f} | {} | {:.2f} | {} | {:.1f} % | {:.2f} | {} | {:.1f} % | {:.2f} % | "
        "{:.0f} |\n",
        row["triangles"].get<std::size_t>(), row["width"].get<int>(), row["height"].get<int>(),
        row["part"].get<std::string>(), row["threads"].get<int>(), driverText(row), number("opengl_ms"),
        row["opengl_geometry"].get<std::string>(), number("exact_ms"), ratioText(row["exact_ratio"]),
        100 * number("exact_share_of_memset"), number("fast_ms"), ratioText(row["fast_ratio"]),
        100 * number("fast_share_of_memset"), 100 * number("pixels_alike"), number("peak_megabytes"));
    if (options.stages)
        fmt::print("    exact: {}\n    fast:  {}\n", row["exact_stages_ms"].dump(), row["fast_stages_ms"].dump());
    std::fflush(stdout);
}

int run(const Options& options) {
    Json rows = Json::array();
    if (!options.json) printHead(options);
    bool failed = false;
    const std::vector<Workload> model{{.name = options.model,
                                       .width = options.size[0],
                                       .height = options.size[1],
                                       .shadowSize = options.shadowSize,
                                       .file = options.model}};
    for (const Workload& workload : options.model.empty() ? workloads() : model) {
        if (!options.only.empty() && std::ranges::find(options.only, workload.name) == options.only.end()) continue;
        for (const Part part : kParts) {
            if (!options.parts.empty() && std::ranges::find(options.parts, key(part)) == options.parts.end()) continue;
            for (const int threads : {1, 2}) {
                if (options.threads != 0 && options.threads != threads) continue;
                const Json row = inChild({workload, part, threads}, options);
                if (row.find("error")) {
                    fmt::print(stderr, "{}, {}, {}: {}\n", workload.name, name(part, workload),
                               pipeline::plural(threads, "thread"), row["error"].get<std::string>());
                    if (!options.model.empty()) return 1;  // nothing else can be drawn of it either
                    failed = true;
                } else if (options.json) {
                    rows.push_back(row);
                } else {
                    printRow(row, options);
                }
            }
        }
    }
    if (options.json) {
        const Json json{{"processor", processorName()},
                        {"processors", processorCount()},
                        {"rounds", options.turns.rounds},
                        {"seconds_each_turn", options.turns.seconds},
                        {"rows", rows}};
        fmt::print("{}\n", json.dump(2));
    }
    return failed ? 1 : 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
    bench::Options options;
    CLI::App program("Draw the same scenes with OpenGL and with Shadescope, in turns, and compare their times");
    std::vector<std::string> names;
    for (const bench::Workload& workload : bench::workloads()) names.push_back(workload.name);
    program.add_option("--only", options.only, "Workloads, by their number of polygons")
        ->check(CLI::IsMember(names))
        ->delimiter(',');
    program.add_option("--parts", options.parts, "What is drawn of them")
        ->check(CLI::IsMember({"depth", "phong", "shadow"}))
        ->delimiter(',');
    CLI::Option* model = program.add_option("--model", options.model, "A model instead of them: OBJ, PLY, STL or glTF")
                             ->check(CLI::ExistingFile)
                             ->excludes("--only");
    program.add_option("--size", options.size, "Width and height of the model's picture")
        ->expected(2)
        ->check(CLI::Range(1, 16384))
        ->needs(model)
        ->capture_default_str();
    program.add_option("--shadow-size", options.shadowSize, "Side of its shadow buffer")
        ->check(CLI::Range(16, 16384))
        ->needs(model)
        ->capture_default_str();
    program.add_option("--threads", options.threads, "Threads and processors; 0: 1, then 2")->check(CLI::Range(0, 2));
    program.add_option("--rounds", options.turns.rounds, "Rounds")->check(CLI::Range(1, 1000))->capture_default_str();
    program.add_option("--seconds", options.turns.seconds, "Length of a turn")
        ->check(CLI::Range(0.0, 60.0))
        ->capture_default_str();
    program.add_flag("--stages", options.stages, "Print the time of every stage below each row");
    program.add_flag("--json", options.json, "Print JSON");
    CLI11_PARSE(program, argc, argv);
    pipeline::keepFreedMemory();  // as the program does
    return bench::run(options);
}
