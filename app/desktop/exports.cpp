#include "app/desktop/exports.h"

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/commands/actions.h"
#include "app/desktop/shown_state.h"
#include "app/document/document.h"
#include "app/export/export_dialog.h"
#include "app/export/figure_dialog.h"
#include "app/export/film_dialog.h"
#include "app/export/slide_dialog.h"
#include "app/look/text.h"
#include "app/views/view_area.h"
#include "app/vtk/offscreen.h"
#include "lessons/state/cue_list.h"

namespace app {

Exports::Exports(QWidget& window, Actions& actions, Document& document, ViewArea& views, const ShownState& shown)
    : QObject(&window), m_window(window), m_document(document), m_views(views), m_shown(shown) {
    using A = ActionId;
    const auto whyNot = [this] { return whyNoValues(m_document); };
    actions.add({.id = A::Export,
                 .menu = "File",
                 .text = "Export buffers…",
                 .keys = "Ctrl+E",
                 .tip = "Write the buffers of this frame to a folder.",
                 .run = [this] { exportBuffers(); },
                 .whyNot = whyNot,
                 .startsGroup = true});
    actions.add({.id = A::SaveBuffer,
                 .menu = "File",
                 .text = "Save this buffer…",
                 .keys = "",
                 .tip = "Write the buffer of the active view to a folder.",
                 .run = [this] { exportActive(); },
                 .whyNot = whyNot});
    actions.add({.id = A::Figure,
                 .menu = "File",
                 .text = "Figure of this buffer…",
                 .keys = "",
                 .tip = "Write the buffer of the active view as a figure for a text: SVG, PDF or PNG, its size in mm.",
                 .run = [this] { exportFigure(); },
                 .whyNot = whyNot});
    actions.add({.id = A::Slide,
                 .menu = "File",
                 .text = "Picture for a slide…",
                 .keys = "Ctrl+F12; F12",
                 .tip = "Save a view in any size, on a transparent ground; the file opens the scene again.",
                 .run = [this] { exportSlide(); },
                 .whyNot = whyNot});
    actions.add({.id = A::Film,
                 .menu = "File",
                 .text = "Step film…",
                 .keys = "",
                 .tip = "Write a buffer's build-up, step by step, as a GIF or as PNG files.",
                 .run = [this] { exportFilm(); },
                 .whyNot = whyNot});
    connect(&views, &ViewArea::saveAsked, this,
            [this](SavedAs as) { as == SavedAs::Figure ? exportFigure() : exportActive(); });
}

QString whyNoValues(const Document& document) {
    if (document.hidden().count() != 0) return Document::tr("After your answer.");
    return document.frames().shown() ? QString() : Document::tr("The first frame is not ready yet.");
}

ExportDialog* Exports::makeDialog() {
    auto* dialog = new ExportDialog(m_document, &m_window);
    if (auto now = m_shown.now()) {
        std::vector<pipeline::BufferName> shown;
        for (const auto& view : now->views)
            if (const auto name = pipeline::findAnyBuffer(view.buffer)) shown.push_back(*name);
        dialog->setShown(std::move(shown));
        now->scene.clear(), now->set.clear(), now->sceneText.clear();  // it stands beside it
        dialog->setState(toToml(*now));
    }
    QStringList files;
    for (const std::string& file : viewFiles()) files += toQString(file);
    dialog->setViews(writeViews, files);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    return dialog;
}

void Exports::exportBuffers() { makeDialog()->open(); }

void Exports::exportActive() {
    ExportDialog* const dialog = makeDialog();
    dialog->choose(m_views.activeBuffer().buffer());
    dialog->open();
}

// What the active view shows: its part, unless that is all, and its own range.
void Exports::exportFigure() {
    const BufferView& view = m_views.activeBuffer();
    FigureOrder order{.buffer = view.buffer()};
    const QRect seen = view.canvas()->placing().visiblePart(), all(QPoint(0, 0), view.canvas()->content().size);
    if (!seen.isEmpty() && seen != all)
        order.part = pipeline::Figure::Part{{seen.left(), seen.top()}, {seen.right(), seen.bottom()}};
    if (const auto range = view.state().range) order.range = pipeline::PaletteRange{(*range)[0], (*range)[1]};
    auto* dialog = new FigureDialog(m_document, order, &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void Exports::exportSlide() {
    const auto now = m_shown.now();
    if (!now) return;
    auto* dialog = new SlideDialog(m_document, m_views, *now, &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void Exports::exportFilm() {
    auto* dialog = new FilmDialog(m_document, m_views.first().buffer(), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

}  // namespace app
