#include "app/desktop/clean_view.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/core/memory_notice.h"
#include "app/core/number_format.h"
#include "app/core/pixel_inspection.h"
#include "app/core/scene_opener.h"
#include "app/core/shown_name.h"
#include "app/core/text.h"
#include "app/desktop/ask_panel.h"
#include "app/desktop/caption_line.h"
#include "app/desktop/opening_bar.h"
#include "app/desktop/pen_layer.h"
#include "app/desktop/pinned_settings.h"
#include "app/desktop/view_area.h"
#include "app/desktop/work_bar.h"
#include "app/panels/algorithm_panel.h"
#include "app/panels/algorithm_view.h"
#include "app/panels/follow_theme.h"
#include "app/panels/math_view.h"

namespace app {
namespace {

constexpr int kKeyMs = 1200, kCursorMs = 2000;
constexpr int kFailedMs = 4000, kHintMs = 6000, kKeysMs = 20000;
constexpr int kMomentMs = 1000;
constexpr double kTitle = 31;  // 57 px in 1080 lines

}  // namespace

double CleanView::scaleFor(int height) {
    const double scale = 22.0 / 12 * height / 1080;
    return std::min(std::ceil(scale * 20) / 20, Theme::kMostScale);  // in the theme's steps
}

CleanView::CleanView(Document& document, CueModel& cues, const SceneOpener& opener)
    : m_document(document), m_cues(cues), m_opener(opener), m_pen(nullptr) {
    setObjectName("cleanView");
    setWindowTitle(tr("Shadescope, presentation"));
    setAutoFillBackground(true);
    auto* column = new QVBoxLayout(this);
    column->setSizeConstraint(QLayout::SetNoConstraint);  // it fills the screen, and the views give way
    m_views = new ViewArea(document, this, ViewDress::Bare);
    auto* beside = new QHBoxLayout;
    beside->addWidget(m_views, 1);
    beside->addWidget(makeAlgorithm());
    m_ask = new AskPanel(cues, this);
    beside->addWidget(m_ask);
    m_title = new QLabel(this);
    m_title->setObjectName("cueTitle");
    m_title->setTextFormat(Qt::PlainText);
    m_title->setWordWrap(true);
    column->addWidget(m_title);
    column->addLayout(beside, 1);
    column->addWidget(new PinnedSettings(document, this));
    column->addWidget(makeEquation());
    m_caption = new CaptionLine(this);
    column->addWidget(m_caption);
    m_hint = new QLabel(cues.size() > 0 ? tr("PgDown next cue · F10 step · B black · H keys · Esc leaves")
                                        : tr("F10 step · Ctrl+→ next stage · B black · H keys · Esc leaves"),
                        this);
    m_hint->setObjectName("cleanHint");
    m_hint->setProperty("kind", "overlay");
    m_hint->setProperty("tone", 2);
    m_hintTime.setSingleShot(true);
    connect(&m_hintTime, &QTimer::timeout, m_hint, &QWidget::hide);
    m_hintTime.start(kHintMs);
    makeWork();
    m_pen = new PenLayer(this);
    m_keyTime.setSingleShot(true);
    connect(&m_keyTime, &QTimer::timeout, this, [this] { m_caption->setKey({}); });
    m_cursorTime.setSingleShot(true);
    m_cursorTime.setInterval(kCursorMs);
    connect(&m_cursorTime, &QTimer::timeout, this, [this] {
        if (!std::exchange(m_cursorHidden, true)) QApplication::setOverrideCursor(Qt::BlankCursor);
    });
    connect(&document.inspection(), &PixelInspection::changed, this, &CleanView::showEquation);
    connect(&document.pointing(), &Pointing::channelChanged, this, &CleanView::showEquation);
    connect(&NumberStyle::current(), &NumberStyle::changed, this, &CleanView::showEquation);
    connect(&document, &Document::stageChanged, this, &CleanView::showCaption);
    connect(&document.stepper(), &Stepper::changed, this, [this] {
        showCaption();
        showAlgorithm();
        showEquation();
    });
    // The list of errors stands in the window behind.
    const auto tell = [this](const QString& words) {
        m_caption->setKey(words);
        m_keyTime.start(kFailedMs);
    };
    connect(&document, &Document::failed, this, [tell](const pipeline::Errors& errors) {
        if (errors.empty()) return;
        const QString file = shownName(toQString(errors.front().where.file));
        tell(file.isEmpty() ? toQString(errors.front().found) : tr("%1 could not be read").arg(file));
    });
    connect(&document.frames(), &FrameFeed::outOfMemory, this,
            [tell] { tell(tr("not enough memory for this frame")); });
    connect(&MemoryNotice::instance(), &MemoryNotice::gaveUp, this, [tell] { tell(tr("not enough memory")); });
    const auto tellNotWritten = [tell](const QString& file) {
        tell(tr("%1 could not be written").arg(shownName(file)));
    };
    connect(&document, &Document::notWritten, this, tellNotWritten);
    connect(&cues, &CueModel::notWritten, this, tellNotWritten);
    connect(&cues, &CueModel::changed, this, [this] {
        m_pen->clearLines();
        showCaption();
    });
    connect(m_ask, &AskPanel::changed, this, [this] {
        showQuestion();
        showCaption();
    });
    followTheme(this, [this] { applyTheme(); });
    qApp->installEventFilter(this);
    showQuestion();
    showCaption();
    m_cursorTime.start();
}

CleanView::~CleanView() {
    qApp->removeEventFilter(this);
    if (m_cursorHidden) QApplication::restoreOverrideCursor();
    // The views go while the document that they observe is still there.
    qDeleteAll(findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
}

void CleanView::makeWork() {
    m_work = new QFrame(this);
    m_work->setProperty("kind", "overlay");
    auto* reading = new OpeningBar(m_opener, m_work);
    auto* lines = new QVBoxLayout(m_work);
    lines->addWidget(reading);
    lines->addWidget(new WorkBar(m_document.work(), m_work));
    m_workTime.setSingleShot(true);
    m_workTime.setInterval(kMomentMs);
    connect(reading, &OpeningBar::cancelAsked, this, &CleanView::cancelAsked);
    connect(&m_opener, &SceneOpener::changed, this, &CleanView::placeWork);
    connect(&m_document.work(), &WorkList::changed, this, &CleanView::placeWork);
    placeWork();
}

QWidget* CleanView::makeEquation() {
    m_equationRow = new QWidget(this);
    auto* columns = new QHBoxLayout(m_equationRow);
    columns->setContentsMargins(0, 0, 0, 0);
    m_math = new MathView(m_equationRow);
    m_math->setBaseSize(20.8);  // 38 px in 1080 lines
    m_math->setFocusPolicy(Qt::NoFocus);
    m_value = new QLabel(m_equationRow);
    m_swatch = new QLabel(m_equationRow);
    m_swatch->setFrameShape(QFrame::Box);
    columns->addWidget(m_math, 1);
    columns->addWidget(m_value, 0, Qt::AlignVCenter);
    columns->addWidget(m_swatch, 0, Qt::AlignVCenter);
    return m_equationRow;
}

void CleanView::applyTheme() {
    const Theme& theme = Theme::current();
    layout()->setContentsMargins(theme.px(19), theme.px(15), theme.px(19), theme.px(10));
    static_cast<QVBoxLayout*>(layout())->setSpacing(theme.px(12));
    m_title->setFont(theme.text(kTitle, 600));
    m_value->setFont(theme.mono(13));
    m_leftOut->setFont(theme.text(12));
    m_hint->setFont(theme.text(12));
    m_hint->setMargin(theme.px(4));
    m_swatch->setFixedSize(theme.px(64), theme.px(64));
    m_equationRow->layout()->setSpacing(theme.px(12));
    showEquation();
}

// Above the caption, at the right: the views stay as they are. The hint where the keys will stand.
void CleanView::placeWork() {
    const WorkList& work = m_document.work();
    const bool runs = m_opener.busy() || !work.running().isEmpty();
    if (std::exchange(m_works, runs) && !runs) m_workTime.start();
    m_work->setVisible(runs || !work.stopped().isEmpty());
    m_work->adjustSize();
    const int margin = Theme::current().px(19);
    m_work->move(width() - m_work->width() - margin, m_caption->y() - m_work->height() - margin / 2);
    m_hint->adjustSize();
    const int beside = m_caption->geometry().center().y() - m_hint->height() / 2;
    m_hint->move(width() - m_hint->width() - margin, std::min(beside, height() - m_hint->height() - margin / 2));
}

void CleanView::showKeys() {
    m_hint->setText(
        tr("PgDown, PgUp   next cue, the one before\n"
           "F10, Shift+F10   step, step back\n"
           "Ctrl+→, Ctrl+←   next stage, the one before\n"
           "B, W   black, white\n"
           "P, O   pen, spotlight\n"
           "A   algorithm\n"
           "A to D, digits   votes, while a question is on show\n"
           "1, 2   one view, all views\n"
           "F4   swap the screens\n"
           "Esc   leaves"));
    m_hint->show();
    m_hint->raise();
    m_caption->setKey({});
    placeWork();
    m_hintTime.start(kKeysMs);
}

// Whether there was work on show to stop.
bool CleanView::stopWork() {
    WorkList& work = m_document.work();
    if (m_opener.busy())
        emit cancelAsked();
    else if (m_pen->cover() != PenLayer::Cover::None)
        return false;
    else if (work.running().isEmpty())
        return false;
    else
        work.cancel();
    return true;
}

pipeline::Errors CleanView::lookAt(const lessons::WindowState& state) {
    findChild<PinnedSettings*>()->show(state.sliders);
    return m_views->lookAt(state);
}

bool CleanView::takeKey(int key) {
    using Cover = PenLayer::Cover;
    if (m_ask->takeKey(key)) return true;
    switch (key) {
        case Qt::Key_B:
        case Qt::Key_Period: m_pen->setCover(m_pen->cover() == Cover::Black ? Cover::None : Cover::Black); break;
        case Qt::Key_W: m_pen->setCover(m_pen->cover() == Cover::White ? Cover::None : Cover::White); break;
        case Qt::Key_P: m_pen->setPen(!m_pen->hasPen()); break;
        case Qt::Key_O:
            m_pen->pointAt(mapFromGlobal(QCursor::pos()));
            m_pen->setSpotlight(!m_pen->hasSpotlight());
            break;
        case Qt::Key_A: m_document.stepper().setShowsAlgorithm(!m_document.stepper().showsAlgorithm()); break;
        case Qt::Key_1: m_views->setAlone(true); break;
        case Qt::Key_2: m_views->setAlone(false); break;
        case Qt::Key_F4: emit swapAsked(); break;
        case Qt::Key_H: showKeys(); break;
        case Qt::Key_Escape:
            if (stopWork() || m_ask->leaveField()) break;
            if (m_pen->cover() != Cover::None || m_pen->hasPen() || m_pen->hasSpotlight() || m_pen->hasLines()) {
                m_pen->setCover(Cover::None);
                m_pen->setPen(false);
                m_pen->setSpotlight(false);
                m_pen->clearLines();
                break;
            }
            if (!m_workTime.isActive()) emit left();  // pressed for work that has just ended it does not end the talk
            break;
        default: return false;
    }
    return true;
}

void CleanView::showKey(const QKeyEvent& key) {
    if (key.isAutoRepeat()) return;
    switch (key.key()) {
        case Qt::Key_Shift:
        case Qt::Key_Control:
        case Qt::Key_Alt:
        case Qt::Key_AltGr:
        case Qt::Key_Meta:
        case Qt::Key_unknown: return;
        default: break;
    }
    m_hint->hide();
    m_caption->setKey(QKeySequence(key.keyCombination()).toString(QKeySequence::NativeText));
    m_keyTime.start(kKeyMs);
}

void CleanView::wakeCursor() {
    if (std::exchange(m_cursorHidden, false)) QApplication::restoreOverrideCursor();
    m_cursorTime.start();
}

static bool isTextField(const QWidget* widget) {
    return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
           qobject_cast<const QTextEdit*>(widget) || qobject_cast<const QPlainTextEdit*>(widget);
}

// Keys here mean the same wherever the focus is: a buffer view would take B for its blue channel. But what is typed into
// a field, as a condition is, belongs there.
bool CleanView::eventFilter(QObject* watched, QEvent* event) {
    auto* widget = qobject_cast<QWidget*>(watched);
    if (!widget || widget->window() != this) return QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::MouseMove) {
        m_pen->pointAt(widget->mapTo(this, static_cast<QMouseEvent*>(event)->position().toPoint()));
        wakeCursor();
    }
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    const auto& key = *static_cast<QKeyEvent*>(event);
    if (isTextField(QApplication::focusWidget()) && key.key() != Qt::Key_F4)
        return QWidget::eventFilter(watched, event);
    const bool plain = (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    constexpr std::array kOwn{Qt::Key_B, Qt::Key_Period, Qt::Key_W,  Qt::Key_P,      Qt::Key_O, Qt::Key_A,
                              Qt::Key_1, Qt::Key_2,      Qt::Key_F4, Qt::Key_Escape, Qt::Key_H};
    const bool own = plain && (m_ask->wantsKey(key.key()) || std::ranges::find(kOwn, key.key()) != kOwn.end());
    if (event->type() == QEvent::ShortcutOverride) {
        showKey(key);
        if (own) event->accept();
        return own;
    }
    return own && !key.isAutoRepeat() ? takeKey(key.key()) : QWidget::eventFilter(watched, event);
}

void CleanView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    showQuestion();
    placeWork();
    m_pen->setGeometry(rect());
    m_pen->raise();
}

void CleanView::closeEvent(QCloseEvent* event) {
    event->ignore();
    emit left();
}

}  // namespace app
