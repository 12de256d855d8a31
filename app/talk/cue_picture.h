#pragma once
#include "lessons/pages/talk_page.h"

namespace app {

// A view of a cue as the window's view draws it, in the theme in force, without a window: lessons::DrawView.
// Makes a QGuiApplication where there is none.
pipeline::Result<lessons::TalkPicture> drawCueView(const lessons::WindowState& state,
                                                   const std::shared_ptr<const pipeline::Scene>& scene,
                                                   lessons::ViewLeaf view, const lessons::TalkRoom& room,
                                                   const pipeline::Stop& stop);

}  // namespace app
