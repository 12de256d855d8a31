#pragma once
#include "app/core/document.h"

namespace app {

// A document's scene with its file and its undo steps, put aside while another scene is shown.
class SceneAside {
public:
    explicit SceneAside(const Document& document);  // it must have a scene
    void putBack(Document& document) const;

private:
    ScenePtr m_scene;
    KeptScene m_kept;
    SceneHistory::Steps m_steps;
};

}  // namespace app
