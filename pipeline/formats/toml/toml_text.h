#pragma once
#include <optional>
#include <string_view>

#include "pipeline/core/stop.h"
#include "pipeline/scene/mesh/mesh.h"

namespace pipeline {

// Where a character beyond ASCII stands outside strings and comments, or nothing. TOML has none
// there, and what toml++ 3.3 does with one in place of a value is not defined.
std::optional<TextPosition> strayCharacter(std::string_view text, const Stop& stop = {});

// Where a key has more parts, a.b.c, than any scene's, or nothing. toml++ makes a table of each and takes them down one
// inside the other, until there is no stack left.
inline constexpr int kMostKeyParts = 16;
std::optional<TextPosition> deepKey(std::string_view text, const Stop& stop = {});

}  // namespace pipeline
