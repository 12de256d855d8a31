#pragma once
#include <fmt/format.h>

#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "pipeline/core/text.h"
#include "pipeline/run/find_seen.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/run/stage_parts.h"
#include "pipeline/simd/rasterize.h"
#include "pipeline/stages/outlines.h"
#include "pipeline/stages/painter.h"
#include "pipeline/stages/sample_pattern.h"
#include "pipeline/stages/translucent.h"

// Runs each stage as a whole, its pieces on threads. Only runner.cpp includes it.
namespace pipeline {

template <class Real>
void snapVertices(TransformOutput<Real>& out, Threads& threads) {
    piece::makeRoomForSnapped(out);
    threads.forRange(out.world.size(), kVertexGrain,
                     [&](std::size_t begin, std::size_t end) { piece::snap(begin, end, out); });
}

template <class Real>
std::shared_ptr<const TransformOutput<Real>> runTransform(const TransformInputs& inputs, Threads& threads) {
    auto out = std::make_shared<TransformOutput<Real>>(prepareTransform<Real>(inputs));
    piece::makeRoomForSnapped(*out);
    for (std::size_t object = 0; object < inputs.transforms.size(); ++object) {
        threads.forRange(
            inputs.topology->meshes[object]->positions.size(), kVertexGrain,
            [&](std::size_t begin, std::size_t end) { piece::transform(inputs, object, begin, end, *out); });
    }
    if (inputs.planted) spoilPlaces(inputs, *out);
    if (inputs.planted) snapVertices(*out, threads);
    return out;
}

template <class Real>
std::shared_ptr<const CullOutput> runCull(const CullInputs& inputs, const TransformOutput<Real>& in, Threads& threads) {
    auto out = std::make_shared<CullOutput>(prepareCull(in.topology->polygonCount()));
    cullPolygons(inputs, in, in.topology->polygonCount(), threads, *out);
    return out;
}

template <class Real>
std::shared_ptr<const NormalsOutput<Real>> runNormals(const NormalsInputs& inputs, const TransformOutput<Real>& in,
                                                      Threads& threads) {
    auto out = std::make_shared<NormalsOutput<Real>>(prepareNormals(inputs, in));
    findPolygonNormals(inputs, in, out->polygon.size(), threads, *out);
    for (std::size_t object = 0; object < in.topology->meshes.size() && inputs.vertexNormals; ++object)
        if (!threads.stopped()) findVertexNormals(inputs, in, object, threads, *out);
    out->weighted = RawVector<Vec3<Real>>();
    return out;
}

template <class Real>
std::shared_ptr<const ShadowBufferOutput<Real>> runShadowBuffer(const ShadowBufferInputs& inputs,
                                                                const TransformOutput<Real>& in, Threads& threads) {
    auto out = std::make_shared<ShadowBufferOutput<Real>>(piece::prepareShadowBuffer(inputs, in));
    for (std::vector<LightView<Real>>& samples : out->lights) drawShadows<Real>(in, inputs.cull, {}, samples, threads);
    return out;
}

// Without the transparent objects, which throw no shadow.
template <class Real>
std::shared_ptr<const ShadowBufferOutput<Real>> runShadowsOf(const ShadowBufferInputs& inputs,
                                                             const TransformOutput<Real>& in, Threads& threads) {
    return runShadowBuffer(inputs, in.transparent.empty() ? in : withoutTransparent(in), threads);
}

template <class Real>
void sumCounts(ZBufferOutput<Real>& out, const Threads& threads) {
    const auto& triangles = out.triangle->pixels;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (i % kPixelGrain == 0 && threads.stopped()) return;
        out.arrived += out.overdraw.pixels[i], out.won += out.depthWrites.pixels[i];
        out.seenPixels += triangles[i] != kNoTriangle;
    }
}

template <class Real>
std::shared_ptr<const ZBufferOutput<Real>> runOutlines(const FrameData<Real>& data, Threads& threads) {
    const View& view = data.transform->view;
    auto out = std::make_shared<ZBufferOutput<Real>>(clearedZBuffer<Real>(view.size, DepthFormat::Linear, {}, threads));
    const OutlineBins<Real> bins = binOutlines<Real>(*data.transform, {{0, 0}, view.size},
                                                     [&](std::uint32_t polygon) { return data.hasOutline(polygon); });
    for (const auto& bin : bins.bins) out->tileIsDrawn.push_back(!bin.empty());
    threads.forRange(bins.tiles.size(), kTileGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile) drawOutlines(view, bins, tile, *out);
    });
    sumCounts(*out, threads);
    out->note = fmt::format("; {} outline{}", bins.polygons, bins.polygons == 1 ? "" : "s");
    return out;
}

// The inputs of stage 5; kept alive until nobody can ask for triangle ids any more.
template <class Real>
struct DrawingSources {
    std::shared_ptr<const TransformOutput<Real>> transform;
    std::shared_ptr<const CullOutput> cull;
    std::span<const Verdict> verdicts{};
    std::span<const std::uint8_t> marks{};
    std::vector<std::uint8_t> drawn{};  // for each polygon; empty: all are

    DrawingSources(const ZBufferInputs& inputs, std::shared_ptr<const TransformOutput<Real>> transformed,
                   std::shared_ptr<const CullOutput> culled)
        : transform(std::move(transformed)), cull(std::move(culled)) {
        if (cull) verdicts = cull->verdicts;
        if (cull && !inputs.parts[Part::Clipping]) marks = cull->marks;
        drawn = drawnIn(Pass::Opaque, *transform->topology, transform->transparent, inputs.translucent, cull.get());
    }
};

template <class Real>
std::shared_ptr<const ZBufferOutput<Real>> runZBuffer(const ZBufferInputs& inputs, const DrawingSources<Real>& sources,
                                                      Threads& threads) {
    const TransformOutput<Real>& in = *sources.transform;
    auto out = std::make_shared<ZBufferOutput<Real>>(
        clearedZBuffer<Real>(in.view.size, in.depthFormat, inputs.planted, threads));
    const auto binned = [&](TriangleRange range) {
        auto bins = binTriangles<Real>(*in.topology, in.view, in.world, sources.verdicts, sources.marks, sources.drawn,
                                       {}, range);
        out->clipped += bins.clipped, out->unclipped += bins.unclipped;
        out->tileIsDrawn.resize(bins.bins.size());
        for (std::size_t tile = 0; tile < bins.bins.size(); ++tile)
            out->tileIsDrawn[tile] = out->tileIsDrawn[tile] || !bins.bins[tile].empty();
        return bins;
    };
    if (inputs.visibility == Visibility::Painter) {
        const TriangleBins<Real> bins = binned({});
        const PaintingOrder order =
            paintingOrder<Real>(*in.topology, in.view, in.world, bins, inputs.split, threads.stop());
        const auto tiles = binPieces(bins, order);
        threads.forRange(tiles.size(), kTileGrain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t tile = begin; tile < end; ++tile)
                paint<Real>(in.view, bins, order, tiles[tile], bins.tile(tile), *out);
        });
        out->note = fmt::format("; {} in order, {} split",
                                plural(std::int64_t(order.pieces.size() - order.splits), "triangle"), order.splits);
        if (order.unordered > 0) out->note += fmt::format(", {} out of order", order.unordered);
        out->unordered = order.unordered, out->pieces = order.pieces.size();
        sumCounts(*out, threads);
        return out;
    }
    forTrianglesInParts(*in.topology, [&](TriangleRange range) {
        if (threads.stopped()) return;
        const TriangleBins<Real> bins = binned(range);
        threads.forRange(bins.bins.size(), kTileGrain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t tile = begin; tile < end; ++tile)
                zBuffer(in.view, in.depthFormat, bins, bins.bins[tile], bins.tile(tile), *out);
        });
    });
    sumCounts(*out, threads);
    return out;
}

// With the SIMD kernels; gives the same bits.
inline std::shared_ptr<const ZBufferOutput<float>> runZBufferInVectors(const ZBufferInputs& inputs,
                                                                       const DrawingSources<float>& sources,
                                                                       Threads& threads) {
    const TransformOutput<float>& in = *sources.transform;
    const SetUpInputs setUp{*in.topology,
                            in.view,
                            in.world,
                            &in.snapped,
                            sources.verdicts,
                            sources.marks,
                            sources.drawn,
                            inputs.parts[Part::SeenPolygons],
                            inputs.parts[Part::Clipping]};
    auto out = std::make_shared<ZBufferOutput<float>>();
    if (inputs.parts[Part::Weights]) out->barycentric = filled(in.view.size, Vec3<float>(0), threads);
    if (inputs.parts[Part::FragmentCounts])
        for (Buffer2D<std::int32_t>* counts : {&out->overdraw, &out->depthWrites})
            *counts = filled(in.view.size, 0, threads);
    auto seen = std::make_shared<SeenBlocks>();
    seen->pieces = prepareSetUp(setUp);
    setUpPieces(setUp, 0, seen->pieces.pieces.size(), seen->pieces, threads);
    seen->z = BlockBuffer2D<float>(in.view.size);
    if (inputs.parts[Part::SeenPolygons]) seen->name = BlockBuffer2D<std::uint32_t>(in.view.size);
    const TrianglePieces& pieces = seen->pieces;
    for (const TrianglePiece& piece : pieces.pieces) out->clipped += piece.clipped, out->unclipped += piece.unclipped;
    for (std::size_t tile = 0; tile < pieces.tileCount(); ++tile) out->tileIsDrawn.push_back(pieces.touches(tile));
    std::vector<TileCounts> counts(pieces.tileCount());
    threads.forRange(counts.size(), kTileGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile) counts[tile] = zBufferInVectors(setUp, tile, *seen, *out);
    });
    for (const TileCounts& tile : counts)
        out->arrived += tile.arrived, out->won += tile.won, out->seenPixels += tile.seen;
    seen->triangles = pieces.count();
    seen->pieces.forgetDrawn();
    out->seen = seen;
    const std::vector<std::uint8_t>& drawn = out->tileIsDrawn;
    out->zView = LateBuffer2D<float>([seen, drawn] { return rowsOf(seen->z, drawn, SeenBlocks::kNowhere); });
    if (!inputs.parts[Part::SeenPolygons]) {
        // Runs the stage again to get triangle ids only; keeps its inputs alive until then.
        out->triangle = LateBuffer2D<std::uint32_t>([again = inputs, sources]() mutable {
            Threads one(1, {});
            again.parts.whole.set(Part::SeenPolygons);
            again.parts.whole.set(Part::FragmentCounts, false).set(Part::Weights, false);
            return *runZBufferInVectors(again, sources, one)->triangle;
        });
        return out;
    }
    out->triangle = LateBuffer2D<std::uint32_t>([seen, drawn] {
        Buffer2D<std::uint32_t> rows = rowsOf(seen->name, drawn, kNoTriangle);
        const Buffer2D<float> z = rowsOf(seen->z, drawn, SeenBlocks::kNowhere);
        for (std::size_t i = 0; i < rows.pixels.size(); ++i) {
            std::uint32_t& triangle = rows.pixels[i];
            triangle = z.pixels[i] < SeenBlocks::kNowhere ? seen->pieces.triangleOf(triangle) : kNoTriangle;
        }
        return rows;
    });
    return out;
}
inline std::shared_ptr<const ZBufferOutput<float>> runZBuffer(const ZBufferInputs& inputs,
                                                              const DrawingSources<float>& sources, Threads& threads) {
    return inputs.parts[Part::DrawnInVectors] ? runZBufferInVectors(inputs, sources, threads)
                                              : runZBuffer<float>(inputs, sources, threads);
}

// Stage 5 for the scene's visibility: the z-buffer, the painter's algorithm or outlines.
template <class Real>
std::shared_ptr<const ZBufferOutput<Real>> runVisibility(const FrameData<Real>& data, Threads& threads) {
    if (data.keys.zBuffer.visibility == Visibility::None) return runOutlines(data, threads);
    const ZBufferInputs& inputs = data.keys.zBuffer;
    return runZBuffer(inputs, DrawingSources<Real>(inputs, data.transform, data.cull), threads);
}

// Adds up the counts of pieces that run at the same time.
class CountSum {
public:
    explicit CountSum(ShadingCounts& sum) : m_sum(sum) {}
    void add(const ShadingCounts& counts) {  // once for each piece, so the lock costs nothing
        const std::scoped_lock lock(m_mutex);
        m_sum += counts;
    }

private:
    std::mutex m_mutex;
    ShadingCounts& m_sum;
};

// Shades the pixels of tile i, with SIMD or one at a time as the plan has chosen. A tile with kept light is lit again
// from it. `looks` is for those tiles.
template <class Real>
ShadingCounts shadeTile(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::span<const Look> looks,
                        std::size_t i, ShadingOutput<Real>& out) {
    const Tile pixels = tileOf(in.transform.view.size, i);
    if (inputs.outlines) return shadeOutlines(in, pixels, out);
    ShadingCounts relit{.relitTiles = 1};
    return piece::relight(inputs, looks, i, pixels, out, relit) ? relit : piece::shadePixels(inputs, in, pixels, out);
}

// Shades the pixels of a picture after its polygons and vertices, then blends the translucent layers.
template <class Real>
void shadePicture(const ShadingInputs& inputs, const ShadingSources<Real>& in, ShadingOutput<Real>& out,
                  CountSum& counts, Threads& threads) {
    const std::vector<std::uint8_t>& drawn = in.zBuffer.tileIsDrawn;
    std::vector<Look> looks;
    if (!out.incidence.empty())
        for (const Material& material : inputs.materials) looks.emplace_back(inputs, material);
    threads.forRange(drawn.size(), kTileGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile) {
            if (!inputs.parts[Part::Tiles] && !drawn[tile]) {
                piece::leaveDark(inputs, tileOf(in.transform.view.size, tile), out);
                counts.add({.emptyTiles = 1});
                continue;
            }
            ShadingCounts shaded = shadeTile(inputs, in, looks, tile, out);
            ++shaded.tiles;
            counts.add(shaded);
        }
    });
    if (!inputs.layers.drawn || threads.stopped()) return;
    const LayerBins<Real> layers = binLayers(inputs, in);
    threads.forRange(layers.order.size(), kTileGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile)
            counts.add(drawLayers(inputs, in, layers, tile, out, piece::layerShader<Real>(inputs)));
    });
}

// Computes the picture again for each sample of a pixel, with the pixels' centres moved to the sample, and takes the
// mean: an accumulation buffer. All other buffers are those of the centres. Polygons and vertices are shaded only once.
// P. Haeberli and K. Akeley, "The accumulation buffer: hardware support for high-quality rendering", SIGGRAPH 1990.
template <class Real>
void antialias(const FrameData<Real>& data, unsigned draw, ShadingOutput<Real>& out, CountSum& counts,
               Threads& threads) {
    const ShadingInputs& inputs = data.keys.shading;
    const std::vector<glm::dvec2> places = samplePlaces(inputs.samplePattern, inputs.samples, draw);
    auto moved = std::make_shared<TransformOutput<Real>>(*data.transform);
    FrameData<Real> sample = data;
    sample.transform = moved;
    Buffer2D<Vec3<Real>>& mean = out.vectors[index(BufferId::Antialiased)][0];
    typename Buffer2D<Vec3<Real>>::Pixels first(mean.pixels.size());
    for (std::size_t i = 0; i < places.size() && !threads.stopped(); ++i) {
        moved->view.centre = data.transform->view.centre - places[i];
        snapVertices(*moved, threads);
        if (data.cull) sample.cull = runCull(data.keys.cull, *moved, threads);
        sample.zBuffer = runVisibility(sample, threads);
        ShadingOutput<Real> shaded =
            clearedShading(inputs, sample.shadingSources(), setOf({BufferId::Intensity}), threads);
        // Swapped instead of copied, because there may be as many as the mesh has.
        const auto lend = [&] {
            std::swap(out.polygons, shaded.polygons);
            std::swap(out.vertices, shaded.vertices);
            std::swap(out.verticesBack, shaded.verticesBack);
        };
        lend();
        shadePicture(inputs, sample.shadingSources(), shaded, counts, threads);
        lend();
        const auto& intensity = shaded.vectors[index(BufferId::Intensity)][0].pixels;
        // Adds differences from the first sample: if all samples are equal, the mean equals them exactly.
        threads.forRange(first.size(), kPixelGrain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t p = begin; p < end; ++p) {
                if (i == 0) mean.pixels[p] = first[p] = intensity[p];
                mean.pixels[p] += (intensity[p] - first[p]) / Real(places.size());
            }
        });
    }
    threads.forRange(first.size(), kPixelGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p)
            storeFrameBufferValue(Vec3d(mean.pixels[p]), out.iMax, inputs.planted, out.color.pixels[p]);
    });
}

// incidence: the light kept by the last frame; null in tiles that have to keep it, empty if no tile does. draw: of the
// samples of a pixel.
template <class Real>
std::shared_ptr<const ShadingOutput<Real>> runShading(const FrameData<Real>& data, BufferSet wanted,
                                                      const Incidences& incidence, Threads& threads,
                                                      unsigned draw = 0) {
    const ShadingInputs& inputs = data.keys.shading;
    const ShadingSources<Real> in = data.shadingSources();
    auto out = std::make_shared<ShadingOutput<Real>>(clearedShading(inputs, in, wanted, threads));
    out->incidence = incidence;
    prepareElements(inputs, in, findSeen(inputs, in, threads), *out);
    CountSum counts(out->counts);
    threads.forRange(out->polygons.count(), kPolygonGrain, [&](std::size_t begin, std::size_t end) {
        counts.add(shadePolygons(inputs, in, begin, end, *out));
    });
    threads.forRange(out->vertices.count(), kVertexGrain, [&](std::size_t begin, std::size_t end) {
        counts.add(shadeVertices(inputs, in, begin, end, *out));
    });
    shadePicture(inputs, in, *out, counts, threads);
    auto& mean = out->vectors[index(BufferId::Antialiased)];
    if (inputs.samples > 1)
        antialias(data, draw, *out, counts, threads);
    else if (!mean.empty())  // the only sample's
        threads.forRange(mean[0].pixels.size(), kPixelGrain, [&](std::size_t begin, std::size_t end) {
            const auto& only = out->vectors[index(BufferId::Intensity)][0].pixels;
            std::copy(only.begin() + std::ptrdiff_t(begin), only.begin() + std::ptrdiff_t(end),
                      mean[0].pixels.begin() + std::ptrdiff_t(begin));
        });
    return out;
}

}  // namespace pipeline
