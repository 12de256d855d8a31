#pragma once
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include "pipeline/run/parallel.h"
#include "pipeline/simd/seen_blocks.h"
#include "pipeline/stages/shading.h"

// The polygons and vertices that flat and Gouraud shading evaluate if the plan leaves out hidden ones.
namespace pipeline {

// Marks the polygons that the pixels of a tile show. Tiles may run at the same time.
template <class Real>
void markShown(const ShadingSources<Real>& in, std::size_t tile, std::vector<std::uint8_t>& isSeen) {
    std::uint32_t last = kNoTriangle;  // neighbours mostly show the same triangle
    const auto mark = [&](std::uint32_t name, const auto& triangleOf) {
        if (name == last || name == kNoTriangle) return;
        last = name;
        const std::uint32_t polygon = in.transform.topology->polygonOf(triangleOf(name));
        std::atomic_ref(isSeen[polygon]).store(1, std::memory_order_relaxed);  // other tiles may mark it too
    };
    const Tile pixels = tileOf(in.transform.view.size, tile);
    if (const SeenBlocks* seen = in.zBuffer.seen.get()) {
        const std::uint32_t* names = seen->name.tile(tile)->of;
        const float* z = seen->z.tile(tile)->of;
        for (std::size_t at = 0; at < kTilePixels; ++at) {
            const glm::ivec2 pixel = pixels.min + pixelOf(at);
            if (pixel.x < pixels.max.x && pixel.y < pixels.max.y && z[at] < SeenBlocks::kNowhere)
                mark(names[at], [&](std::uint32_t name) { return seen->pieces.triangleOf(name); });
        }
        return;
    }
    for (int y = pixels.min.y; y < pixels.max.y; ++y)
        for (int x = pixels.min.x; x < pixels.max.x; ++x)
            mark(in.zBuffer.triangle->at({x, y}), [](std::uint32_t triangle) { return triangle; });
}

// One byte for each polygon that is kept. In a fine mesh only those that a pixel shows.
template <class Real>
std::vector<std::uint8_t> seenPolygons(const ShadingInputs& inputs, const ShadingSources<Real>& in, Threads& threads) {
    std::vector<std::uint8_t> isSeen(in.transform.topology->polygonCount());
    for (std::size_t i = 0; i < isSeen.size(); ++i) isSeen[i] = in.goesOn(i);
    // Checking a pixel costs a small part of an evaluation, so it pays unless there are far fewer polygons than pixels.
    constexpr long long kPixels = 4;
    const bool isFine = kPixels * std::ranges::count(isSeen, 1) > in.zBuffer.seenPixels;
    if (!isFine || inputs.layers.drawn) return isSeen;  // layers show more polygons than the z-buffer
    std::ranges::fill(isSeen, 0);
    const std::vector<std::uint8_t>& drawn = in.zBuffer.tileIsDrawn;
    threads.forRange(drawn.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t tile = begin; tile < end; ++tile)
            if (drawn[tile]) markShown(in, tile, isSeen);
    });
    return isSeen;
}

// Consecutive places for those that are seen; place 0 is for those that are not.
inline std::vector<std::uint32_t> placesOf(const std::vector<std::uint8_t>& isSeen) {
    std::vector<std::uint32_t> places(isSeen.size());
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = isSeen[i] ? ++last : 0;
    return places;
}

// The polygons and vertices to evaluate; empty if all are.
template <class Real>
ElementPlaces findSeen(const ShadingInputs& inputs, const ShadingSources<Real>& in, Threads& threads) {
    const bool polygons = inputs.parts[Part::PolygonTerms] && !inputs.parts[Part::HiddenPolygons];
    const bool vertices = inputs.parts[Part::VertexTerms] && !inputs.parts[Part::HiddenVertices];
    if (!polygons && !vertices) return {};
    const std::vector<std::uint8_t> isSeen = seenPolygons(inputs, in, threads);
    ElementPlaces places;
    if (polygons) places.polygons = placesOf(isSeen);
    if (vertices) {
        const Topology& topology = *in.transform.topology;
        std::vector<std::uint8_t> vertexIsSeen(topology.vertexCount(), 0);
        for (std::size_t polygon = 0; polygon < isSeen.size(); ++polygon) {
            if (!isSeen[polygon]) continue;
            const Topology::Corners corners = topology.corners(polygon);
            for (std::size_t i = 0; i < corners.size(); ++i) vertexIsSeen[corners[i]] = 1;
        }
        places.vertices = placesOf(vertexIsSeen);
    }
    return places;
}

}  // namespace pipeline
