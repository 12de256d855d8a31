#pragma once
#include <vector>

#include "app/drawing3d/drawing.h"
#include "app/drawing3d/view_content.h"
#include "app/drawing3d/view_options.h"
#include "app/vtk/world_layer.h"

class vtkTexture;

namespace app {

// The picture of the scene's eye and those of the lights' shadow buffers, where they stand in a WorldScene.
class PicturePlanes {
public:
    explicit PicturePlanes(vtkRenderer& world);

    void forgetPicture() { m_isPictureOld = true; }                            // the mesh is another one
    void placeFrusta(const ViewContent* content, const ViewOptions& options);  // null: none
    void showPicture(const ViewContent* content, const ViewOptions& options, const ViewFrame& view);

private:
    struct Plane {
        WorldLayer layer;
        vtkSmartPointer<vtkTexture> texture;
    };
    static Plane addPlane(vtkRenderer& world);

    vtkRenderer& m_world;
    Plane m_picture;
    std::vector<Plane> m_frusta;  // as many as were ever needed
    bool m_isPictureOld = true;   // it is made when it is shown
};

}  // namespace app
