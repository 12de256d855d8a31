#pragma once
#include <QLabel>
#include <QVariantAnimation>
#include <QWidget>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/core/working_bar.h"
#include "app/view3d/handle_drag.h"
#include "app/view3d/offscreen.h"
#include "app/view3d/space_content.h"
#include "app/view3d/vtk_widget.h"
#include "app/view3d/world_drawing.h"

namespace app {

class ViewCorner;

// A 3D view with its camera: what VTK renders, letters and legend over it, mouse and keys.
// Left drag orbits, middle or Shift+left drag pans, the wheel zooms to the cursor; a click gives
// the ray under it. Keys: 1 front, 3 side, 7 top, 9 iso, 0 from the eye, Z out of it, 5 orthographic,
// R the first view again, A everything; arrows orbit, + and − zoom; S the next space, F the next face of
// a point light; M what an object's
// handle does: move, turn, scale. While a handle is dragged x, y and z hold it to an arm, Shift drags
// finely, Ctrl in coarse steps, and Esc puts it back.
class SceneView : public QWidget {
    Q_OBJECT
public:
    explicit SceneView(QWidget* parent = nullptr);
    ~SceneView() override;

    // Null shows the sentence of setEmptyText on a bare background. The camera stays, unless `newScene`. `moved`: the same
    // by inSpace, in the space on show, for content that takes its time; in any other it is made here.
    void setContent(std::shared_ptr<const ViewContent> content, bool newScene,
                    std::shared_ptr<const ViewContent> moved = nullptr);
    void setEmptyText(const QString& sentence);
    void setBuilding(bool building);  // newer content is on its way
    // It was, and has been given up; what is being drawn is, and is drawn after all.
    void setStopped(bool stopped);
    void cancelDrawing() { m_vtk ? m_vtk->cancel() : void(); }
    void resumeDrawing() { m_vtk ? m_vtk->resume() : void(); }
    const std::shared_ptr<const ViewContent>& content() const { return m_content; }
    // As the space on show has it; null where no point is picked, or a light has no shadow buffer.
    const std::shared_ptr<const ViewContent>& shown() const;
    // Each space keeps its own camera. The polygons move there in 400 ms, or at once where motion is
    // not wanted, or to and from the hemisphere at the point. `moved`: as of setContent, of the space that it goes to.
    void setSpace(SpaceId space, std::shared_ptr<const ViewContent> moved = nullptr);
    SpaceId space() const { return m_space; }
    bool isMoving() const { return m_morph.has_value(); }  // from one space to another
    void setOptions(const ViewOptions& options);
    const ViewOptions& options() const { return m_options; }

    // These vectors strong and the other ones faint, for as long as another view points at them, shown even where they
    // are hidden; none: all as they are.
    void pointAt(const std::vector<VectorCode>& codes);
    // A point of the world that another view's cursor is on, marked lightly.
    void setProbe(std::optional<Vec3d> point);

    // What can be dragged, of what is shown. One that is being dragged stays as it was when it was taken hold of.
    void setHandles(std::vector<Handle> handles);
    const std::vector<Handle>& handles() const { return m_handles; }
    bool isDragging() const { return m_drag == Drag::Handle; }
    void cancelDrag();  // whatever the mouse holds; a handle goes back
    // Stands beside the cursor while a handle is dragged or the cursor is on one.
    void setNumbers(const QString& text);
    const QString& numbers() const { return m_numbers; }

    const OrbitCamera& camera() const { return m_camera; }
    void setCamera(const OrbitCamera& camera);
    bool isTouched() const { return m_touched; }  // the user has moved the camera; else it follows the view's size
    // What the view shows, for a picture of another size. Errors: nothing to show.
    pipeline::Result<SpacePicture> picture(QSize size, bool transparent) const;
    void frameAnew();            // as if not
    void go(ViewPreset preset);  // in 250 ms, or at once where motion is not wanted
    // From the scene's own eye out of it, until its frustum is seen whole.
    void zoomOut();
    void setOrthographic(bool orthographic);
    ViewFrame viewFrame() const;
    const Drawing& drawing() const { return m_drawing; }
    // Whether the picture on show is of all that was set; it is made beside the window. Each new one is told with drawn().
    bool isDrawn() const { return !m_vtk || m_vtk->isDrawn(); }
    // Why nothing is rendered here; empty where it works.
    QString problem() const { return m_problem; }

signals:
    void drawn();
    void renderingChanged(bool renders);
    void workingChanged(bool working);  // a newer picture is on its way
    void optionsChanged();              // by the legend
    void orthographicChanged(bool orthographic);
    void clicked(const app::Hit& hit);  // on a polygon; in world space, whatever space is on show
    void hovered(const std::optional<app::Hit>& hit);
    void spaceAsked(int step);  // 1 the next one, −1 the one before
    void faceAsked(int step);   // likewise, of a point light
    void left();
    // A handle, as it was when it was taken hold of, is to have this value; `done` with the button's release.
    void dragged(const app::Handle& handle, app::Vec3d value, bool done);
    void dragCancelled(const app::Handle& handle);
    void handleHovered(const app::Handle* handle);  // null: none any more

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    class Overlay;
    enum class Drag { None, Click, Orbit, Pan, Pick, Handle };

    void refresh();  // after a change of camera, content, options or theme
    void applyTheme();
    void placeCorners();
    void showDetail();
    void tellWorking();
    bool showsLegend() const;
    double takenFoot() const;  // of the height, by the legend
    void frameIfUntouched();
    void showContent();
    bool isWorld() const { return m_space.space == ViewSpace::World; }
    bool isInMotion() const { return m_drag != Drag::None || m_flight.state() == QVariantAnimation::Running; }
    bool isPoint() const { return m_space.space == ViewSpace::Point; }
    void moveTo(const SpaceMap& from, const OrbitCamera& camera);
    void endMove();
    QString sentence() const;
    OrbitCamera cameraOf(ViewPreset preset) const;
    void flyTo(const OrbitCamera& camera, int milliseconds);
    bool keyAction(int key);
    std::optional<Hit> hitAt(QPointF position) const;
    bool beginDrag(QPointF position);
    void dragTo(QPointF position, Qt::KeyboardModifiers modifiers);
    void endDrag();
    bool dragKey(int key, Qt::KeyboardModifiers modifiers);
    HandleView handlesOnScreen() const;  // only when something is shown
    void findHandle(QPointF position);
    bool showsHandles() const { return m_options.handles && !isPoint() && shown() && !isMoving(); }
    void paintHandles(QPainter& painter) const;
    std::vector<QRectF> takenPlaces() const;  // by what lies over the view
    void updateOverlay();
    void updateWithPicture();

    SpaceId m_space;
    std::shared_ptr<const ViewContent> m_content;  // of the world
    std::shared_ptr<const ViewContent> m_moved;    // of the space on show, where that is not the world
    QString m_emptyText;
    std::optional<Vec3d> m_probe;
    std::vector<VectorCode> m_pointedAt;  // under the cursor in the legend or the equation
    ViewOptions m_options;
    OrbitCamera m_camera;
    // The user has moved the camera; until then each new size is framed anew.
    bool m_touched = false;
    std::map<SpaceId, OrbitCamera> m_cameras;  // that the user has moved, of the spaces not on show
    Drawing m_drawing;
    QString m_problem;

    VtkWidget* m_vtk = nullptr;  // null where there is no OpenGL
    QWidget* m_overlay;
    ViewCorner* m_legend;
    ViewCorner* m_cube;
    QLabel* m_coarse;
    QLabel* m_sentence;
    WorkingBar* m_working;
    bool m_rendering = false, m_building = false, m_stopped = false;
    std::optional<SpaceMorph> m_morph;
    QVariantAnimation m_move;  // along m_morph
    QVariantAnimation m_flight;
    OrbitCamera m_from, m_to;

    Drag m_drag = Drag::None;
    Qt::MouseButton m_button = Qt::NoButton;  // that began it
    QPointF m_pressedAt, m_last;

    std::vector<Handle> m_handles;
    std::optional<std::size_t> m_hot;  // the handle that the cursor is near
    Handle m_held;                     // as it was when it was taken hold of
    Vec3d m_heldAt{0.0};               // its value now
    HandleView m_heldView;             // then: a space may change with what is dragged in it
    std::optional<std::size_t> m_arm;  // that the cursor is on or holds
    QString m_numbers;
};

}  // namespace app
