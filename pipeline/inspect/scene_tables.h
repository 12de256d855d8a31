#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pipeline/run/frame.h"

namespace pipeline {

// The scene, and what a frame made of it, as the arrays of lecture 1's section "Data Structures for
// Flat-Shaded Polygon Mesh Rendering": objects, polygons, the vertices of both, lights. A member that
// the lecture names stands under that name.

enum class TableId : std::uint8_t { Objects, Polygons, Vertices, Lights };
inline constexpr std::size_t kTableCount = 4;
std::string_view name(TableId id);  // "objects"
std::optional<TableId> findTable(std::string_view name);

// A value as the frame stores it; nothing where it holds none.
using Cell = std::variant<std::monostate, std::int64_t, float, double, std::string>;

struct TableColumn {
    std::string lecture;   // lecture 1's name: "num_pts"; empty where it has none
    std::string name;      // the program's: a setting's key, a buffer's name, or a word
    std::string unit;      // "world units"; empty for a pure number
    std::string meaning;   // one sentence
    int decimals = -1;     // for people; -1: as many as the shortest text has that reads back
    std::string whyEmpty;  // a sentence where no row has a value
    std::function<Cell(std::size_t row)> cell;

    // The lecture's name, or the last part of the program's: "shadow" of "light.#.shadow". No two
    // columns of a table have the same.
    std::string heading() const;
};

// What belongs to the array as a whole: num_lights, I_a.
struct TableFact {
    std::string lecture, name, unit;
    Cell value;
    std::string heading() const { return lecture.empty() ? name : lecture; }
};

// Holds on to the frame and reads a cell when asked for it: nothing is copied, however many rows.
struct SceneTable {
    TableId id = TableId::Objects;
    std::string meaning;  // what a row is, one sentence
    std::vector<TableFact> facts;
    std::vector<TableColumn> columns;
    std::size_t rows = 0;
};

// Shows what the frame holds and asks for nothing more: a column of a buffer that the plan left out
// is empty and says why. Columns of settings that have no effect in this scene are left out, but for
// those that the lecture names.
SceneTable sceneTable(const FramePtr& frame, TableId id);
// The buffers that the table shows and that are useful in this scene: a frame that has been asked for them has all that an
// export of the scene has.
BufferSet tableBuffers(const Scene& scene, TableId id);

// The rows in the order of a column's values, and in their own order where those are equal. Rows
// without a value come last either way.
std::vector<std::uint32_t> sortedRows(const SceneTable& table, std::size_t column, bool descending);

}  // namespace pipeline
