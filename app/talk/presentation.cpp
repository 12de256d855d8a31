#include "app/talk/presentation.h"

#include <QAction>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QScreen>
#include <QWidget>
#include <utility>

#include "app/look/theme.h"
#include "app/talk/clean_view.h"
#include "app/talk/notes_window.h"
#include "app/talk/talk_keys.h"
#include "app/widgets/follow_theme.h"

namespace app {

Presentation::Presentation(Document& document, CueModel& cues, const SceneOpener& opener, QWidget& window)
    : QObject(&window), m_document(document), m_cues(cues), m_opener(opener), m_window(window) {
    connect(&Theme::current(), &Theme::changed, this, [this] {
        if (isOn() && Theme::current().scale() < m_scale) magnify();
    });
}

// Another theme brings a scale of its own.
void Presentation::magnify() {
    Theme& theme = Theme::current();
    m_scales.try_emplace(theme.id(), theme.scale());
    if (theme.scale() < m_scale) theme.setScale(m_scale);
}

void Presentation::restoreScales() {
    Theme& theme = Theme::current();
    const ThemeId now = theme.id();
    for (const auto& [id, scale] : std::exchange(m_scales, {})) {
        if (id != theme.id()) theme.set(id);
        theme.setScale(scale);
    }
    if (theme.id() != now) theme.set(now);
}

Presentation::~Presentation() { end(); }

void Presentation::begin(const lessons::WindowState& state, const QList<QAction*>& keys, bool withNotes) {
    if (isOn()) return;
    m_swapped = false;
    m_changesWindow = true;
    m_clean = std::make_unique<CleanView>(m_document, m_cues, m_opener);
    m_clean->addActions(keys);
    connect(m_clean.get(), &CleanView::left, this, &Presentation::end, Qt::QueuedConnection);
    connect(m_clean.get(), &CleanView::cancelAsked, this, &Presentation::cancelAsked);
    connect(m_clean.get(), &CleanView::swapAsked, this, [this] {
        m_swapped = !m_swapped;
        place();
    });
    m_clean->lookAt(state);
    if (withNotes && QGuiApplication::screens().size() > 1) {
        m_notes = std::make_unique<NotesWindow>(m_cues, *m_clean);
        m_notes->addActions(keys);
        m_notes->installEventFilter(this);
        connect(m_notes.get(), &NotesWindow::asked, this, &Presentation::cueAsked);
        connect(m_notes.get(), &NotesWindow::left, this, &Presentation::end, Qt::QueuedConnection);
    }
    place();
}

// The audience has the screen that the window is not on, where there is one.
void Presentation::place() {
    const QList<QScreen*> screens = QGuiApplication::screens();
    QScreen* own = m_window.screen();
    QScreen* other = own;
    for (QScreen* screen : screens)
        if (screen != own) other = screen;
    if (m_swapped) std::swap(own, other);
    m_scale = CleanView::scaleFor(other->size().height());
    magnify();
    const auto show = [](QWidget& widget, QScreen& screen) {
        widget.setGeometry(screen.geometry());
        widget.showFullScreen();
    };
    if (m_notes) show(*m_notes, *own);
    show(*m_clean, *other);
    followThemeAgain(*m_clean);  // what was set before it was shown is gone
    m_clean->activateWindow();
    m_clean->setFocus();
}

void Presentation::end() {
    if (!isOn()) return;
    m_notes.reset();
    m_clean.reset();
    restoreScales();
    m_window.activateWindow();
    m_changesWindow = false;
    emit ended();
}

pipeline::Errors Presentation::lookAt(const lessons::WindowState& state) {
    return isOn() ? m_clean->lookAt(state) : pipeline::Errors();
}

// The keys of the clean view work from the notes too.
bool Presentation::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress && m_clean) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if ((key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier && m_clean->keys().take(key.key())) return true;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace app
