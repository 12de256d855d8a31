#pragma once
#include <array>
#include <string>
#include <string_view>

#include "lessons/state/window_state.h"
#include "pipeline/formats/toml/toml_values.h"

// A state as a part of a TOML file.
namespace lessons {

// The kinds of what is selected, in files: "polygon 3".
inline constexpr std::array<std::string_view, 4> kSelectedKinds{"object", "polygon", "vertex", "light"};

// How a view is compared, in files; in the order of the buttons.
inline constexpr std::array<std::string_view, 5> kCompareModes{"a", "b", "blink", "wipe", "difference"};

// The channel of the equation, in files.
inline constexpr std::array<std::string_view, 3> kEquationChannels{"red", "green", "blue"};

// The keys of a state, then its tables; `prefix` stands before the tables' names: "cue.".
std::string stateText(const WindowState& state, const std::string& prefix);

// More keys of the same table, which the caller has read.
using KnownKeys = std::vector<std::string>;
// Reads a table that holds a state beside those keys; what is wrong goes into `values`.
WindowState readStateTable(const toml::table& table, const std::string& path, const KnownKeys& others,
                           pipeline::TomlValues& values);

}  // namespace lessons
