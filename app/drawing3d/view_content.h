#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/drawing3d/coarse_mesh.h"
#include "app/drawing3d/light_frustum.h"
#include "app/drawing3d/orbit_camera.h"
#include "app/drawing3d/view_options.h"
#include "app/drawing3d/view_picture.h"
#include "app/drawing3d/view_space.h"
#include "lessons/state/selection.h"
#include "pipeline/inspect/bounds.h"
#include "pipeline/inspect/formula.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/run/frame.h"
#include "pipeline/steps/steps.h"

namespace app {

using pipeline::VectorCode;
using FaceTree = pipeline::rays::TriangleTree<double>;

// What a 3D view shows of a frame, as plain data: made by contentOf, drawn by WorldScene and
// paintOverlay. All positions are in world space, or where inSpace made it, in that of `map`. Nothing here depends on a theme, on the
// camera of the view or on the size of the window.

// A triangle of a polygon.
struct Face {
    std::array<std::uint32_t, 3> vertices;  // into ViewMesh::positions
    std::int32_t polygon = 0;               // counted over all objects
    bool shaded = true;                     // false: the pipeline culled the polygon, so that it has no colour
    float alpha = 1;                        // opacity of its front; 0: not drawn
};

// A normal as it is drawn; see normalArrows.
struct NormalArrow {
    Vec3d base, direction;  // direction has unit length
    glm::vec3 color{0.5f};  // (N + 1) / 2 of N in world space
    std::uint32_t object = 0;
    double length = 1;  // of the length that is set
    bool operator==(const NormalArrow&) const = default;
};

// One of the five vectors where the illumination was evaluated.
struct VectorArrow {
    VectorCode code = VectorCode::N;
    int light = -1;         // of L, R and H
    Vec3d base, direction;  // direction has unit length
    bool main = true;       // false at the lesser of the three vertices of Gouraud shading
    std::string letter;     // "N"; "L₁" where the scene has more than one light
};

// cos^n of the angle to `axis`, as a surface around it. What it is where `probe` cuts it is the factor
// of the specular term: Phong's (R·V)^n has it around R, Blinn's (N·H)^n around H.
struct SpecularLobe {
    VectorCode code = VectorCode::R;  // of the axis
    int light = 0;
    Vec3d base{0.0}, axis{0, 0, 1}, probe{0, 0, 1};  // the probe is V, or N; both unit
    double exponent = 1;                             // the model's factor included
    double power = 0;                                // where the probe cuts it; 0 beyond 90°
    bool main = true;
};

struct LightMark {
    int light = 0;
    bool atInfinity = true;
    Vec3d direction{0, 0, 1};  // towards a light at infinity, unit
    Vec3d position{0.0};       // of a point light
    std::string caption;       // "light 0, at infinity"
};

// A box that holds points; `any` is false while it holds none.
struct Bounds {
    Vec3d min{0.0}, max{0.0};
    bool any = false;
    void add(Vec3d point);
    void giveExtent();  // where it has none, that of a unit cube
    Vec3d centre() const { return (min + max) / 2.0; }
    double radius() const { return glm::length(max - min) / 2; }  // of the sphere around it
    std::array<Vec3d, 8> corners() const;
};

// Lecture 2's bounds of an object.
struct ObjectBounds {
    pipeline::BoundingBox box;
    pipeline::BoundingSphere sphere;
};

// The polygons of a frame. Shared, because a newly picked pixel changes nothing in it.
struct ViewMesh {
    std::shared_ptr<const pipeline::Topology> topology;  // the frame's; null without vertices
    std::vector<Vec3d> positions;                        // of every vertex, as vertices.world
    std::vector<Face> faces;
    // sRGB, 0 to 1, as the frame buffer would hold them: per vertex, or with flat shading per polygon.
    std::vector<glm::vec3> vertexColors, polygonColors;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;  // of polygons, each once
    double meanEdge = 0;                                         // their mean length, world units
    // Unit normals in world space, (0, 0, 0) where there is none: per polygon, and per vertex where the frame has those.
    // In float, because a mesh may have millions of them.
    std::vector<glm::vec3> polygonNormals, vertexNormals;
    bool hasAngles = true;              // false where a normal would not stand at right angles to its polygon
    std::vector<ObjectBounds> objects;  // per object, in world space; empty where the frame has no vertices
    Picture picture;                    // the frame buffer; empty before the first pixel is shaded
    // Over the faces, where there are many; null: a ray looks at them one by one.
    std::shared_ptr<const FaceTree> tree;
    // Of many faces, for pictures of a view that moves; null where there are few, or they are large.
    std::shared_ptr<const std::vector<CoarseFace>> coarse;
    // Where it is cut at the near plane: the vertex that an edge, its lesser end first, was given there.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> cuts;

    const glm::vec3& colorOf(const Face& face, std::size_t corner) const {
        return polygonColors.empty() ? vertexColors[face.vertices[corner]] : polygonColors[std::size_t(face.polygon)];
    }
};

struct ViewContent {
    std::shared_ptr<const ViewMesh> mesh;   // never null
    SpaceMap map;                           // from world space to where this stands
    std::shared_ptr<const ViewMesh> world;  // what `mesh` was moved from; null where that is nothing else
    double faceStrength = 1;                // of the faces' colours over the background; 0 leaves none
    std::vector<LightMark> lights;
    std::vector<LightFrustum> frusta;  // where they were asked for: see lightFrusta
    pipeline::View eye;                // the scene's camera
    double pictureDistance = 1;        // of the picture plane from the eye, along its viewing direction
    Bounds bounds;                     // of the objects; where they have no extent, of a unit cube around them

    // The picked pixel; nothing where none is picked or nothing was drawn there.
    std::optional<Vec3d> point;  // what the pixel shows
    std::optional<Vec3d> foot;   // where its illumination was evaluated: where the main vectors start
    std::int32_t pickedPolygon = -1;
    std::vector<std::uint32_t> pickedLoop;  // its vertices in order
    std::vector<VectorArrow> vectors;
    std::vector<SpecularLobe> lobes;  // of the lights that have a specular term there

    // What is selected beside the pixel.
    std::vector<std::uint32_t> markedLoop;           // a polygon's vertices in order
    std::optional<pipeline::BoundingBox> markedBox;  // of an object, in world space
    std::optional<Vec3d> markedVertex;
    // While an algorithm is at a pixel: its ray from the near plane to the plane of the polygon that it tests.
    struct StepRay {
        glm::ivec2 pixel;
        Vec3d from, to;
    };
    std::optional<StepRay> stepRay;
    const std::vector<std::uint32_t>& outlinedLoop() const { return markedLoop.empty() ? pickedLoop : markedLoop; }
};

// While the window stands inside a stage: polygons that the stage is not done with lose their colour, and the one that
// it is at is outlined where nothing else is.
ViewContent withProgress(const ViewContent& content, const pipeline::Steps& steps, pipeline::Moment moment);

// Reads from the frame whatever of these buffers it has: vertices.world, polygons.verdict,
// polygons.normal, vertices.normal, polygons.intensity, vertices.intensity, color.
// `before`, of an earlier frame: where no vertex has moved since, what hangs on their places alone is taken from it.
// placed: another frame of the same scene that has the vertices' places, for a frame inside the transform stage: those
// without one would all stand at the origin. Null: `frame` has them.
// Incomplete when it is stopped.
ViewContent contentOf(const pipeline::Frame& frame, std::optional<glm::ivec2> pixel,
                      const ViewContent* before = nullptr, const std::stop_token& stop = {},
                      const pipeline::Frame* placed = nullptr);
// The same content with another picked pixel, or with what is known about it; `frame` is the one that it was made of.
ViewContent withReport(const ViewContent& content, const pipeline::Frame& frame, const pipeline::PixelReport* report);
ViewContent withPixel(const ViewContent& content, const pipeline::Frame& frame, std::optional<glm::ivec2> pixel,
                      const std::stop_token& stop = {});
// The same content with another thing marked.
ViewContent withSelection(const ViewContent& content, const pipeline::Frame& frame,
                          const std::optional<lessons::Selection>& selection);
// Those that this scene's shading leaves; vertex normals beside them where the view shows them.
pipeline::BufferSet contentBuffers(const pipeline::Scene& scene, bool vertexNormals);

// The first face that a ray meets.
struct Hit {
    Vec3d at;
    double distance;  // from the ray's origin
    std::int32_t polygon;
};
std::optional<Hit> firstHit(const ViewContent& content, const Ray& ray);

// Which pixel of the picture shows a point of a polygon.
struct Shown {
    std::optional<glm::ivec2> pixel;
    std::string whyNot;  // a sentence where there is none
};
Shown pixelShowing(const pipeline::Frame& frame, const ViewContent& content, const Hit& hit);

// The point of the scene that a pixel's centre looks at; nothing where it looks past everything.
std::optional<Vec3d> pointShownBy(const ViewContent& content, glm::ivec2 pixel);

// Four corners of the picture at a distance along the viewing direction: top left, top right,
// bottom right, bottom left.
std::array<Vec3d, 4> pictureCorners(const pipeline::View& view, double distance);

}  // namespace app
