#include "app/vtk/mark_layers.h"

#include <qopengl.h>
#include <vtkActor.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "app/drawing3d/space_drawing.h"
#include "app/vtk/vtk_data.h"

namespace app {

namespace {

constexpr double kOuter = 4, kInner = 2;  // pixels of the design, as in the buffer views
constexpr double kHiddenStrength = 0.35;
constexpr double kOuterPull = 4, kInnerPull = 6;

// Draws what lies behind something that is drawn already, and hides nothing itself.
class HiddenMapper : public vtkOpenGLPolyDataMapper {
public:
    static HiddenMapper* New() { VTK_STANDARD_NEW_BODY(HiddenMapper); }

    void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override {
        vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
        const vtkOpenGLState::ScopedglDepthFunc func(state);
        const vtkOpenGLState::ScopedglDepthMask mask(state);
        state->vtkglDepthFunc(GL_GREATER);
        state->vtkglDepthMask(GL_FALSE);
        vtkOpenGLPolyDataMapper::RenderPiece(renderer, actor);
    }
};

// Blended with what hides it, which has been drawn before.
WorldLayer addHiddenLayer(vtkRenderer& world) {
    WorldLayer layer = addLayer(world);
    layer.mapper = vtkSmartPointer<HiddenMapper>::New();
    layer.actor->SetMapper(layer.mapper);
    layer.actor->ForceOpaqueOn();
    layer.actor->GetProperty()->SetOpacity(kHiddenStrength);
    return layer;
}

}  // namespace

MarkLayers::MarkLayers(vtkRenderer& world)
    : m_hiddenOuter(addHiddenLayer(world)),
      m_hiddenInner(addHiddenLayer(world)),
      m_outer(addLayer(world)),
      m_inner(addLayer(world)) {
    for (WorldLayer* layer : {&m_hiddenOuter, &m_outer}) {
        pullLines(*layer, kOuterPull);
        setColor(*layer->actor, Qt::black);
    }
    for (WorldLayer* layer : {&m_hiddenInner, &m_inner}) {
        pullLines(*layer, kInnerPull);
        setColor(*layer->actor, Qt::white);
    }
}

void MarkLayers::setContent(const ViewContent* content) {
    const auto data = segmentsData(content ? markedOutline(*content) : std::vector<Segment>());
    for (const WorldLayer* layer : {&m_hiddenOuter, &m_hiddenInner, &m_outer, &m_inner})
        layer->mapper->SetInputData(data);
}

void MarkLayers::setScale(double devicePixels) {
    for (WorldLayer* layer : {&m_hiddenOuter, &m_outer}) setWidth(*layer, kOuter * devicePixels);
    for (WorldLayer* layer : {&m_hiddenInner, &m_inner}) setWidth(*layer, kInner * devicePixels);
}

}  // namespace app
