// What the MainWindow shows as a value, and what becomes of it when a scene is left: sessions, recent files, the
// question before changes are lost.
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
    if (const pipeline::Errors errors = m_views->lookAt(found); !errors.empty())
        m_errors->report(tr("Not all of it could be shown."), errors);
    return true;
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
    if (const pipeline::Errors errors = m_views->lookAt(**state); !errors.empty())
        m_errors->report(tr("Not all of it could be shown."), errors);
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
