#pragma once
#include <initializer_list>
#include <random>
#include <vector>

#include "pipeline/run/runner.h"
#include "pipeline/scene/scene.h"

namespace test {

using namespace pipeline;

// A mesh from its positions and its polygons, written out.
inline std::shared_ptr<const Mesh> mesh(VertexVectors positions,
                                        const std::vector<std::vector<std::uint32_t>>& polygons) {
    Mesh m;
    m.positions = std::move(positions);
    for (const auto& polygon : polygons) m.addPolygon(polygon);
    return makeMesh(std::move(m));
}

// Each vertex p goes to to(p).
template <class To>
void moveVertices(Mesh& mesh, To to) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) mesh.positions.set(i, to(mesh.positions[i]));
}

// Lecture 1's example, typed in from the lecture and not read from a file.
inline Scene pyramid() {
    Scene scene;
    scene.name = "pyramid";
    scene.camera.kind = CameraKind::Spherical;
    scene.camera.screenDistance = 200, scene.camera.rho = 1000, scene.camera.theta = 45, scene.camera.phi = 60;
    Object object{"pyramid",
                  mesh({{0, 0, 0}, {150, 0, 0}, {150, 150, 0}, {0, 150, 0}, {75, 75, 150}},
                       {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 3}, {0, 3, 2, 1}}),
                  {{1.8, 1, 1}, {0, 0, 0}, {200, 0, 0}},
                  {{0.2, 0.5, 0.9}, Vec3d(0.4), 8}};
    scene.objects.push_back(object);
    scene.lights.push_back({LightKind::AtInfinity, {500, 500, 500}, 100, Vec3d(1), true});
    scene.ambient.intensity = 50;
    return scene;
}

// An axis-aligned box between two corners, faces outward.
inline std::shared_ptr<const Mesh> box(Vec3d a, Vec3d b) {
    return mesh({{a.x, a.y, a.z},
                 {b.x, a.y, a.z},
                 {b.x, b.y, a.z},
                 {a.x, b.y, a.z},
                 {a.x, a.y, b.z},
                 {b.x, a.y, b.z},
                 {b.x, b.y, b.z},
                 {a.x, b.y, b.z}},
                {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

// A ground whose top is at z = 0 and a box from z = 1 to 2 over it, lit from straight above and seen aslant: a place on
// the ground lies in the box's shadow where |x| < 1 and |y| < 1.
inline Scene boxOverGround() {
    Scene scene;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, -8, 6};
    scene.camera.target = {0, 0, 0.5};
    scene.objects.push_back({"ground", box({-4, -4, -1}, {4, 4, 0}), {}, {Vec3d(0.7), Vec3d(0), 1}});
    scene.objects.push_back({"box", box({-1, -1, 1}, {1, 1, 2}), {}, {Vec3d(0.7), Vec3d(0), 1}});
    scene.lights.push_back({LightKind::AtInfinity, {0, 0, 1}, 100, Vec3d(1), true});
    scene.ambient.intensity = 30;
    scene.settings.width = 120, scene.settings.height = 90;
    return scene;
}

// The cube of lecture 1's sample code for OpenGL, with its light, material, translation and turns.
// The lecture leaves the projection open.
inline Scene openGlCube() {
    Scene scene;
    scene.name = "cube";
    scene.settings.model = Model::OpenGl;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 0, -1}, scene.camera.up = {0, 1, 0};
    scene.camera.near = 1, scene.camera.far = 10;
    Object cube{"cube", box(Vec3d(-0.5), Vec3d(0.5)), {}, {{0, 0.7, 0}, Vec3d(1), 20, {0, 0.7, 0}}};
    cube.transform.translation = {0, 0, -3};
    cube.transform.turns = {{20, {1, 0, 0}}, {20, {0, 1, 0}}};
    scene.objects.push_back(cube);
    Light light{LightKind::AtInfinity, {1, 1, 1}, 1, Vec3d(0.5), true};
    light.gl.ambient = Vec3d(0.3), light.gl.specular = Vec3d(0);
    scene.lights.push_back(light);
    scene.ambient.intensity = 0.2;
    return scene;
}

// A closed sphere of quads and triangles around the origin.
inline std::shared_ptr<const Mesh> sphere(double radius, int rings, int segments) {
    std::vector<Vec3d> positions{{0, 0, radius}};
    for (int i = 1; i < rings; ++i)
        for (int j = 0; j < segments; ++j) {
            const double phi = 3.14159265358979323846 * i / rings, theta = 2 * 3.14159265358979323846 * j / segments;
            positions.push_back(radius *
                                Vec3d(std::sin(phi) * std::cos(theta), std::sin(phi) * std::sin(theta), std::cos(phi)));
        }
    positions.push_back({0, 0, -radius});
    const auto at = [&](int i, int j) { return std::uint32_t(1 + (i - 1) * segments + j % segments); };
    const auto last = std::uint32_t(positions.size() - 1);
    std::vector<std::vector<std::uint32_t>> polygons;
    for (int j = 0; j < segments; ++j) {
        polygons.push_back({0, at(1, j), at(1, j + 1)});
        for (int i = 1; i + 1 < rings; ++i)
            polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        polygons.push_back({at(rings - 1, j), last, at(rings - 1, j + 1)});
    }
    return mesh(std::move(positions), polygons);
}

// Three spheres of different materials in and out of each other's shadow, Phong shaded, in a picture whose width no
// vector divides.
inline Scene spheres() {
    Scene scene = pyramid();
    scene.settings.width = 333, scene.settings.height = 241;
    scene.settings.shading = Shading::Phong;
    scene.settings.shadowSize = 256;
    Object object = scene.objects[0];
    object.transform = {Vec3d(1), Vec3d(0), Vec3d(0)};
    object.mesh = sphere(150, 24, 40);
    scene.objects.assign(3, object);
    scene.objects[1].transform.translation = {180, 60, 90};
    scene.objects[1].material = {{0.9, 0.3, 0.2}, Vec3d(0), 1};
    scene.objects[2].transform.translation = {-160, 120, 30};
    scene.objects[2].material.exponent = 300;
    scene.lights.push_back({LightKind::Point, {300, 300, 500}, 60, {0.5, 1, 0.7}, false});
    return scene;
}

inline BufferSet everyBuffer() { return BufferSet().set(); }

inline FramePtr frameOf(const Scene& scene, BufferSet wanted = everyBuffer(), int threads = 0,
                        const FramePtr& before = {}) {
    FrameRequest request;
    request.wanted = wanted;
    request.threads = threads;
    return runFrame(std::make_shared<const Scene>(scene), request, before);
}

// Polygons of three corners and more side by side, of one object and once more mirrored.
Scene polygonsOfAllSizes();

// A scene of spheres, boxes, loose polygons, lights and a camera, different for every seed.
Scene randomScene(unsigned seed);

// A random scene in a small picture, for tests over a thousand of them; with what randomScene leaves as it is: a near
// and a far plane, a spherical camera, biases of the shadow test, filtering, attenuation and spots. No object's and no
// camera's angle has more than 20 bits behind the point, so that 90 degrees more are added without rounding.
Scene smallScene(unsigned seed);

// A random scene with values that are possible but strange: coefficients and intensities that are
// negative or huge, singular transforms and cameras, no light, no object… checkScene accepts it.
Scene strangeScene(unsigned seed);

// Any of the forms of every formula.
Forms randomForms(std::mt19937& random);

// Gives the meshes of some objects normals of their own, among them some that are 0, tiny or huge, and flattens some
// objects; they are used where the setting normals is `given`.
void giveNormals(Scene& scene, std::mt19937& random);
// Colours of vertices from 0 to 1, some of them black, to most objects.
void giveColors(Scene& scene, std::mt19937& random);

// One change of a kind that a user makes: a light, a material, the camera, a setting…
void changeSomething(Scene& scene, std::mt19937& random);

// The names of the buffers that hold NaN, or an infinity other than that of a depth where nothing was drawn.
std::string buffersWithoutNumbers(const Frame& frame);

// The first buffer in which two frames differ, and where; empty when they agree bit for bit.
std::string firstDifference(const Frame& a, const Frame& b, BufferSet compared = everyBuffer());

}  // namespace test
