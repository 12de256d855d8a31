#pragma once
#include <QWidget>
#include <memory>

#include "app/document/document.h"
#include "app/jobs/background_job.h"
#include "app/view3d/scene_view.h"
#include "lessons/state/window_state.h"

class QMenu;

namespace app {

class PictureTurns;
class View3dHandles;
class View3dHeader;
class View3dSpaces;

// The 3D view of the document's frame: the scene in any of its spaces with normals, the vectors at the
// picked point, lights, eye and frustum. A click picks the pixel that shows the point under it.
class View3dPanel : public QWidget {
    Q_OBJECT
public:
    explicit View3dPanel(Document& document, QWidget* parent = nullptr);
    ~View3dPanel() override;

    SceneView& view() { return *m_view; }
    void setBare(bool bare);  // without the header
    QMenu* menu() const;      // of its last button; the window adds what it can do with the view
    void changeOptions(const ViewOptions& options);
    // Shows another space: a light's once the frame with its shadow buffer is there, any once a large mesh is transformed.
    void setSpace(SpaceId space);

    // Saves camera, space and options; restores them, for a new scene after its first frame. Errors: names that the view
    // does not have; these are left out.
    lessons::SpaceShown state() const;
    pipeline::Errors lookAt(const lessons::SpaceShown& state);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    bool wantsFrusta() const;
    void wantBuffers();
    void takeSpace();
    void observeWork();
    void showWanted();
    void takeCamera(const std::optional<lessons::SpaceShown::Camera>& camera);
    bool misses();
    void takeFrame();
    // What content is made of.
    struct Made {
        pipeline::FramePtr frame;
        std::optional<glm::ivec2> pixel;
        std::optional<lessons::Selection> selection;
    };
    // In the world, and in the space that was on show when it was begun; that one null in the world.
    struct Built {
        std::shared_ptr<const ViewContent> content, moved;
    };
    void showContent(const Built& built, const Made& made);
    void takePixel();
    void takeSelection();
    void takeHover();
    void pick(const Hit& hit);
    void hover(const std::optional<Hit>& hit);

    Document& m_document;
    SceneView* m_view;
    View3dHeader* m_header;
    std::unique_ptr<View3dSpaces> m_spaces;
    std::unique_ptr<View3dHandles> m_handles;
    struct Wanted {
        SpaceId space;
        std::optional<lessons::SpaceShown::Camera> camera;
        lessons::SpaceShown asked;
    };
    ViewOptions m_firstOptions;      // with which the scene on show begins
    std::optional<Wanted> m_wanted;  // once the scene's first frame is there
    Made m_made;                     // of the content on show; of no frame before the first of a scene
    PictureTurns* m_turns;
    BackgroundJob m_building;  // of the content, where there is much
    bool m_missed = false;     // a frame, or what is picked in it, while it was put away
};

}  // namespace app
