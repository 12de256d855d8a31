#include "app/view3d/view_camera.h"

#include <QStyle>
#include <QWidget>

#include "app/drawing3d/point_drawing.h"
#include "app/view3d/scene_view.h"

namespace app {

namespace {

constexpr int kFlightMilliseconds = 250, kZoomOutMilliseconds = 1200;

}  // namespace

bool wantsMotion(const QWidget& widget) {
    return widget.style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, &widget) > 0;
}

ViewCamera::ViewCamera(SceneView& view) : m_view(view) {
    m_flight.setStartValue(0.0);
    m_flight.setEndValue(1.0);
    m_flight.setEasingCurve(QEasingCurve::OutCubic);
    connect(&m_flight, &QVariantAnimation::valueChanged, this, [this](const QVariant& t) {
        m_camera = between(m_from, m_to, t.toDouble());
        m_view.refresh();
    });
}

ViewCamera::~ViewCamera() { m_flight.disconnect(this); }

void ViewCamera::set(const OrbitCamera& camera) {
    m_view.space().endMove();
    const bool turned = camera.orthographic != m_camera.orthographic;
    change([&](OrbitCamera& now) { now = camera; });
    if (turned) emit orthographicChanged(camera.orthographic);
}

void ViewCamera::change(const std::function<void(OrbitCamera& camera)>& how) {
    touch();
    how(m_camera);
    m_view.refresh();
}

void ViewCamera::touch() {
    m_flight.stop();
    m_touched = true;
}

void ViewCamera::setOrthographic(bool orthographic) {
    if (orthographic == m_camera.orthographic) return;
    m_camera.orthographic = m_to.orthographic = orthographic;
    frameIfUntouched();
    m_view.refresh();
    emit orthographicChanged(orthographic);
}

OrbitCamera ViewCamera::of(ViewPreset preset) const {
    const ShownSpace& space = m_view.space();
    const auto camera = space.isPoint() ? pointCamera : presetCamera;
    return camera(preset, *space.shown(), m_view.options(), m_view.viewFrame().size, m_camera.orthographic,
                  m_view.corners().takenFoot());
}

void ViewCamera::go(ViewPreset preset) {
    if (!m_view.space().shown()) return;
    m_touched = preset != ViewPreset::Iso;
    flyTo(of(preset), kFlightMilliseconds);
}

void ViewCamera::goAlong(Vec3d direction) {
    OrbitCamera camera = of(ViewPreset::Front);
    lookAlong(camera, direction);
    frame(camera, sceneExtent(*m_view.space().shown(), m_view.options()), m_view.viewFrame().size, 0.11,
          m_view.corners().takenFoot());
    m_touched = true;
    flyTo(camera, kFlightMilliseconds);
}

void ViewCamera::zoomOut() {
    if (!m_view.space().isWorld() || !m_view.space().content()) return;
    ViewOptions options = m_view.options();
    options.eye = options.frustum = true;
    m_view.changeOptions(options);
    m_touched = true;
    const OrbitCamera outside = of(ViewPreset::Outside);
    m_camera = of(ViewPreset::Eye);
    flyTo(outside, kZoomOutMilliseconds);
}

void ViewCamera::flyTo(const OrbitCamera& camera, int milliseconds) {
    m_flight.stop();
    m_flight.setDuration(wantsMotion(m_view) ? milliseconds : 0);
    m_from = m_camera;
    m_to = camera;
    m_flight.start();
}

void ViewCamera::frameAnew() {
    m_flight.stop();
    m_view.space().endMove();
    m_touched = false;
    frameIfUntouched();
    m_view.refresh();
}

void ViewCamera::frameIfUntouched() {
    if (m_touched || !m_view.space().shown()) return;
    m_flight.stop();
    m_camera = of(ViewPreset::Iso);
}

void ViewCamera::changeSpace(SpaceId from, SpaceId to) {
    m_flight.stop();
    const bool orthographic = m_camera.orthographic;
    if (m_touched) m_cameras[from] = m_camera;
    const auto kept = m_cameras.find(to);
    m_touched = kept != m_cameras.end();
    m_camera = m_touched ? kept->second : OrbitCamera();
    m_camera.orthographic = orthographic;
}

void ViewCamera::forget() {
    m_touched = false;
    m_cameras.clear();
}

}  // namespace app
