#include "pipeline/run/frame_remarks.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include <fmt/format.h>

#include "pipeline/core/numerics.h"
#include "pipeline/core/text.h"
#include "pipeline/plan/black.h"
#include "pipeline/plan/scene_remarks.h"
#include "pipeline/run/frame_data.h"

namespace pipeline {
namespace {

using Counts = std::array<std::size_t, kVerdictCount>;

std::string allPolygons(std::size_t count) {
    return count == 1 ? "The only polygon" : fmt::format("All {} polygons", count);
}
std::string_view form(std::size_t count, std::string_view ofOne, std::string_view ofMany) {
    return count == 1 ? ofOne : ofMany;
}

// The setting that makes the camera look from the other side.
std::string otherSide(const Camera& camera) {
    if (camera.kind == CameraKind::LookAt) return "move camera.eye to the other side";
    const double theta = camera.theta > 0 ? camera.theta - 180 : camera.theta + 180;
    return fmt::format("look from the other side: camera.theta={} camera.phi={}", shortestText(theta),
                       shortestText(180 - camera.phi));
}

// Where float holds no object: its places are 0 then, and none of the reasons below is the cause.
std::optional<Remark> whyUnderflow(const Scene& scene) {
    constexpr double kSmallest = 0x1p-126;  // a normal number in float
    double size = 0;
    for (const Object& object : scene.objects) {
        const MeshFacts& facts = object.mesh->facts;
        size = std::max(size, largestComponent((facts.high - facts.low) * object.transform.scale));
    }
    if (scene.settings.precision != Precision::Float || !(size > 0) || size >= kSmallest) return {};
    return Remark{"precision", fmt::format("Underflow: the largest object is {} world units large, and float rounds "
                                           "what is much smaller than {} to 0. Set precision=double, or scale the "
                                           "objects and the camera up.",
                                           shortestText(size), shortestText(kSmallest))};
}

// For objects of which no polygon is drawn.
Remark whyNoneIsDrawn(const Scene& scene, const Counts& counts, std::size_t all) {
    if (const auto underflow = whyUnderflow(scene)) return *underflow;
    const auto of = [&](Verdict verdict) { return counts[static_cast<std::size_t>(verdict)]; };
    const auto are = [&](std::string_view rest) {
        return fmt::format("{} {} {}", allPolygons(all), form(all, "is", "are"), rest);
    };
    const std::size_t beside =
        of(Verdict::OutsideLeft) + of(Verdict::OutsideRight) + of(Verdict::OutsideTop) + of(Verdict::OutsideBottom);
    if (of(Verdict::Transparent) == all) return whyBlack(scene);
    if (of(Verdict::BackFacing) == all)
        return {"cull", fmt::format("{} {} away from the eye, and back faces are left out. Set cull=none, or {}.",
                                    allPolygons(all), form(all, "faces", "face"), otherSide(scene.camera))};
    if (of(Verdict::Degenerate) == all)
        return {"", are("without area in the picture: seen edge-on, too small, or without area in the mesh. Look from "
                        "another direction, or come nearer.")};
    if (of(Verdict::OutsideNear) == all)
        return {"camera.near", are(scene.camera.near != 0
                                       ? "before the near plane. Set camera.near=0, which chooses it from the scene."
                                       : "behind the eye. Move the camera back, or turn it round.")};
    if (of(Verdict::OutsideFar) == all)
        return {"camera.far", are("behind the far plane. Set camera.far=0, which chooses it from the scene.")};
    if (beside == all) {
        const bool isSpherical = scene.camera.kind == CameraKind::Spherical;
        return {
            isSpherical ? "camera.distance" : "camera.target_x",
            are(isSpherical ? "outside the picture. The camera looks at the world's origin: move the objects there, or "
                              "set a smaller camera.distance or a larger camera.rho."
                            : "outside the picture. Turn camera.target to them, or widen the view.")};
    }
    std::vector<std::string> parts;
    const auto add = [&](std::size_t count, std::string_view what) {
        if (count > 0) parts.push_back(fmt::format("{} {}", count, what));
    };
    add(of(Verdict::Transparent), "wholly transparent");
    add(of(Verdict::BackFacing), "facing away (cull=none draws them)");
    add(of(Verdict::OutsideNear), "before the near plane or behind the eye");
    add(of(Verdict::OutsideFar), "behind the far plane");
    add(beside, "outside the picture");
    add(of(Verdict::Degenerate), "without area in the picture");
    add(of(Verdict::Kept) + of(Verdict::Clipped), "smaller than a pixel, between the pixels' centres");
    if (parts.size() == 1 && of(Verdict::Kept) + of(Verdict::Clipped) > 0)
        return {"camera.distance", are("in view, and so small that no pixel's centre is covered. Come nearer, or set a "
                                       "larger picture.")};
    return {"", fmt::format("Of {} polygons none is seen: {}.", all, fmt::join(parts, ", "))};
}

bool showsBlackAlone(const AnyBuffer& color) {
    const auto bytes = std::get<std::span<const std::uint8_t>>(color.data);
    return std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte == 0; });
}

// Where 1 is white, and almost every pixel that shows something is. Of large pictures some pixels are looked at.
std::optional<Remark> whyWhite(const Frame& frame) {
    const Scene& scene = frame.scene();
    const auto color = frame.until() == StageId::Shading ? frame.buffer({BufferId::Color}) : std::nullopt;
    const ModelFacts& model = modelFacts(scene.settings.model);
    if (!color || model.white != White::One) return {};
    const auto bytes = std::get<std::span<const std::uint8_t>>(color->data);
    constexpr std::size_t kMostLooks = 1 << 18;
    const std::size_t step = 3 * (1 + bytes.size() / 3 / kMostLooks);
    std::size_t white = 0, shown = 0;
    for (std::size_t i = 0; i + 2 < bytes.size(); i += step) {
        const int least = std::min({bytes[i], bytes[i + 1], bytes[i + 2]});
        white += least == 255, shown += least > 0 || bytes[i] > 0 || bytes[i + 1] > 0 || bytes[i + 2] > 0;
    }
    constexpr double kAlmostAll = 0.9;
    if (shown == 0 || double(white) < kAlmostAll * double(shown)) return {};
    std::string key = "ambient.intensity";
    double most = scene.ambient.intensityIn(scene.settings.model);
    for (std::size_t k = 0; k < scene.lights.size(); ++k)
        if (scene.lights[k].intensity > most)
            most = scene.lights[k].intensity, key = fmt::format("light.{}.intensity", k);
    return Remark{key, fmt::format("{:.0f} % of the pixels that are not black are white. In {} 1 is white, and {} is "
                                   "{}: set it lower.",
                                   100 * double(white) / double(shown), model.name, key, shortestText(most))};
}

// What the stages have drawn; empty if the last stage that could tell has not run.
struct Drawn {
    bool isKnown = false;
    bool any = false;
};
Drawn drawnIn(const Frame& frame) {
    return readStages(frame, [](const auto& data) -> Drawn {
        if (data.shading && data.zBuffer) return {true, data.zBuffer->seenPixels + data.shading->counts.layers > 0};
        if (data.zBuffer && data.keys.zBuffer.translucent.empty()) return {true, data.zBuffer->seenPixels > 0};
        if (!data.zBuffer && data.cull)
            return {true, std::ranges::any_of(data.cull->verdicts, [](Verdict v) { return goesOn(v); })};
        return {};
    });
}

}  // namespace

std::optional<Remark> whyNothingIsSeen(const Frame& frame) {
    const Drawn drawn = drawnIn(frame);
    if (!drawn.isKnown) return {};
    if (drawn.any) {
        const auto color = frame.until() == StageId::Shading ? frame.buffer({BufferId::Color}) : std::nullopt;
        if (!color || !showsBlackAlone(*color)) return {};
        Remark black = whyBlack(frame.scene());
        black.text = "Everything that is drawn is black. " + black.text;
        return black;
    }
    const auto verdicts = frame.buffer({BufferId::PolygonsVerdict});
    if (!verdicts) return {};
    if (verdicts->count() == 0) return Remark{"object", "The scene has no polygons."};
    Counts counts{};
    for (std::size_t i = 0; i < verdicts->count(); ++i) ++counts[static_cast<std::size_t>(verdicts->flat(i))];
    return whyNoneIsDrawn(frame.scene(), counts, verdicts->count());
}

std::vector<Remark> frameRemarks(const Frame& frame) {
    std::vector<Remark> remarks = sceneRemarks(frame.scene());
    for (const StageId stage : kStages)
        if (const auto& remark = frame.run(stage).remark) remarks.push_back(*remark);
    auto nothing = whyNothingIsSeen(frame);
    // The scene's remarks have already said what is certain before drawing.
    const bool isSaid = nothing && (frame.scene().objects.empty() ||
                                    (isBlack(frame.scene()) && nothing->about == whyBlack(frame.scene()).about));
    if (nothing && !isSaid) remarks.push_back(*std::move(nothing));
    if (auto white = whyWhite(frame)) remarks.push_back(*std::move(white));
    return remarks;
}

}  // namespace pipeline
