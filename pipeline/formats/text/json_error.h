#pragma once
#include <cstddef>
#include <string_view>

#include "pipeline/core/stop.h"
#include "pipeline/scene/mesh/mesh.h"

namespace pipeline {

// The byte, from 0, at which a text that is not JSON stops being it; its size where it ends too early,
// or where the search was stopped.
std::size_t jsonErrorAt(std::string_view text, const Stop& stop = {});

// Line and column of a byte, from 1, columns in characters.
TextPosition positionOf(std::string_view text, std::size_t byte);

}  // namespace pipeline
