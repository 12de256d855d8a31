#pragma once
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/core/real.h"
#include "pipeline/core/result.h"
#include "pipeline/core/stop.h"
#include "pipeline/inspect/formula.h"
#include "pipeline/inspect/fragment_report.h"
#include "pipeline/run/frame.h"

namespace pipeline {

// A polygon that would have covered the pixel but was dropped before.
struct CulledReport {
    int polygon;
    char letter;         // B back-facing, D degenerate, O outside, T wholly transparent
    std::string reason;  // "back-facing, signed area −1 991.6 px²"
    std::optional<double>
        signedArea;  // px², on the screen, below 0 where its back is seen; the verdict's, where it took one
};

// A translucent surface over the pixel, in the order in which they are laid over it.
struct LayerReport {
    int polygon;
    double zView;     // world units
    double alpha;     // its opacity, 0 to 1
    Vec3d intensity;  // its own, before it is laid over what is behind
    Vec3d composed;   // afterwards: alpha · intensity + (1 − alpha) · what was there
};

struct LightReport {
    int light;
    Vec3d L, R, H;                                // world space, unit
    double nDotL, rDotV, nDotH;                   // before clamping
    double specularPower;                         // (R·V)^n or (N·H)^n after clamping, 0 where it does not count
    double fading;                                // OpenGL: attenuation times spot, else 1
    std::array<double, kMostFactors> factors;     // of the model's own, in the order of its row
    double shadow;                                // S
    Vec3d ambient;                                // OpenGL: the light's own ambient part, else 0
    Vec3d diffuse, specular;                      // what they add to the intensity, S included
    Vec3d unshadowedDiffuse, unshadowedSpecular;  // for S = 1
    std::string note;                             // "N·L is below 0, so light 0 adds nothing here."; may be empty
};

// Where the vectors of a report were taken: one entry for flat and Phong shading, one per
// vertex for Gouraud shading (whose intensities are then weighted).
struct Evaluation {
    std::string where;     // "at the mean of the vertices (335, 125, 50)", "vertex 4", "at the pixel"
    double weight = 1;     // in the pixel's intensity
    Vec3d position, N, V;  // world space
    std::vector<LightReport> lights;
    Vec3d emission{0.0}, ambient{0.0}, intensity{0.0};
    int vertex = -1;       // of Gouraud shading, over all objects
    Vec3d color{1.0};      // of the mesh's vertices: k_d and k_a are multiplied by it
    bool clamped = false;  // OpenGL: the colour was above 1 (or below 0), and its terms shrank
};

// Everything known about a pixel, replayed by the pure stages from a frame, in its own arithmetic: a term is, bit for bit,
// what its buffer holds.
struct PixelReport {
    glm::ivec2 pixel;
    Color8 color;
    bool covered = false;
    bool outline = false;                     // visibility none: a polygon's outline, not shaded
    int polygon = -1, object = -1;            // over all objects; object's index
    int triangle = -1;                        // of the polygon, index into Topology::triangles
    bool back = false;                        // lit from behind, with the back material
    std::array<int, 3> vertices{-1, -1, -1};  // of the triangle, over all objects
    Vec3d barycentric{0.0};
    Vec3d position{0.0};          // world space
    double zView = 0, depth = 0;  // depth: as stored; z_view where no depths are
    // What its intensity or normal is interpolated with; empty in flat shading.
    std::string interpolation;                    // "affine", "affine: scanline knows no clipped polygon"
    std::vector<std::pair<int, double>> weights;  // (vertex, weight), 2 to 4
    std::vector<Evaluation> evaluations;
    std::vector<double> shadow;             // S_k at the pixel, per light
    std::vector<std::string> shadowPlaces;  // "lit", "penumbra (S = 0.44)", "umbra"; empty where the model knows none
    bool isShaded = true;                   // false where the frame stands inside the shading stage, before this pixel
    Vec3d ambient{0.0}, emission{0.0};
    Vec3d intensity{0.0};  // of the opaque surface: the sum of its terms
    std::vector<LayerReport> layers;
    double transmittance = 1;  // composed = transmittance · intensity + translucent, which the frame buffer scales
    Vec3d translucent{0.0}, composed{0.0};
    std::optional<Vec3d> antialiased{};    // what the frame buffer scales in place of composed
    int samples = 1;                       // along a side of the pixel, that antialiased is the mean of
    std::vector<Vec3d> diffuse, specular;  // per light, at the pixel, S_k included
    double iMax = 0;
    std::vector<FragmentReport> fragments;
    std::vector<CulledReport> culled;
};

// pixel must lie in the picture. Incomplete when it is stopped.
PixelReport inspectPixel(const Frame& frame, glm::ivec2 pixel, const Stop& stop = {});

// What shading does at a pixel in which a surface is seen: the report without fragments, and without who is in the way of
// a light.
PixelReport inspectShading(const Frame& frame, glm::ivec2 pixel);
// What flat shading evaluates once for a polygon, and Gouraud shading for a vertex, in the light of every light (S = 1). A
// vertex is seen from the front. The frame has shaded.
Evaluation inspectPolygon(const Frame& frame, std::uint32_t polygon);
Evaluation inspectVertex(const Frame& frame, std::uint32_t vertex);

// The illumination equation of a pixel for channel 0, 1 or 2 (r, g, b): in symbols, with its
// numbers, its result, the frame buffer value, and the rows of dot products and vectors below. What the scene says, k, I
// and n, stands there as it was typed; what was computed as `chosen` says.
struct EquationLine {
    std::string role;  // "symbols", "numbers", "result", "frame buffer", "row"
    Formula formula;
    std::string remark;  // "39.2°", "Flat: evaluated once, at the mean of the vertices"
};
std::vector<EquationLine> equation(const Scene& scene, const PixelReport& report, int channel,
                                   const NumberText& chosen = {});

// Where a polygon stands in the mesh's file, or in the scene's where the mesh stands in it; nothing where no file has it.
std::optional<SourceLocation> definedAt(const Frame& frame, int polygon);

// What `inspect` prints.
std::string toText(const Frame& frame, const PixelReport& report);

}  // namespace pipeline
