#include "app/view3d/picture_turns.h"

namespace app {

PictureTurns::PictureTurns(Document& document, SceneView& view, QObject* panel) : QObject(panel), m_document(document) {
    m_pause.setSingleShot(true);
    connect(&m_pause, &QTimer::timeout, this, [this] {
        if (m_skipped) emit due();
    });
    connect(&view.progress(), &ViewProgress::renderingChanged, this, [this](bool renders) {
        m_renders = renders;
        if (renders)
            m_begun.start();
        else
            m_pause.start(int(m_begun.elapsed()));
        m_document.frames().hold(parent(), false);
    });
}

bool PictureTurns::skips() {
    m_skipped = m_document.frames().isMoving() && (m_renders || m_pause.isActive());
    m_document.frames().hold(parent(), m_skipped && m_renders);
    return m_skipped;
}

}  // namespace app
