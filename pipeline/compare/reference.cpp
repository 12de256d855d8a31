#include "pipeline/compare/reference.h"

#include <algorithm>
#include <cmath>

#include "pipeline/defects/defect_ways.h"
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
    reference.openPixels = std::make_shared<std::vector<std::atomic<PixelState>>>(polygons.count());
    for (std::size_t i = 0; i < polygons.count(); ++i)
        reference.outline[i] = anyAround(i, 1, polygons.columns, polygons.rows, [&](std::size_t other) {
            return polygons.numbers[other] != polygons.numbers[i];
        });
}

// Where the S of a light is open.
std::vector<std::uint8_t> openShadow(Reference& reference, std::size_t light) {
    const NumbersInPlace s(*reference.frame, "shadow." + std::to_string(light));
    const NumbersInPlace towards(*reference.frame, "light_vector." + std::to_string(light));
    const Values& polygons = reference.values.at("polygon_id");
    const auto& data = *dataOf<double>(*reference.frame);
    const auto& covered = reference.context.covered;
    std::vector<std::uint8_t> open(covered.size(), 0);
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (!covered[i]) continue;
        const Vec3d plane = polygonNormal(*data.transform, std::size_t(polygons.numbers[i]));
        const bool grazes = glm::dot(plane, towards.vector(i)) < kGrazing;
        if (grazes) reference.grazing[i] = 1;
        if (!grazes && s[i] < 0.5) reference.shadowed[i] = 1;
        open[i] = grazes || anyAround(i, kShadowBand, polygons.columns, polygons.rows, [&](std::size_t other) {
                      return covered[other] && std::abs(s[other] - s[i]) > 0.01;
                  });
    }
    return open;
}

// Whether the first light's S is a factor of the ambient term too.
bool ambientIsShadowed(const Planted& planted) {
    return planted.defect == Defect::AmbientInShadow && planted.way != kHighlightInShadow;
}

// A term of a light that casts a shadow, with and without its S.
struct ShadowedTerm {
    std::size_t light;
    NumbersInPlace here, whole;
};
std::vector<ShadowedTerm> shadowedTerms(const Frame& shadowed, const Frame& unshadowed) {
    std::vector<ShadowedTerm> out;
    const std::vector<Light>& lights = shadowed.scene().lights;
    for (std::size_t k = 0; k < lights.size(); ++k)
        for (const std::string term : {"diffuse.", "specular."}) {
            const std::string name = term + std::to_string(k);
            if (lights[k].castsShadow) out.push_back({k, {shadowed, name}, {unshadowed, name}});
        }
    std::erase_if(out, [](const ShadowedTerm& term) { return term.here.empty() || term.whole.empty(); });
    return out;
}

void findShadows(Reference& reference, const Frame& unshadowed) {
    const Scene& scene = reference.frame->scene();
    const std::size_t count = reference.context.covered.size();
    reference.shadowOpen.resize(scene.lights.size());
    reference.shadowed.assign(count, 0), reference.grazing.assign(count, 0);
    for (std::size_t k = 0; k < scene.lights.size(); ++k)
        if (scene.lights[k].castsShadow) reference.shadowOpen[k] = openShadow(reference, k);
    reference.shadowContrast.resize(count), reference.unshadowedTerms.resize(count);
    reference.colorLow.resize(count), reference.colorHigh.resize(count);
    reference.intensityLow.resize(count), reference.intensityHigh.resize(count);
    const NumbersInPlace intensity(*reference.frame, "intensity");
    const std::vector<ShadowedTerm> terms = shadowedTerms(*reference.frame, unshadowed);
    const Planted planted = dataOf<double>(*reference.frame)->keys.shading.planted;
    const bool takesAmbient = ambientIsShadowed(planted) && !reference.shadowOpen[0].empty();
    const NumbersInPlace s(*reference.frame, "shadow.0"), ambient(unshadowed, "ambient");
    for (std::size_t i = 0; i < count; ++i) {
        Vec3d low = intensity.vector(i), high = low, sum(0);
        double contrast = 0;
        for (const ShadowedTerm& term : terms) {
            const Vec3d here = term.here.vector(i), whole = term.whole.vector(i);
            sum += whole, contrast += std::max({whole.x, whole.y, whole.z});
            if (reference.shadowOpen[term.light][i]) low -= here, high += whole - here;
        }
        if (takesAmbient && reference.shadowOpen[0][i])
            low -= s[i] * ambient.vector(i), high += (1 - s[i]) * ambient.vector(i);
        const double iMax = reference.context.iMax;
        reference.shadowContrast[i] = float(255 * contrast / iMax), reference.unshadowedTerms[i] = sum;
        reference.intensityLow[i] = low, reference.intensityHigh[i] = high;
        storeFrameBufferValue(low, iMax, planted, reference.colorLow[i]);
        storeFrameBufferValue(high, iMax, planted, reference.colorHigh[i]);
    }
}

}  // namespace

NumbersInPlace::NumbersInPlace(const Frame& frame, const std::string& name)
    : m_buffer(frame.buffer(*findBuffer(name))) {
    if (!m_buffer) return;
    if (const auto* const numbers = std::get_if<std::span<const double>>(&m_buffer->data)) m_numbers = *numbers;
}

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
                const FramePtr& before, const Stop& stop, FramePtr& unshadowed) {
    const FrameRequest request{wanted, StageId::Shading, 0, stop};
    out.frame = runFrame(scene, request, before);
    if (!out.frame) return false;
    const bool isLit = std::ranges::any_of(kLit, [&](BufferId id) { return wanted[index(id)]; });
    if (!isLit || !castsShadows(*scene)) return true;
    Scene without = *scene;
    for (Light& light : without.lights) light.castsShadow = false;
    FrameRequest terms = request;
    terms.wanted = setOf({BufferId::Diffuse, BufferId::Specular});
    if (ambientIsShadowed(dataOf<double>(*out.frame)->keys.shading.planted)) terms.wanted.set(index(BufferId::Ambient));
    unshadowed = runFrame(keepsWanted(std::move(without)), terms, out.frame);
    return unshadowed != nullptr;
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
    const NumbersInPlace intensity(*out.frame, "intensity");
    const Values* const color = out.values.find("color");
    if (intensity.empty() || !color || !(out.context.iMax > 0)) return;
    out.context.unrounded.resize(color->numbers.size());
    for (std::size_t i = 0; i < color->numbers.size(); ++i) {
        const double unrounded = 255 * std::clamp(intensity[i] / out.context.iMax, 0.0, 1.0);
        // What a planted error of the frame buffer has stored does not follow.
        if (!(std::abs(unrounded - color->numbers[i]) < 0.6)) return out.context.unrounded = {}, void();
        out.context.unrounded[i] = unrounded;
    }
}

// unshadowed: null where no light casts a shadow.
void findOpen(Reference& out, const FramePtr& unshadowed) {
    if (!out.values.contains("polygon_id")) return;
    findOutline(out);
    if (unshadowed && out.values.contains("intensity") && out.values.contains("color")) findShadows(out, *unshadowed);
}

}  // namespace

std::optional<Reference> makeReference(const Scene& scene, const std::map<std::string, double>& overrides, Stop stop,
                                       PixelCorner corner) {
    Reference out;
    out.corner = corner;
    FramePtr unshadowed;
    BufferSet kept = allCompared();
    kept.set(index(BufferId::Transmittance)).set(index(BufferId::Translucent));  // their pixels are shaded with these
    if (!drawFrames(out, keepsWanted(*referenceScene(scene, corner)), kept, nullptr, stop, unshadowed)) return {};
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
    findOpen(out, unshadowed);
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
    FramePtr unshadowed;
    if (!drawFrames(out, keepsWanted(*referenceScene(wrong, corner)), compared, before, stop, unshadowed)) return {};
    readFrame(out, compared);
    findOpen(out, unshadowed);
    return out;
}

}  // namespace pipeline::foreign
