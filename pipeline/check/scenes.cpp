#include "pipeline/check/scenes.h"

#include <cstring>

namespace pipeline::check {

std::shared_ptr<const Mesh> meshOf(VertexVectors positions, const Polygons& polygons) {
    Mesh mesh;
    mesh.positions = std::move(positions);
    for (const auto& polygon : polygons) mesh.addPolygon(polygon);
    return makeMesh(std::move(mesh));
}

std::shared_ptr<const Mesh> trianglesOf(std::span<const Corners> triangles) {
    std::vector<Vec3d> positions;
    Polygons polygons;
    for (const Corners& corners : triangles) {
        const auto first = std::uint32_t(positions.size());
        positions.insert(positions.end(), corners.begin(), corners.end());
        polygons.push_back({first, first + 1, first + 2});
    }
    return meshOf(std::move(positions), polygons);
}

std::shared_ptr<const Mesh> boxMesh(double low, double high) {
    std::vector<Vec3d> positions;
    for (int i = 0; i < 8; ++i) positions.emplace_back(i & 1 ? high : low, i & 2 ? high : low, i & 4 ? high : low);
    return meshOf(std::move(positions),
                  {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

std::shared_ptr<const Mesh> gridMesh(int cells, Vec3d low, Vec3d high) {
    std::vector<Vec3d> positions;
    Polygons polygons;
    for (int y = 0; y <= cells; ++y)
        for (int x = 0; x <= cells; ++x)
            positions.emplace_back(low.x + (high.x - low.x) * x / cells, low.y + (high.y - low.y) * y / cells, low.z);
    const auto at = [&](int x, int y) { return std::uint32_t(y * (cells + 1) + x); };
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x) polygons.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
    return meshOf(std::move(positions), polygons);
}

Object objectOf(std::shared_ptr<const Mesh> mesh, Material material) {
    Object object;
    object.name = "object";
    object.mesh = std::move(mesh);
    object.material = material;
    return object;
}

Scene litScene(std::vector<std::shared_ptr<const Mesh>> meshes) {
    Scene scene;
    for (auto& mesh : meshes) scene.objects.push_back(objectOf(std::move(mesh)));
    scene.lights.push_back({});
    scene.ambient.intensity = 0.25;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.up = {0, 1, 0};
    scene.settings.precision = Precision::Double;
    scene.settings.cull = CullMode::None;
    scene.settings.width = scene.settings.height = 64;
    scene.settings.shadowSize = 64;
    return scene;
}

Scene pixelScene(int width, int height, std::vector<std::shared_ptr<const Mesh>> meshes) {
    Scene scene = litScene(std::move(meshes));
    scene.settings.width = width, scene.settings.height = height;
    scene.camera.projection = ProjectionKind::Orthographic;
    scene.camera.height = height;
    scene.camera.target = {width / 2.0, height / 2.0, 0};
    scene.camera.eye = scene.camera.target + Vec3d(0, 0, 16);
    return scene;
}

Scene frontScene(double distance, std::vector<std::shared_ptr<const Mesh>> meshes) {
    Scene scene = litScene(std::move(meshes));
    scene.camera.eye = {0, 0, distance};
    return scene;
}

double numberOf(const FramePtr& frame, BufferName name, std::size_t i) { return frame->buffer(name)->flat(i); }

Vec3d vectorOf(const FramePtr& frame, BufferName name, std::size_t i) {
    const AnyBuffer buffer = *frame->buffer(name);
    return {buffer.flat(3 * i), buffer.flat(3 * i + 1), buffer.flat(3 * i + 2)};
}

std::size_t drawnPixels(const FramePtr& frame) {
    const AnyBuffer ids = *frame->buffer({BufferId::ObjectId});
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < ids.count(); ++i) drawn += ids.flat(i) >= 0;
    return drawn;
}

std::size_t differences(const FramePtr& a, const FramePtr& b, std::initializer_list<BufferId> compared) {
    const BufferSet set = setOf(compared);
    std::size_t count = 0;
    for (const BufferName& name : allBuffers(a->scene().lights.size())) {
        if (!set[index(name.id)]) continue;
        const auto x = a->buffer(name), y = b->buffer(name);
        if (!x && !y) continue;
        if (!x || !y || x->shape != y->shape) {
            count += (x ? *x : *y).count();
            continue;
        }
        for (std::size_t i = 0; i < x->count(); ++i) {
            const double p = x->flat(i), q = y->flat(i);
            count += std::memcmp(&p, &q, sizeof p) != 0;
        }
    }
    return count;
}

Long degreesBetween(Long3 a, Long3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / 3.14159265358979323846264338327950288L;
}

Vec3d Random::direction() {
    for (;;) {
        const Vec3d v = inCube(1);
        const double length = glm::length(v);
        if (length > 0.1 && length < 1) return v / length;
    }
}

Scene wallScene() {
    Scene scene = pixelScene(64, 64,
                             {gridMesh(1, {-8, -8, 0}, {72, 72, 0}),
                              meshOf({{16, -8, 0}, {16, 72, 0}, {16, 72, 16}, {16, -8, 16}}, {{0, 1, 2, 3}})});
    scene.lights[0].position = {-1, 0, 1};
    scene.settings.shadowSize = 512;
    scene.settings.shadowBiasValue = 8;  // read by a constant bias alone
    return scene;
}

}  // namespace pipeline::check
