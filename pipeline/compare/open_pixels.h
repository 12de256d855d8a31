#pragma once
#include "pipeline/compare/reference.h"

namespace pipeline::foreign {

// Pixels at a border between polygons where right renderers may see another polygon: an edge runs so close by the sample
// that snapping to 4 bits of a pixel, the least that OpenGL allows, may cover it or not; or two polygons are as near there
// as the tolerance of a depth tells.
class OpenPixels {
public:
    // Of a reference with outlines.
    explicit OpenPixels(const Reference& reference) : m_reference(reference) {}
    bool isOpen(std::size_t pixel) const;

private:
    bool find(std::size_t pixel) const;
    const Reference& m_reference;
};

}  // namespace pipeline::foreign
