#include "app/desktop/state_clipboard.h"

#include <QApplication>
#include <QClipboard>
#include <QMimeData>

#include "app/buffer_view/buffer_view.h"
#include "app/commands/actions.h"
#include "app/desktop/scene_files.h"
#include "app/desktop/shown_state.h"
#include "app/document/document_state.h"
#include "app/look/text.h"
#include "app/widgets/error_list.h"
#include "lessons/state/cue_list.h"
#include "pipeline/formats/toml/toml_writer.h"

namespace app {

StateClipboard::StateClipboard(QWidget& pages, Actions& actions, Document& document, ShownState& shown,
                               SceneFiles& files, ErrorList& errors)
    : QObject(&pages), m_document(document), m_shown(shown), m_files(files), m_errors(errors) {
    actions.add({.id = ActionId::CopyState,
                 .menu = "Edit",
                 .text = "Copy view and state",
                 .keys = "Ctrl+C",
                 .tip =
                     "Copy scene, stage, step, pixel and how every view looks, as text that a window shows again; in a "
                     "buffer view its picture too.",
                 .run = [this] { copy(); },
                 .startsGroup = true,
                 .within = &pages});
    actions.add({.id = ActionId::PasteState,
                 .menu = "Edit",
                 .text = "Paste view and state",
                 .keys = "Ctrl+V",
                 .tip = "Show what a window has copied as text.",
                 .run = [this] { paste(); },
                 .needsScene = false,
                 .within = &pages});
}

namespace {

// Of the buffer view that has the keys; null for any other part.
QImage pictureInFocus() {
    for (QWidget* part = QApplication::focusWidget(); part; part = part->parentWidget())
        if (const auto* view = qobject_cast<BufferView*>(part))
            return view->shown() ? view->shown()->content.image : QImage();
    return {};
}

}  // namespace

// A scene that is no part of the program goes along, for a machine that does not have its file.
void StateClipboard::copy() {
    auto now = m_shown.now();
    if (!now) {
        emit m_document.said(tr("The scene is too large to be copied as text."));
        return;
    }
    if (std::filesystem::path(now->scene).is_absolute())
        if (const auto text = toTomlScene(m_document.scene())) now->sceneText = *text, now->set.clear();
    auto* copied = new QMimeData;
    copied->setText(toQString(toToml(*now)));
    const QImage picture = pictureInFocus();
    if (!picture.isNull()) copied->setImageData(picture);
    QApplication::clipboard()->setMimeData(copied);
    emit m_document.said(
        picture.isNull()
            ? tr("Copied what you see as text. Ctrl+V in a view shows it again, in any window.")
            : tr("Copied the picture, and what you see as text. Ctrl+V in a view shows it again, in any window."));
}

// Without a scene it is a place in the scene on show.
void StateClipboard::paste() {
    const std::string text = QApplication::clipboard()->text().trimmed().toStdString();
    const auto read = text.empty() ? pipeline::Result<lessons::WindowState>(pipeline::Error{
                                         {"clipboard", 1, 1}, "no text", "what Ctrl+C in a view has copied"})
                                   : lessons::readState(text, "clipboard");
    if (!read) return m_errors.report(tr("This is no state of a window. Nothing has changed."), read.errors());
    m_errors.hide();
    const auto tell = [this, place = placeText(*read)] {
        emit m_document.said(tr("Shows what was copied: %1.").arg(place));
    };
    if (read->scene.empty() && read->sceneText.empty() && m_shown.hasScene()) {
        m_document.replace(m_document.scene(), tr("paste"), m_shown.looksTo(*read));
        m_shown.showPlace(*read);
        return tell();
    }
    if (!isOpen(m_document, *read, {}) && !m_files.mayLeave()) return;
    m_files.showState(*read, {}, SceneChanges::Pasted, tell);
}

}  // namespace app
