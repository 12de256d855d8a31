#pragma once
#include "app/vtk/offscreen.h"
#include "lessons/state/window_state.h"

namespace app {

// The options of a state's 3D view, over `options`. Errors: unknown names and values out of range; those keep the value
// of `options`.
ViewOptions optionsOf(const lessons::SpaceShown& shown, pipeline::Errors& errors, ViewOptions options = {});
std::optional<SpaceId> spaceNamed(std::string_view name);  // "eye", "light 0 -x"

// The picture of a state's 3D view at the state's place in the frame, equal to that of a view of this size in the window.
// pixelRatio: of the shot; 0: by its height. Errors: a space that the scene does not have; "stopped".
pipeline::Result<SpacePicture> spacePicture(const lessons::WindowState& state, const lessons::SpaceShown& shown,
                                            const std::shared_ptr<const pipeline::Scene>& scene, glm::ivec2 size,
                                            double pixelRatio = 0, const std::stop_token& stop = {});
// How such a view frames what it shows where nobody has moved its camera. size: logical pixels.
OrbitCamera firstCamera(const ViewContent& content, const ViewOptions& options, bool isPoint, glm::dvec2 size,
                        bool orthographic);
ViewShot shotOf(glm::ivec2 size, bool isPoint, bool isWorld, bool transparent);

}  // namespace app
