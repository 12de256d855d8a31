#include "app/talk/notes_window.h"

#include <QCloseEvent>
#include <QDateTime>
#include <QLabel>
#include <QListView>
#include <QScrollArea>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "app/canvas/state_picture.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "app/look/theme.h"
#include "app/look/window_look.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/surface.h"
#include "lessons/state/state_scene.h"

namespace app {
namespace {

// A lecturer looks for what the audience reads, not for what a cue is called in its file.
class CaptionDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->text = index.data(CueModel::CaptionRole).toString();
    }
};

QString minutesText(qint64 seconds) {
    return QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

QLabel* makeLabel(QWidget* parent, int tone) {
    auto* label = new QLabel(parent);
    label->setProperty("tone", tone);
    return label;
}

// A picture as large as fits into a label.
void showImage(QLabel* label, const QImage& image) {
    if (image.isNull()) return label->setPixmap({});
    const double ratio = label->devicePixelRatioF();
    QPixmap pixmap =
        QPixmap::fromImage(image.scaled(label->size() * ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation));
    pixmap.setDevicePixelRatio(ratio);
    label->setPixmap(pixmap);
}

}  // namespace

NotesWindow::NotesWindow(CueModel& cues, QWidget& audience) : m_cues(cues), m_audience(audience) {
    setObjectName("notesWindow");
    setWindowTitle(tr("Shadescope, notes"));
    setAutoFillBackground(true);
    auto* columns = new QHBoxLayout;
    columns->addWidget(makePictures(), 5);
    columns->addWidget(makeRight(), 4);
    auto* all = new QVBoxLayout(this);
    all->addLayout(columns, 1);
    all->addWidget(makeFoot());
    m_since.start();
    m_second.setInterval(250);
    connect(&m_second, &QTimer::timeout, this, &NotesWindow::showTime);
    m_second.start();
    // Often enough to follow a hand, seldom enough to leave the views their time.
    m_grab.setInterval(400);
    connect(&m_grab, &QTimer::timeout, this, &NotesWindow::showAudience);
    m_grab.start();
    connect(&cues, &CueModel::changed, this, &NotesWindow::showCue);
    connect(&cues, &CueModel::votesChanged, this, &NotesWindow::showNote);
    followTheme(this, [this] { applyTheme(); });
    showCue();
    showTime();
}

QWidget* NotesWindow::makePictures() {
    auto* left = new QWidget(this);
    auto* column = spaced(new QVBoxLayout(left), {});
    m_nowTitle = makeLabel(left, 2), m_nextTitle = makeLabel(left, 2);
    for (QLabel** picture : {&m_now, &m_next}) {
        *picture = new QLabel(left);
        (*picture)->setAlignment(Qt::AlignCenter);
        (*picture)->setMinimumSize(160, 90);
        (*picture)->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    }
    m_now->setAccessibleName(tr("What the audience sees"));
    m_next->setAccessibleName(tr("The picture of the next cue"));
    column->addWidget(m_nowTitle);
    column->addWidget(surface(m_now, left), 5);
    column->addWidget(m_nextTitle);
    column->addWidget(surface(m_next, left), 3);
    return left;
}

QWidget* NotesWindow::makeRight() {
    auto* right = new QWidget(this);
    auto* column = spaced(new QVBoxLayout(right), {});
    m_notesTitle = makeLabel(right, 2);
    m_notesTitle->setText(tr("Notes"));
    m_notes = new QLabel;
    m_notes->setWordWrap(true);
    m_notes->setTextFormat(Qt::PlainText);
    m_notes->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* scroll = new QScrollArea(right);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(m_notes);
    m_list = new QListView(right);
    m_list->setModel(&m_cues);
    m_list->setItemDelegate(new CaptionDelegate(m_list));
    m_list->setAccessibleName(tr("Cues"));
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list->setFocusPolicy(Qt::NoFocus);  // it would search for a letter that is a key of the presentation
    connect(m_list, &QListView::clicked, this, [this](const QModelIndex& row) { emit asked(row.row()); });
    column->addWidget(m_notesTitle);
    column->addWidget(surface(scroll, right), 3);
    column->addWidget(surface(m_list, right), 1);
    return right;
}

QWidget* NotesWindow::makeFoot() {
    auto* foot = new QWidget(this);
    auto* row = spaced(new QHBoxLayout(foot), {});
    m_timer = makeLabel(foot, 1), m_left = makeLabel(foot, 2);
    m_clock = makeLabel(foot, 1);
    m_keys = new ElidedLabel(foot);  // what a small screen can do without
    m_keys->setProperty("tone", 2);
    m_keys->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_timer->setAccessibleName(tr("Time since you began"));
    m_clock->setAccessibleName(tr("Clock"));
    m_keys->setText(tr("PgUp back · PgDn on · B black · P pen · O spotlight · F4 swap screens · Esc leave"));
    row->addWidget(m_timer);
    row->addWidget(m_left);
    row->addWidget(m_keys, 1);
    row->addWidget(m_clock);
    return foot;
}

// Dark whatever the theme: it throws no light into the room, and in the dark it is not what one looks at.
void NotesWindow::applyTheme() {
    const Theme& theme = Theme::current();
    WindowLook look;
    look.theme.id = ThemeId::Dark;
    {
        const WornLook dark(look);
        setPalette(theme.palette());
        setStyleSheet(theme.styleSheet());
    }
    layout()->setContentsMargins(theme.px(12), theme.px(10), theme.px(12), theme.px(10));
    layout()->setSpacing(theme.px(8));
    for (QLabel* title : {m_nowTitle, m_nextTitle, m_notesTitle, m_left, m_keys}) title->setFont(theme.text(12));
    m_notes->setFont(theme.text(14));
    m_notes->setMargin(theme.px(12));
    m_list->setFont(theme.text(12));
    m_timer->setFont(theme.mono(25));
    m_clock->setFont(theme.mono(16));
    m_left->setContentsMargins(theme.px(12), 0, 0, 0);
    m_clock->setContentsMargins(theme.px(12), 0, 0, 0);
}

QString NotesWindow::place() const {
    return m_cues.current() < 0 ? tr("%1 cues").arg(m_cues.size())
                                : tr("cue %1 of %2").arg(m_cues.current() + 1).arg(m_cues.size());
}
QString NotesWindow::timer() const { return m_timer->text(); }
QString NotesWindow::notes() const { return m_notes->text(); }

// The choices with their votes, for a cue that asks, and the keys.
QString NotesWindow::votesText() const {
    const lessons::CueQuestion& question = *m_cues.currentCue()->ask;
    const std::vector<int> votes = m_cues.votes(m_cues.current());
    QStringList rows;
    for (std::size_t i = 0; i < votes.size(); ++i)
        rows << QStringLiteral("%1  %2   %3%4")
                    .arg(QChar('A' + int(i)))
                    .arg(votes[i])
                    .arg(toQString(question.choices[i]), i == question.right ? tr("   (right)") : QString());
    return tr("%1\nVotes: press a letter, type the number; Tab goes to the next letter.").arg(rows.join('\n'));
}

void NotesWindow::showNote() {
    const lessons::Cue* cue = m_cues.currentCue();
    const QString votes = cue && cue->ask ? QStringLiteral("\n\n") + votesText() : QString();
    m_notes->setText(!cue                ? tr("PgDn begins with the first cue.")
                     : cue->note.empty() ? tr("No notes for this cue.") + votes
                                         : toQString(cue->note) + votes);
}

void NotesWindow::showCue() {
    const lessons::Cue* cue = m_cues.currentCue();
    const auto stage = [](const lessons::Cue& one) { return toQString(stageInfo(one.state.stage).label); };
    m_nowTitle->setText(tr("What they see   ") + place() + (cue ? ", " + stage(*cue) : QString()));
    showNote();
    if (m_cues.current() >= 0) m_list->setCurrentIndex(m_cues.index(m_cues.current()));
    computeNext();
    showTime();
}

// A newer cue stops what is made for an older one, and waits for nothing.
void NotesWindow::computeNext() {
    const int next = m_cues.current() + 1;
    m_hasNext = false;
    m_nextImage = {};
    if (next >= m_cues.size()) {
        m_nextTitle->setText(tr("Next   this is the last cue"));
        showImage(m_next, {});
        return m_job.forget();
    }
    const lessons::Cue& cue = m_cues.cue(next);
    m_nextTitle->setText(tr("Next   cue %1: %2").arg(next + 1).arg(onOneLine(cue.name)));
    m_job.ask(
        [state = cue.state, folder = m_cues.folder()](const BackgroundJob::Control& control) -> QImage {
            auto scene = sceneOf(state, folder, {{}, control.stop});
            if (!scene || control.stop.stop_requested()) return {};
            const auto frame =
                frameOf(state, std::make_shared<const pipeline::Scene>(std::move(scene).value()), control.stop);
            if (!frame) return {};
            return pictureOf(*frame, state, state.views.front(), {QSize(960, 720)}, control.stop);
        },
        [this](const QImage& image) {
            m_nextImage = image;
            m_hasNext = !m_nextImage.isNull();
            showImage(m_next, m_nextImage);
        });
}

void NotesWindow::showTime() {
    const qint64 seconds = m_since.elapsed() / 1000, all = 60 * m_cues.list().minutes;
    m_timer->setText(minutesText(seconds));
    m_left->setText(
        seconds <= all
            ? tr("since you began\n%1 to the end of %2 minutes").arg(minutesText(all - seconds)).arg(all / 60)
            : tr("since you began\n%1 over %2 minutes").arg(minutesText(seconds - all)).arg(all / 60));
    m_clock->setText(QDateTime::currentDateTime().toString(QStringLiteral("HH:mm")));
}

void NotesWindow::showAudience() {
    if (isVisible() && m_audience.isVisible()) showImage(m_now, m_audience.grab().toImage());
}

void NotesWindow::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    showImage(m_next, m_nextImage);
}

void NotesWindow::closeEvent(QCloseEvent* event) {
    event->ignore();
    emit left();
}

}  // namespace app
