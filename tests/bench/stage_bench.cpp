// Time per stage, as the runner measures it, on scenes that load different stages.
//   stage_bench --benchmark_filter=Shading
#include <benchmark/benchmark.h>

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

// What a slider costs that moves a light: the stages that depend on it, the others reused.
void lightMoves(benchmark::State& state, Scene scene) {
    FramePtr frame = test::frameOf(scene, setOf({BufferId::Color}));
    for (auto _ : state) {
        scene.lights[0].position.x += 1;
        frame = test::frameOf(scene, setOf({BufferId::Color}), 0, frame);
    }
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
        benchmark::RegisterBenchmark((std::string("Light moves/") + name).c_str(), lightMoves, scene)
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
    }
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    registerAll();
    benchmark::RunSpecifiedBenchmarks();
}
