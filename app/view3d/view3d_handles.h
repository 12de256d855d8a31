#pragma once
#include <QObject>

#include "app/document/document.h"
#include "app/view3d/scene_view.h"

namespace app {

// What a drag of a 3D view's handle does to the scene. A drag is one step of undo.
class View3dHandles : public QObject {
    Q_OBJECT
public:
    View3dHandles(Document& document, SceneView& view);

    void show();    // of the frame on show, so that handles stand where the picture has them
    void forget();  // the drag: its scene is gone

private:
    void drag(const Handle& handle, Vec3d value, bool done);
    void cancel(const Handle& handle);
    void drop();
    void showNumbers(const Handle* handle);

    Document& m_document;
    SceneView& m_view;
    ScenePtr m_before;     // the scene before the drag; null while nothing is dragged
    bool m_drags = false;  // the scene changes by a drag, just now
};

}  // namespace app
