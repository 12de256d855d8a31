#pragma once
#include <QObject>
#include <QVariantAnimation>
#include <functional>
#include <map>

#include "app/drawing3d/view_options.h"
#include "app/drawing3d/view_space.h"
#include "app/drawing3d/world_drawing.h"

class QWidget;

namespace app {

class SceneView;

// A desktop that asks for less motion gives its style no time for it.
bool wantsMotion(const QWidget& widget);

// The camera of a 3D view. Each space keeps the one that the user has moved. An untouched camera follows the view's size.
class ViewCamera : public QObject {
    Q_OBJECT
public:
    explicit ViewCamera(SceneView& view);
    ~ViewCamera() override;

    const OrbitCamera& now() const { return m_camera; }
    bool isTouched() const { return m_touched; }  // the user has moved it
    bool isFlying() const { return m_flight.state() == QVariantAnimation::Running; }
    void set(const OrbitCamera& camera);
    void change(const std::function<void(OrbitCamera& camera)>& how);  // by the user
    void touch();                                                      // as if it was changed
    void setOrthographic(bool orthographic);

    void go(ViewPreset preset);     // in 250 ms, or at once without motion
    void goAlong(Vec3d direction);  // likewise; everything is in the view
    void zoomOut();                 // from the scene's own eye out of it, until its frustum is seen whole
    void frameAnew();               // as if untouched
    void frameIfUntouched();

    // For the space on show: without a frame of its own, the picture is refreshed later.
    void place(const OrbitCamera& camera) { m_camera = camera; }
    void changeSpace(SpaceId from, SpaceId to);
    void forget();  // what the user has moved, in every space

signals:
    void orthographicChanged(bool orthographic);

private:
    OrbitCamera of(ViewPreset preset) const;
    void flyTo(const OrbitCamera& camera, int milliseconds);

    SceneView& m_view;
    OrbitCamera m_camera;
    bool m_touched = false;
    std::map<SpaceId, OrbitCamera> m_cameras;  // that the user has moved, of the spaces not on show
    QVariantAnimation m_flight;
    OrbitCamera m_from, m_to;
};

}  // namespace app
