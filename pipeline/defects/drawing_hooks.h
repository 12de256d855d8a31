#pragma once
#include <array>
#include <functional>

#include "pipeline/defects/hooks.h"

// As hooks.h, of what only the drawing itself calls.
namespace pipeline {

struct Tile;
template <class Real>
struct ShadingOutput;

// Which pixels of the tile a triangle covers. isDrawn: they are decided, and were visited as forEachCovered() does.
template <class Real>
void spoilCoverage(const Planted& planted, const View& view, const RasterTriangle<Real>& triangle, Tile tile,
                   const std::function<void(glm::ivec2 pixel, const std::array<std::int64_t, 3>& e)>& visit,
                   bool& isDrawn);
// The pixels of a tile, which are shaded.
template <class Real>
void spoilTile(const Planted& planted, Tile tile, ShadingOutput<Real>& out);

}  // namespace pipeline
