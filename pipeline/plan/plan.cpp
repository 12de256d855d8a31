#include "pipeline/plan/plan.h"

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/plan/plan_parts.h"
#include "pipeline/simd/incidence.h"
#include "pipeline/simd/model_kernels.h"

namespace pipeline {

std::string_view name(Action action) {
    switch (action) {
        case Action::Run: return "runs";
        case Action::Reuse: return "reused";
        case Action::LeaveOut: return "left out";
    }
    return {};
}

namespace {

// The first difference that a user would name, between the values of a vector's elements.
template <class T>
std::string firstDifferent(const std::vector<T>& a, const std::vector<T>& b, std::string_view one,
                           std::string_view all) {
    if (a.size() != b.size()) return fmt::format("{} changed.", all);
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!(a[i] == b[i])) return fmt::format("{} {} changed.", one, i);
    return {};
}

constexpr const char* kOtherDefect = "The planted defect changed.";

std::string difference(const TransformInputs& a, const TransformInputs& b) {
    if (a.planted != b.planted) return kOtherDefect;
    if (a.topology != b.topology) return "The objects changed.";
    if (auto text = firstDifferent(a.transforms, b.transforms, "The transform of object", "The objects"); !text.empty())
        return text;
    if (a.transparent != b.transparent) return "Other objects are wholly transparent.";
    if (a.depthFormat != b.depthFormat) return "The depth format changed.";
    if (a.normalMatrix != b.normalMatrix) return "The form of the normal matrix changed.";
    if (a.placesAsGiven != b.placesAsGiven) return "The rule of the model transform was switched.";
    if (a.view.subPixelBits != b.view.subPixelBits) return "The setting numerics.subpixel_bits changed.";
    if (a.view.size != b.view.size) return "The picture's size changed.";
    return a == b ? "" : "The camera changed.";
}

// What a light looks at, wherever the camera stands.
bool isSameWorld(const TransformInputs& a, const TransformInputs& b) {
    return a.topology == b.topology && a.transforms == b.transforms && a.transparent == b.transparent;
}

std::string difference(const CullInputs& a, const CullInputs& b) {
    if (a.planted != b.planted) return kOtherDefect;
    return a == b ? "" : "The setting cull changed.";
}

std::string difference(const NormalsInputs& a, const NormalsInputs& b) {
    if (a.planted != b.planted) return kOtherDefect;
    // Where nobody reads them any more they may stay.
    if (b.polygonNormals && !a.polygonNormals) return "Polygon normals are needed now.";
    if (a.vertexNormals != b.vertexNormals)
        return b.vertexNormals ? "Vertex normals are needed now." : "Vertex normals are not needed any more.";
    if (a.form != b.form || a.angle != b.angle || a.unit != b.unit) return "The form of a formula changed.";
    if (a.weight != b.weight) return "The weights of the normals changed.";
    if (a.asGiven != b.asGiven)
        return b.asGiven ? "The mesh's own normals serve now." : "The mesh's own normals do not serve any more.";
    NormalsInputs same = a;
    same.polygonNormals = b.polygonNormals;
    same.ownNormals = b.ownNormals;  // sums that nobody reads change no bit
    return same == b ? "" : "The settings of the normals changed.";
}

std::string difference(const ShadowBufferInputs& a, const ShadowBufferInputs& b) {
    if (a.size != b.size) return "The size of the shadow buffers changed.";
    if (a.cull != b.cull) return "The setting shadow.cull changed.";
    if (auto text = firstDifferent(a.casters, b.casters, "Light", "The lights"); !text.empty()) return text;
    return a == b ? "" : "The settings of the shadow buffers changed.";
}

std::string difference(const ZBufferInputs& a, const ZBufferInputs& b) {
    if (a.planted != b.planted) return kOtherDefect;
    if (a.visibility != b.visibility) return "The setting visibility changed.";
    if (a.translucent != b.translucent) return "Other objects are translucent.";
    if (a.split != b.split) return "The setting split changed.";
    for (const Part part : {Part::SeenPolygons, Part::FragmentCounts, Part::Weights})
        if (b.parts[part] && !a.parts[part]) return "Other buffers are asked for.";
    if (a.parts[Part::Clipping] != b.parts[Part::Clipping]) return "The rule of clipping was switched.";
    ZBufferInputs same = a;
    same.parts = b.parts;  // what more parts leave serves as well
    return same == b ? "" : "The settings of the z-buffer changed.";
}

std::string difference(const ShadingInputs& a, const ShadingInputs& b) {
    if (a.planted != b.planted) return kOtherDefect;
    if (a.shading != b.shading) return "The setting shading changed.";
    if (a.interpolation != b.interpolation) return "The setting interpolation changed.";
    const LightDetail &forms = a.illumination.detail, &others = b.illumination.detail;
    if (forms.power != others.power || forms.unit != others.unit) return "The form of a formula changed.";
    Illumination model = a.illumination;
    model.detail.logContrast = others.logContrast;  // which follows from materials and lights
    if (!(model == b.illumination)) return "The illumination model changed.";
    if (auto text = firstDifferent(a.materials, b.materials, "Material", "The materials"); !text.empty()) return text;
    if (auto text = firstDifferent(a.backMaterials, b.backMaterials, "Back material", "The materials"); !text.empty())
        return text;
    if (auto text = firstDifferent(a.lights, b.lights, "Light", "The lights"); !text.empty()) return text;
    if (!(a.ambient == b.ambient)) return "The ambient light changed.";
    if (!(a.shadow == b.shadow)) return "The settings of the shadow test changed.";
    if (a.samples != b.samples) return "The setting antialiasing changed.";
    if (a.samplePattern != b.samplePattern) return "The setting antialiasing_pattern changed.";
    if (!(a.layers == b.layers)) return "The layers of translucent surfaces changed.";
    if (a.parts[Part::FastVectors] != b.parts[Part::FastVectors])
        return b.parts[Part::FastVectors] ? "Fast arithmetic is used now." : "Exact arithmetic is used now.";
    if (a.parts[Part::ShadedInVectors] != b.parts[Part::ShadedInVectors])
        return b.parts[Part::ShadedInVectors] ? "Pixels are shaded in vectors now."
                                              : "Pixels are shaded one by one now.";
    return a == b ? "" : "Other parts of it are needed.";
}

// Whether the same light falls on the same pixels: only what is made of it may differ, the materials with their exponents,
// the strength and colours of lights, and ambient light.
bool hasSameIncidence(ShadingInputs a, const ShadingInputs& b) {
    if (a.lights.size() != b.lights.size()) return false;
    a.materials = b.materials, a.backMaterials = b.backMaterials, a.ambient = b.ambient;
    for (std::size_t k = 0; k < a.lights.size(); ++k)
        a.lights[k].intensity = b.lights[k].intensity, a.lights[k].color = b.lights[k].color;
    a.illumination.exponentFactor = b.illumination.exponentFactor;
    // What is needed for the materials; how each was shaded is kept with the light.
    a.illumination.detail.reflection = b.illumination.detail.reflection;
    a.illumination.detail.halfway = b.illumination.detail.halfway;
    a.illumination.detail.logContrast = b.illumination.detail.logContrast;
    for (const Part part : {Part::Ambient, Part::Position, Part::ViewVector}) a.parts.whole.set(part, b.parts[part]);
    return a == b;
}

// The buffers that shading leaves only when asked; the mean of several samples it leaves anyway.
bool shadingCovers(BufferSet have, BufferSet wanted, int samples) {
    for (const BufferInfo& info : bufferTable())
        if (info.stage == StageId::Shading && info.domain == Domain::Pixel && info.id != BufferId::Color &&
            !(info.id == BufferId::Antialiased && samples > 1) && wanted[index(info.id)] && !have[index(info.id)])
            return false;
    return true;
}

// What becomes of the incidence that a frame and the one before have in common.
PlanPart incidenceOf(const ShadingInputs& inputs, glm::ivec2 picture, BufferSet wanted, const Past& past) {
    PlanPart part{"N·L, highlights and S", Action::LeaveOut, "", ""};
    const double bytes = incidenceBytes(picture, inputs.lights.size());
    const bool asked = std::ranges::any_of(bufferTable(), [&](const BufferInfo& info) {
        return info.stage == StageId::Shading && info.domain == Domain::Pixel && info.id != BufferId::Color &&
               info.id != BufferId::Intensity && wanted[index(info.id)];
    });
    if (inputs.shading != Shading::Phong || !inputs.parts[Part::ShadedInVectors]) {
        part.why = "Not kept for other materials: Phong shading in vectors of pixels alone keeps them.";
    } else if (kernelOf(inputs.illumination.model) != Kernel::Power) {
        part.why = "Not kept for other materials: models whose highlight is a power alone keep them.";
    } else if (inputs.samples > 1) {
        part.why = "Not kept for other materials: each of a pixel's samples has its own.";
    } else if (asked) {
        part.why = "Not kept for other materials: more buffers than the picture are asked for.";
    } else if (bytes > kMostIncidence) {
        part.why =
            fmt::format("Not kept for other materials: they may take more than {:.0f} MB.", kMostIncidence / 1e6);
        part.saves = fmt::format("{:.0f} MB", bytes / 1e6);
    } else if (past.keptIncidence) {
        part.action = Action::Reuse;
        part.why = fmt::format("Those of frame {}, where they are all that the materials need.", past.number);
    } else {
        part.action = Action::Run;
        part.why = fmt::format("Kept for other materials, in {:.1f} MB where all is seen and lit.", bytes / 1e6);
    }
    return part;
}

}  // namespace

Plan decide(const Needs& needs, StageId until, const StageKeys& keys, const Past& past) {
    const auto changed = [&](auto member) { return past.keys ? difference(past.keys->*member, keys.*member) : ""; };
    const std::string reused = fmt::format("Nothing that this stage reads has changed since frame {}.", past.number);

    Plan plan;
    std::array<bool, kStageCount> rewritten{};  // its output will not be the one of the frame before
    // reads: the stages whose outputs this one takes.
    const auto step = [&](StageId stage, const Need& need, const std::string& difference,
                          std::initializer_list<StageId> reads) {
        PlanStep& out = plan[index(stage)];
        out.stage = stage;
        const bool had = past.has[index(stage)];
        StageId because = stage;
        for (StageId read : reads)
            if (rewritten[index(read)] && because == stage) because = read;

        if (index(stage) > index(until)) {
            out.action = Action::LeaveOut;
            out.why = fmt::format("The run ends after {}.", stageInfo(until).name);
        } else if (!need) {
            out.action = Action::LeaveOut;
            out.why = need.notBecause;
            out.rule = need.rule;
        } else if (!had || !difference.empty() || because != stage) {
            out.action = Action::Run;
            out.why = !difference.empty() ? difference
                      : because != stage  ? fmt::format("{} ran again.", stageInfo(because).label)
                      : past.keys         ? "It was left out before."
                                          : std::string(kNotRunYet);
        } else {
            out.action = Action::Reuse;
            out.why = reused;
        }
        rewritten[index(stage)] = out.action == Action::Run || (out.action == Action::LeaveOut && had);
    };

    const Need always;
    using enum StageId;
    step(Transform, always, changed(&StageKeys::transform), {});
    step(Cull, needs[Part::Culling], changed(&StageKeys::cull), {Transform});
    // For either kind; the reason is that of the polygon normals.
    const Need& normals = needs[needs[Part::VertexNormals] ? Part::VertexNormals : Part::PolygonNormals];
    step(Normals, normals, changed(&StageKeys::normals), {Transform});
    const std::string casters = changed(&StageKeys::shadowBuffer);
    if (past.keys && isSameWorld(past.keys->transform, keys.transform))
        step(StageId::ShadowBuffer, needs[Part::ShadowBuffer], casters, {});
    else
        step(StageId::ShadowBuffer, needs[Part::ShadowBuffer], casters, {Transform});
    step(ZBuffer, always, changed(&StageKeys::zBuffer), {Transform, Cull});
    std::string shading = changed(&StageKeys::shading);
    if (shading.empty() && past.keys && !shadingCovers(past.made, needs.buffers, keys.shading.samples))
        shading = "Other buffers are asked for.";
    step(StageId::Shading, always, shading, {ZBuffer, Normals, StageId::ShadowBuffer, Transform, Cull});
    PlanStep& last = plan[index(StageId::Shading)];
    const bool anew = std::ranges::count(rewritten, true) > 1 || !past.has[index(StageId::Shading)];
    if (last.action == Action::Run && !anew && !keys.shading.outlines &&
        hasSameIncidence(past.keys->shading, keys.shading))
        last.incidence = incidenceOf(keys.shading, keys.transform.view.size, needs.buffers, past);
    return plan;
}

void explain(const Scene& scene, const Needs& needs, Plan& plan) {
    for (PlanStep& step : plan) {
        step.parts = planParts(step.stage, scene, needs, step.action);
        if (step.incidence) step.parts.push_back(*step.incidence);
        if (step.action != Action::LeaveOut) continue;
        for (PlanPart& part : step.parts) {
            part.action = Action::LeaveOut;
            part.why = step.why;
        }
    }
}

}  // namespace pipeline
