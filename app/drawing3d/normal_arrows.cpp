#include "app/drawing3d/normal_arrows.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "pipeline/scene/mesh/topology.h"

namespace app {

namespace {

// Of many objects so many each would cover all of them.
constexpr std::size_t kManyObjects = 24, kFew = 20;

// Of so many arrows of an object.
std::size_t shownOf(std::size_t arrows, std::size_t every, bool manyObjects) {
    return std::max(arrows / every, manyObjects ? 0 : std::min(arrows, kFew));
}

bool hasMany(const ViewMesh& mesh) { return mesh.objects.size() > kManyObjects; }

// Polygons or vertices that have a normal, by their numbers.
class Normals {
public:
    Normals(const ViewMesh& mesh, NormalsShown shown) : m_mesh(mesh), m_areOfVertices(shown == NormalsShown::Vertices) {
        if (shown == NormalsShown::Off || !mesh.hasAngles || !mesh.topology) return;
        for (std::uint32_t i = 0; i < all().size(); ++i)
            if (all()[i] != glm::vec3(0)) m_numbers.push_back(i);
    }
    std::size_t count() const { return m_numbers.size(); }
    // use(numbers) of one object after the other; of many objects all are taken as one.
    void forEachObject(const auto& use) const {
        std::span<const std::uint32_t> rest = m_numbers;
        while (!rest.empty()) {
            const auto objectAt = [&](std::uint32_t number) { return objectOf(number); };
            const auto end = std::ranges::upper_bound(rest, objectOf(rest.front()), {}, objectAt);
            const std::size_t own = hasMany(m_mesh) ? rest.size() : std::size_t(end - rest.begin());
            use(rest.first(own));
            rest = rest.subspan(own);
        }
    }
    std::size_t objectOf(std::uint32_t number) const {
        const pipeline::Topology& topology = *m_mesh.topology;
        return m_areOfVertices ? topology.objectOfVertex(number) : topology.objectOfPolygon(number);
    }
    NormalArrow arrow(std::uint32_t number, const SpaceMap& map, double length) const {
        const glm::vec3& normal = all()[number];
        return {baseOf(number), map.turned(glm::normalize(Vec3d(normal))), colorOfNormal(normal),
                std::uint32_t(objectOf(number)), length};
    }

private:
    const std::vector<glm::vec3>& all() const { return m_areOfVertices ? m_mesh.vertexNormals : m_mesh.polygonNormals; }
    Vec3d baseOf(std::uint32_t number) const {
        if (m_areOfVertices) return m_mesh.positions[number];
        const auto corners = m_mesh.topology->corners(number);
        Vec3d sum{0.0};
        for (std::size_t i = 0; i < corners.size(); ++i) sum += m_mesh.positions[corners[i]];
        return sum / double(corners.size());
    }

    const ViewMesh& m_mesh;
    bool m_areOfVertices;
    std::vector<std::uint32_t> m_numbers;
};

double sceneRadius(const ViewMesh& mesh) {
    Bounds all;
    for (const ObjectBounds& object : mesh.objects)
        if (object.sphere.radius > 0) all.add(object.box.min), all.add(object.box.max);
    return all.radius();
}

// Of an object's radius in the scene's; 1 where that has none.
double shareOf(const ViewMesh& mesh, std::size_t object, double sceneRadius) {
    return sceneRadius > 0 ? std::min(mesh.objects[object].sphere.radius / sceneRadius, 1.0) : 1;
}

}  // namespace

std::size_t normalCount(const ViewMesh& mesh, NormalsShown shown) { return Normals(mesh, shown).count(); }

std::vector<NormalArrow> shownNormals(const ViewContent& content, const ViewOptions& options) {
    // From a third of the scene's radius on they are as long as any, and never shorter than can be seen.
    constexpr double kFull = 3, kShortest = 0.3;
    // Every k-th by count would fall into step with the rows of a regular mesh; multiples of the
    // golden ratio, taken where their fraction is below 1/k, never do.
    constexpr double kGolden = 0.6180339887498949;
    const ViewMesh& mesh = *content.mesh;
    const Normals normals(mesh, options.normals);
    const std::size_t every = options.everyOf(normals.count());
    const double radius = sceneRadius(mesh);
    std::vector<NormalArrow> shown;
    normals.forEachObject([&](std::span<const std::uint32_t> own) {
        const double k = double(own.size()) / double(shownOf(own.size(), every, hasMany(mesh)));
        for (std::size_t i = 0; i < own.size(); ++i) {
            const double multiple = double(i) * kGolden;
            if ((multiple - std::floor(multiple)) * k >= 1) continue;
            const double share = shareOf(mesh, normals.objectOf(own[i]), radius);
            shown.push_back(normals.arrow(own[i], content.map, std::clamp(kFull * share, kShortest, 1.0)));
        }
    });
    return shown;
}

void makeNormalsReadable(const ViewContent& content, ViewOptions& options) {
    constexpr double kReadable = 150, kModel = 250;  // of a model in so many pixels
    constexpr double kShortest = 16;
    const ViewMesh& mesh = *content.mesh;
    const double radius = sceneRadius(mesh);
    const Normals normals(mesh, NormalsShown::Polygons);
    std::size_t every = 1, shown = 0;
    normals.forEachObject([&](std::span<const std::uint32_t> own) {
        const double share = hasMany(mesh) ? 1 : shareOf(mesh, normals.objectOf(own.front()), radius);
        const double readable = std::max(kReadable * share * share, double(kFew));
        every = std::max(every, std::size_t(double(own.size()) / readable));
    });
    every = std::min(every, std::size_t(kSparsestNormals));
    normals.forEachObject(
        [&](std::span<const std::uint32_t> own) { shown += shownOf(own.size(), every, hasMany(mesh)); });
    options.everyNormal = int(every);
    options.normalLength = std::round(
        std::clamp(kModel / std::sqrt(double(std::max<std::size_t>(shown, 1))), kShortest, ViewOptions().normalLength));
}

}  // namespace app
