#pragma once
#include <QElapsedTimer>
#include <QTimer>

#include "app/document/document.h"
#include "app/view3d/scene_view.h"

namespace app {

// Decides when a 3D view shows the next frame. Buffers go first while the scene moves: after each picture the view
// pauses for as long as the picture took. Of the frames that come during a pause it shows the last.
class PictureTurns : public QObject {
    Q_OBJECT
public:
    // panel: the object that asks the document for buffers.
    PictureTurns(Document& document, SceneView& view, QObject* panel);

    bool skips();  // true: the new frame waits; due() says when to show it

signals:
    void due();

private:
    Document& m_document;
    bool m_renders = false, m_skipped = false;
    QElapsedTimer m_begun;  // of the newest picture
    QTimer m_pause;
};

}  // namespace app
