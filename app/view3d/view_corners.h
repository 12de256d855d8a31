#pragma once
#include <QObject>
#include <QRectF>
#include <vector>

#include "app/drawing3d/orbit_camera.h"
#include "app/drawing3d/view_content.h"

namespace app {

class SceneView;
class ViewCorner;

// The panels that lie on a 3D view: the legend of the vectors and the cube of directions.
class ViewCorners : public QObject {
    Q_OBJECT
public:
    explicit ViewCorners(SceneView& view);

    void setBare(bool bare) { m_isBare = bare; }  // for an audience: a legend of the vectors that are drawn alone
    void place();                                 // after a change of the view's size or the theme
    void show(bool works);                        // works: there is a picture below them
    double takenFoot() const;                     // of the view's height, by the legend
    std::vector<QRectF> places() const;           // on the view

private:
    bool showsLegend() const;
    std::vector<VectorCode> drawn() const;  // the vectors that the view has arrows of

    SceneView& m_view;
    bool m_isBare = false;
    ViewCorner* m_legend;
    ViewCorner* m_cube;
};

}  // namespace app
