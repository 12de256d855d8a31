#pragma once
#include "app/core/document.h"

namespace app {

// A document's scene with its file and its steps of undo, put aside while another one is on show.
class SceneAside {
public:
    explicit SceneAside(const Document& document);  // which has a scene
    void putBack(Document& document) const;

private:
    std::shared_ptr<const pipeline::Scene> m_scene;
    KeptScene m_kept;
    Document::Steps m_steps;
};

}  // namespace app
