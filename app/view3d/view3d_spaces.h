#pragma once
#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "app/document/document.h"
#include "app/jobs/background_job.h"
#include "app/view3d/scene_view.h"

namespace app {

// The spaces of a document's scene, one for each light.
std::vector<SpaceId> spacesOf(const Document& document);
QString whyNotLight(const Document& document, int light);  // why a light has no space; empty if it has
// Of the light whose space is on show; null in any other.
const LightFrustum* shownFrustum(const ShownSpace& space);

// Takes a 3D view to another space: a light's once the frame with its shadow buffer is there, any once a large mesh is
// transformed.
class View3dSpaces : public QObject {
    Q_OBJECT
public:
    View3dSpaces(Document& document, SceneView& view);

    void go(SpaceId space);
    void step(int by);                                                   // to the next space that can be shown
    void stepFace(int by);                                               // of a point light
    const std::optional<SpaceId>& awaited() const { return m_awaited; }  // to go to when all of it is there
    void goOn();                                                         // other content is on show
    bool isMoving() const { return m_moving.busy(); }
    void stopMoving() { m_moving.forget(); }
    void forget();

signals:
    void busyChanged();
    void chosen(app::SpaceId space);  // by a key
    void awaits();                    // a frame with other buffers
    void entered();

private:
    void moveTo(SpaceId space);
    void enter(SpaceId space, std::shared_ptr<const ViewContent> moved);
    void addFrusta();

    Document& m_document;
    SceneView& m_view;
    std::optional<SpaceId> m_awaited;
    BackgroundJob m_moving;  // of the content to the space to go to
};

}  // namespace app
