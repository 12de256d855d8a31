#include "app/lesson/lesson_head.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/lesson/question_card.h"
#include "app/look/accessible.h"
#include "app/look/icons.h"
#include "app/look/text.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"

namespace app {

PageSegments::PageSegments(const LessonRun& run, QWidget* parent) : QWidget(parent), m_run(run) {
    setAccessibleRole(*this, QAccessible::ProgressBar);
    followTheme(this, [this] { setFixedHeight(Theme::current().px(11)); });
}

void PageSegments::showPages() {
    if (!m_run.lesson()) return;
    int done = 0;
    for (int i = 0; i < m_run.pageCount(); ++i) done += m_run.progress(i).outcome != lessons::Progress::Outcome::Open;
    setAccessibleName(tr("%1 of %2 questions are settled").arg(done).arg(m_run.pageCount()));
    update();
}

void PageSegments::paintEvent(QPaintEvent*) {
    if (!m_run.lesson()) return;
    const ThemeColors& c = Theme::current().colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int pages = m_run.pageCount();
    const double gap = 3, wide = (width() - 4 - gap * (pages - 1)) / pages, tall = height() - 6.0;
    for (int i = 0; i < pages; ++i) {
        const QRectF box(2 + i * (wide + gap), 3, wide, tall);
        const bool isOpen = i == m_run.page();
        const bool isDone = i < m_run.page() || m_run.progress(i).outcome != lessons::Progress::Outcome::Open;
        painter.setPen(Qt::NoPen);
        painter.setBrush(isDone && !isOpen ? c.fill : c.hover);
        painter.drawRoundedRect(box, 2, 2);
        if (!isOpen) continue;
        painter.setBrush(c.fill);
        painter.drawRoundedRect(m_run.isSettled() ? box : box.adjusted(0, 0, -wide / 2, 0), 2, 2);
        painter.setPen(QPen(c.accent, 1.5));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(box.adjusted(-1, -2, 1, 2), 3, 3);
    }
}

LessonHead::LessonHead(const LessonRun& run, QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_all(new QPushButton(tr("All lessons"), this)),
      m_title(new ElidedLabel(this)),
      m_whole(styled(new QLabel(this), {.name = "lessonWholeTitle", .wraps = true})),
      m_place(styled(new QLabel(this), {.name = "lessonPlace", .tone = 2})),
      m_points(styled(new QLabel(this), {.name = "lessonPoints", .tone = 2})),
      m_only(new QToolButton(this)),
      m_more(new QToolButton(this)),
      m_close(new QToolButton(this)),
      m_segments(new PageSegments(run, this)) {
    m_all->setProperty("kind", "link");
    m_all->setObjectName("allLessons");
    m_only->setText(tr("Only this"));
    m_only->setCheckable(true);
    m_only->setObjectName("onlyThis");
    m_only->setToolTip(tr("Hide the panels that this page does not need"));
    makeMenu();
    m_close->setIcon(icon("close"));
    m_close->setObjectName("closeLesson");
    m_close->setAccessibleName(tr("Close the lesson"));
    m_close->setToolTip(tr("Close the lesson; your scene comes back as it was"));
    auto* top = spaced(new QHBoxLayout, {}, 6);
    top->addWidget(m_all);
    top->addWidget(m_title, 1);
    top->addWidget(m_only);
    top->addWidget(m_more);
    top->addWidget(m_close);
    auto* below = new QHBoxLayout;
    below->addWidget(m_place, 1);
    below->addWidget(m_points);
    auto* column = spaced(new QVBoxLayout(this), {14, 6, 10, 6}, 4);
    column->addLayout(top);
    column->addWidget(m_whole);
    column->addWidget(m_segments);
    column->addLayout(below);
    m_whole->setTextFormat(Qt::PlainText);
    connect(m_all, &QPushButton::clicked, this, &LessonHead::leaveAsked);
    connect(m_close, &QToolButton::clicked, this, &LessonHead::leaveAsked);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        for (QLabel* label : {m_title, m_whole}) label->setFont(theme.text(13, 600));
        for (QLabel* label : {m_place, m_points}) label->setFont(theme.text(12));
        m_only->setFont(theme.text(12));
        setQuiet(m_isQuiet);
    });
}

void LessonHead::makeMenu() {
    m_more->setIcon(icon("more"));
    m_more->setObjectName("lessonMore");
    m_more->setAccessibleName(tr("More about the lesson"));
    m_more->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(m_more);
    QAction* only = menu->addAction(m_only->text(), m_only, &QToolButton::click);
    only->setCheckable(true);
    connect(menu, &QMenu::aboutToShow, this, [this, only] { only->setChecked(m_only->isChecked()); });
    menu->addAction(tr("Write this lesson as a handout…"), this, &LessonHead::handoutAsked);
    m_more->setMenu(menu);
}

void LessonHead::setQuiet(bool quiet) {
    m_isQuiet = quiet;
    m_only->setVisible(!quiet);
    m_more->setVisible(quiet);
    const QString all = tr("All lessons");
    m_all->setText(quiet ? QString() : all);
    m_all->setIcon(quiet ? icon("chevron-left") : QIcon());
    m_all->setAccessibleName(all);
    m_all->setToolTip(quiet ? all : QString());
    m_all->setMinimumWidth(m_all->fontMetrics().horizontalAdvance(m_all->text()) + Theme::current().px(12));
    layout()->activate();
    fitTitle();
}

// Below the buttons, on lines of its own, where there is no room between them.
void LessonHead::fitTitle() {
    const bool fits = m_title->fontMetrics().horizontalAdvance(m_whole->text()) <= m_title->width();
    m_title->setText(fits ? m_whole->text() : QString());
    m_whole->setVisible(!fits);
}

void LessonHead::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layout()->activate();
    fitTitle();
}

void LessonHead::showRun() {
    if (!m_run.lesson()) return;
    const lessons::Lesson& lesson = *m_run.lesson();
    const int returning = int(returningPages(lesson)), pages = m_run.pageCount() - returning;
    m_whole->setText(toQString(lesson.title));
    fitTitle();
    m_place->setText(m_run.isAtEnd()        ? tr("%1 pages").arg(pages)
                     : m_run.current().from ? tr("Question %1 of %2 that returns").arg(m_run.page() + 1).arg(returning)
                                            : tr("Page %1 of %2").arg(m_run.page() + 1 - returning).arg(pages));
    const double of = m_run.pointsOf();
    const QString points = m_run.isAtEnd() ? tr("%1 of %2 points") : tr("%1 of %2 points so far");
    m_points->setText(of > 0 ? points.arg(pointsText(m_run.pointsSoFar()), pointsText(of)) : QString());
    m_segments->showPages();
}

LessonFoot::LessonFoot(LessonRun& run, QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_back(new QPushButton(tr("Back"), this)),
      m_next(new QPushButton(tr("Next"), this)),
      m_why(styled(new QLabel(this), {.tone = 2, .size = 12})) {
    m_back->setObjectName("previousPage");
    m_next->setObjectName("nextPage");
    m_why->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* row = spaced(new QHBoxLayout(this), {14, 6, 14, 8}, 10);
    row->addWidget(m_back);
    row->addWidget(m_why, 1);
    row->addWidget(m_next);
    connect(m_back, &QPushButton::clicked, &run, [&run] { run.goTo(run.page() - 1); });
    connect(m_next, &QPushButton::clicked, &run, [&run] { run.goTo(run.page() + 1); });
}

void LessonFoot::showRun() {
    const bool atEnd = m_run.isAtEnd(), settled = m_run.isSettled();
    m_back->setEnabled(m_run.page() > 0);
    m_back->setVisible(!m_isQuiet || m_run.page() > 0);
    m_back->setToolTip(m_run.page() > 0 ? tr("Previous page (Alt+←)") : tr("Already at the first page."));
    m_next->setVisible(!atEnd && (!m_isQuiet || settled));
    m_next->setEnabled(settled);
    m_next->setText(m_run.page() + 1 == m_run.pageCount() ? tr("Finish") : tr("Next"));
    m_next->setToolTip(settled ? tr("Next page (Alt+→)") : tr("After your answer"));
    m_next->setProperty("kind", settled ? "primary" : "");
    m_next->style()->polish(m_next);
    m_why->setText(atEnd ? QString() : settled ? tr("Enter goes on") : m_isQuiet ? QString() : tr("after your answer"));
    setVisible(!m_isQuiet || settled || m_run.page() > 0);
}

void LessonFoot::setQuiet(bool quiet) {
    m_isQuiet = quiet;
    showRun();
}

void LessonFoot::takeFocus() { m_next->setFocus(); }

}  // namespace app
