#pragma once
#include <memory>

#include "pipeline/core/stop.h"
#include "pipeline/scene/mesh/mesh.h"
#include "pipeline/scene/mesh/shape.h"

// Making a mesh takes seconds where it is large. Once stopped, these give an unfinished mesh of no use.
namespace pipeline {

std::shared_ptr<const Mesh> makeMesh(Mesh mesh, const Stop& stop);
std::shared_ptr<const Mesh> makeShape(const Shape& shape, const Stop& stop);

// At most so many vertices does makeShape give; exactly, but for the teapot, whose patches share some.
std::size_t mostVerticesOf(const Shape& shape);
std::size_t mostTrianglesOf(const Shape& shape);  // likewise

}  // namespace pipeline
