#pragma once
#include "pipeline/stages/shading.h"

// What pixels leave beside their intensity.
namespace pipeline {

// Writes into buffers that are there, and nowhere else.
template <class Real>
struct Writer {
    ShadingOutput<Real>* out;  // null: nothing but the intensity is asked for
    std::size_t at;
    void put(BufferId id, Vec3<Real> value, std::size_t k = 0) const {
        if (out && !out->vectors[index(id)].empty()) out->vectors[index(id)][k].pixels[at] = value;
    }
    void put(BufferId id, Real value, std::size_t k = 0) const {
        if (out && !out->scalars[index(id)].empty()) out->scalars[index(id)][k].pixels[at] = value;
    }
};

// What somebody who looks wants to have beside the intensity.
struct Wanted {
    bool vectors = false, surfaces = false, everyShadow = false, any = false;
};
template <class Real>
Wanted wantedOf(const ShadingOutput<Real>& out) {
    PartSet reads;
    bool any = false;  // not of what is made of the intensity afterwards
    for (const BufferInfo& info : bufferTable()) {
        if (out.vectors[index(info.id)].empty() && out.scalars[index(info.id)].empty()) continue;
        reads |= info.reads;
        any = any || !info.reads.hasAnyOf(partsOf(Part::Intensity, Part::Layers));
    }
    return {reads[Part::LightVectors], reads[Part::SurfaceVectors], reads[Part::ShadowLookup], any};
}

}  // namespace pipeline
