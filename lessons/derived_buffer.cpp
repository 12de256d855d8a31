#include "lessons/derived_buffer.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "pipeline/scene/view.h"

namespace lessons {

using pipeline::BufferId;
using pipeline::BufferName;
using pipeline::BufferSet;
using pipeline::Error;
using pipeline::Frame;
using pipeline::Result;
using pipeline::Scene;
using pipeline::TermMix;

namespace {

const pipeline::SourceLocation kStart{{}, 1, 1};

TermMix mixOf(const DerivedRecipe& recipe, const Scene& scene) {
    return recipe.mix.empty() ? pipeline::plainMix(scene.lights.size()) : recipe.mix;
}

Result<lessons::Expression> conditionOf(const BufferName& name, const DerivedRecipe& recipe, const Scene& scene) {
    const bool isTruth = name.id == BufferId::Condition;
    if (recipe.text.empty()) return Error{{}, isTruth ? "There is no condition." : "There is no expression.", {}};
    return isTruth ? lessons::parseCondition(recipe.text, kStart, {scene})
                   : lessons::parseNumbers(recipe.text, kStart, {scene});
}

Result<DerivedBuffer> makeMix(const BufferName&, const DerivedRecipe& recipe, const Frame& frame,
                              const DerivedControl& control) {
    const TermMix mix = mixOf(recipe, frame.scene());
    const auto mixed = mixTerms(frame, mix, control.stop);
    if (!mixed) return mixed.errors();
    return DerivedBuffer{.buffer = mixed->color,
                         .meaning = fmt::format("The frame buffer of the terms mixed so: {}.", describe(mix)),
                         .clamped = mixed->clamped};
}

Result<DerivedBuffer> makeVerdicts(const BufferName& name, const DerivedRecipe&, const Frame& frame,
                                   const DerivedControl& control) {
    const auto light = std::size_t(name.light);
    std::shared_ptr<const KnownRays> rays = control.rays;
    if (!rays || rays->exact.light != light || !haveSameRays(*rays->scene, frame.scene())) {
        auto exact = exactShadows(frame.scene(), light, control.threads, control.stop, control.progress);
        if (!exact) return Error{{}, "stopped", {}};
        rays = std::make_shared<const KnownRays>(KnownRays{frame.sharedScene(), *std::move(exact)});
    }
    auto verdicts = judgeShadows(frame, rays->exact);
    const BufferName shadow{BufferId::Shadow, name.light};
    if (!verdicts) return Error{{}, fmt::format("no {} in this frame: {}", shadow.text(), frame.whyAbsent(shadow)), {}};
    const auto found = std::make_shared<const pipeline::ShadowVerdicts>(*std::move(verdicts));
    return DerivedBuffer{.buffer = bufferOf(*found),
                         .meaning =
                             "Of the shadow factor against exact rays: 0 lit, 1 shadowed, 2 acne, 3 leak; "
                             "-1 none.",
                         .verdicts = found,
                         .rays = rays};
}

Result<DerivedBuffer> makeCondition(const BufferName& name, const DerivedRecipe& recipe, const Frame& frame,
                                    const DerivedControl& control) {
    const auto condition = conditionOf(name, recipe, frame.scene());
    if (!condition) return condition.errors();
    if (name.id == BufferId::Expression) {
        auto numbers = numbersOf(*condition, {.frame = frame, .stop = control.stop});
        if (!numbers) return numbers.errors();
        return DerivedBuffer{.buffer = std::move(numbers).value(), .meaning = fmt::format("{}.", recipe.text)};
    }
    auto mask = maskOf(*condition, {.frame = frame, .stop = control.stop});
    if (!mask) return mask.errors();
    const auto found = std::make_shared<const ConditionMask>(std::move(mask).value());
    return DerivedBuffer{
        .buffer = bufferOf(*found), .meaning = fmt::format("1 where {} holds, else 0.", recipe.text), .mask = found};
}

// As OpenGL's projection matrices give it (glFrustum, glOrtho), written so that the two planes are exact. Beyond the far
// plane it is above 1.
double zNdc(const pipeline::View& view, double zView) {
    if (std::isinf(zView)) return zView;  // nothing was drawn
    const double range = view.far - view.near;
    return view.perspective ? 1 - 2 * (view.near / zView) * ((view.far - zView) / range)
                            : 2 * (zView - view.near) / range - 1;
}

Result<DerivedBuffer> makeZNdc(const BufferName&, const DerivedRecipe&, const Frame& frame, const DerivedControl&) {
    const BufferName name{BufferId::ZNdc}, from{BufferId::ZView};
    const auto z = frame.buffer(from);
    if (!z) return Error{{}, fmt::format("no {} in this frame: {}", from.text(), frame.whyAbsent(from)), {}};
    const pipeline::View view = makeView(frame.scene());
    pipeline::AnyBuffer buffer{name, &bufferInfo(name.id), z->shape, {}, {}};
    std::visit(
        [&]<class T>(std::span<const T> distances) {
            const auto numbers = std::make_shared<std::vector<T>>();
            for (const T distance : distances) numbers->push_back(T(zNdc(view, double(distance))));
            buffer.data = std::span<const T>(*numbers);
            buffer.owner = numbers;
        },
        z->data);
    return DerivedBuffer{
        .buffer = std::move(buffer),
        .meaning = fmt::format("z in normalised device coordinates: -1 at z_view = {:.6g}, 1 at {:.6g}.", view.near,
                               view.far)};
}

Error noneBecause(const std::string& why) { return Error{{}, why, {}}; }

Result<BufferSet> mixNeeds(const BufferName&, const DerivedRecipe& recipe, const Scene& scene) {
    if (const std::string why = whyNoMix(scene); !why.empty()) return noneBecause(why);
    if (mixOf(recipe, scene).size() != pipeline::plainMix(scene.lights.size()).size())
        return noneBecause("The mix is of another number of lights.");
    return pipeline::mixBuffers();
}
Result<BufferSet> verdictsNeed(const BufferName& name, const DerivedRecipe&, const Scene& scene) {
    if (const std::string why = whyNoShadowVerdicts(scene, std::size_t(name.light)); !why.empty())
        return noneBecause(why);
    return pipeline::setOf({BufferId::Shadow, BufferId::ObjectId});
}
Result<BufferSet> conditionNeeds(const BufferName& name, const DerivedRecipe& recipe, const Scene& scene) {
    const auto condition = conditionOf(name, recipe, scene);
    if (!condition) return condition.errors();
    return condition->buffers;
}
Result<BufferSet> zNdcNeeds(const BufferName&, const DerivedRecipe&, const Scene&) {
    return pipeline::setOf({BufferId::ZView});
}

struct DerivedRow {
    BufferId id;
    Result<BufferSet> (*needs)(const BufferName&, const DerivedRecipe&, const Scene&);
    Result<DerivedBuffer> (*make)(const BufferName&, const DerivedRecipe&, const Frame&, const DerivedControl&);
};
// In the order of the enumerators: a derived buffer without a row does not compile.
constexpr auto kRows = std::to_array<DerivedRow>({
    {BufferId::Mix, mixNeeds, makeMix},
    {BufferId::ShadowVerdict, verdictsNeed, makeVerdicts},
    {BufferId::Condition, conditionNeeds, makeCondition},
    {BufferId::Expression, conditionNeeds, makeCondition},
    {BufferId::ZNdc, zNdcNeeds, makeZNdc},
});
static_assert(kRows.size() == pipeline::kDerivedCount);

static_assert([] {
    for (std::size_t i = 0; i < kRows.size(); ++i)
        if (index(kRows[i].id) != pipeline::kBufferCount + i) return false;
    return true;
}());

const DerivedRow& rowOf(BufferId id) { return kRows[index(id) - pipeline::kBufferCount]; }

}  // namespace

Result<BufferSet> buffersFor(const BufferName& name, const DerivedRecipe& recipe, const Scene& scene) {
    if (!pipeline::isDerived(name.id)) return noneBecause(name.text() + " is a buffer of the frame.");
    return rowOf(name.id).needs(name, recipe, scene);
}

Result<DerivedBuffer> derive(const BufferName& name, const DerivedRecipe& recipe, const Frame& frame,
                             const DerivedControl& control) {
    return rowOf(name.id).make(name, recipe, frame, control);
}

}  // namespace lessons
