#include "app/view3d/normal_arrows.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

// Of many objects so many each would cover all of them.
constexpr std::size_t kManyObjects = 24, kFew = 20;

// Of so many arrows of an object.
std::size_t shownOf(std::size_t arrows, std::size_t every, bool manyObjects) {
    return std::max(arrows / every, manyObjects ? 0 : std::min(arrows, kFew));
}

bool hasMany(const ViewMesh& mesh) { return mesh.objects.size() > kManyObjects; }

// The arrows of one object stand together; of many objects all are taken as one.
void forEachObject(const ViewMesh& mesh, std::span<const NormalArrow> arrows, const auto& use) {
    while (!arrows.empty()) {
        const auto end = std::ranges::upper_bound(arrows, arrows.front().object, {}, &NormalArrow::object);
        const std::size_t own = hasMany(mesh) ? arrows.size() : std::size_t(end - arrows.begin());
        use(arrows.first(own));
        arrows = arrows.subspan(own);
    }
}

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

std::span<const NormalArrow> normalArrows(const ViewMesh& mesh, NormalsShown shown) {
    switch (shown) {
        case NormalsShown::Polygons: return mesh.polygonNormals;
        case NormalsShown::Vertices: return mesh.vertexNormals;
        case NormalsShown::Off: break;
    }
    return {};
}

std::vector<NormalArrow> shownNormals(const ViewContent& content, const ViewOptions& options) {
    // From a third of the scene's radius on they are as long as any, and never shorter than can be seen.
    constexpr double kFull = 3, kShortest = 0.3;
    // Every k-th by count would fall into step with the rows of a regular mesh; multiples of the
    // golden ratio, taken where their fraction is below 1/k, never do.
    constexpr double kGolden = 0.6180339887498949;
    const ViewMesh& mesh = *content.mesh;
    const std::span<const NormalArrow> arrows = normalArrows(mesh, options.normals);
    const std::size_t every = options.everyOf(arrows.size());
    const double radius = sceneRadius(mesh);
    std::vector<NormalArrow> shown;
    forEachObject(mesh, arrows, [&](std::span<const NormalArrow> own) {
        const double k = double(own.size()) / double(shownOf(own.size(), every, hasMany(mesh)));
        for (std::size_t i = 0; i < own.size(); ++i) {
            const double multiple = double(i) * kGolden;
            if ((multiple - std::floor(multiple)) * k >= 1) continue;
            shown.push_back(own[i]);
            shown.back().length = std::clamp(kFull * shareOf(mesh, own[i].object, radius), kShortest, 1.0);
        }
    });
    return shown;
}

void makeNormalsReadable(const ViewContent& content, ViewOptions& options) {
    constexpr double kReadable = 150, kModel = 250;  // of a model in so many pixels
    constexpr double kShortest = 16;
    const ViewMesh& mesh = *content.mesh;
    const double radius = sceneRadius(mesh);
    const std::span<const NormalArrow> arrows = mesh.polygonNormals;
    std::size_t every = 1, shown = 0;
    forEachObject(mesh, arrows, [&](std::span<const NormalArrow> own) {
        const double share = hasMany(mesh) ? 1 : shareOf(mesh, own.front().object, radius);
        const double readable = std::max(kReadable * share * share, double(kFew));
        every = std::max(every, std::size_t(double(own.size()) / readable));
    });
    every = std::min(every, std::size_t(kSparsestNormals));
    forEachObject(mesh, arrows,
                  [&](std::span<const NormalArrow> own) { shown += shownOf(own.size(), every, hasMany(mesh)); });
    options.everyNormal = int(every);
    options.normalLength = std::round(
        std::clamp(kModel / std::sqrt(double(std::max<std::size_t>(shown, 1))), kShortest, ViewOptions().normalLength));
}

}  // namespace app
