#include "tests/bench/workloads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "pipeline/formats/model_reader.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/run/runner.h"

namespace bench {

using namespace pipeline;

const std::vector<Workload>& workloads() {
    static const std::vector<Workload> kWorkloads{
        {"100", 100, 1, 640, 480, 1024},          {"5k", 5'000, 1, 640, 480, 1024},
        {"70k", 70'000, 1, 1920, 1080, 2048},     {"1M", 1'000'000, 3, 1920, 1080, 2048},
        {"10M", 10'000'000, 3, 1920, 1080, 2048},
    };
    return kWorkloads;
}

const Workload& workload(std::string_view name) { return *std::ranges::find(workloads(), name, &Workload::name); }

std::string name(Part part, const Workload& workload) {
    switch (part) {
        case Part::Depth: return "depth";
        case Part::Phong: return "Phong";
        case Part::PhongShadow: return "Phong + " + std::to_string(workload.shadowSize) + "²";
    }
    return {};
}

namespace {

// Rings of twice as many segments as there are rings; triangles, also at the poles.
int ringsOf(int triangles) { return std::max(2, int(std::lround(std::sqrt(triangles / 4.0)))); }
void reserveSpheres(Mesh& mesh, int triangles, std::size_t spheres) {
    const auto rings = std::size_t(ringsOf(triangles)), vertices = spheres * (2 + (rings - 1) * 2 * rings);
    const std::size_t polygons = spheres * (rings - 1) * 4 * rings;
    mesh.positions.reserve(vertices), mesh.normals.reserve(vertices), mesh.reservePolygons(polygons, 3 * polygons);
}
void addSphere(Mesh& mesh, int triangles, Vec3d centre, double radius) {
    const int rings = ringsOf(triangles), segments = 2 * rings;
    const auto first = std::uint32_t(mesh.positions.size());
    const auto place = [&](int ring, int segment) {
        const double down = std::numbers::pi * ring / rings, around = 2 * std::numbers::pi * segment / segments;
        const Vec3d outward(std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around));
        mesh.positions.push_back(glm::vec3(centre + radius * outward));
        mesh.normals.push_back(glm::vec3(outward));
    };
    place(0, 0);
    for (int ring = 1; ring < rings; ++ring)
        for (int segment = 0; segment < segments; ++segment) place(ring, segment);
    place(rings, 0);
    const auto at = [&](int ring, int segment) {
        return ring == 0 ? first : first + std::uint32_t(1 + (ring - 1) * segments + segment % segments);
    };
    const std::uint32_t last = std::uint32_t(mesh.positions.size() - 1);
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh.addPolygon(std::array{a, b, c}); };
    for (int segment = 0; segment < segments; ++segment) add(first, at(1, segment + 1), at(1, segment));
    for (int ring = 1; ring + 1 < rings; ++ring)
        for (int segment = 0; segment < segments; ++segment) {
            add(at(ring, segment), at(ring, segment + 1), at(ring + 1, segment + 1));
            add(at(ring, segment), at(ring + 1, segment + 1), at(ring + 1, segment));
        }
    for (int segment = 0; segment < segments; ++segment) add(at(rings - 1, segment), at(rings - 1, segment + 1), last);
}

// The triangles of a mesh that has normals.
void addMesh(Mesh& mesh, const Mesh& part) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (const Vec3d& p : part.positions) mesh.positions.push_back(glm::vec3(p));
    for (const Vec3d& n : part.normals) mesh.normals.push_back(glm::vec3(n));
    for (const Triangle& triangle : part.triangles) {
        const auto& [a, b, c] = triangle.vertices;
        mesh.addPolygon(std::array{first + a, first + b, first + c});
    }
}

// Those that the normals stage finds, weighted by area.
VertexVectors normalsOf(std::shared_ptr<const Mesh> mesh) {
    Scene scene;
    scene.objects.push_back({"model", std::move(mesh), {}, {}});
    scene.settings.normalWeight = NormalWeight::Area;
    const FrameRequest request{
        .wanted = setOf({BufferId::VerticesNormal}), .until = StageId::Normals, .threads = 1, .stop = {}};
    const FramePtr frame = runFrame(std::make_shared<const Scene>(std::move(scene)), request, nullptr);
    VertexVectors normals;
    for (const Vec3<float>& n : dataOf<float>(*frame)->normals->vertex) normals.push_back(n);
    return normals;
}

Result<std::shared_ptr<const Mesh>> meshOf(const std::filesystem::path& file) {
    const Result<NamedFile> opened = openFile(file);
    if (!opened) return opened.errors();
    const Result<LoadedModel> model =
        readModel({opened->text, opened->path, {}, opened->tail}, file.extension().string(), filesBeside(file));
    if (!model) return model.errors();
    Mesh mesh;
    for (const Object& object : model->objects) {
        Mesh part = *object.mesh;
        if (part.normals.empty()) part.normals = normalsOf(object.mesh);
        addMesh(mesh, part);
    }
    return makeMesh(std::move(mesh));
}

}  // namespace

Result<std::shared_ptr<const Mesh>> meshOf(const Workload& workload) {
    if (!workload.file.empty()) return meshOf(workload.file);
    Mesh mesh;
    const int n = workload.spheres, each = workload.triangles / (n * n * n);
    reserveSpheres(mesh, each, std::size_t(n) * std::size_t(n) * std::size_t(n));
    for (int i = 0; i < n * n * n; ++i) {
        const Vec3d at = Vec3d(i % n, i / n % n, i / n / n) - (n - 1) / 2.0;
        addSphere(mesh, each, at, n > 1 ? 0.45 : 1);
    }
    return makeMesh(std::move(mesh));
}

Scene sceneOf(const Workload& workload, Part part, std::shared_ptr<const Mesh> mesh, bool moved,
              Arithmetic arithmetic) {
    Scene scene;
    scene.name = workload.name;
    const Vec3d low = mesh->facts.low, high = mesh->facts.high, middle = (low + high) / 2.0;
    double radius = 0;
    for (const Vec3d& p : mesh->positions) radius = std::max(radius, glm::length(p - middle));

    Object object{workload.name, std::move(mesh), {}, {{0.8, 0.6, 0.4}, Vec3d(0.4), 32}};
    scene.objects.push_back(object);
    scene.lights.push_back({LightKind::AtInfinity, Vec3d(1), 1, Vec3d(1), part == Part::PhongShadow});
    scene.ambient.intensity = 0.2;

    constexpr double kFieldOfView = 40;
    const double distance = radius / std::sin(kFieldOfView / 2 / 180 * std::numbers::pi);
    Camera& camera = scene.camera;
    camera.kind = CameraKind::LookAt;
    camera.fovY = kFieldOfView;
    camera.target = middle + Vec3d(moved ? radius * 0x1p-40 : 0, 0, 0);
    camera.eye = camera.target + distance * glm::normalize(Vec3d(0.4, 0.3, 1));
    camera.up = {0, 1, 0};
    camera.near = distance - 1.05 * radius, camera.far = distance + 1.05 * radius;

    Settings& settings = scene.settings;
    settings.width = workload.width, settings.height = workload.height;
    settings.arithmetic = arithmetic;
    settings.shading = part == Part::Depth ? Shading::Flat : Shading::Phong;
    settings.normalWeight = NormalWeight::Given;  // OpenGL, too, is handed normals with the vertices
    settings.shadowSize = workload.shadowSize;
    settings.shadowCull = ShadowCull::Back;  // as OpenGL culls in both of its passes
    // One sphere throws no shadow on itself that its own sides do not show, which the plan knows and OpenGL does not.
    settings.rules[index(Rule::ConvexShadow)] = false;
    settings.rules[index(Rule::DistantShadow)] = false;
    return scene;
}

}  // namespace bench
