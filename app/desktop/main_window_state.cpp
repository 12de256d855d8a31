// What the MainWindow shows as a value, and what becomes of it when a scene is left: sessions, recent files, the
// question before changes are lost.
#include <QApplication>
#include <QClipboard>
#include <QFileInfo>
#include <QStackedWidget>

#include "app/core/document_state.h"
#include "app/core/recent_files.h"
#include "app/core/text.h"
#include "app/desktop/actions.h"
#include "app/desktop/keep_changes.h"
#include "app/desktop/main_window.h"
#include "app/desktop/session.h"
#include "app/desktop/slide_dialog.h"
#include "app/desktop/view_area.h"
#include "app/panels/buffer_view.h"
#include "app/panels/error_list.h"
#include "app/panels/film_dialog.h"
#include "app/state/state_scene.h"
#include "pipeline/formats/toml_writer.h"

namespace app {

bool MainWindow::showsScene() const { return m_width.has_value() && m_document.hasScene(); }

std::optional<WindowState> MainWindow::state(const std::filesystem::path& folder) const {
    if (!showsScene()) return {};
    auto state = stateOf(m_document, folder);
    if (!state) return {};  // a scene too large to be kept
    WindowState whole = std::move(state).value();
    m_views->fill(whole);
    nameFilesFrom(whole, folder);
    return whole;
}

bool MainWindow::showState(const WindowState& state, const std::filesystem::path& folder, SceneChanges changes) {
    if (!app::show(m_document, state, folder, changes)) return false;
    showScene();
    WindowState found = state;
    findFilesFrom(found, folder);
    lookAt(found);
    return true;
}

void MainWindow::lookAt(const WindowState& state) {
    if (const pipeline::Errors errors = m_views->lookAt(state); !errors.empty())
        m_errors->report(tr("Not all of it could be shown."), errors);
}

bool MainWindow::mayLeaveScene() {
    if (!showsScene()) return true;
    if (m_document.isChanged()) {
        switch (askToKeep(this, QFileInfo(m_document.kept().file).fileName())) {
            case KeepChanges::GoBack: return false;
            case KeepChanges::Keep:
                if (!saveScene()) return false;
                break;
            case KeepChanges::Drop: break;
        }
    }
    rememberWhere();
    return true;
}

// Among the recent files; what has been changed in the scene is not a part of it.
void MainWindow::rememberWhere() {
    auto now = state({});
    if (!now || m_document.kept().file.isEmpty()) return;
    now->set.clear();
    now->sceneText.clear();
    rememberPlace(m_document.kept().file, placeText(*now), toQString(toToml(*now)));
}

// A picture's scene is open; what the window showed then comes with it.
void MainWindow::showCarriedState(const QString& picture) {
    if (!picture.endsWith(".png", Qt::CaseInsensitive)) return;
    const auto state = stateInPicture(picture);
    if (!state)
        return m_errors->report(tr("The scene is open; what the picture says about the views is not read."),
                                state.errors());
    if (!state->has_value()) return;
    showPlace(m_document, **state);
    lookAt(**state);
}

// A scene that is no part of the program goes along, for a machine that does not have its file.
void MainWindow::copyState() {
    auto now = state({});
    if (!now) {
        emit m_document.said(tr("The scene is too large to be copied as text."));
        return;
    }
    if (std::filesystem::path(now->scene).is_absolute())
        if (const auto text = toTomlScene(m_document.scene())) now->sceneText = *text, now->set.clear();
    QApplication::clipboard()->setText(toQString(toToml(*now)));
    emit m_document.said(tr("Copied what you see as text. Ctrl+V in a view shows it again, in any window."));
}

// Without a scene it is a place in the scene on show.
void MainWindow::pasteState() {
    const std::string text = QApplication::clipboard()->text().trimmed().toStdString();
    const auto read = text.empty() ? pipeline::Result<WindowState>(pipeline::Error{
                                         {"clipboard", 1, 1}, "no text", "what Ctrl+C in a view has copied"})
                                   : readState(text, "clipboard");
    if (!read) return m_errors->report(tr("This is no state of a window. Nothing has changed."), read.errors());
    m_errors->hide();
    if (read->scene.empty() && read->sceneText.empty() && showsScene()) {
        showPlace(m_document, *read);
        lookAt(*read);
    } else {
        if (!isOpen(m_document, *read, {}) && !mayLeaveScene()) return;
        if (!showState(*read, {}, SceneChanges::Pasted)) return;
    }
    emit m_document.said(tr("Shows what was copied: %1.").arg(placeText(*read)));
}

void MainWindow::exportSlide() {
    const auto now = state({});
    if (!now) return;
    auto* dialog = new SlideDialog(m_document, *m_views, *now, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::exportFilm() {
    auto* dialog = new FilmDialog(m_document, m_views->first().buffer(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::closeScene() {
    if (!mayLeaveScene()) return;
    m_document.undoStack()->setClean();  // the question has been answered
    showStartPage();
    if (m_session) m_session->save();
}

bool MainWindow::openRecent(const QString& file) {
    QString text;
    for (const RecentFile& recent : recentFiles())
        if (recent.file == file) text = recent.state;
    if (!openFile(file)) return false;
    if (text.isEmpty()) return true;
    const auto state = readState(text.toStdString(), "recent");
    if (!state) return true;  // of another version: the file is open all the same
    return showState(*state, {}, SceneChanges::Given);
}

void MainWindow::startSession(const QString& folder, bool restore) {
    m_session = new Session(
        m_document, folder, [this] { return state({}); }, this);
    if (restore && SessionFile::isWanted()) {
        SessionFile& file = m_session->file();
        const SessionFile::Left left = file.take();
        if (!left.errors.empty())
            m_errors->report(tr("The last session could not be restored. It is kept as %1.").arg(left.aside),
                             left.errors);
        if (left.state) showState(*left.state, {}, SceneChanges::Ours);
    }
    m_session->begin();
}

}  // namespace app
