#pragma once
#include <string>
#include <vector>

#include "pipeline/scene/scene.h"

namespace pipeline {

// A rectangle that shines: soft shadows (lecture 1). L runs to its centre, as from a point light there; the rectangle
// counts in the shadow factor alone, S_k = the mean over sample points of the shadow factor of a point light there.

// The columns of the rectangle's samples, along its width, and their rows. Samples that would coincide, along a side
// of length 0, are one: their mean is what each of them says.
struct SampleGrid {
    int columns = 1, rows = 1;
    int count() const { return columns * rows; }
};

// Where a light's shadow is looked for. For a light at infinity and a point light that is one place; an area light has
// a grid of cells alike, sampled in their centres: of a straight edge across it, N columns tell the share that is seen
// with an error of at most 1 / (2 N).
SampleGrid sampleGrid(const Light& light);

// The rectangle's sides, world units: the width runs across world z, the height across both it and the direction that
// the light faces. For a light that faces along z the width runs along x.
struct AreaSides {
    Vec3d width{0.0}, height{0.0};
};
AreaSides sidesOf(const Light& light);

// The i-th sample, row by row, in world space; for a light at infinity the direction towards it. A grid of one sample
// has the light's position itself, to the last bit. grid and sides are those of the light.
Vec3d samplePlace(const Light& light, SampleGrid grid, const AreaSides& sides, int i);
std::vector<Vec3d> samplePlaces(const Light& light);

// Shadow buffers a sample of such a light takes: all six ways, but for a light at infinity.
constexpr int shadowFacesPerSample(LightKind kind) { return kind == LightKind::AtInfinity ? 1 : 6; }

// What a light's shadow factor, 0 to 1, makes of a place: "lit", "umbra", which gets no light, or "penumbra (S = 0.44)",
// which gets light from part of an area light. Of a light without extent only filtering leaves something between:
// "filtered edge (S = 0.44)".
std::string shadowPlace(const Light& light, double shadowFactor);

}  // namespace pipeline
