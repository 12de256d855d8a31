#include <fmt/format.h>

#include <cmath>

#include "pipeline/core/numerics.h"
#include "pipeline/core/text.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/run/runner.h"

namespace pipeline {
namespace {

// The largest difference over the largest magnitude in double, for numbers that are finite in both runs.
double largestRelative(const AnyBuffer& a, const AnyBuffer& b, const std::vector<bool>& compared) {
    double largest = 0, scale = 0;
    const auto channels = std::size_t(a.channels());
    for (std::size_t i = 0; i < a.count(); ++i) {
        if (!compared[i / channels]) continue;
        const double x = a.flat(i), y = b.flat(i);
        if (!std::isfinite(x) || !std::isfinite(y)) continue;
        largest = std::max(largest, std::abs(x - y));
        scale = std::max(scale, std::abs(y));
    }
    return scale > 0 ? largest / scale : 0;
}

Vec3d vectorAt(const AnyBuffer& buffer, std::size_t i) {
    return {buffer.value(0, i, 0), buffer.value(0, i, 1), buffer.value(0, i, 2)};
}

// Calls visit(ours, theirs) where both exist: near a plane or near 0 only one precision may have a value.
template <class IsThere, class Visit>
void forEachInBoth(const AnyBuffer& a, const AnyBuffer& b, IsThere isThere, Visit visit) {
    for (std::size_t i = 0; i < a.rows(); ++i)
        if (const Vec3d p = vectorAt(a, i), q = vectorAt(b, i); isThere(p) && isThere(q)) visit(p, q);
}

StageError transformError(const AnyBuffer& a, const AnyBuffer& b) {
    double largest = 0;
    forEachInBoth(a, b, hasScreenPosition<double>,
                  [&](Vec3d p, Vec3d q) { largest = std::max(largest, glm::distance(glm::dvec2(p), glm::dvec2(q))); });
    return {largest, fmt::format("{:.1e} px", largest)};
}

StageError cullError(const AnyBuffer& a, const AnyBuffer& b) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.count(); ++i) different += a.flat(i) != b.flat(i);
    return {double(different) / double(std::max<std::size_t>(1, a.count())),
            plural(std::int64_t(different), "polygon")};
}

StageError normalsError(const AnyBuffer& a, const AnyBuffer& b) {
    double largest = 0;
    const auto isDirection = [](Vec3d v) { return v != Vec3d(0); };
    forEachInBoth(a, b, isDirection, [&](Vec3d n, Vec3d m) { largest = std::max(largest, angleBetween(n, m)); });
    return {largest, fmt::format("{:.1e} rad", largest)};
}

// Pixels that show the same polygon in both runs; at other pixels the comparison means nothing.
std::vector<bool> sameSeen(const Frame& a, const Frame& b, std::size_t& different) {
    const AnyBuffer ids = *a.buffer({BufferId::PolygonId}), others = *b.buffer({BufferId::PolygonId});
    std::vector<bool> same(ids.count());
    for (std::size_t i = 0; i < same.size(); ++i) {
        different += ids.flat(i) != others.flat(i);
        same[i] = ids.flat(i) == others.flat(i) && ids.flat(i) >= 0;
    }
    return same;
}

std::string relativeText(double value, std::size_t differentPixels) {
    std::string text = value == 0 ? "0" : fmt::format("{:.1e}", value);
    if (differentPixels > 0) text += fmt::format(", {} px differ", differentPixels);
    return text;
}

}  // namespace

std::array<std::optional<StageError>, kStageCount> errorAgainstDouble(const FramePtr& frame, Stop stop) {
    std::array<std::optional<StageError>, kStageCount> errors;
    auto scene = std::make_shared<Scene>(frame->scene());
    scene->settings.precision = Precision::Double;
    FrameRequest request{frame->wanted(), frame->until(), 0, std::move(stop)};
    const FramePtr reference = runFrame(std::move(scene), request, nullptr);
    if (!reference) return errors;

    std::size_t different = 0;
    std::vector<bool> same;
    const auto compare = [&](StageId stage, BufferId id, auto error) {
        const auto a = frame->buffer({id}), b = reference->buffer({id});
        if (a && b) errors[index(stage)] = error(*a, *b);
    };
    compare(StageId::Transform, BufferId::VerticesScreen, transformError);
    compare(StageId::Cull, BufferId::PolygonsVerdict, cullError);
    const bool ofPolygons = frame->buffer({BufferId::PolygonsNormal}).has_value();
    compare(StageId::Normals, ofPolygons ? BufferId::PolygonsNormal : BufferId::VerticesNormal, normalsError);
    for (std::size_t k = 0; k < frame->scene().lights.size(); ++k) {
        const BufferName name{BufferId::ShadowBuffer, int(k)};
        const auto a = frame->buffer(name), b = reference->buffer(name);
        if (!a || !b) continue;
        const double value = largestRelative(*a, *b, std::vector<bool>(a->count(), true));
        auto& entry = errors[index(StageId::ShadowBuffer)];
        if (!entry || entry->value < value) entry = StageError{value, relativeText(value, 0)};
    }
    if (frame->buffer({BufferId::PolygonId}) && reference->buffer({BufferId::PolygonId}))
        same = sameSeen(*frame, *reference, different);
    const auto perPixel = [&](const AnyBuffer& a, const AnyBuffer& b) {
        const double value = largestRelative(a, b, same);
        return StageError{value, relativeText(value, different)};
    };
    compare(StageId::ZBuffer, BufferId::ZView, perPixel);
    compare(StageId::Shading, BufferId::Intensity, perPixel);
    return errors;
}

}  // namespace pipeline
