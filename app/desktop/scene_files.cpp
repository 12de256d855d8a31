#include "app/desktop/scene_files.h"

#include <QDir>
#include <QFileInfo>

#include "app/commands/actions.h"
#include "app/desktop/ask_to_save.h"
#include "app/desktop/shown_state.h"
#include "app/docks/window_layout.h"
#include "app/document/file_watch.h"
#include "app/document/own_file.h"
#include "app/document/recent_files.h"
#include "app/lesson/lesson_panel.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "app/talk/presentation.h"
#include "app/views/view_area.h"
#include "app/widgets/error_list.h"
#include "app/widgets/save_dialog.h"
#include "lessons/state/cue_list.h"
#include "lessons/state/state_scene.h"
#include "pipeline/formats/built_in_scenes.h"

namespace app {

SceneFiles::SceneFiles(QWidget& window, Actions& actions, Document& document, SceneOpener& opener, ShownState& shown,
                       WindowLayout& layout, LessonPanel& lessons, const Presentation& presentation, ErrorList& errors)
    : QObject(&window),
      m_window(window),
      m_document(document),
      m_opener(opener),
      m_shown(shown),
      m_layout(layout),
      m_lessons(lessons),
      m_presentation(presentation),
      m_errors(errors),
      m_watch(new FileWatch(document)) {
    m_watch->setParent(this);
    connect(m_watch, &FileWatch::changed, this, &SceneFiles::takeFileChange);
    connect(&presentation, &Presentation::cancelAsked, this, &SceneFiles::cancel);
    addActions(actions);
}

void SceneFiles::addActions(Actions& actions) {
    using A = ActionId;
    const auto whyNotSave = [this] { return this->whyNotSave(); };
    actions.add(
        {.id = A::ReadAgain,
         .menu = "File",
         .text = "Reload",
         .keys = "F5",
         .tip = "Read the scene's file again; views, step and pixel stay.",
         .run = [this] { reload(); },
         .whyNot = [this] { return m_document.kept().scene ? QString() : tr("This scene comes from no file."); }});
    actions.add({.id = A::Save,
                 .menu = "File",
                 .text = "Save scene",
                 .keys = "Ctrl+S",
                 .tip = "Write the scene to its file; ask for a name if the file holds more than this program writes.",
                 .run = [this] { save(); },
                 .whyNot = whyNotSave});
    actions.add({.id = A::SaveAs,
                 .menu = "File",
                 .text = "Save scene as…",
                 .keys = "Ctrl+Shift+S",
                 .tip = "Write the scene with all its settings as a TOML file.",
                 .run = [this] { saveAs(); },
                 .whyNot = whyNotSave});
    actions.add({.id = A::Close,
                 .menu = "File",
                 .text = "Close",
                 .keys = "Ctrl+W",
                 .tip = "Close the scene and show the start page.",
                 .run = [this] { close(); },
                 .startsGroup = true});
}

QString SceneFiles::whyNotSave() const {
    return m_lessons.lesson() ? tr("Close the lesson first: this scene is its own.") : QString();
}

bool SceneFiles::hasChangedOutside() const { return m_watch->hasChanged(); }

void SceneFiles::read(const QString& name, SceneOpener::Read read, std::function<void(const OpenedScene&)> take) {
    m_lessons.close();
    emit asked();
    const auto left = m_document.sharedScene();
    m_opener.open(name, std::move(read), [this, left, take](const pipeline::Result<OpenedScene>& opened) {
        const bool changed = left != m_document.sharedScene() && wouldLoseChanges();
        if (!opened) {
            emit m_document.failed(opened.errors());
            emit notShown();
        } else if (!changed || m_presentation.isOn() || opened->kept.scene == m_document.kept().scene || mayLeave()) {
            take(*opened);
        }
    });
}

void SceneFiles::cancel() {
    m_opener.cancel();
    emit notShown();
}

bool SceneFiles::open(const QString& file, const Then& then) {
    if (!mayLeave()) return false;
    const auto readIt = [file](const pipeline::ReadProgress& progress) { return readSceneFile(file, progress); };
    read(shownName(file), readIt, [this, file, then](const OpenedScene& opened) {
        m_document.open(opened);
        showPoint();
        showCarriedState(opened);
        addRecentFile(file);
        if (then) then();
    });
    return true;
}

// A scene of the program opens with what makes its point: its stage, and its buffers in the views.
void SceneFiles::showPoint() {
    const auto scene = pipeline::builtInSceneOf(m_document.kept().file.toStdString());
    if (!scene || scene->buffers.empty()) return;
    m_document.setStage(scene->stage);
    m_shown.showBuffers(scene->buffers);
}

// A picture's scene is open; what the window showed then comes with it.
void SceneFiles::showCarriedState(const OpenedScene& picture) {
    const auto& state = picture.carried;
    if (!state)
        return m_errors.report(tr("The scene is open; what the picture says about the views is not read."),
                               state.errors());
    if (state->has_value()) m_shown.showPlace(**state);
}

// A scene with other settings is opened like another file, and looked at as before.
void SceneFiles::reload() {
    const KeptScene kept = m_document.kept();  // keeping changes may make it another
    if (!mayLeave()) return;
    const QString name = shownName(kept.file);
    const auto readIt = [kept](const pipeline::ReadProgress& progress) { return readSceneAgain(kept, progress); };
    read(name, readIt, [this, name](const OpenedScene& again) {
        m_errors.hide();
        const auto now = m_shown.now();
        if (!m_document.reload(again)) {
            m_document.open(again);
            if (now) m_shown.showPlace(*now);
        }
        emit m_document.said(tr("%1 has been read again.").arg(name));
    });
}

// Another program has written to the scene's file: an editor, most of all. Changes of one's own are not given up unasked.
void SceneFiles::takeFileChange() {
    emit changedOutside();
    if (!m_watch->hasChanged() || !m_layout.showsScene()) return;
    if (FileWatch::readsAgain() && !m_document.isChanged()) return reload();
    emit m_document.said(tr("%1 has been changed by another program. F5 reads it again; views, step and pixel stay.")
                             .arg(shownName(m_document.kept().file)));
}

void SceneFiles::showState(const lessons::WindowState& state, const std::filesystem::path& folder, SceneChanges changes,
                           const Then& then) {
    const KeptScene open = isOpen(m_document, state, folder) ? m_document.kept() : KeptScene();
    const auto readIt = [state, folder, open](const pipeline::ReadProgress& progress) {
        return readStateScene(state, folder, open, progress);
    };
    read(shownName(toQString(state.scene)), readIt, [=, this](const OpenedScene& opened) {
        lessons::WindowState found = state;
        findFilesFrom(found, folder);
        app::show(m_document, opened, state, changes,
                  changes == SceneChanges::Pasted ? m_shown.looksTo(found) : StepLooks());
        m_layout.showViews();
        m_shown.lookAt(found);
        if (then) then();
    });
}

// A moved slider in a scene of the program loses nothing: the session brings it back, and "Save as" keeps it.
bool SceneFiles::wouldLoseChanges() const {
    return m_document.isChanged() && !pipeline::builtInSceneOf(m_document.kept().file.toStdString());
}

bool SceneFiles::mayLeave() {
    m_lessons.close();  // which brings the user's scene back
    if (!m_layout.showsScene()) return true;
    if (wouldLoseChanges()) {
        switch (askToSave(&m_window, shownName(m_document.kept().file))) {
            case SaveChanges::Cancel: return false;
            case SaveChanges::Save:
                if (!save()) return false;
                break;
            case SaveChanges::Discard: break;
        }
    }
    rememberPlace();
    return true;
}

// Among the recent files; what has been changed in the scene is not a part of it.
void SceneFiles::rememberPlace() {
    auto now = m_shown.now();
    if (!now || m_document.kept().file.isEmpty()) return;
    now->set.clear();
    now->sceneText.clear();
    app::rememberPlace(m_document.kept().file, placeText(*now), toQString(toToml(*now)));
}

// To its own file without a question, where nothing is lost with what stands there.
bool SceneFiles::save() {
    const QString own = ownFile(m_document);
    return own.isEmpty() ? saveAs() : m_document.save(own);
}

bool SceneFiles::saveAs() {
    const QFileInfo opened(toQString(m_document.scene().file)), named(toQString(m_document.scene().name));
    const bool hasFile = !opened.fileName().isEmpty();
    const QString proposed = (hasFile ? opened.dir() : QDir::home())
                                 .filePath((hasFile ? opened : named).completeBaseName() + QStringLiteral(".toml"));
    const QString file = askWhereToSave(&m_window, tr("Save the scene"), proposed, tr("Scenes (*.toml)"), "toml");
    if (file.isEmpty() || !m_document.save(file)) return false;
    addRecentFile(file);
    return true;
}

void SceneFiles::close() {
    if (m_lessons.lesson()) return m_lessons.close();
    if (!mayLeave()) return;
    m_document.history().stack()->setClean();  // the question has been answered
    m_layout.showStart();
    emit closed();
}

bool SceneFiles::openRecent(const QString& file) {
    QString text;
    for (const RecentFile& recent : recentFiles())
        if (recent.file == file) text = recent.state;
    return open(file, [this, text] {
        if (text.isEmpty()) return;
        const auto state = lessons::readState(text.toStdString(), "recent");
        // One of another version is not read; the file is open all the same.
        if (state) showState(*state, {}, SceneChanges::Given);
    });
}

}  // namespace app
