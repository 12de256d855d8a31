#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/inspect/scene_tables.h"

namespace lessons {

// A thing of the scene that every view marks, beside the picked pixel. Polygons and vertices are
// counted over all objects, as in the buffers.
struct Selection {
    enum class Kind : unsigned char { Object, Polygon, Vertex, Light };
    Kind kind = Kind::Object;
    std::size_t index = 0;
    bool operator==(const Selection&) const = default;
};

// Whether the scene still has it.
bool isIn(const pipeline::Scene& scene, const Selection& selection);

// What a row of a table stands for.
Selection selectionOf(pipeline::TableId table, std::size_t row);

// The polygon that a pixel shows; nothing on the background, or before the z-buffer has run.
std::optional<std::size_t> polygonAt(const pipeline::Frame& frame, glm::ivec2 pixel);

// The rows of a table that belong to what is selected, or, where nothing is, to the picked pixel: its
// polygon, the polygon's object, its corners. In ascending order.
std::vector<std::uint32_t> rowsOf(const pipeline::Frame& frame, pipeline::TableId table,
                                  const std::optional<Selection>& selection, std::optional<glm::ivec2> pixel);

}  // namespace lessons
