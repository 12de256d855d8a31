// The pipeline at a glance: six stages in order, each a pure function of the ones before.
#include "pipeline/run/runner.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/defects/defect_table.h"
#include "pipeline/run/counts.h"
#include "pipeline/run/draws.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/run/run_stages.h"

namespace pipeline {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

std::shared_ptr<const Topology> topologyOf(const Scene& scene, const FramePtr& before) {
    auto meshes = meshesOf(scene);
    std::shared_ptr<const Topology> old;
    if (before) old = readStages(*before, [](const auto& data) { return data.keys.transform.topology; });
    if (scene.settings.defect != Defect::None) spoilMeshes(scene, old.get(), meshes);
    if (old && old->meshes == meshes) return old;
    return std::make_shared<const Topology>(makeTopology(std::move(meshes)));
}

namespace {

Past pastOf(const Scene& scene, const FramePtr& before) {
    Past out;
    if (!before || before->scene().settings.precision != scene.settings.precision) return out;
    readStages(*before, [&](const auto& data) {
        out.keys = &data.keys;
        for (StageId stage : kStages) out.has[index(stage)] = data.has(stage);
        if (data.shading) out.keptIncidence = !data.shading->incidence.empty();
    });
    out.made = before->made();
    out.number = before->number();
    return out;
}

Scene withOwn(Scene scene, const FrameRequest& request) {
    scene.settings.own = request.own;
    return scene;
}

}  // namespace

Plan makePlan(const Scene& scene, const FrameRequest& request, const FramePtr& before) {
    if (request.own && scene.settings.own != request.own) return makePlan(withOwn(scene, request), request, before);
    const Needs needs = needsOf(scene, request.wanted, request.until);
    // Of a large scene the topology takes long; it is only compared with that of the frame before.
    const StageKeys keys = stageKeys(scene, needs, before ? topologyOf(scene, before) : nullptr);
    Plan plan = decide(needs, request.until, keys, pastOf(scene, before));
    explain(scene, needs, plan);
    return plan;
}

// May write a frame's members while the frame is made.
class Runner {
public:
    static FramePtr run(std::shared_ptr<const Scene> scene, const FrameRequest& request, const FramePtr& before) {
        const Clock::time_point start = Clock::now();
        auto frame = std::make_shared<Frame>();
        frame->m_topology = topologyOf(*scene, before);
        const Clock::time_point decides = Clock::now();
        frame->m_needs = needsOf(*scene, request.wanted, request.until);
        const double needed = millisecondsSince(decides);
        StageKeys keys = stageKeys(*scene, frame->m_needs, frame->m_topology);  // the inputs of the stages
        const Clock::time_point plans = Clock::now();
        frame->m_plan = decide(frame->m_needs, request.until, keys, pastOf(*scene, before));
        frame->m_planMilliseconds = needed + millisecondsSince(plans);
        frame->m_made = frame->m_needs.buffers;
        frame->m_number = before ? before->m_number + 1 : 1;
        frame->m_until = request.until;
        frame->m_wanted = request.wanted;
        frame->m_scene = std::move(scene);
        if (!runStages(*frame, request, std::move(keys), before)) return nullptr;
        frame->m_milliseconds = millisecondsSince(start);
        return frame;
    }

    static FramePtr unfinished(const Frame& whole, std::shared_ptr<const FrameStages> stages, StageId until) {
        auto frame = std::make_shared<Frame>();
        frame->m_scene = whole.m_scene, frame->m_topology = whole.m_topology;
        frame->m_needs = whole.m_needs, frame->m_plan = whole.plan(), frame->m_runs = whole.m_runs;
        frame->m_wanted = whole.m_wanted, frame->m_made = whole.m_made;
        frame->m_milliseconds = whole.m_milliseconds, frame->m_planMilliseconds = whole.m_planMilliseconds;
        frame->m_number = whole.m_number, frame->m_until = until;
        frame->m_stages = std::move(stages);
        for (std::size_t later = index(until) + 1; later < kStageCount; ++later) {
            frame->m_runs[later] = {};
            PlanStep& step = frame->m_plan[later];
            if (step.action == Action::LeaveOut) continue;
            step = {
                step.stage, Action::LeaveOut, fmt::format("Not yet: {} comes first.", stageInfo(until).label), {}, {},
                {}};
        }
        return frame;
    }

private:
    static bool runStages(Frame& frame, const FrameRequest& request, StageKeys keys, const FramePtr& before) {
        switch (frame.m_scene->settings.precision) {
            case Precision::Float: return runStagesIn<float>(frame, request, std::move(keys), before);
            case Precision::Double: return runStagesIn<double>(frame, request, std::move(keys), before);
            case Precision::Extended: return runStagesIn<long double>(frame, request, std::move(keys), before);
            case Precision::Quad: return runStagesIn<Quad>(frame, request, std::move(keys), before);
        }
        return false;
    }

    template <class Real>
    static bool runStagesIn(Frame& frame, const FrameRequest& request, StageKeys&& keys, const FramePtr& before) {
        Threads threads(request.threads, request.stop);
        auto stages = std::make_shared<FrameStages>();
        FrameData<Real>& data = stages->data.emplace<FrameData<Real>>();
        const FrameData<Real>* const old = before ? dataOf<Real>(*before) : nullptr;
        data.keys = std::move(keys);

        // Follows the plan for one stage: runs it, reuses the last frame's output, or leaves it out.
        const auto stage = [&](StageId id, auto member, auto compute) {
            if (threads.stopped()) return;  // the last output may be incomplete
            switch (frame.m_plan[index(id)].action) {
                case Action::LeaveOut: return;
                case Action::Reuse:
                    data.*member = (*old).*member;
                    frame.m_runs[index(id)] = before->m_runs[index(id)];
                    return;
                case Action::Run: break;
            }
            const Clock::time_point start = Clock::now();
            data.*member = compute();
            frame.m_runs[index(id)].milliseconds = millisecondsSince(start);
            if (threads.stopped()) return;
            frame.m_runs[index(id)].counts = countsOf(id, data);
            frame.m_runs[index(id)].tallies = talliesOf(id, data);
            frame.m_runs[index(id)].remark = remarkOf(id, data);
        };
        using Data = FrameData<Real>;
        stage(StageId::Transform, &Data::transform, [&] { return runTransform<Real>(data.keys.transform, threads); });
        stage(StageId::Cull, &Data::cull, [&] { return runCull(data.keys.cull, *data.transform, threads); });
        stage(StageId::Normals, &Data::normals,
              [&] { return runNormals(data.keys.normals, *data.transform, threads); });
        stage(StageId::ShadowBuffer, &Data::shadowBuffer,
              [&] { return runShadowsOf(data.keys.shadowBuffer, *data.transform, threads); });
        stage(StageId::ZBuffer, &Data::zBuffer, [&] { return runVisibility(data, threads); });
        stage(StageId::Shading, &Data::shading, [&] {
            const auto& incidence = frame.m_plan[index(StageId::Shading)].incidence;
            if (!incidence || incidence->action == Action::LeaveOut) return runShading(data, frame.m_made, {}, threads);
            if (incidence->action == Action::Reuse)
                return runShading(data, frame.m_made, old->shading->incidence, threads);
            return runShading(data, frame.m_made, Incidences(data.zBuffer->tileIsDrawn.size()), threads);
        });
        frame.m_stages = std::move(stages);
        return !threads.stopped();
    }
};

FramePtr unfinishedFrame(const Frame& whole, std::shared_ptr<const FrameStages> stages, StageId until) {
    return Runner::unfinished(whole, std::move(stages), until);
}

namespace {

template <class Real>
std::shared_ptr<const FrameStages> alone(const Frame& whole, const StageKeys& keys, StageId stage) {
    Threads threads(0, {});
    auto stages = std::make_shared<FrameStages>();
    FrameData<Real>& data = stages->data.emplace<FrameData<Real>>(*dataOf<Real>(whole));
    switch (stage) {
        case StageId::Transform:
            data.transform = runTransform<Real>(data.keys.transform = keys.transform, threads);
            break;
        case StageId::Cull: data.cull = runCull(data.keys.cull = keys.cull, *data.transform, threads); break;
        case StageId::Normals: {
            // The matrix for the mesh's own normals is computed with the other matrices, but belongs to this stage.
            auto in = std::make_shared<TransformOutput<Real>>(*data.transform);
            in->normalMatrix = prepareTransform<Real>(keys.transform).normalMatrix;
            data.transform = in;
            data.normals = runNormals(data.keys.normals = keys.normals, *data.transform, threads);
            break;
        }
        case StageId::ShadowBuffer:
            data.shadowBuffer = runShadowsOf(data.keys.shadowBuffer = keys.shadowBuffer, *data.transform, threads);
            break;
        case StageId::ZBuffer:
            data.keys.zBuffer = keys.zBuffer;
            data.zBuffer = runVisibility(data, threads);
            break;
        case StageId::Shading:
            data.keys.shading = keys.shading;
            data.shading = runShading(data, whole.made(), {}, threads);
            break;
    }
    return stages;
}

}  // namespace

FramePtr runAlone(const FramePtr& whole, StageId stage) {
    Scene right = whole->scene();
    if (!right.settings.isPlanted()) return whole;
    const Defect defect = right.settings.defect;
    const bool isOfFile = defect != Defect::None && !defectInfo(defect).stage;
    right.settings.defect = Defect::None, right.settings.own = nullptr, right.settings.leaveOut = false;
    const Needs needs = needsOf(right, whole->wanted(), whole->until());
    return readStages(*whole, [&]<class Real>(const FrameData<Real>& data) {
        // If the file is wrong, every stage is right for that file.
        const StageKeys keys = isOfFile ? data.keys : stageKeys(right, needs, whole->sharedTopology());
        return unfinishedFrame(*whole, alone<Real>(*whole, keys, stage), stage);
    });
}

FramePtr withDraw(const FramePtr& frame, unsigned draw, Stop stop) {
    return readStages(*frame, [&]<class Real>(const FrameData<Real>& before) -> FramePtr {
        Threads threads(0, stop);
        auto stages = std::make_shared<FrameStages>();
        FrameData<Real>& data = stages->data.emplace<FrameData<Real>>(before);
        data.shading = runShading(data, frame->made(), {}, threads, draw);
        return threads.stopped() ? nullptr : unfinishedFrame(*frame, std::move(stages), StageId::Shading);
    });
}

FramePtr runFrame(std::shared_ptr<const Scene> scene, const FrameRequest& request, const FramePtr& before) {
    if (request.own && scene->settings.own != request.own)
        scene = std::make_shared<const Scene>(withOwn(*scene, request));
    const bool isAsked = before && before->sharedScene() == scene && before->wanted() == request.wanted &&
                         before->until() == request.until;
    if (isAsked) return before;
    return Runner::run(std::move(scene), request, before);
}

}  // namespace pipeline
