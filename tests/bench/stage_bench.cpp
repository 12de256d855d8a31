// Time per stage, as the runner measures it, on scenes that load different stages; and of a frame after one change.
//   stage_bench --benchmark_filter=Shading
//   stage_bench --benchmark_filter=Change
// And of a jump into the middle of a stage, and to its end:
//   stage_bench --benchmark_filter=Seek
// And of reading a model of a million triangles:
//   stage_bench --benchmark_filter=Read
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "pipeline/core/memory.h"
#include "pipeline/formats/model_reader.h"
#include "pipeline/run/runner.h"
#include "pipeline/steps/steps.h"
#include "tests/bench/workloads.h"
#include "tests/support/scenes.h"

namespace {

using namespace pipeline;

// A number of frames, and not a total time: a stage of microseconds would wait for it through
// thousands of frames.
constexpr int kFrames = 30;

// Two spheres of 20 000 polygons each, one in the shadow of the other, Phong shaded.
Scene spheres() {
    Scene scene = test::pyramid();
    scene.settings.shading = Shading::Phong;
    Object object = scene.objects[0];
    object.transform = {Vec3d(1), Vec3d(0), Vec3d(0)};
    object.mesh = test::sphere(150, 100, 200);
    scene.objects = {object, object};
    scene.objects[1].transform.translation = Vec3d(200);
    return scene;
}

// Every frame is computed from nothing, in the precision given; what is timed is one stage of it.
void fromNothing(benchmark::State& state, Scene scene, Precision precision, StageId stage) {
    scene.settings.precision = precision;
    for (auto _ : state)
        state.SetIterationTime(test::frameOf(scene, setOf({BufferId::Color}))->run(stage).milliseconds / 1000);
}

// What one change costs: the stages that depend on it, the others reused. On one thread, 640 x 480, Phong shading with a
// shadow buffer; the frame before is kept, as the window keeps it.
struct Change {
    const char* name;
    void (*make)(Scene& scene);  // null: nothing changes
};
constexpr Change kChanges[]{
    {"nothing", nullptr},
    {"camera", [](Scene& scene) { scene.camera.eye += Vec3d(0.01); }},
    {"light", [](Scene& scene) { scene.lights[0].position += Vec3d(0.01, 0, 0); }},
    {"material", [](Scene& scene) { scene.objects[0].material.diffuse *= 0.99; }},
    {"exponent", [](Scene& scene) { scene.objects[0].material.exponent += 1; }},
};

void changes(benchmark::State& state, const Scene& scene, const Change& change) {
    const auto before = std::make_shared<const Scene>(scene);
    auto after = before;
    if (change.make) {
        auto changed = std::make_shared<Scene>(scene);
        change.make(*changed);
        after = std::move(changed);
    }
    const FrameRequest request{.wanted = setOf({BufferId::Color}), .threads = 1, .stop = {}};
    FramePtr frame = runFrame(before, request, nullptr);
    bool there = true;
    for (auto _ : state) frame = runFrame((there = !there) ? before : after, request, frame);
}

// The state of a stage between its steps, 640 x 480, a million polygons, all processors.
void seeks(benchmark::State& state, StageId stage, double share) {
    static const Steps steps = [] {
        const bench::Workload& workload = bench::workload("1M");
        Scene scene = sceneOf(workload, bench::Part::PhongShadow, *meshOf(workload), false, Arithmetic::Exact);
        scene.settings.width = 640, scene.settings.height = 480;
        const FrameRequest request{.wanted = setOf({BufferId::Color}), .threads = 0, .stop = {}};
        return Steps(runFrame(std::make_shared<const Scene>(std::move(scene)), request, nullptr));
    }();
    const Moment moment{stage, std::int64_t(share * double(steps.total(stage)))};
    for (auto _ : state) benchmark::DoNotOptimize(steps.frameAt(moment));
}

void reads(benchmark::State& state) {
    const std::shared_ptr<const Mesh> mesh = *meshOf(bench::workload("1M"));
    std::string text;
    for (const Vec3d& p : mesh->positions)
        fmt::format_to(std::back_inserter(text), "v {:.6f} {:.6f} {:.6f}\n", p.x, p.y, p.z);
    for (const Triangle& t : mesh->triangles)
        fmt::format_to(std::back_inserter(text), "f {} {} {}\n", t.vertices[0] + 1, t.vertices[1] + 1,
                       t.vertices[2] + 1);
    const FileLoader none = [](std::string_view) -> Result<NamedFile> { return Error{}; };
    for (auto _ : state) benchmark::DoNotOptimize(readModel({text, "spheres.obj", {}}, ".obj", none));
    state.SetBytesProcessed(std::int64_t(text.size()) * state.iterations());
}

void registerAll() {
    const std::pair<const char*, Scene> scenes[]{{"pyramid", test::pyramid()}, {"spheres", spheres()}};
    for (const auto& [name, scene] : scenes) {
        for (const StageId stage : kStages) {
            for (const auto& [precision, text] :
                 {std::pair(Precision::Float, "float"), std::pair(Precision::Double, "double")}) {
                const FramePtr frame = test::frameOf(scene, setOf({BufferId::Color}));
                if (frame->plan()[index(stage)].action == Action::LeaveOut) continue;
                const std::string title = std::string(stageInfo(stage).label) + "/" + name + "/" + text;
                benchmark::RegisterBenchmark(title.c_str(), fromNothing, scene, precision, stage)
                    ->UseManualTime()
                    ->Iterations(kFrames)
                    ->Unit(benchmark::kMillisecond);
            }
        }
    }
    const bench::Workload& workload = bench::workload("5k");
    const auto mesh = *meshOf(workload);
    for (const auto& [arithmetic, text] :
         {std::pair(Arithmetic::Exact, "exact"), std::pair(Arithmetic::Fast, "fast")}) {
        const Scene scene = sceneOf(workload, bench::Part::PhongShadow, mesh, false, arithmetic);
        for (const Change& change : kChanges)
            benchmark::RegisterBenchmark(
                (std::string("Change/") + change.name + "/" + workload.name + "/" + text).c_str(), changes, scene,
                change)
                ->UseRealTime()
                ->Unit(benchmark::kMicrosecond);
    }
    benchmark::RegisterBenchmark("Read/obj", reads)->Unit(benchmark::kMillisecond);
    for (const StageId stage : kStages)
        for (const auto& [share, text] : {std::pair(0.5, "middle"), std::pair(0.999, "end")})
            benchmark::RegisterBenchmark(("Seek/" + std::string(stageInfo(stage).name) + "/" + text).c_str(), seeks,
                                         stage, share)
                ->UseRealTime()
                ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
    pipeline::keepFreedMemory();  // as the program does
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    registerAll();
    benchmark::RunSpecifiedBenchmarks();
}
