#pragma once
#include <optional>
#include <string_view>

#include "pipeline/scene/mesh.h"

namespace pipeline {

// Where a character beyond ASCII stands outside strings and comments, or nothing. TOML has none
// there, and what toml++ 3.3 does with one in place of a value is not defined.
std::optional<TextPosition> strayCharacter(std::string_view text);

}  // namespace pipeline
