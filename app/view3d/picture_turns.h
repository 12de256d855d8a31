#pragma once
#include <QElapsedTimer>
#include <QTimer>

#include "app/document/document.h"
#include "app/view3d/scene_view.h"

namespace app {

// When a 3D view shows the next frame. While the scene moves, the buffers go first: the view pauses as long as its
// picture took, which is nothing where the machine is fast. Of the frames that come meanwhile it shows the last.
class PictureTurns : public QObject {
    Q_OBJECT
public:
    // panel: what wants the buffers of the frames.
    PictureTurns(Document& document, SceneView& view, QObject* panel);

    bool skips();  // the frame that has come; due() follows

signals:
    void due();

private:
    Document& m_document;
    bool m_renders = false, m_skipped = false;
    QElapsedTimer m_begun;  // of the newest picture
    QTimer m_pause;
};

}  // namespace app
