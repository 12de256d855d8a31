#include "app/cli/commands/scaling_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/cli/message.h"
#include "pipeline/run/runner.h"

namespace app {

namespace {

using namespace pipeline;

// A sphere in the middle of a square picture, lit from beside the camera.
Scene sphereScene(int tessellation, int side) {
    Scene scene;
    scene.name = "sphere";
    Object object;
    object.name = "sphere";
    object.shape = Shape{ShapeKind::Sphere, tessellation};
    object.mesh = makeShape(*object.shape);
    object.material.specular = Vec3d(0.3);
    scene.objects.push_back(object);
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, -3, 0};
    scene.camera.fovY = 45;
    Light light;
    light.position = {1, -1, 1};
    scene.lights.push_back(light);
    scene.settings.width = scene.settings.height = side;
    scene.settings.shading = Shading::Phong;
    scene.settings.rules[index(Rule::ConvexShadow)] = false;  // the shadow buffer is measured too
    return scene;
}

// Adds one size to a series; false when stopped.
bool measure(const Scene& scene, double size, const ScalingOptions& options, ScalingSeries& series) {
    FrameRequest request;
    request.wanted.set(index(BufferId::Color));
    request.threads = options.threads;
    request.stop = options.stop;
    const auto shared = std::make_shared<const Scene>(scene);
    double frame = 0;
    std::array<double, kStageCount> stages{};
    for (int i = 0; i < options.repeats; ++i) {
        const FramePtr done = runFrame(shared, request, nullptr);
        if (!done) return false;
        const auto least = [&](double& best, double now) { best = i == 0 ? now : std::min(best, now); };
        least(frame, done->milliseconds());
        for (const StageId stage : kStages) least(stages[index(stage)], done->run(stage).milliseconds);
    }
    series.sizes.push_back(size);
    series.frame.push_back(frame);
    for (const StageId stage : kStages)
        if (stages[index(stage)] > 0) series.stages[index(stage)].push_back(stages[index(stage)]);
    return true;
}

}  // namespace

std::optional<std::array<ScalingSeries, 2>> measureScaling(const ScalingOptions& options) {
    std::array<ScalingSeries, 2> series;
    series[0].over = "polygons", series[1].over = "pixels";
    for (const int tessellation : {8, 16, 32, 64, 128}) {
        const Scene scene = sphereScene(tessellation, 512);
        if (!measure(scene, double(scene.objects[0].mesh->polygonCount()), options, series[0])) return std::nullopt;
    }
    for (const int side : {128, 256, 512, 1024, 2048})
        if (!measure(sphereScene(16, side), double(side) * side, options, series[1])) return std::nullopt;
    return series;
}

double growthExponent(const std::vector<double>& sizes, const std::vector<double>& times) {
    const std::size_t first = std::min(sizes.size() / 2, sizes.size() - 2);
    const auto n = double(sizes.size() - first);
    double x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = first; i < sizes.size(); ++i) {
        const double u = std::log(sizes[i]), v = std::log(times[i]);
        x += u / n, y += v / n, xx += u * u / n, xy += u * v / n;
    }
    return (xy - x * y) / (xx - x * x);
}

void printScaling(const std::array<ScalingSeries, 2>& series) {
    for (const ScalingSeries& one : series) {
        say("{:<14}", one.over);
        for (const double size : one.sizes) say(" {:>10.0f}", size);
        say("   exponent\n");
        const auto row = [&](std::string_view name, const std::vector<double>& times) {
            if (times.size() != one.sizes.size()) return;
            say("{:<14}", name);
            for (const double time : times) say(" {:>10.3f}", time);
            say("   {:.2f}\n", growthExponent(one.sizes, times));
        };
        for (const StageId stage : kStages) row(stageInfo(stage).name, one.stages[index(stage)]);
        row("frame, ms", one.frame);
        say("\n");
    }
}

Json scalingJson(const std::array<ScalingSeries, 2>& series) {
    Json json = Json::array();
    for (const ScalingSeries& one : series) {
        Json stages = Json::array();
        const auto entry = [&](std::string_view name, const std::vector<double>& times) {
            return Json{{"stage", name}, {"milliseconds", times}, {"exponent", growthExponent(one.sizes, times)}};
        };
        for (const StageId stage : kStages)
            if (one.stages[index(stage)].size() == one.sizes.size())
                stages.push_back(entry(stageInfo(stage).name, one.stages[index(stage)]));
        json.push_back({{"over", one.over},
                        {"sizes", one.sizes},
                        {"milliseconds", one.frame},
                        {"exponent", growthExponent(one.sizes, one.frame)},
                        {"stages", stages}});
    }
    return json;
}

}  // namespace app
