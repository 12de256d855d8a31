#include "pipeline/compare/reference.h"

#include <algorithm>
#include <cmath>

#include "pipeline/illumination/illumination.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/run/runner.h"
#include "pipeline/stages/shading.h"

namespace pipeline::foreign {

namespace {

constexpr double kGrazing = 0.12;  // N·L of the plane below which a bias decides

BufferSet allCompared() {
    BufferSet wanted;
    for (const Tolerance& row : toleranceTable()) wanted.set(index(row.buffer));
    wanted.set(index(BufferId::Transmittance)).set(index(BufferId::Translucent));
    return wanted;
}

double sceneExtent(const Reference& reference) {
    const Values* const world = reference.values.find("vertices.world");
    if (!world) return 1;
    Vec3d low(HUGE_VAL), high(-HUGE_VAL);
    for (std::size_t i = 0; i < world->count(); ++i)
        for (int c = 0; c < 3; ++c)
            low[c] = std::min(low[c], world->at(i)[c]), high[c] = std::max(high[c], world->at(i)[c]);
    const double extent = glm::length(high - low);
    return std::isfinite(extent) && extent > 0 ? extent : 1;
}

// f(neighbour) of the pixels around one, within a radius; true as soon as it is.
template <class Function>
bool anyAround(std::size_t i, int radius, std::size_t width, std::size_t height, Function f) {
    const int x = int(i % width), y = int(i / width);
    for (int v = std::max(0, y - radius); v <= std::min(int(height) - 1, y + radius); ++v)
        for (int u = std::max(0, x - radius); u <= std::min(int(width) - 1, x + radius); ++u)
            if (f(std::size_t(v) * width + std::size_t(u))) return true;
    return false;
}

void findOutline(Reference& reference) {
    const Values& polygons = reference.values.at("polygon_id");
    reference.outline.assign(polygons.count(), 0);
    for (std::size_t i = 0; i < polygons.count(); ++i)
        reference.outline[i] = anyAround(i, 1, polygons.columns, polygons.rows, [&](std::size_t other) {
            return polygons.numbers[other] != polygons.numbers[i];
        });
}

// Where the S of a light is open.
std::vector<std::uint8_t> openShadow(Reference& reference, std::size_t light) {
    const Values& s = reference.values.at("shadow." + std::to_string(light));
    const Values& l = reference.values.at("light_vector." + std::to_string(light));
    const Values& polygons = reference.values.at("polygon_id");
    const auto& data = *dataOf<double>(*reference.frame);
    std::vector<std::uint8_t> open(s.count(), 0);
    const auto& covered = reference.context.covered;
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (!covered[i]) continue;
        const auto polygon = std::size_t(polygons.numbers[i]);
        const Vec3d plane = polygonNormal(*data.transform, polygon);
        const Vec3d towards(l.at(i)[0], l.at(i)[1], l.at(i)[2]);
        const bool grazes = glm::dot(plane, towards) < kGrazing;
        if (grazes) reference.grazing[i] = 1;
        if (!grazes && s.numbers[i] < 0.5) reference.shadowed[i] = 1;
        open[i] = grazes || anyAround(i, kShadowBand, s.columns, s.rows, [&](std::size_t other) {
                      return covered[other] && std::abs(s.numbers[other] - s.numbers[i]) > 0.01;
                  });
    }
    return open;
}

void findShadows(Reference& reference) {
    const Scene& scene = reference.frame->scene();
    if (!reference.unshadowed) return;
    reference.shadowOpen.resize(scene.lights.size());
    const Values& intensity = reference.values.at("intensity");
    reference.intensityLow = reference.intensityHigh = intensity;
    reference.shadowed.assign(intensity.count(), 0), reference.grazing.assign(intensity.count(), 0);
    reference.shadowContrast.assign(intensity.count(), 0);
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        if (!scene.lights[k].castsShadow) continue;
        reference.shadowOpen[k] = openShadow(reference, k);
        for (const std::string term : {"diffuse.", "specular."}) {
            const Values& here = reference.values.at(term + std::to_string(k));
            const auto whole =
                valuesIn(*reference.unshadowed, *findBuffer(term + std::to_string(k)), reference.context.covered);
            if (!whole) continue;
            for (std::size_t i = 0; i < here.count(); ++i) {
                const double change = std::max({whole->at(i)[0], whole->at(i)[1], whole->at(i)[2]});
                reference.shadowContrast[i] += 255 * change / reference.context.iMax;
                if (!reference.shadowOpen[k][i]) continue;
                for (int c = 0; c < 3; ++c) {
                    reference.intensityLow.at(i)[c] -= here.at(i)[c];
                    reference.intensityHigh.at(i)[c] += whole->at(i)[c] - here.at(i)[c];
                }
            }
        }
    }
    reference.colorLow = reference.colorHigh = reference.values.at("color");
    const Planted planted = dataOf<double>(*reference.frame)->keys.shading.planted;
    const auto set = [&](const Values& from, Values& to) {
        for (std::size_t i = 0; i < from.count(); ++i) {
            const Color8 color =
                frameBufferValue({from.at(i)[0], from.at(i)[1], from.at(i)[2]}, reference.context.iMax, planted);
            for (int c = 0; c < 3; ++c) to.at(i)[c] = color[c];
        }
    };
    set(reference.intensityLow, reference.colorLow);
    set(reference.intensityHigh, reference.colorHigh);
}

}  // namespace

std::shared_ptr<const Scene> referenceScene(Scene scene, PixelCorner corner) {
    scene.settings.precision = Precision::Double;
    scene.settings.leaveOut = false;
    return std::make_shared<const Scene>(sampledAt(std::move(scene), corner));
}

namespace {

constexpr BufferId kLit[]{BufferId::Color, BufferId::Intensity, BufferId::Diffuse, BufferId::Specular,
                          BufferId::Shadow};

// Whose frames keep the buffers that are asked for and no others: all of them take hundreds of bytes a pixel.
std::shared_ptr<const Scene> keepsWanted(Scene scene) {
    scene.settings.leaveOut = true, scene.settings.rules = RuleSet().set(index(Rule::UnreadBuffers));
    return std::make_shared<const Scene>(std::move(scene));
}

bool castsShadows(const Scene& scene) { return std::ranges::any_of(scene.lights, &Light::castsShadow); }

// The frames, with shadows and, where some are open, without. False where it was stopped.
bool drawFrames(Reference& out, const std::shared_ptr<const Scene>& scene, const BufferSet& wanted,
                const FramePtr& before, const Stop& stop) {
    const FrameRequest request{wanted, StageId::Shading, 0, stop};
    out.frame = runFrame(scene, request, before);
    if (!out.frame) return false;
    const bool isLit = std::ranges::any_of(kLit, [&](BufferId id) { return wanted[index(id)]; });
    if (!isLit || !castsShadows(*scene)) return true;
    Scene without = *scene;
    for (Light& light : without.lights) light.castsShadow = false;
    FrameRequest terms = request;
    terms.wanted = BufferSet().set(index(BufferId::Diffuse)).set(index(BufferId::Specular));
    out.unshadowed = runFrame(keepsWanted(std::move(without)), terms, out.frame);
    return out.unshadowed != nullptr;
}

// What a comparison reads of the frame, with the values of the buffers that are wanted.
void readFrame(Reference& out, const BufferSet& wanted) {
    const Scene& scene = out.frame->scene();
    const Settings& settings = scene.settings;
    out.context.covered = coveredIn(*out.frame);
    out.context.view = readStages(*out.frame, [](const auto& data) { return data.transform->view; });
    out.context.sampleShift = sampleShiftOf(scene);
    out.context.opensPlanes = scene.camera.near == 0 || scene.camera.far == 0;
    out.context.iMax = maximumIntensity(scene);
    out.context.width = std::size_t(settings.width), out.context.height = std::size_t(settings.height);
    out.values = ReferenceValues(out.frame, out.context.covered, wanted);
    const Values *const intensity = out.values.find("intensity"), *const color = out.values.find("color");
    if (!intensity || !color || !(out.context.iMax > 0)) return;
    for (std::size_t i = 0; i < intensity->numbers.size(); ++i) {
        out.context.unrounded.push_back(255 * std::clamp(intensity->numbers[i] / out.context.iMax, 0.0, 1.0));
        // What a planted error of the frame buffer has stored does not follow.
        if (!(std::abs(out.context.unrounded.back() - color->numbers[i]) < 0.6)) return out.context.unrounded.clear();
    }
}

void findOpen(Reference& out) {
    if (out.values.contains("polygon_id")) findOutline(out);
    if (out.values.contains("intensity") && out.values.contains("color") && out.values.contains("polygon_id"))
        findShadows(out);
}

}  // namespace

std::optional<Reference> makeReference(const Scene& scene, const std::map<std::string, double>& overrides, Stop stop,
                                       PixelCorner corner) {
    Reference out;
    out.corner = corner;
    if (!drawFrames(out, referenceScene(scene, corner), allCompared(), nullptr, stop)) return {};
    readFrame(out, allCompared());
    double nearest = HUGE_VAL, farthest = 0;
    if (const Values* const z = out.values.find("z_view"))
        for (std::size_t i = 0; i < z->count(); ++i)
            if (z->there[i]) nearest = std::min(nearest, z->numbers[i]), farthest = std::max(farthest, z->numbers[i]);
    const double extent = sceneExtent(out);
    for (const auto& [name, buffer] : out.values.names()) {
        const Tolerance& row = *toleranceOf(buffer.id);
        const double of = row.of == Tolerance::Of::Unit         ? 1
                          : row.of == Tolerance::Of::IMax       ? out.context.iMax
                          : row.of == Tolerance::Of::DepthRange ? std::max(farthest - nearest, extent * 1e-3)
                                                                : extent;
        const auto override = overrides.find(std::string(bufferInfo(buffer.id).name));
        if (buffer.id == BufferId::ShadowBuffer) out.context.ofShadowBuffers = row.value * of;
        out.tolerances[name] = override != overrides.end() ? override->second : row.value * of;
    }
    findOpen(out);
    return out;
}

std::optional<Reference> makeHypothesis(const Scene& wrong, const Reference& right, BufferSet compared,
                                        PixelCorner corner, const FramePtr& before, const Stop& stop) {
    using enum BufferId;
    Reference out;
    out.corner = corner;
    out.tolerances = right.tolerances, out.context.ofShadowBuffers = right.context.ofShadowBuffers;
    compared.set(index(PolygonId)).set(index(VerticesScreen));
    const bool isLit = std::ranges::any_of(kLit, [&](BufferId id) { return compared[index(id)]; });
    if (isLit && castsShadows(wrong))
        for (const BufferId id : {Color, Intensity, Diffuse, Specular, Shadow, LightVector, NDotL})
            compared.set(index(id));
    if (compared[index(Color)]) compared.set(index(Intensity));
    if (!drawFrames(out, keepsWanted(*referenceScene(wrong, corner)), compared, before, stop)) return {};
    readFrame(out, compared);
    findOpen(out);
    return out;
}

}  // namespace pipeline::foreign
