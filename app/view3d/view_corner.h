#pragma once
#include <QWidget>

#include "app/drawing3d/overlay.h"

namespace app {

// The two panels that lie on a 3D view: the legend of the vectors and the cube of directions.
class ViewCorner : public QWidget {
    Q_OBJECT
public:
    enum class Kind { Legend, Cube };
    ViewCorner(Kind kind, QWidget* parent);

    void setOptions(const ViewOptions& options);
    void setCamera(const OrbitCamera& camera, ViewSpace space);
    void setOnly(std::optional<std::vector<VectorCode>> codes);  // a legend of these alone, which does not hide them
    void setRoom(int width) { m_room = width; }                  // of the view: a legend that is wider has two rows
    QSize sizeHint() const override;

signals:
    void vectorClicked(pipeline::VectorCode code);
    void vectorHovered(pipeline::VectorCode code);  // None: the cursor left it
    void faceClicked(app::CubeFace face);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    bool event(QEvent* event) override;  // tooltips by what is under the cursor

private:
    VectorCode vectorAt(QPointF position) const;
    void setHovered(VectorCode code);

    Kind m_kind;
    ViewOptions m_options;
    std::optional<std::vector<VectorCode>> m_only;
    int m_room = 1 << 20;
    VectorCode m_hovered = VectorCode::None;
    OrbitCamera m_camera;
    ViewSpace m_space = ViewSpace::World;
};

}  // namespace app
