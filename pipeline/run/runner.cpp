// The pipeline at a glance: six stages, in order, each a pure function of the ones before.
#include "pipeline/run/runner.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/run/frame_data.h"
#include "pipeline/run/parallel.h"
#include "pipeline/scene/area_light.h"
#include "pipeline/stages/painter.h"

namespace pipeline {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Enough work for one piece that handing it out does not show.
constexpr std::size_t kVertexGrain = 4096, kPolygonGrain = 1024, kTileGrain = 1, kSampleGrain = 1;

template <class Real>
std::shared_ptr<const TransformOutput<Real>> runTransform(const TransformInputs& inputs, Threads& threads) {
    auto out = std::make_shared<TransformOutput<Real>>(prepareTransform<Real>(inputs));
    for (std::size_t object = 0; object < inputs.transforms.size(); ++object)
        threads.forRange(inputs.topology->meshes[object]->positions.size(), kVertexGrain,
                         [&](std::size_t begin, std::size_t end) { transform(inputs, object, begin, end, *out); });
    return out;
}

template <class Real>
std::shared_ptr<const CullOutput> runCull(const CullInputs& inputs, const TransformOutput<Real>& in, Threads& threads) {
    auto out = std::make_shared<CullOutput>(prepareCull(in.topology->polygonCount()));
    threads.forRange(in.topology->polygonCount(), kPolygonGrain,
                     [&](std::size_t begin, std::size_t end) { cull(inputs, in, begin, end, *out); });
    return out;
}

template <class Real>
std::shared_ptr<const NormalsOutput<Real>> runNormals(const NormalsInputs& inputs, const TransformOutput<Real>& in,
                                                      Threads& threads) {
    auto out = std::make_shared<NormalsOutput<Real>>(prepareNormals(inputs, in));
    threads.forRange(in.topology->polygonCount(), kPolygonGrain,
                     [&](std::size_t begin, std::size_t end) { polygonNormals(in, begin, end, *out); });
    if (inputs.vertexNormals)
        for (std::size_t object = 0; object < in.topology->meshes.size(); ++object)
            if (!threads.stopped()) vertexNormals(inputs, in, object, *out);
    return out;
}

template <class Real>
std::shared_ptr<const ShadowBufferOutput<Real>> runShadowBuffer(const ShadowBufferInputs& inputs,
                                                                const TransformOutput<Real>& in, Threads& threads) {
    auto out = std::make_shared<ShadowBufferOutput<Real>>(prepareShadowBuffer(inputs, in));
    const auto drawFace = [&](LightView<Real>& light, std::size_t face) {
        const TriangleBins<Real> bins = binForLight(in, light.faces[face]);
        threads.forRange(bins.bins.size(), kTileGrain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t tile = begin; tile < end; ++tile)
                shadowBuffer(light.faces[face], bins, tile, light.depth[face]);
        });
    };
    for (std::vector<LightView<Real>>& samples : out->lights)
        threads.forRange(samples.size(), kSampleGrain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                for (std::size_t face = 0; face < samples[i].faces.size() && !threads.stopped(); ++face)
                    drawFace(samples[i], face);
        });
    return out;
}

template <class Real>
std::shared_ptr<const ZBufferOutput<Real>> runZBuffer(const ZBufferInputs& inputs, const TransformOutput<Real>& in,
                                                      const std::vector<Verdict>& verdicts, Threads& threads) {
    auto out = std::make_shared<ZBufferOutput<Real>>(prepareZBuffer<Real>({{0, 0}, in.view.size}, in.depthFormat));
    const TriangleBins<Real> bins = binTriangles<Real>(*in.topology, in.view, in.viewSpace, verdicts);
    if (inputs.visibility == Visibility::Painter) {
        const PaintingOrder order = paintingOrder<Real>(*in.topology, in.view, in.viewSpace, bins, inputs.split);
        const auto tiles = binPieces(bins, order);
        threads.forRange(tiles.size(), kTileGrain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t tile = begin; tile < end; ++tile)
                paint<Real>(in.view, bins, order, tiles[tile], bins.tile(tile), *out);
        });
        out->note = fmt::format("; {} triangles in order, {} split", order.pieces.size() - order.splits, order.splits);
        if (order.unordered > 0) out->note += fmt::format(", {} out of order at the limit", order.unordered);
        return out;
    }
    threads.forRange(bins.bins.size(), kTileGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile)
            zBuffer(in.view, in.depthFormat, bins, bins.bins[tile], bins.tile(tile), *out);
    });
    return out;
}

template <class Real>
std::shared_ptr<const ShadingOutput<Real>> runShading(const ShadingInputs& inputs, const ShadingSources<Real>& in,
                                                      BufferSet wanted, Threads& threads) {
    auto out = std::make_shared<ShadingOutput<Real>>(prepareShading(inputs, in, wanted));
    threads.forRange(out->polygons.intensity.size(), kPolygonGrain,
                     [&](std::size_t begin, std::size_t end) { shadePolygons(inputs, in, begin, end, *out); });
    threads.forRange(out->vertices.intensity.size(), kVertexGrain,
                     [&](std::size_t begin, std::size_t end) { shadeVertices(inputs, in, begin, end, *out); });
    const glm::ivec2 size = in.transform.view.size;
    constexpr std::size_t kRows = 16;
    threads.forRange(std::size_t(size.y), kRows, [&](std::size_t begin, std::size_t end) {
        shadePixels(inputs, in, Tile{{0, int(begin)}, {size.x, int(end)}}, *out);
    });
    return out;
}

template <class Count>
std::string plural(Count count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

// What a stage did, in counts that no clock disturbs.
template <class Real>
std::string countsOf(StageId stage, const FrameData<Real>& data) {
    const Topology& topology = *data.transform->topology;
    switch (stage) {
        case StageId::Transform:
            return fmt::format("{} {}", topology.vertexCount(), topology.vertexCount() == 1 ? "vertex" : "vertices");
        case StageId::Cull:
            return fmt::format("{} of {} polygons kept", std::ranges::count_if(data.cull->verdicts, goesOn),
                               topology.polygonCount());
        case StageId::Normals:
            return plural(data.normals->polygon.size(), "polygon normal") +
                   (data.normals->vertex.empty() ? "; vertex normals left out"
                                                 : "; " + plural(data.normals->vertex.size(), "vertex normal"));
        case StageId::ShadowBuffer: {
            std::size_t faces = 0;
            for (const auto& samples : data.shadowBuffer->lights)
                for (const LightView<Real>& sample : samples) faces += sample.faces.size();
            return plural(faces, "shadow buffer") + fmt::format(" of {}²", data.keys.shadowBuffer.size);
        }
        case StageId::ZBuffer: {
            long long arrived = 0, won = 0;
            for (std::int32_t n : data.zBuffer->overdraw.pixels) arrived += n;
            for (std::int32_t n : data.zBuffer->depthWrites.pixels) won += n;
            return fmt::format("{} fragments, {} {}{}", arrived, won,
                               data.keys.zBuffer.visibility == Visibility::ZBuffer ? "won" : "written",
                               data.zBuffer->note);
        }
        case StageId::Shading: {
            const auto seen =
                std::ranges::count_if(data.zBuffer->triangle.pixels, [](std::uint32_t t) { return t != kNoTriangle; });
            return plural(seen, "pixel") + " shaded";
        }
    }
    return {};
}

}  // namespace

std::shared_ptr<const Topology> topologyOf(const Scene& scene, const FramePtr& before) {
    auto meshes = meshesOf(scene);
    if (before) {
        const auto& old = before->dataFloat() ? before->dataFloat()->keys.transform.topology
                                              : before->dataDouble()->keys.transform.topology;
        if (old->meshes == meshes) return old;
    }
    return std::make_shared<const Topology>(makeTopology(std::move(meshes)));
}

StageKeys stageKeys(const Scene& scene, const Needs& needs, std::shared_ptr<const Topology> topology) {
    const Settings& settings = scene.settings;
    StageKeys keys{transformInputs(scene, std::move(topology)),
                   {settings.cull},
                   {settings.normalWeight, bool(needs.vertexNormals)},
                   {{}, settings.shadowSize},
                   {settings.visibility, settings.split},
                   {settings.shading,
                    illuminationOf(settings),
                    {},
                    {},
                    {},
                    scene.ambient,
                    {settings.shadowBias, settings.shadowBiasValue, settings.shadowFilter},
                    {},
                    bool(needs.polygonTerms),
                    bool(needs.vertexTerms),
                    needs.evaluateAll}};
    for (const Object& object : scene.objects) {
        keys.shading.materials.push_back(object.material);
        keys.shading.backMaterials.push_back(object.backMaterial.value_or(object.material));
    }
    keys.shading.lights = lightsInWorldSpace(scene, keys.transform.view);
    const std::vector<Light>& lights = keys.shading.lights;
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        keys.shading.lightCounts.push_back(bool(needs.light[k]));
        if (needs.shadowBuffer[k])
            keys.shadowBuffer.casters.push_back({lights[k].kind, samplePlaces(lights[k])});
        else
            keys.shadowBuffer.casters.push_back({});
    }
    return keys;
}

// Has access to a frame's inside while it is made.
class Runner {
public:
    static FramePtr run(std::shared_ptr<const Scene> scene, const FrameRequest& request, const FramePtr& before) {
        const Clock::time_point start = Clock::now();
        auto frame = std::make_shared<Frame>();
        frame->m_plan = makePlan(*scene, request, before);
        frame->m_topology = topologyOf(*scene, before);
        frame->m_number = before ? before->m_number + 1 : 1;
        frame->m_until = request.until;
        frame->m_wanted = request.wanted;
        frame->m_scene = std::move(scene);
        const bool done =
            frame->m_scene->settings.precision == Precision::Float
                ? runStages(*frame, request, before, before ? before->m_float : nullptr, frame->m_float)
                : runStages(*frame, request, before, before ? before->m_double : nullptr, frame->m_double);
        if (!done) return nullptr;
        frame->m_milliseconds = millisecondsSince(start);
        return frame;
    }

private:
    template <class Real>
    static bool runStages(Frame& frame, const FrameRequest& request, const FramePtr& before,
                          const std::shared_ptr<const FrameData<Real>>& old,
                          std::shared_ptr<const FrameData<Real>>& result) {
        Threads threads(request.threads, request.stop);
        const Scene& scene = *frame.m_scene;
        auto made = std::make_shared<FrameData<Real>>();
        FrameData<Real>& data = *made;
        data.keys = stageKeys(scene, needsOf(scene, request.wanted), frame.m_topology);

        // Carries out the plan for one stage: runs it, takes what the frame before has, or neither.
        const auto stage = [&](StageId id, auto member, auto compute) {
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
            if (!threads.stopped()) frame.m_runs[index(id)].counts = countsOf(id, data);
        };
        using Data = FrameData<Real>;
        stage(StageId::Transform, &Data::transform, [&] { return runTransform<Real>(data.keys.transform, threads); });
        stage(StageId::Cull, &Data::cull, [&] { return runCull(data.keys.cull, *data.transform, threads); });
        stage(StageId::Normals, &Data::normals,
              [&] { return runNormals(data.keys.normals, *data.transform, threads); });
        stage(StageId::ShadowBuffer, &Data::shadowBuffer,
              [&] { return runShadowBuffer(data.keys.shadowBuffer, *data.transform, threads); });
        stage(StageId::ZBuffer, &Data::zBuffer,
              [&] { return runZBuffer(data.keys.zBuffer, *data.transform, data.verdicts(), threads); });
        stage(StageId::Shading, &Data::shading,
              [&] { return runShading(data.keys.shading, data.shadingSources(), request.wanted, threads); });
        result = std::move(made);
        return !threads.stopped();
    }
};

FramePtr runFrame(std::shared_ptr<const Scene> scene, const FrameRequest& request, const FramePtr& before) {
    return Runner::run(std::move(scene), request, before);
}

}  // namespace pipeline
