#include "pipeline/plan/frame_bytes.h"

#include <fmt/format.h>

#include "pipeline/core/text.h"
#include "pipeline/plan/needs.h"
#include "pipeline/scene/area_light.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/stages/snapped_vertices.h"

namespace pipeline {
namespace {

constexpr double kGiB = 1024.0 * 1024 * 1024;

// What a run holds beside the buffers asked for is as large as a buffer that is made of it.
BufferSet heldBy(const Scene& scene, const Needs& needs, StageId until) {
    using enum BufferId;
    BufferSet held = needs.buffers;
    if (until >= StageId::ZBuffer) held.set(index(ZView));
    if (until >= StageId::ZBuffer && needs[Part::SeenPolygons]) held.set(index(PolygonId));
    if (until >= StageId::ZBuffer && needs[Part::FragmentCounts]) held |= setOf({Overdraw, DepthWrites});
    if (until >= StageId::ZBuffer && needs[Part::Weights]) held.set(index(Barycentric));
    if (until == StageId::Shading) held.set(index(Color));
    if (scene.settings.antialiasing == 1) held.reset(index(Antialiased));
    return held;
}

double bytesOfPixel(const Scene& scene, const Needs& needs, StageId until) {
    const double real = bytesOf(scene.settings.precision);
    const BufferSet held = heldBy(scene, needs, until);
    double bytes = 0;
    for (const BufferInfo& info : bufferTable()) {
        if (info.domain != Domain::Pixel || info.stage > until || !held[index(info.id)]) continue;
        const double element = info.element == Element::Real ? real : info.element == Element::Int32 ? 4 : 1;
        bytes += element * info.channels * (info.perLight ? double(scene.lights.size()) : 1);
    }
    // While a mean is made: one sample's depths, triangles, weights, counts and intensity, and the first's.
    if (scene.settings.antialiasing > 1 && until == StageId::Shading) bytes += real * 10 + 4 * 4 + 3;
    return bytes;
}

struct Shadows {
    int faces = 0;
    double bytes = 0;
};
Shadows shadowsOf(const Scene& scene, const Needs& needs, StageId until) {
    Shadows all;
    const double texels = double(scene.settings.shadowSize) * double(scene.settings.shadowSize);
    for (std::size_t k = 0; k < scene.lights.size() && until >= StageId::ShadowBuffer; ++k) {
        if (!needs.of(Part::ShadowBuffer, k)) continue;
        const int faces = sampleGrid(scene.lights[k]).count() * shadowFacesPerSample(scene.lights[k].kind);
        // Several faces are kept one by one, and once more side by side where the buffer is asked for.
        const bool again = faces > 1 && needs.buffers[index(BufferId::ShadowBuffer)];
        all.faces += faces, all.bytes += texels * bytesOf(scene.settings.precision) * faces * (again ? 2 : 1);
    }
    return all;
}

// What stages hand on of vertices, polygons and triangles; the meshes themselves are there already.
struct Elements {
    double vertices = 0, polygons = 0, triangles = 0, bytes = 0;
};
Elements elementsOf(const Scene& scene, const Needs& needs, StageId until) {
    Elements all;
    for (const Object& object : scene.objects) {
        all.vertices += double(object.mesh->positions.size());
        all.polygons += double(object.mesh->polygonCount());
        all.triangles += double(object.mesh->triangles.size());
    }
    const bool isFloat = scene.settings.precision == Precision::Float;
    const double vector = 3.0 * bytesOf(scene.settings.precision), lights = double(scene.lights.size());
    double ofVertex = vector, ofPolygon = 0, ofTriangle = 0;
    if (scene.objects.size() > 1) {  // Topology counts over all objects
        ofPolygon += sizeof(std::uint32_t), ofTriangle += sizeof(Triangle);
        if (all.triangles > all.polygons) ofTriangle += sizeof(std::uint32_t);
    }
    if (isFloat) ofVertex += sizeof(SnappedVertex);
    if (until >= StageId::Cull) ofPolygon += 2;
    if (until >= StageId::Normals && needs[Part::PolygonNormals]) ofPolygon += vector;
    if (until >= StageId::Normals && needs[Part::VertexNormals]) ofVertex += vector;
    if (until >= StageId::Normals && needs[Part::NormalSums]) ofPolygon += vector;  // Room for work
    const double terms = vector * (3 + 2 * lights);
    if (until == StageId::Shading && needs[Part::PolygonTerms]) ofPolygon += terms;
    if (until == StageId::Shading && needs[Part::VertexTerms]) ofVertex += terms;
    all.bytes = all.vertices * ofVertex + all.polygons * ofPolygon + all.triangles * ofTriangle;
    return all;
}

double bytesOfFrame(const Scene& scene, const Needs& needs, StageId until) {
    const double pixels = double(scene.settings.width) * double(scene.settings.height);
    return pixels * bytesOfPixel(scene, needs, until) + shadowsOf(scene, needs, until).bytes +
           elementsOf(scene, needs, until).bytes;
}

// What makes it large, the most telling first.
std::vector<std::string> keysOf(const Scene& scene, bool samples) {
    std::vector<std::string> keys{"width", "height", "shadow.size", "antialiasing", "precision"};
    if (samples) keys = {"shadow.size"};
    for (std::size_t k = scene.lights.size(); k-- > 0;)
        if (!samples || scene.lights[k].kind == LightKind::Area)
            for (const char* name : {"samples", "kind", "shadow"}) keys.push_back(fmt::format("light.{}.{}", k, name));
    return keys;
}

}  // namespace

double frameBytes(const Scene& scene, BufferSet wanted, StageId until) {
    return bytesOfFrame(scene, needsOf(scene, wanted, until), until);
}

Errors checkMemory(const Scene& scene, BufferSet wanted, StageId until) {
    const Needs needs = needsOf(scene, wanted, until);
    const double bytes = bytesOfFrame(scene, needs, until);
    if (bytes <= kMemoryLimit) return {};
    if (const Elements elements = elementsOf(scene, needs, until); elements.bytes > bytes / 2) {
        Error error{
            {},
            fmt::format("the stages' output for {} with {} vertices, {} polygons and {} triangles takes {:.1f} GiB",
                        plural(std::int64_t(scene.objects.size()), "object"), std::size_t(elements.vertices),
                        std::size_t(elements.polygons), std::size_t(elements.triangles), bytes / kGiB),
            "at most 4 GiB; fewer objects, or a smaller tessellation"};
        for (std::size_t i = scene.objects.size(); i-- > 0;)
            if (scene.objects[i].shape) error.keys.push_back(fmt::format("object.{}.tessellation", i));
        error.keys.emplace_back("precision");
        return {std::move(error)};
    }
    Scene hard = scene;
    for (Light& light : hard.lights) light.area.samples = 1;
    const bool samples = bytesOfFrame(hard, needs, until) <= kMemoryLimit;
    const bool fewer = bytesOfFrame(scene, needsOf(scene, {}, until), until) <= kMemoryLimit;
    const Settings& s = scene.settings;
    const auto faces = shadowsOf(scene, needs, until).faces;
    Error error{{},
                fmt::format("the buffers of a {} × {} picture with {} and {} of {} × {} "
                            "take {:.1f} GiB",
                            s.width, s.height, plural(std::int64_t(scene.lights.size()), "light"),
                            plural(faces, "shadow buffer"), s.shadowSize, s.shadowSize, bytes / kGiB),
                fmt::format("at most 4 GiB; {}{}", fewer ? "ask for fewer buffers, or " : "",
                            samples ? "make shadow.size or the samples of the area lights smaller"
                                    : "make the picture smaller")};
    error.keys = keysOf(scene, samples);
    return {std::move(error)};
}

Errors checkSceneAndMemory(const Scene& scene) {
    if (Errors errors = checkScene(scene); !errors.empty()) return errors;
    return checkMemory(scene, BufferSet().set());
}

}  // namespace pipeline
