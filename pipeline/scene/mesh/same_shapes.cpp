#include "pipeline/scene/mesh/same_shapes.h"

#include <algorithm>

namespace pipeline {
namespace {

thread_local SameShapes* innermost = nullptr;

}  // namespace

SameShapes::SameShapes() : m_outer(innermost) { innermost = this; }
SameShapes::~SameShapes() { innermost = m_outer; }

std::shared_ptr<const Mesh> SameShapes::find(const Shape& shape) {
    if (!innermost) return {};
    const auto made = std::ranges::find(innermost->m_made, shape, &Made::shape);
    return made == innermost->m_made.end() ? nullptr : made->mesh;
}

void SameShapes::keep(const Shape& shape, const std::shared_ptr<const Mesh>& mesh) {
    if (innermost) innermost->m_made.push_back({shape, mesh});
}

}  // namespace pipeline
