#pragma once
#include <string>

#include "pipeline/buffers/buffer_table.h"
#include "pipeline/scene/settings.h"

namespace pipeline {

// What the kernels of this folder have beside the stages' own text. Each says why they do not have a scene's, one sentence,
// or is empty.

// The z-buffer.
std::string whyNotDrawnInVectors(const Settings& settings);
// The shading of pixels, with these buffers.
std::string whyNotShadedInVectors(const Settings& settings, BufferSet wanted);

}  // namespace pipeline
