#pragma once
#include <algorithm>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "pipeline/run/kernel_set.h"
#include "pipeline/run/parallel.h"
#include "pipeline/simd/rasterize.h"
#include "pipeline/stages/room.h"
#include "pipeline/stages/shadow_buffer.h"

// Parts of stages, on threads and with SIMD if there are kernels. Whole stages and steps inside a stage are built from
// them.
namespace pipeline {

// Work for one piece: large enough that starting it costs next to nothing.
inline constexpr std::size_t kVertexGrain = 4096, kPolygonGrain = 1024, kTileGrain = 1, kSampleGrain = 1;
inline constexpr std::size_t kPixelGrain = 65536;

// A buffer of one value.
template <class T>
Buffer2D<T> filled(glm::ivec2 size, T value, Threads& threads) {
    Buffer2D<T> out(size);
    threads.forRange(out.pixels.size(), kPixelGrain,
                     [&](std::size_t begin, std::size_t end) { clearPixels(out, begin, end, value); });
    return out;
}
// prepareZBuffer and prepareShading for a whole picture.
template <class Real>
ZBufferOutput<Real> clearedZBuffer(glm::ivec2 size, DepthFormat format, const Planted& planted, Threads& threads) {
    ZBufferOutput<Real> out = roomForZBuffer<Real>({{0, 0}, size}, format, planted);
    threads.forRange(out.overdraw.pixels.size(), kPixelGrain,
                     [&](std::size_t begin, std::size_t end) { clearZBuffer(format, begin, end, out); });
    if (threads.stopped()) return out;
    if (planted) spoilCleared(out);
    return out;
}
template <class Real>
ShadingOutput<Real> clearedShading(const ShadingInputs& inputs, const ShadingSources<Real>& in, BufferSet wanted,
                                   Threads& threads) {
    ShadingOutput<Real> out = roomForShading(inputs, in, wanted);
    threads.forRange(out.color.pixels.size(), kPixelGrain,
                     [&](std::size_t begin, std::size_t end) { clearShading(inputs, begin, end, out); });
    return out;
}

// Polygons [0, count).
template <class Real>
void cullPolygons(const CullInputs& inputs, const TransformOutput<Real>& in, std::size_t count, Threads& threads,
                  CullOutput& out) {
    threads.forRange(count, kPolygonGrain,
                     [&](std::size_t begin, std::size_t end) { piece::cull(inputs, in, begin, end, out); });
    if (inputs.planted) spoilVerdicts(inputs, in, count, out);
}
template <class Real>
void findPolygonNormals(const NormalsInputs& inputs, const TransformOutput<Real>& in, std::size_t count,
                        Threads& threads, NormalsOutput<Real>& out) {
    threads.forRange(count, kPolygonGrain,
                     [&](std::size_t begin, std::size_t end) { piece::polygonNormals(inputs, in, begin, end, out); });
    if (inputs.planted) spoilPolygonNormals(inputs.planted, in, count, out);
}

// For one object. If all normals are the mesh's own, nothing reads the sums, and no normal vanishes.
template <class Real>
void findVertexNormals(const NormalsInputs& inputs, const TransformOutput<Real>& in, std::size_t object,
                       Threads& threads, NormalsOutput<Real>& out) {
    if (out.vertex.areGiven()) return;
    const bool sums = inputs.ownNormals.empty() || !inputs.ownNormals[object];
    if (sums) sumAroundVertices(inputs, in, object, out);
    const std::size_t count = in.topology->firstVertex[object + 1] - in.topology->firstVertex[object];
    threads.forRange(count, kVertexGrain, [&](std::size_t begin, std::size_t end) {
        piece::unitVertexNormals(inputs, in, object, begin, end, out);
    });
    if (sums) replaceVanishing(in, object, out);
    if (inputs.planted) spoilVertexNormals(inputs, in, object, out);
}

// Sets up pieces [first, last) of the triangles.
inline void setUpPieces(const SetUpInputs& inputs, std::size_t first, std::size_t last, TrianglePieces& out,
                        Threads& threads) {
    threads.forRange(last - first, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t piece = first + begin; piece < first + end; ++piece) setUpPiece(inputs, piece, out);
    });
}

// The rows of a buffer drawn in blocks, made when they are first read.
inline LateBuffer2D<float> rowsLater(const std::shared_ptr<const BlockBuffer2D<float>>& blocks) {
    return LateBuffer2D<float>(
        [blocks] { return rowsOf(*blocks, std::vector<std::uint8_t>(blocks->tileCount(), 1), 0.0F); });
}

// The face of a light that sees nothing; all such faces share one. Most faces of a point light do, and area lights may
// have hundreds.
class EmptyFace {
public:
    std::shared_ptr<const BlockBuffer2D<float>> ofSize(glm::ivec2 size) {
        std::call_once(m_made, [&] {
            auto blocks = std::make_shared<BlockBuffer2D<float>>(size);
            for (std::size_t tile = 0; tile < blocks->tileCount(); ++tile)
                blocks->fill(tile, std::numeric_limits<float>::infinity());
            m_blocks = blocks;
        });
        return m_blocks;
    }

private:
    std::once_flag m_made;
    std::shared_ptr<const BlockBuffer2D<float>> m_blocks;
};

// Draws what one face of a light sees. drawn: for each polygon, whether it casts; empty: all do.
inline void drawShadowFace(const TransformOutput<float>& in, ShadowCull cull, std::span<const std::uint8_t> drawn,
                           LightView<float>& light, std::size_t number, EmptyFace& empty, Threads& threads) {
    const View& face = light.faces[number];
    SnappedVertices snapped;
    SetUpInputs setUp{*in.topology, face, in.world, nullptr, {}, {}, drawn, false, false, facingFilter(cull, in)};
    TrianglePieces pieces = prepareSetUp(setUp);
    if (!snapsSeldom(setUp, pieces)) {
        snapped.bits = face.subPixelBits;
        snapped.of.resize(in.world.size());
        threads.forRange(in.world.size(), kVertexGrain, [&](std::size_t begin, std::size_t end) {
            snapInVectors(face, in.world, begin, end, snapped);
        });
        setUp.vertices = &snapped;
    }
    // Limits the triangles set up at once, so that the lists of a fine mesh are not all in memory. The nearest depth
    // remains in any order.
    constexpr std::size_t kMostAtOnce = 1 << 19;  // triangles
    const std::size_t each = std::max<std::size_t>(1, kMostAtOnce / (1 + trianglesOfPiece(setUp, pieces)));
    std::shared_ptr<BlockBuffer2D<float>> blocks;
    for (std::size_t first = 0; first < pieces.pieces.size(); first += each) {
        const std::size_t last = std::min(pieces.pieces.size(), first + each);
        setUpPieces(setUp, first, last, pieces, threads);
        if (last == pieces.pieces.size()) snapped = {}, setUp.vertices = nullptr;
        const std::span<TrianglePiece> some = std::span(pieces.pieces).subspan(first, last - first);
        if (std::ranges::all_of(some, [](const auto& piece) { return piece.runs.empty(); })) continue;
        const bool isFirst = !blocks;
        if (isFirst) blocks = std::make_shared<BlockBuffer2D<float>>(face.size);
        threads.forRange(pieces.tileCount(), kTileGrain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t tile = begin; tile < end; ++tile)
                shadowBufferInVectors(setUp, pieces, tile, isFirst, *blocks);
        });
        for (TrianglePiece& piece : some) piece = {};  // keeps its capacity
    }
    light.blocks[number] = blocks ? blocks : empty.ofSize(face.size);
    light.depth[number] = rowsLater(light.blocks[number]);
}
template <class Real>
void drawShadowFace(const TransformOutput<Real>& in, ShadowCull cull, std::span<const std::uint8_t> drawn,
                    LightView<Real>& light, std::size_t number, EmptyFace&, Threads& threads) {
    const View& face = light.faces[number];
    if (light.depth[number]->empty())
        light.depth[number] = filled(face.size, std::numeric_limits<Real>::infinity(), threads);
    // The nearest depth remains in any order.
    forTrianglesInParts(*in.topology, [&](TriangleRange range) {
        if (threads.stopped()) return;
        const TriangleBins<Real> bins = binForLight(in, face, cull, drawn, range);
        threads.forRange(bins.bins.size(), kTileGrain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t tile = begin; tile < end; ++tile) shadowBuffer(face, bins, tile, *light.depth[number]);
        });
    });
}

// Draws what all samples and faces of a light see.
template <class Real>
void drawShadows(const TransformOutput<Real>& in, ShadowCull cull, std::span<const std::uint8_t> drawn,
                 std::vector<LightView<Real>>& samples, Threads& threads) {
    EmptyFace empty;
    threads.forRange(samples.size(), kSampleGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t face = 0; face < samples[i].faces.size() && !threads.stopped(); ++face)
                drawShadowFace(in, cull, drawn, samples[i], face, empty, threads);
    });
}

}  // namespace pipeline
