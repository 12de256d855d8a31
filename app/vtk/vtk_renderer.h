#pragma once
#include <QImage>
#include <QSurfaceFormat>
#include <memory>
#include <stop_token>
#include <vector>

#include "app/drawing3d/drawing.h"
#include "app/drawing3d/view_content.h"
#include "app/drawing3d/view_options.h"

class QSurface;

namespace app {

// What VTK's renderer needs.
QSurfaceFormat viewSurfaceFormat();

// What a picture of a 3D view shows, as values: what has changed since the last one is found by comparing them.
struct ViewSnapshot {
    std::shared_ptr<const ViewContent> content;
    std::shared_ptr<const std::vector<InkedLine>> ground;
    ViewOptions options;
    std::shared_ptr<const ThemeColors> colors;
    ViewFrame view;
    std::shared_ptr<const Drawing> drawing;  // made for `view`: another view comes with another drawing
    QSize size;                              // device pixels
    double pixelRatio = 1;                   // of them a logical pixel
    bool moves = false;                      // the next picture follows soon
};

// VTK in an OpenGL context of its own beside the screen. It belongs to the thread that it is made in.
class VtkRenderer {
public:
    explicit VtkRenderer(QSurface& surface);  // which comes from the GUI thread, and outlives it
    ~VtkRenderer();
    VtkRenderer(const VtkRenderer&) = delete;
    VtkRenderer& operator=(const VtkRenderer&) = delete;

    bool works() const;  // false: OpenGL came up, but not in a version that VTK can use
    struct Result {
        QImage image;           // null where it was given up
        bool isWhole = false;   // its edges are smooth, and all faces are there
        bool isCoarse = false;  // few of its many faces are
    };
    // While pictures follow each other on a machine too slow for it, edges are not smoothed, and of a mesh of many faces
    // few are drawn.
    Result render(const ViewSnapshot& snapshot, const std::stop_token& stop);

private:
    void set(const ViewSnapshot& snapshot);
    struct Impl;  // keeps VTK out of this header
    std::unique_ptr<Impl> m_impl;
};

}  // namespace app
