#pragma once
#include <array>
#include <concepts>
#include <functional>
#include <optional>

#include "pipeline/inspect/scene_tables.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/scene/settings_table.h"

// How a column of a scene table is made from a setting or a buffer; scene_tables.cpp alone reads it.
namespace pipeline::table_columns {

inline constexpr int kUnitDecimals = 4;  // of the components of unit vectors

TableColumn rowNumber(std::string lecture, std::string name, std::string meaning);

// A whole number, by a function of the row.
template <class Count>
TableColumn count(std::string lecture, std::string name, std::string meaning, Count count) {
    return {std::move(lecture),
            std::move(name),
            "",
            std::move(meaning),
            -1,
            {},
            [count = std::move(count)](std::size_t row) -> Cell { return std::int64_t(count(row)); }};
}

// One column a setting of the group, in the order of their table, where `keeps` says so of its key.
void addSettings(const FramePtr& frame, SettingGroup group, std::vector<TableColumn>& columns,
                 const std::function<bool(std::string_view key)>& keeps);

// One column a channel of a buffer: lecture 1's names for the three, and what is added to the buffer's. Rows without a value
// (rowsWithValue) are empty, and a fact counts them.
void addBuffer(const FramePtr& frame, BufferId buffer, std::array<std::string, 3> lecture,
               std::array<std::string, 3> parts, int decimals, SceneTable& table);

// scrn_dist, ρ, θ, φ of lecture 1's camera; eye and target of another.
std::vector<TableFact> viewingFacts(const Scene& scene);
// I_max; nothing where shading has not run.
std::optional<double> largestIntensity(const Frame& frame);

// Decimals for people, the same in every row. Of lengths: about six digits of the farthest point
// that the eye sees, so that they stay when things move.
int lengthDecimals(const Frame& frame);
int depthDecimals(const Frame& frame);
int intensityDecimals(const Frame& frame);

}  // namespace pipeline::table_columns
