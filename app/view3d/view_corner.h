#pragma once
#include <QWidget>

#include "app/view3d/overlay.h"

namespace app {

// The two panels that lie on a 3D view: the legend of the vectors and the cube of directions.
class ViewCorner : public QWidget {
    Q_OBJECT
public:
    enum class Kind { Legend, Cube };
    ViewCorner(Kind kind, QWidget* parent);

    void setOptions(const ViewOptions& options);
    void setCamera(const OrbitCamera& camera);
    QSize sizeHint() const override;

signals:
    void vectorClicked(pipeline::VectorCode code);
    void faceClicked(app::CubeFace face);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;  // tooltips by what is under the cursor

private:
    VectorCode vectorAt(QPointF position) const;

    Kind m_kind;
    ViewOptions m_options;
    OrbitCamera m_camera;
};

}  // namespace app
