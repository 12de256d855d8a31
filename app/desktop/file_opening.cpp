#include "app/desktop/file_opening.h"

#include <QApplication>
#include <QDropEvent>
#include <QFileDialog>
#include <QMimeData>
#include <algorithm>

#include "app/commands/actions.h"
#include "app/desktop/scene_files.h"
#include "app/desktop/window_cues.h"
#include "app/desktop/window_lessons.h"
#include "app/desktop/window_renderer.h"
#include "app/document/document.h"
#include "app/document/recent_files.h"
#include "app/look/text.h"
#include "app/start/start_page.h"
#include "app/talk/cue_panel.h"
#include "lessons/library.h"
#include "lessons/state/cue_list.h"
#include "pipeline/formats/format_table.h"

namespace app {
namespace {

// Everything that can be read, then any file.
QString fileFilters() {
    QStringList patterns;
    for (const pipeline::Format& format : pipeline::formatTable()) patterns << u'*' + toQString(format.extension);
    return FileOpening::tr("Scenes and models (%1);;Lessons (lesson.md);;All files (*)").arg(patterns.join(u' '));
}

}  // namespace

FileOpening::FileOpening(QWidget& window, Actions& actions, Document& document, StartPage& start, SceneFiles& files,
                         WindowLessons& lessons, WindowCues& cues, WindowRenderer& renderer, CuePanel& cuePanel)
    : QObject(&window),
      m_window(window),
      m_document(document),
      m_start(start),
      m_files(files),
      m_lessons(lessons),
      m_cues(cues),
      m_renderer(renderer) {
    window.setAcceptDrops(true);
    qApp->installEventFilter(this);
    connect(&start, &StartPage::openRequested, this, [this] { choose(); });
    connect(&start, &StartPage::fileChosen, this, [this](const QString& file) { open(file); });
    connect(&start, &StartPage::recentChosen, this, &FileOpening::openRecent);
    connect(&start, &StartPage::talkChosen, this, &FileOpening::giveTalk);
    connect(&start, &StartPage::lessonChosen, &lessons, &WindowLessons::open);
    connect(&cuePanel, &CuePanel::openAsked, this, [this] { choose(tr("Open a cue list"), WindowCues::fileFilter()); });
    actions.add({.id = ActionId::Open,
                 .menu = "File",
                 .text = "Open…",
                 .keys = "Ctrl+O",
                 .tip = "Open a scene file.",
                 .run = [this] { choose(); },
                 .needsScene = false});
}

bool FileOpening::open(const QString& file, const std::function<void()>& then) {
    if (file.endsWith(lessons::kCueEnding, Qt::CaseInsensitive)) return m_cues.open(file, {}, then);
    if (const auto lesson = lessons::lessonAt(file.toStdString()); !lesson.empty()) {
        const bool opened = m_lessons.openAt(lesson);
        if (opened && then) then();
        return opened;
    }
    if (!m_renderer.accepts({file})) return m_files.open(file, then);
    m_renderer.check({file});
    return false;
}

bool FileOpening::openRecent(const QString& file) {
    if (file.endsWith(lessons::kCueEnding, Qt::CaseInsensitive)) return openCues(file, {});
    if (m_renderer.accepts({file})) {
        m_renderer.check({file});
        return true;
    }
    return lessons::lessonAt(file.toStdString()).empty() ? m_files.openRecent(file) : open(file);
}

// At the cue that was shown last, if the list still has it.
bool FileOpening::openCues(const QString& file, const std::function<void()>& then) {
    const auto recent = recentFiles();
    const auto left = std::ranges::find(recent, file, &RecentFile::file);
    const auto list = lessons::readCueFile(file.toStdString());
    const QString cue =
        list && left != recent.end() && lessons::findCue(*list, left->state.toStdString()) ? left->state : QString();
    return m_cues.open(file, cue, then);
}

void FileOpening::giveTalk(const QString& file) {
    openCues(file, [this] { m_cues.present(); });
}

void FileOpening::chooseTalk() {
    const QString file =
        QFileDialog::getOpenFileName(&m_window, tr("Open a cue list"), QString(), WindowCues::fileFilter());
    if (!file.isEmpty()) giveTalk(file);
}

void FileOpening::choose() { choose(tr("Open a file"), fileFilters()); }

void FileOpening::choose(const QString& title, const QString& filters) {
    const QString file = QFileDialog::getOpenFileName(&m_window, title, QString(), filters);
    if (!file.isEmpty()) open(file);
}

// A file may be dropped anywhere: a text field, which would take its name as words, leaves it to the window.
bool FileOpening::takesDrop(QObject* watched, const QDropEvent& drop) const {
    const auto* widget = qobject_cast<QWidget*>(watched);
    return widget && widget->window() == &m_window && widget->acceptDrops() && drop.mimeData()->hasUrls();
}

bool FileOpening::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::DragLeave:
            if (watched == &m_window) m_start.setDropHint(false);
            return false;
        case QEvent::DragEnter:
        case QEvent::DragMove:
        case QEvent::Drop: break;
        default: return false;
    }
    auto& drop = static_cast<QDropEvent&>(*event);
    if (!takesDrop(watched, drop)) return false;
    drop.acceptProposedAction();
    if (event->type() != QEvent::DragMove) m_start.setDropHint(event->type() == QEvent::DragEnter);
    if (event->type() == QEvent::Drop) takeDrop(drop);
    return true;
}

// Whatever is dropped is answered: what cannot be opened, with the reason.
void FileOpening::takeDrop(const QDropEvent& drop) {
    const QList<QUrl> urls = drop.mimeData()->urls();
    const auto refuse = [this](const QString& found, const QString& expected) {
        emit m_document.failed({{{}, found.toStdString(), expected.toStdString()}});
    };
    QStringList paths;
    for (const QUrl& url : urls)
        if (url.isLocalFile()) paths += url.toLocalFile();
    if (paths.size() == urls.size() && m_renderer.accepts(paths)) return m_renderer.check(paths);
    if (urls.size() != 1) return refuse(tr("%1 files were dropped").arg(urls.size()), tr("one scene or model"));
    if (!urls.front().isLocalFile())
        return refuse(tr("%1 is no file of this machine").arg(urls.front().toDisplayString()),
                      tr("a file; save it first"));
    open(urls.front().toLocalFile());
}

}  // namespace app
