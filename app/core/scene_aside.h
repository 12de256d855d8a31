#pragma once
#include "app/core/document.h"

namespace app {

// A document's scene with its file and its undo steps, put aside while another scene is shown.
class SceneAside {
public:
    explicit SceneAside(const Document& document);  // it must have a scene
    void putBack(Document& document) const;

private:
    std::shared_ptr<const pipeline::Scene> m_scene;
    KeptScene m_kept;
    Document::Steps m_steps;
};

}  // namespace app
