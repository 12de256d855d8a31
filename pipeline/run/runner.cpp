// The pipeline at a glance: six stages, in order, each a pure function of the ones before.
#include "pipeline/run/runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "pipeline/run/counts.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/run/parallel.h"
#include "pipeline/scene/area_light.h"
#include "pipeline/stages/outlines.h"
#include "pipeline/stages/painter.h"
#include "pipeline/stages/translucent.h"

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
std::shared_ptr<const ZBufferOutput<Real>> runOutlines(const FrameData<Real>& data, Threads& threads) {
    const View& view = data.transform->view;
    auto out = std::make_shared<ZBufferOutput<Real>>(prepareZBuffer<Real>({{0, 0}, view.size}, DepthFormat::Linear));
    const OutlineBins<Real> bins = binOutlines<Real>(*data.transform, {{0, 0}, view.size},
                                                     [&](std::uint32_t polygon) { return data.hasOutline(polygon); });
    for (const auto& bin : bins.bins) out->tileIsDrawn.push_back(!bin.empty());
    threads.forRange(bins.tiles.size(), kTileGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile) drawOutlines(view, bins, tile, *out);
    });
    out->note = fmt::format("; {} outline{}", bins.polygons, bins.polygons == 1 ? "" : "s");
    return out;
}

template <class Real>
std::shared_ptr<const ZBufferOutput<Real>> runZBuffer(const ZBufferInputs& inputs, const TransformOutput<Real>& in,
                                                      const CullOutput* cull, Threads& threads) {
    auto out = std::make_shared<ZBufferOutput<Real>>(prepareZBuffer<Real>({{0, 0}, in.view.size}, in.depthFormat));
    std::span<const Verdict> verdicts;
    if (cull) verdicts = cull->verdicts;
    std::span<const std::uint8_t> inside;
    if (cull && !inputs.clipAll) inside = cull->inside;
    const std::vector<std::uint8_t> drawn =
        drawnIn(Pass::Opaque, *in.topology, in.transparent, inputs.translucent, cull);
    const TriangleBins<Real> bins = binTriangles<Real>(*in.topology, in.view, in.viewSpace, verdicts, inside, drawn);
    out->clipped = bins.clipped, out->unclipped = bins.unclipped;
    for (const auto& bin : bins.bins) out->tileIsDrawn.push_back(!bin.empty());
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
    std::mutex mutex;
    const auto add = [&](const ShadingCounts& counts) {  // once a piece: the lock does not show
        const std::scoped_lock lock(mutex);
        out->counts += counts;
    };
    threads.forRange(out->polygons.intensity.size(), kPolygonGrain,
                     [&](std::size_t begin, std::size_t end) { add(shadePolygons(inputs, in, begin, end, *out)); });
    threads.forRange(out->vertices.intensity.size(), kVertexGrain,
                     [&](std::size_t begin, std::size_t end) { add(shadeVertices(inputs, in, begin, end, *out)); });
    const std::vector<std::uint8_t>& drawn = in.zBuffer.tileIsDrawn;
    threads.forRange(drawn.size(), kTileGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile) {
            if (inputs.parts.emptyTiles || drawn[tile]) {
                const Tile pixels = tileOf(in.transform.view.size, tile);
                ShadingCounts counts =
                    inputs.outlines ? shadeOutlines(in, pixels, *out) : shadePixels(inputs, in, pixels, *out);
                ++counts.tiles;
                add(counts);
            } else {
                add({.emptyTiles = 1});
            }
        }
    });
    if (!inputs.layers.drawn || threads.stopped()) return out;
    const LayerBins<Real> layers = binLayers(inputs, in);
    threads.forRange(layers.order.size(), kTileGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile) add(drawLayers(inputs, in, layers, tile, *out));
    });
    return out;
}

}  // namespace

std::shared_ptr<const Topology> topologyOf(const Scene& scene, const FramePtr& before) {
    auto meshes = meshesOf(scene);
    if (before) {
        auto old = readStages(*before, [](const auto& data) { return data.keys.transform.topology; });
        if (old->meshes == meshes) return old;
    }
    return std::make_shared<const Topology>(makeTopology(std::move(meshes)));
}

namespace {

bool without(const Needs& needs, Rule rule) { return !needs.rules[index(rule)]; }

ShadingParts shadingParts(const Needs& needs) {
    ShadingParts parts;
    for (const Need& need : needs.light) parts.lights.push_back(bool(need));
    for (const Need& need : needs.attenuation) parts.attenuation.push_back(bool(need));
    parts.polygonTerms = bool(needs.polygonTerms), parts.vertexTerms = bool(needs.vertexTerms);
    parts.hiddenPolygons = needs.hiddenPolygons, parts.hiddenVertices = needs.hiddenVertices;
    parts.ambient = bool(needs.ambient);
    parts.position = bool(needs.position), parts.viewVector = bool(needs.viewVector);
    parts.idleLookups = without(needs, Rule::ShadowLookup);
    parts.emptyTiles = without(needs, Rule::EmptyTiles);
    return parts;
}

}  // namespace

StageKeys stageKeys(const Scene& scene, const Needs& needs, std::shared_ptr<const Topology> topology) {
    const Settings& settings = scene.settings;
    StageKeys keys{transformInputs(scene, std::move(topology)),
                   {settings.cull},
                   {settings.normalWeight, bool(needs.vertexNormals)},
                   {{}, settings.shadowSize},
                   {settings.visibility, settings.split, without(needs, Rule::Clipping), translucentSides(scene)},
                   {settings.shading,
                    settings.shading == Shading::Flat ? Interpolation::Perspective : settings.interpolation,
                    settings.visibility == Visibility::None,
                    illuminationOf(settings),
                    {},
                    {},
                    {},
                    scene.ambient,
                    {settings.shadowBias, settings.shadowBiasValue, settings.shadowFilter},
                    shadingParts(needs)}};
    keys.shading.illumination.detail = {bool(needs.reflection), bool(needs.halfway), without(needs, Rule::Specular),
                                        without(needs, Rule::VanishingPower)};
    if (needs.layers)
        keys.shading.layers = {true, bool(needs.layerSort), settings.translucency,
                               settings.visibility == Visibility::ZBuffer, keys.zBuffer.translucent};
    for (const Object& object : scene.objects) {
        keys.shading.materials.push_back(object.material);
        keys.shading.backMaterials.push_back(object.backMaterial.value_or(object.material));
    }
    keys.shading.lights = lightsInWorldSpace(scene, keys.transform.view);
    const std::vector<Light>& lights = keys.shading.lights;
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
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
        frame->m_topology = topologyOf(*scene, before);
        const Clock::time_point decides = Clock::now();
        frame->m_needs = needsOf(*scene, request.wanted);
        const double needed = millisecondsSince(decides);
        StageKeys keys = stageKeys(*scene, frame->m_needs, frame->m_topology);  // what the stages read
        const Clock::time_point plans = Clock::now();
        frame->m_plan = decide(*scene, request, frame->m_needs, keys, before);
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
    static bool runStagesIn(Frame& frame, const FrameRequest& request, StageKeys keys, const FramePtr& before) {
        Threads threads(request.threads, request.stop);
        auto stages = std::make_shared<FrameStages>();
        FrameData<Real>& data = stages->data.emplace<FrameData<Real>>();
        const FrameData<Real>* const old = before ? dataOf<Real>(*before) : nullptr;
        data.keys = std::move(keys);

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
            if (threads.stopped()) return;
            frame.m_runs[index(id)].counts = countsOf(id, data);
            frame.m_runs[index(id)].tallies = talliesOf(id, data);
        };
        using Data = FrameData<Real>;
        stage(StageId::Transform, &Data::transform, [&] { return runTransform<Real>(data.keys.transform, threads); });
        stage(StageId::Cull, &Data::cull, [&] { return runCull(data.keys.cull, *data.transform, threads); });
        stage(StageId::Normals, &Data::normals,
              [&] { return runNormals(data.keys.normals, *data.transform, threads); });
        stage(StageId::ShadowBuffer, &Data::shadowBuffer, [&] {
            const TransformOutput<Real>& in = *data.transform;
            if (in.transparent.empty()) return runShadowBuffer(data.keys.shadowBuffer, in, threads);
            return runShadowBuffer(data.keys.shadowBuffer, withoutTransparent(in), threads);
        });
        stage(StageId::ZBuffer, &Data::zBuffer, [&] {
            return data.keys.zBuffer.visibility == Visibility::None
                       ? runOutlines(data, threads)
                       : runZBuffer(data.keys.zBuffer, *data.transform, data.cull.get(), threads);
        });
        stage(StageId::Shading, &Data::shading,
              [&] { return runShading(data.keys.shading, data.shadingSources(), frame.m_made, threads); });
        frame.m_stages = std::move(stages);
        return !threads.stopped();
    }
};

FramePtr runFrame(std::shared_ptr<const Scene> scene, const FrameRequest& request, const FramePtr& before) {
    return Runner::run(std::move(scene), request, before);
}

}  // namespace pipeline
