#include "app/view3d/view3d_handles.h"

#include <QScopedValueRollback>

#include "app/document/hand.h"
#include "app/look/text.h"

namespace app {

namespace {

// The object that is selected, or that the picked pixel shows.
std::optional<std::size_t> ownerOf(const Document& document) {
    const auto& selection = document.pointing().selection();
    const pipeline::Frame& frame = *document.frames().shown();
    if (selection && !isIn(frame.scene(), *selection)) return {};  // of a scene whose frame is on its way
    const auto ofPolygon = [&](std::size_t polygon) { return frame.placeOf(int(polygon)).object; };
    if (selection && selection->kind == lessons::Selection::Kind::Object) return selection->index;
    if (selection && selection->kind == lessons::Selection::Kind::Polygon) return ofPolygon(selection->index);
    if (selection || !document.pointing().pixel()) return {};
    const auto polygon = lessons::polygonAt(frame, *document.pointing().pixel());
    if (!polygon) return {};
    return ofPolygon(*polygon);
}

// The step of undo.
QString nameOf(const Handle& handle) {
    const QString name = toQString(handle.name);
    switch (handle.tool) {
        case HandleTool::Turn: return View3dHandles::tr("turn %1").arg(name);
        case HandleTool::Scale: return View3dHandles::tr("scale %1").arg(name);
        case HandleTool::Move: break;
    }
    return View3dHandles::tr("move %1").arg(name);
}

// How the keys of the settings begin that a drag of the handle changes.
std::string settingsOf(const Handle& handle) {
    switch (handle.kind) {
        case Handle::Kind::Light:
        case Handle::Kind::LightDirection:
        case Handle::Kind::LightFacing: return "light." + std::to_string(handle.index) + '.';
        case Handle::Kind::Eye:
        case Handle::Kind::Target: return "camera.";
        case Handle::Kind::Object: break;
    }
    return "object." + std::to_string(handle.index) + '.';
}

QString nextTool(HandleTool tool) {
    switch (tool) {
        case HandleTool::Move: return View3dHandles::tr("M: turn it");
        case HandleTool::Turn: return View3dHandles::tr("M: scale it");
        case HandleTool::Scale: break;
    }
    return View3dHandles::tr("M: move it");
}

}  // namespace

View3dHandles::View3dHandles(Document& document, SceneView& view) : m_document(document), m_view(view) {
    connect(&view.handles(), &ViewHandles::dragged, this, &View3dHandles::drag);
    connect(&view.handles(), &ViewHandles::cancelled, this, &View3dHandles::cancel);
    connect(&view.handles(), &ViewHandles::hovered, this, &View3dHandles::showNumbers);
    connect(&document, &Document::sceneChanged, this, &View3dHandles::drop);
    connect(&document.hand(), &Hand::taken, this, &View3dHandles::show);
}

void View3dHandles::forget() { m_before.reset(); }

void View3dHandles::show() {
    const auto& frame = m_document.frames().shown();
    if (!frame || !m_view.space().shown() || m_view.space().id().space == ViewSpace::Point)
        return m_view.handles().set({});
    auto handles = handlesOf(frame->scene(), *m_view.space().shown(), ownerOf(m_document), m_view.options().objectTool);
    std::erase_if(handles, [this](const Handle& handle) { return !m_document.hand().allows(settingsOf(handle)); });
    m_view.handles().set(std::move(handles));
}

void View3dHandles::drag(const Handle& handle, Vec3d value, bool done) {
    if (!m_before && !isIn(m_document.scene(), handle)) return m_view.input().cancelDrag();
    if (!m_before) m_before = std::make_shared<const pipeline::Scene>(m_document.scene());
    const QScopedValueRollback own(m_drags, true);
    m_document.edit(withHandleAt(*m_before, handle, value), nameOf(handle),
                    done ? Document::Change::Done : Document::Change::Live);
    showNumbers(&handle);
    if (done) m_before.reset();
}

// The scene has changed under a drag: what it began with is gone.
void View3dHandles::drop() {
    if (m_drags || !m_before) return;
    m_before.reset();
    m_view.input().cancelDrag();
}

void View3dHandles::cancel(const Handle& handle) {
    if (!m_before) return;
    const QScopedValueRollback own(m_drags, true);
    m_document.edit(*m_before, nameOf(handle), Document::Change::Done);
    m_before.reset();
}

void View3dHandles::showNumbers(const Handle* handle) {
    if (!handle || !isIn(m_document.scene(), *handle)) return m_view.handles().setNumbers({});
    QString text = toQString(handle->name + ": " + numbersOf(m_document.scene(), *handle));
    const bool canChange =
        handle->kind == Handle::Kind::Object && !handle->arms.empty() && !m_view.handles().isDragging();
    if (canChange) text += '\n' + nextTool(handle->tool);
    m_view.handles().setNumbers(text);
}

}  // namespace app
