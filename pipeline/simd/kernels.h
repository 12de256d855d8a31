#pragma once
#include <string>

#include "pipeline/buffers/buffer_table.h"
#include "pipeline/scene/settings.h"

namespace pipeline {

// Says whether the kernels of this folder support a scene's settings. Each function returns one sentence with the
// reason if they do not, else an empty string.

// The z-buffer.
std::string whyNotDrawnInVectors(const Settings& settings);
// The shading of pixels, with these buffers.
std::string whyNotShadedInVectors(const Settings& settings, BufferSet wanted);

}  // namespace pipeline
