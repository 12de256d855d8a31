#pragma once
#include <array>
#include <memory>
#include <vector>

#include "pipeline/buffers/buffer_table.h"
#include "pipeline/illumination/illumination.h"
#include "pipeline/stages/interpolate.h"
#include "pipeline/stages/normals.h"
#include "pipeline/stages/shadow_factor.h"
#include "pipeline/stages/vertex_weights.h"
#include "pipeline/stages/z_buffer.h"

namespace pipeline {

// Stage 6: the illumination of what is seen, and the frame buffer. Deferred: the z-buffer has
// decided, so each pixel is shaded once, and every quantity on the way can be kept.

// What was done and what was not, in counts that no clock disturbs.
struct ShadingCounts {
    long long evaluations = 0;                   // of a light at a point
    long long polygons = 0, hiddenPolygons = 0;  // evaluated; left out
    long long vertices = 0, hiddenVertices = 0;  // likewise, and so on
    long long powers = 0, vanished = 0;
    long long lookups = 0, idleLookups = 0;
    long long tiles = 0, emptyTiles = 0;
    long long layers = 0;         // of translucent surfaces over all pixels
    long long affineInstead = 0;  // pixels whose weights could not be those of Scanline
    long long relit = 0;          // of a light at a point, what the frame before has kept
    long long relitTiles = 0;
    ShadingCounts& operator+=(const ShadingCounts& more);
};

// How translucent polygons are laid over the opaque ones; see translucent.h.
struct LayerInputs {
    bool drawn = false;  // false where the plan leaves them out
    bool sorted = true;  // Exact: false where no pixel can have two layers
    Translucency order = Translucency::Exact;
    bool depthStored = true;                // layers are compared with the z-buffer's depth; else with z_view
    std::vector<TranslucentSides> sides{};  // per object; empty when everything is opaque
    bool operator==(const LayerInputs&) const = default;
};

struct ShadingInputs {
    Shading shading;
    Interpolation interpolation;
    bool outlines;  // visibility none: what is seen is drawn in white, nothing is evaluated
    Illumination illumination;
    std::vector<Material> materials;      // per object
    std::vector<Material> backMaterials;  // per object
    std::vector<Light> lights;            // in world space
    AmbientLight ambient;
    ShadowSettings shadow;
    // HiddenPolygons, HiddenVertices: also of what nobody can see; ShadowLookup: S also where the terms that it multiplies
    // are 0; Tiles: also those in which nothing was drawn.
    Parts parts{};
    LayerInputs layers{};
    int samples = 1;  // along a side of a pixel; above 1 the frame buffer shows their mean
    SamplePattern samplePattern = SamplePattern::Grid;
    bool firstVertexNormal = false;  // lightsFirstVertex
    bool colored = false;            // hasVertexColors
    Planted planted{};
    bool operator==(const ShadingInputs&) const = default;
};

struct Incidence;                                                  // pipeline/simd/incidence.h
using Incidences = std::vector<std::shared_ptr<const Incidence>>;  // per tile

template <class Real>
struct ShadingOutput : Shaded<Real> {
    // What a frame that differs in materials alone is made from; null where nothing was drawn, and empty where
    // the plan has nothing kept.
    Incidences incidence;
    // Which pixels that see a surface have been shaded, a byte each; empty where all are, as but inside the stage.
    std::vector<std::uint8_t> pixelIsShaded;
    ShadingCounts counts;  // the sum over all calls below
};

// What shading reads of the stages before it.
template <class Real>
struct ShadingSources {
    const TransformOutput<Real>& transform;
    const NormalsOutput<Real>& normals;
    const ShadowBufferOutput<Real>* shadow;  // null where the plan leaves it out
    const ZBufferOutput<Real>& zBuffer;
    const CullOutput* cull;  // null where culling is left out

    bool goesOn(std::size_t polygon) const { return !cull || pipeline::goesOn(cull->verdicts[polygon]); }
    // Where the stage has not left those of all, of the polygon alone.
    Vec3<Real> polygonNormal(std::size_t polygon) const {
        return normals.polygon.empty() ? pipeline::polygonNormal(transform, polygon) : normals.polygon[polygon];
    }
    // Of the plane that a triangle is drawn in, which shadows go by: the polygon's may be another.
    Vec3<Real> planeNormal(std::size_t triangle) const {
        const Topology& topology = *transform.topology;
        if (topology.polygons.empty()) return polygonNormal(triangle);
        const Vec3<Real> normal = triangleNormal(transform, triangle);
        return normal != Vec3<Real>(0) ? normal : polygonNormal(topology.polygonOf(triangle));
    }
};

// Whether flat shading lights a polygon with its first vertex' given normal instead of its own.
template <class Real>
bool takesFirstVertexNormal(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t polygon) {
    const Topology& topology = *in.transform.topology;
    return inputs.firstVertexNormal && !topology.meshes[topology.objectOfPolygon(polygon)]->normals.empty();
}
template <class Real>
Vec3<Real> flatNormal(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t polygon) {
    if (!takesFirstVertexNormal(inputs, in, polygon)) return in.normals.polygon[polygon];
    return in.normals.vertex[in.transform.topology->corners(polygon)[0]];
}

// Whether a polygon is lit from behind: two-sided lighting turns its normal round.
template <class Real>
bool showsBack(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t polygon) {
    return inputs.illumination.twoSided && in.cull && in.cull->isBack(polygon);
}
// The colour that k_d and k_a are multiplied by. Of a polygon that is lit once: the mean of its vertices', in OpenGL's model
// the first one's. At a pixel the vertices', interpolated with the weights; in flat shading the polygon's. 1 without colours.
template <class Real>
Vec3<Real> polygonColor(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t polygon);
template <class Real>
Vec3<Real> pixelColor(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::uint32_t polygon,
                      const VertexWeights<Real>& weights);
inline const Material& materialOf(const ShadingInputs& inputs, std::size_t object, bool back) {
    return back ? inputs.backMaterials[object] : inputs.materials[object];
}

// wanted: which per-pixel buffers to leave beside color; intensity always but for the vectors of pipeline/simd. Of these
// two the vectors write every pixel, and they are left raw for them.
template <class Real>
ShadingOutput<Real> prepareShading(const ShadingInputs& inputs, const ShadingSources<Real>& in, BufferSet wanted);

// Elements::places of polygons and vertices.
struct ElementPlaces {
    std::vector<std::uint32_t> polygons, vertices;
};
// Makes room for the terms of what is evaluated; all of them are 0.
template <class Real>
void prepareElements(const ShadingInputs& inputs, const ShadingSources<Real>& in, ElementPlaces places,
                     ShadingOutput<Real>& out);

// Polygons [begin, end); vertices [begin, end); the pixels of one tile. Pieces may run at the same
// time; each returns what it did, for `counts`.
template <class Real>
ShadingCounts shadePolygons(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t begin,
                            std::size_t end, ShadingOutput<Real>& out);
template <class Real>
ShadingCounts shadeVertices(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t begin,
                            std::size_t end, ShadingOutput<Real>& out);
template <class Real>
ShadingCounts shadePixels(const ShadingInputs& inputs, const ShadingSources<Real>& in, Tile tile,
                          ShadingOutput<Real>& out);

// Outlines in their place: white, at the intensity that white stands for.
template <class Real>
ShadingCounts shadeOutlines(const ShadingSources<Real>& in, Tile tile, ShadingOutput<Real>& out);

// Room that is used again from pixel to pixel, by one thread.
template <class Real>
struct ShadingScratch {
    std::vector<LightSample<Real>> samples;  // per light
    std::vector<Real> shadows{};             // of the lights so far, for a student's sum alone
    RowCrossings row{};
    explicit ShadingScratch(const ShadingInputs& inputs) : samples(inputs.lights.size()) {}
};

// The intensity of a triangle at a pixel, before it is scaled; the same bits as shadePixels writes. `out` holds the
// polygons and vertices that have been shaded.
template <class Real>
Vec3<Real> surfaceIntensity(const ShadingInputs& inputs, const ShadingSources<Real>& in, const ShadingOutput<Real>& out,
                            std::uint32_t triangle, Vec3<Real> barycentric, glm::ivec2 pixel,
                            ShadingScratch<Real>& scratch, ShadingCounts& counts);

// Where a polygon is evaluated: at the mean of its vertices, in OpenGL's model at the first of them.
template <class Real>
Surface<Real> polygonSurface(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t polygon);
// A vertex, seen from the front or from behind.
template <class Real>
Surface<Real> vertexSurface(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t vertex, bool back);
// Normals are interpolated with `weights` and renormalised when the normals stage left vertex normals;
// the position is perspective-correct. V follows from the pixel, in OpenGL's model from the position.
template <class Real>
Surface<Real> pixelSurface(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::uint32_t triangle,
                           glm::ivec2 pixel, Vec3<Real> barycentric, const VertexWeights<Real>& weights);
// The same inputs with every vector of a surface and of a light computed: for those who look.
ShadingInputs withAllVectors(ShadingInputs inputs);

// S of light k at a surface point of a polygon: of an area light the mean over its samples, which
// shine like point lights. A polygon that faces away from a casting light, or from a sample of one,
// shadows itself, whatever its interpolated normal says: no look-up.
template <class Real>
Real shadowAt(const ShadingInputs& inputs, const ShadingSources<Real>& in, std::size_t k, std::uint32_t triangle,
              Vec3<Real> position);

// round(255 · clamp(I / I_max, 0, 1)); 0 where I_max is 0 or I is not a number.
Color8 frameBufferValue(Vec3d intensity, double iMax, const Planted& planted = {});
// The same for a picture: three bytes that are returned go through the stack, and cost more than computing them.
void storeFrameBufferValue(Vec3d intensity, double iMax, const Planted& planted, Color8& pixel);

}  // namespace pipeline
