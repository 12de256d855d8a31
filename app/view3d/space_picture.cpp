#include "app/view3d/space_picture.h"

#include <algorithm>

#include "app/drawing3d/normal_arrows.h"
#include "app/drawing3d/overlay.h"
#include "app/drawing3d/point_drawing.h"
#include "app/drawing3d/space_content.h"
#include "app/drawing3d/world_drawing.h"
#include "pipeline/plan/needs.h"
#include "pipeline/run/runner.h"
#include "pipeline/steps/steps.h"

namespace app {

namespace {

// The content in world space, at the state's place; null when stopped.
std::shared_ptr<const ViewContent> worldOf(const lessons::WindowState& state,
                                           const std::shared_ptr<const pipeline::Scene>& scene,
                                           const ViewOptions& options, bool hasFrusta, const std::stop_token& stop) {
    pipeline::FrameRequest request{.wanted = contentBuffers(*scene, options.normals == NormalsShown::Vertices),
                                   .stop = stop};
    if (hasFrusta && whyUseless(*scene, pipeline::BufferId::ShadowBuffer).empty())
        request.wanted |= pipeline::setOf({pipeline::BufferId::ShadowBuffer});
    const pipeline::FramePtr whole = runFrame(scene, request, nullptr);
    if (!whole) return nullptr;
    const auto steps = state.place ? std::make_unique<pipeline::Steps>(whole) : nullptr;
    const pipeline::Moment moment = steps ? steps->momentOf(*state.place) : pipeline::Moment();
    const pipeline::FramePtr frame = steps ? steps->frameAt(moment, 0, stop) : whole;
    if (!frame) return nullptr;
    const auto pixel = state.pixel ? std::optional(glm::ivec2((*state.pixel)[0], (*state.pixel)[1])) : std::nullopt;
    const bool inTransform = steps && frame->until() == pipeline::StageId::Transform;
    ViewContent content = contentOf(*frame, pixel, nullptr, stop, inTransform ? steps->frame().get() : nullptr);
    if (stop.stop_requested()) return nullptr;
    content = withSelection(content, *frame, state.selected);
    if (hasFrusta) content.frusta = lightFrusta(*frame);
    if (steps) content = withProgress(content, *steps, moment);
    return std::make_shared<const ViewContent>(std::move(content));
}

}  // namespace

OrbitCamera firstCamera(const ViewContent& content, const ViewOptions& options, bool isPoint, glm::dvec2 size,
                        bool orthographic) {
    const double foot = content.map.keepsLengths() && content.point ? size.y - legendAt(size).top() : 0;
    const auto framed = isPoint ? pointCamera : presetCamera;
    return framed(ViewPreset::Iso, content, options, size, orthographic, foot);
}

ViewShot shotOf(glm::ivec2 size, bool isPoint, bool isWorld, bool transparent) {
    constexpr double kUsualHeight = 600;  // of a view with letters in their own size
    return {.size = size,
            .pixelRatio = std::max(0.2, size.y / kUsualHeight),
            .transparent = transparent,
            .isPoint = isPoint,
            .hasGround = isWorld};
}

pipeline::Result<SpacePicture> spacePicture(const lessons::WindowState& state, const lessons::SpaceShown& shown,
                                            const std::shared_ptr<const pipeline::Scene>& scene, glm::ivec2 size,
                                            double pixelRatio, const std::stop_token& stop) {
    pipeline::Errors errors;
    ViewOptions options = optionsOf(shown, errors);
    const auto space = spaceNamed(shown.space);
    if (!space) errors.push_back({{}, "the 3D view has no space \"" + shown.space + '"', {}});
    if (!errors.empty()) return errors;
    const bool isLight = space->space == ViewSpace::Light, isPoint = space->space == ViewSpace::Point;
    const auto world = worldOf(state, scene, options, options.lightFrusta || isLight, stop);
    if (!world) return pipeline::Error{{}, "stopped", {}};
    ViewOptions first;
    makeNormalsReadable(*world, first);
    options = optionsOf(shown, errors, first);
    std::shared_ptr<const ViewContent> content = isPoint ? pointContent(*world) : world;
    if (!isPoint && space->space != ViewSpace::World) {
        const auto map = mapOf(*world, *space);
        content = map ? std::make_shared<const ViewContent>(inSpace(*world, *map)) : nullptr;
    }
    if (!content) return pipeline::Error{{}, "this scene has no " + nameOf(*space), {}};
    ViewShot shot = shotOf(size, isPoint, space->space == ViewSpace::World, false);
    if (pixelRatio > 0) shot.pixelRatio = pixelRatio;
    const glm::dvec2 logical = glm::dvec2(size) / shot.pixelRatio;
    if (!shown.camera)
        return SpacePicture{content, options, firstCamera(*content, options, isPoint, logical, false), shot};
    const auto& c = *shown.camera;
    return SpacePicture{content, options,
                        OrbitCamera{c.target, c.distance, c.right, c.up, c.forward, c.fov, c.orthographic}, shot};
}

}  // namespace app
