#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "pipeline/buffers/block_buffer.h"
#include "pipeline/buffers/buffer_table.h"
#include "pipeline/buffers/late_buffer.h"
#include "pipeline/buffers/verdict.h"
#include "pipeline/scene/mesh/topology.h"
#include "pipeline/scene/view.h"
#include "pipeline/stages/vertex_array.h"

// The pipeline, told by what its stages hand on: six structs, in order, each made of those before it and of the scene. What
// else a frame keeps of a stage, for kernels, for the next frame, or to say what was done, is in the stage's own header.
namespace pipeline {

// 1. Transform: every vertex in the world, and the view that it is seen in.
template <class Real>
struct Transformed {
    std::shared_ptr<const Topology> topology;  // which vertices make which polygon, of which object
    View view;
    DepthFormat depthFormat = DepthFormat::Linear;
    std::vector<std::uint8_t> mirrored;     // per object
    std::vector<std::uint8_t> transparent;  // per object, 1 where it is as if not there; empty when none is
    std::vector<glm::dmat3> normalMatrix;   // per object, in the form that the inputs ask for
    VertexArray<Real> world;                // per vertex

    // Of a vertex. Found where it is asked for: to keep it takes longer.
    Vec3<Real> viewSpace(std::size_t vertex) const { return toView(view, world[vertex]); }
    bool anyMirrored() const {
        return std::ranges::any_of(mirrored, [](std::uint8_t one) { return one != 0; });
    }
};

// 2. Cull: which polygons go on.
struct CullMark {
    static constexpr std::uint8_t kBack = 1;    // its signed area is below 0
    static constexpr std::uint8_t kInside = 2;  // neither a plane nor the picture's border runs through it
};
struct Culled {
    RawVector<Verdict> verdicts;    // per polygon
    RawVector<std::uint8_t> marks;  // per polygon: bits of CullMark

    bool isBack(std::size_t polygon) const { return (marks[polygon] & CullMark::kBack) != 0; }
};

// 3. Normals: which way polygons and vertices face, world space, unit.
template <class Real>
struct Oriented {
    RawVector<Vec3<Real>> polygon;  // per polygon; (0, 0, 0) for one without area; empty when not needed of all
    VertexArray<Real> vertex;       // per vertex; empty when not asked for
    // Where the mean of the normals around a vertex vanishes, or is no more than rounding may have left, the first of them
    // stands in: how often.
    std::size_t vanishing = 0;
};

// 4. Shadow buffer: the depth that each casting light sees. A light is a camera: one orthographic view for a light at
// infinity, fitted to the scene's bounds; six perspective views along +x, −x, +y, −y, +z, −z for a point light and for
// each sample of an area light.
template <class Real>
struct LightView {
    std::vector<View> faces;
    std::vector<LateBuffer2D<Real>> depth;  // Z' per face: z_view of that face, +infinity where nothing is
    // The same, where pipeline/simd drew it; else none.
    std::vector<std::shared_ptr<const BlockBuffer2D<float>>> blocks;
    Real rounding = 0;  // bound of the rounding error of a z', world units
};
template <class Real>
struct LightDepths {
    // Per light: none where it gets no shadow buffer, one for each sample of an area light, else one.
    std::vector<std::vector<LightView<Real>>> lights;
};

// 5. Z-buffer: which triangle is seen in every pixel, and how far away it is.
inline constexpr std::uint32_t kNoTriangle = ~0u;  // nothing was drawn
inline constexpr std::int32_t kNothing = -1;       // the same, in object_id and polygon_id
template <class Real>
struct Visible {
    LateBuffer2D<std::uint32_t> triangle;  // index into Topology::triangles; kNoTriangle
    LateBuffer2D<Real> zView;              // world units; +infinity where nothing was drawn
    Buffer2D<double> depth;                // as stored, exactly; empty in format Linear, where it is zView
    Buffer2D<Vec3<Real>> barycentric;      // perspective-correct weights over that triangle's corners; may be empty
    Buffer2D<std::int32_t> overdraw;       // fragments that arrived; may be empty
    Buffer2D<std::int32_t> depthWrites;    // fragments that won; may be empty
};

// 6. Shading: the intensities of polygons, vertices or pixels, and the frame buffer.
// What a light adds to a polygon or a vertex, before its shadow factor.
template <class Real>
struct LightTerms {
    Vec3<Real> diffuse, specular;
};
// What is there without any shadow.
template <class Real>
struct BaseTerms {
    Vec3<Real> emission, ambient;
};
template <class Real>
struct Shaded {
    double iMax = 0;  // the intensity that 255 stands for
    // Per polygon and per vertex; empty when not asked for. Some models clamp these intensities to
    // [0, 1]; the terms of one that is clamped are scaled alike, so that they still sum to it.
    struct Elements {
        // Per polygon or vertex, where it stands in the lists below: at 0, which stays black, what is not evaluated. Empty
        // where all are, each at its own number.
        std::vector<std::uint32_t> places;
        std::vector<BaseTerms<Real>> base;
        std::vector<LightTerms<Real>> terms;  // lights side by side: [place * lights + k]
        std::vector<Vec3<Real>> intensity;    // unshadowed (S = 1), before scaling by iMax

        std::size_t count() const { return places.empty() ? intensity.size() : places.size(); }
        std::size_t placeOf(std::size_t i) const { return places.empty() ? i : places[i]; }
        const BaseTerms<Real>& baseOf(std::size_t i) const { return base[placeOf(i)]; }
        const LightTerms<Real>& termsOf(std::size_t i, std::size_t lights, std::size_t k) const {
            return terms[placeOf(i) * lights + k];
        }
        bool isEvaluated(std::size_t i) const { return places.empty() || places[i] != 0; }
    };
    Elements polygons, vertices;
    Elements verticesBack;  // as seen from behind; empty without two-sided lighting

    // Per pixel, by buffer and light (0 where the buffer is not per light); empty when not wanted.
    std::array<std::vector<Buffer2D<Vec3<Real>>>, kBufferCount> vectors;
    std::array<std::vector<Buffer2D<Real>>, kBufferCount> scalars;
    Buffer2D<Color8> color;
    Buffer2D<std::int32_t> layers;  // empty when not wanted
};

}  // namespace pipeline
