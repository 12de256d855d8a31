#include "app/vtk/picture_planes.h"

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <utility>

#include "app/drawing3d/space_drawing.h"
#include "app/drawing3d/world_drawing.h"
#include "app/vtk/vtk_data.h"

namespace app {

PicturePlanes::PicturePlanes(vtkRenderer& world) : m_world(world), m_picture(addPlane(world)) {}

PicturePlanes::Plane PicturePlanes::addPlane(vtkRenderer& world) {
    Plane plane{addLayer(world), vtkSmartPointer<vtkTexture>::New()};
    plane.texture->InterpolateOff();
    plane.layer.actor->SetTexture(plane.texture);
    plane.layer.actor->VisibilityOff();
    return plane;
}

void PicturePlanes::placeFrusta(const ViewContent* content, const ViewOptions& options) {
    std::size_t used = 0;
    if (content)
        for (const LightFrustum& frustum : content->frusta) {
            if (!isShown(frustum, *content, options)) continue;
            if (used == m_frusta.size()) m_frusta.push_back(addPlane(m_world));
            Plane& plane = m_frusta[used++];
            plane.layer.mapper->SetInputData(pictureQuad(pictureCorners(frustum.view, frustum.plane)));
            plane.texture->SetInputData(pictureImage(frustum.picture));
        }
    for (std::size_t i = 0; i < m_frusta.size(); ++i) m_frusta[i].layer.actor->SetVisibility(i < used);
}

void PicturePlanes::showPicture(const ViewContent* content, const ViewOptions& options, const ViewFrame& view) {
    const bool isShown =
        content && options.eye && !content->mesh->picture.pixels.empty() && showsWholeEye(*content, view);
    m_picture.layer.actor->SetVisibility(isShown);
    if (!isShown || !std::exchange(m_isPictureOld, false)) return;
    m_picture.layer.mapper->SetInputData(pictureQuad(pictureCorners(content->eye, content->pictureDistance)));
    m_picture.texture->SetInputData(pictureImage(content->mesh->picture));
}

}  // namespace app
