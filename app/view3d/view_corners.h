#pragma once
#include <QObject>
#include <QRectF>
#include <vector>

#include "app/view3d/orbit_camera.h"

namespace app {

class SceneView;
class ViewCorner;

// The panels that lie on a 3D view: the legend of the vectors and the cube of directions.
class ViewCorners : public QObject {
    Q_OBJECT
public:
    explicit ViewCorners(SceneView& view);

    void place();                        // after a change of the view's size or the theme
    void show(bool works);               // works: there is a picture below them
    double takenFoot() const;            // of the view's height, by the legend
    std::vector<QRectF> places() const;  // on the view

private:
    bool showsLegend() const;

    SceneView& m_view;
    ViewCorner* m_legend;
    ViewCorner* m_cube;
};

}  // namespace app
