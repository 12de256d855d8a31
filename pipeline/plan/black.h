#pragma once
#include "pipeline/scene/remark.h"
#include "pipeline/scene/scene.h"

namespace pipeline {

// Whether every point of every surface is certain to be black: no light, material and illumination model together give
// any intensity, or all objects are transparent.
bool isBlack(const Scene& scene);

// Why what is drawn is black, and what to set; beginning with what the materials bring and the illumination model in
// force does not read.
Remark whyBlack(const Scene& scene);

}  // namespace pipeline
