#pragma once
#include "app/document/document.h"

namespace app {

// A document's scene with its file and its undo steps, put aside while another scene is shown.
class StashedScene {
public:
    explicit StashedScene(const Document& document)  // it must have a scene
        : m_scene(document.sharedScene()), m_kept(document.kept()), m_steps(document.history().steps()) {}
    void putBack(Document& document) const {
        document.setScene(*m_scene, m_kept);
        document.history().restore(m_steps);
    }

private:
    ScenePtr m_scene;
    KeptScene m_kept;
    SceneHistory::Steps m_steps;
};

}  // namespace app
