#include "app/core/scene_aside.h"

namespace app {

SceneAside::SceneAside(const Document& document)
    : m_scene(document.sharedScene()), m_kept(document.kept()), m_steps(document.history().steps()) {}

void SceneAside::putBack(Document& document) const {
    document.setScene(*m_scene, m_kept);
    document.history().restore(m_steps);
}

}  // namespace app
