// The handles of a View3dPanel: what there is to drag, and what a drag does to the scene.
#include <QScopedValueRollback>

#include "app/core/text.h"
#include "app/view3d/view3d_panel.h"

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
        case HandleTool::Turn: return View3dPanel::tr("turn %1").arg(name);
        case HandleTool::Scale: return View3dPanel::tr("scale %1").arg(name);
        case HandleTool::Move: break;
    }
    return View3dPanel::tr("move %1").arg(name);
}

QString nextTool(HandleTool tool) {
    switch (tool) {
        case HandleTool::Move: return View3dPanel::tr("M: turn it");
        case HandleTool::Turn: return View3dPanel::tr("M: scale it");
        case HandleTool::Scale: break;
    }
    return View3dPanel::tr("M: move it");
}

}  // namespace

// Of the frame on show, so that handles stand where the picture has them.
void View3dPanel::showHandles() {
    const auto& frame = m_document.frames().shown();
    if (!frame || !m_view->space().shown() || m_view->space().id().space == ViewSpace::Point)
        return m_view->handles().set({});
    m_view->handles().set(
        handlesOf(frame->scene(), *m_view->space().shown(), ownerOf(m_document), m_view->options().objectTool));
}

void View3dPanel::drag(const Handle& handle, Vec3d value, bool done) {
    if (!m_beforeDrag && !isIn(m_document.scene(), handle)) return m_view->input().cancelDrag();
    if (!m_beforeDrag) m_beforeDrag = std::make_shared<const pipeline::Scene>(m_document.scene());
    const QScopedValueRollback own(m_drags, true);
    m_document.edit(withHandleAt(*m_beforeDrag, handle, value), nameOf(handle),
                    done ? Document::Change::Done : Document::Change::Live);
    showNumbers(&handle);
    if (done) m_beforeDrag.reset();
}

// The scene has changed under a drag: what it began with is gone.
void View3dPanel::dropDrag() {
    if (m_drags || !m_beforeDrag) return;
    m_beforeDrag.reset();
    m_view->input().cancelDrag();
}

void View3dPanel::cancelDrag(const Handle& handle) {
    if (!m_beforeDrag) return;
    const QScopedValueRollback own(m_drags, true);
    m_document.edit(*m_beforeDrag, nameOf(handle), Document::Change::Done);
    m_beforeDrag.reset();
}

void View3dPanel::showNumbers(const Handle* handle) {
    if (!handle || !isIn(m_document.scene(), *handle)) return m_view->handles().setNumbers({});
    QString text = toQString(handle->name + ": " + numbersOf(m_document.scene(), *handle));
    const bool canChange =
        handle->kind == Handle::Kind::Object && !handle->arms.empty() && !m_view->handles().isDragging();
    if (canChange) text += '\n' + nextTool(handle->tool);
    m_view->handles().setNumbers(text);
}

}  // namespace app
