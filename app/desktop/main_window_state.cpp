// What the MainWindow shows as a value, and what becomes of it when a scene is left: sessions, recent files, the
// question before changes are lost.
#include <QApplication>
#include <QClipboard>
#include <QStackedWidget>

#include "app/core/document_state.h"
#include "app/core/file_watch.h"
#include "app/core/recent_files.h"
#include "app/core/scene_opener.h"
#include "app/core/shown_name.h"
#include "app/core/text.h"
#include "app/desktop/actions.h"
#include "app/desktop/keep_changes.h"
#include "app/desktop/main_window.h"
#include "app/desktop/presentation.h"
#include "app/desktop/session.h"
#include "app/desktop/slide_dialog.h"
#include "app/desktop/view_area.h"
#include "app/panels/buffer_view.h"
#include "app/panels/error_list.h"
#include "app/panels/film_dialog.h"
#include "app/panels/lesson_panel.h"
#include "lessons/library.h"
#include "lessons/state/cue_list.h"
#include "lessons/state/state_scene.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/toml_writer.h"

namespace app {

bool MainWindow::showsScene() const { return m_width.has_value() && m_document.hasScene(); }

std::optional<lessons::WindowState> MainWindow::state(const std::filesystem::path& folder) const {
    if (!showsScene()) return {};
    auto state = stateOf(m_document, folder);
    if (!state) return {};  // a scene too large to be kept
    lessons::WindowState whole = std::move(state).value();
    m_views->fill(whole);
    nameFilesFrom(whole, folder);
    return whole;
}

void MainWindow::openScene(const QString& name, SceneOpener::Read read, std::function<void(const OpenedScene&)> take) {
    m_lessons->close();
    m_cueAsked.reset();
    const auto left = m_document.sharedScene();
    m_opener->open(name, std::move(read), [this, left, take](const pipeline::Result<OpenedScene>& opened) {
        const bool changed = left != m_document.sharedScene() && wouldLoseChanges();
        if (!opened) {
            m_cueAsked.reset();
            emit m_document.failed(opened.errors());
            if (m_session) m_session->begin();
        } else if (!changed || m_presentation->isOn() || opened->kept.scene == m_document.kept().scene ||
                   mayLeaveScene()) {
            take(*opened);
        }
    });
}

void MainWindow::cancelOpening() {
    m_opener->cancel();
    m_cueAsked.reset();
    if (m_session) m_session->begin();
}

bool MainWindow::openFile(const QString& file, const Then& then) {
    if (file.endsWith(lessons::kCueEnding, Qt::CaseInsensitive)) return openCues(file, {}, then);
    if (const auto lesson = lessons::lessonAt(file.toStdString()); !lesson.empty()) {
        const bool opened = openLessonAt(lesson);
        if (opened && then) then();
        return opened;
    }
    if (!mayLeaveScene()) return false;
    const auto read = [file](const pipeline::ReadProgress& progress) { return readSceneFile(file, progress); };
    openScene(shownName(file), read, [this, file, then](const OpenedScene& opened) {
        m_document.open(opened);
        showPoint();
        showCarriedState(opened);
        addRecentFile(file);
        if (then) then();
    });
    return true;
}

// A scene of the program opens with what makes its point: its stage, and its buffers in the views.
void MainWindow::showPoint() {
    const auto scene = pipeline::builtInSceneOf(m_document.kept().file.toStdString());
    if (!scene || scene->buffers.empty()) return;
    m_document.setStage(scene->stage);
    m_views->showBuffers(scene->buffers);
}

// A scene with other settings is opened like another file, and looked at as before.
void MainWindow::readAgain() {
    const KeptScene kept = m_document.kept();  // keeping changes may make it another
    if (!mayLeaveScene()) return;
    const QString name = shownName(kept.file);
    const auto read = [kept](const pipeline::ReadProgress& progress) { return readSceneAgain(kept, progress); };
    openScene(name, read, [this, name](const OpenedScene& again) {
        m_errors->hide();
        const auto now = state({});
        if (!m_document.reload(again)) {
            m_document.open(again);
            if (now) showPlace(m_document, *now), lookAt(*now);
        }
        emit m_document.said(tr("%1 has been read again.").arg(name));
    });
}

// Another program has written to the scene's file: an editor, most of all. Changes of one's own are not given up unasked.
void MainWindow::takeFileChange() {
    showTitle();
    if (!m_file->hasChanged() || !showsScene()) return;
    if (FileWatch::readsAgain() && !m_document.isChanged()) return readAgain();
    emit m_document.said(tr("%1 has been changed by another program. F5 reads it again; views, step and pixel stay.")
                             .arg(shownName(m_document.kept().file)));
}

void MainWindow::showState(const lessons::WindowState& state, const std::filesystem::path& folder, SceneChanges changes,
                           const Then& then) {
    const KeptScene open = isOpen(m_document, state, folder) ? m_document.kept() : KeptScene();
    const auto read = [state, folder, open](const pipeline::ReadProgress& progress) {
        return readStateScene(state, folder, open, progress);
    };
    openScene(shownName(toQString(state.scene)), read, [=, this](const OpenedScene& opened) {
        lessons::WindowState found = state;
        findFilesFrom(found, folder);
        app::show(m_document, opened, state, changes,
                  changes == SceneChanges::Pasted ? looksTo(found) : Document::Looks());
        showScene();
        lookAt(found);
        if (then) then();
    });
}

// From what the window shows now; none where that cannot be kept.
Document::Looks MainWindow::looksTo(const lessons::WindowState& next) {
    const auto now = state({});
    if (!now) return {};
    const auto show = [this](const lessons::WindowState& state) {
        return [this, state] { showPlace(m_document, state), lookAt(state); };
    };
    return {show(*now), show(next)};
}

void MainWindow::lookAt(const lessons::WindowState& state) {
    if (const pipeline::Errors errors = m_views->lookAt(state); !errors.empty())
        m_errors->report(tr("Not all of it could be shown."), errors);
}

// A moved slider in a scene of the program loses nothing: the session brings it back, and "Save as" keeps it.
bool MainWindow::wouldLoseChanges() const {
    return m_document.isChanged() && !pipeline::builtInSceneOf(m_document.kept().file.toStdString());
}

bool MainWindow::mayLeaveScene() {
    m_lessons->close();  // which brings the user's scene back
    if (!showsScene()) return true;
    if (wouldLoseChanges()) {
        switch (askToKeep(this, shownName(m_document.kept().file))) {
            case KeepChanges::Cancel: return false;
            case KeepChanges::Save:
                if (!saveScene()) return false;
                break;
            case KeepChanges::Discard: break;
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
void MainWindow::showCarriedState(const OpenedScene& picture) {
    const auto& state = picture.carried;
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
    const auto read = text.empty() ? pipeline::Result<lessons::WindowState>(pipeline::Error{
                                         {"clipboard", 1, 1}, "no text", "what Ctrl+C in a view has copied"})
                                   : lessons::readState(text, "clipboard");
    if (!read) return m_errors->report(tr("This is no state of a window. Nothing has changed."), read.errors());
    m_errors->hide();
    const auto tell = [this, place = placeText(*read)] {
        emit m_document.said(tr("Shows what was copied: %1.").arg(place));
    };
    if (read->scene.empty() && read->sceneText.empty() && showsScene()) {
        m_document.replace(m_document.scene(), tr("paste"), looksTo(*read));
        showPlace(m_document, *read);
        lookAt(*read);
    } else {
        if (!isOpen(m_document, *read, {}) && !mayLeaveScene()) return;
        return showState(*read, {}, SceneChanges::Pasted, tell);
    }
    tell();
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
    if (m_aside) return m_lessons->close();
    if (!mayLeaveScene()) return;
    m_document.undoStack()->setClean();  // the question has been answered
    showStartPage();
    if (m_session) m_session->forget();
}

bool MainWindow::openRecent(const QString& file) {
    QString text;
    for (const RecentFile& recent : recentFiles())
        if (recent.file == file) text = recent.state;
    return openFile(file, [this, text] {
        if (text.isEmpty()) return;
        const auto state = lessons::readState(text.toStdString(), "recent");
        // One of another version is not read; the file is open all the same.
        if (state) showState(*state, {}, SceneChanges::Given);
    });
}

void MainWindow::startSession(const QString& folder, bool restore) {
    m_session = new Session(
        m_document, folder, [this] { return m_aside ? m_aside->state : state({}); }, this);
    connect(m_views, &ViewArea::changed, m_session, &Session::saveSoon);
    SessionFile& file = m_session->file();
    const SessionFile::Left left = restore && SessionFile::isWanted() ? file.take() : file.leave();
    if (!left.errors.empty())
        m_errors->report(tr("The last session could not be restored. It is kept as %1.").arg(left.aside), left.errors);
    if (left.state) showState(*left.state, {}, SceneChanges::Ours);
    if (!m_opener->busy()) m_session->begin();
}

}  // namespace app
