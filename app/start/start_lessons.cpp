#include "app/start/start_lessons.h"

#include <QKeyEvent>
#include <QLabel>
#include <QScrollArea>
#include <algorithm>
#include <numeric>

#include "app/start/start_lesson_row.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/surface.h"

namespace app {

StartLessons::StartLessons(QWidget* parent)
    : QFrame(parent),
      m_title(new QLabel(tr("Lessons"), this)),
      m_done(styled(new QLabel(this), {.tone = 2, .size = 12})),
      m_list(new QWidget(this)) {
    setProperty("kind", "panel");
    m_done->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_list->setProperty("kind", "page");
    m_area = scrolling(m_list, this);
    followTheme(this, [this] {
        m_title->setFont(Theme::current().text(13, 600));
        place();
    });
}

void StartLessons::setLessons(const std::vector<StartLesson>& lessons) {
    qDeleteAll(m_rows);
    m_rows.clear();
    for (const StartLesson& lesson : lessons) {
        auto* row = new LessonRow(lesson, int(m_rows.size()) + 1, m_list);
        row->installEventFilter(this);
        connect(row, &LessonRow::clicked, this, [this, name = lesson.name] { emit chosen(name); });
        row->show();
        m_rows += row;
    }
    // One that was left, else the first that is still to do.
    const auto first = [this](bool (StartLesson::*is)() const, bool wanted) {
        const auto row = std::ranges::find(m_rows, wanted, [is](LessonRow* one) { return (one->lesson().*is)(); });
        return row == m_rows.end() ? nullptr : *row;
    };
    m_next = first(&StartLesson::isBegun, true);
    if (!m_next) m_next = first(&StartLesson::isDone, false);
    if (m_next) m_next->setLit(true);
    const auto done = std::ranges::count_if(lessons, &StartLesson::isDone);
    m_done->setText(tr("%1 of %2 done").arg(done).arg(lessons.size()));
    m_shown = m_rows;
}

bool StartLessons::choose(const std::function<bool(const LessonRow& row)>& isWanted) {
    m_shown.clear();
    for (LessonRow* row : m_rows) {
        row->setVisible(isWanted(*row));
        if (!row->isHidden()) m_shown += row;
    }
    LessonRow* const entry = m_shown.contains(m_next) ? m_next : m_shown.value(0);
    for (LessonRow* row : m_shown) row->setFocusPolicy(row == entry ? Qt::StrongFocus : Qt::ClickFocus);
    place();
    return !m_shown.isEmpty();
}

void StartLessons::setColumns(int columns) {
    m_columns = columns;
    place();
}

int StartLessons::headHeight() const { return std::max(Theme::current().px(34), m_title->sizeHint().height()); }

// In two columns a row is as high as the higher of its two.
int StartLessons::rowsHeight(int width) const {
    const qsizetype rows = (m_shown.size() + m_columns - 1) / m_columns;
    int height = 0;
    for (qsizetype i = 0; i < rows; ++i) {
        int row = 0;
        for (qsizetype k = i; k < m_shown.size(); k += rows)
            row = std::max(row, m_shown[k]->wantedHeight(width / m_columns));
        height += row;
    }
    return height;
}

int StartLessons::wantedHeight(int width) const {
    const qsizetype rows = (m_shown.size() + m_columns - 1) / m_columns;
    return headHeight() + std::max(rowsHeight(width - 2), int(rows) * Theme::current().px(34)) + 2;
}

void StartLessons::resizeEvent(QResizeEvent*) { place(); }

void StartLessons::place() {
    const Theme& theme = Theme::current();
    const int head = headHeight(), side = theme.px(12);
    m_title->setGeometry(side, 1, width() / 2, head - 1);
    m_done->setGeometry(width() / 2 - side, 1, width() / 2, head - 1);
    m_area->setGeometry(1, head, width() - 2, height() - head - 1);
    if (m_shown.isEmpty()) return;
    const qsizetype rows = (m_shown.size() + m_columns - 1) / m_columns;
    const int room = m_area->height(), needed = rowsHeight(width() - 2);
    const int bar = needed > room ? theme.px(10) : 0;  // for scrolling
    const int across = (width() - 2 - bar) / m_columns;
    m_list->setMinimumHeight(needed > room ? rowsHeight(width() - 2 - bar) : 0);
    int y = 0;
    for (qsizetype i = 0; i < rows; ++i) {
        int wanted = 0;
        for (qsizetype k = i; k < m_shown.size(); k += rows)
            wanted = std::max(wanted, m_shown[k]->wantedHeight(across));
        // What is left is shared, up to the height of a comfortable row.
        const int share = std::max(0, room - needed) / int(rows);
        const int high = std::max(wanted, std::min(wanted + share, theme.px(44)));
        for (qsizetype k = i, column = 0; k < m_shown.size(); k += rows, ++column)
            m_shown[k]->setGeometry(int(column) * across, y, across, high);
        y += high;
    }
    if (m_next && m_shown.contains(m_next))
        QMetaObject::invokeMethod(
            m_area,
            [this] {
                if (m_next) m_area->ensureWidgetVisible(m_next);
            },
            Qt::QueuedConnection);
}

void StartLessons::focus(LessonRow* row) {
    if (!row) return;
    for (LessonRow* other : m_shown) other->setFocusPolicy(other == row ? Qt::StrongFocus : Qt::ClickFocus);
    row->setFocus(Qt::TabFocusReason);
    m_area->ensureWidgetVisible(row);
}

bool StartLessons::eventFilter(QObject* watched, QEvent* event) {
    auto* row = static_cast<LessonRow*>(watched);
    if (event->type() == QEvent::FocusIn) focus(row);
    if (event->type() != QEvent::KeyPress) return QFrame::eventFilter(watched, event);
    const qsizetype at = m_shown.indexOf(row), rows = (m_shown.size() + m_columns - 1) / m_columns;
    switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Up: focus(m_shown.value(at - 1)); return true;
        case Qt::Key_Down: focus(m_shown.value(at + 1)); return true;
        case Qt::Key_Left: focus(m_shown.value(at - rows)); return true;
        case Qt::Key_Right: focus(m_shown.value(at + rows)); return true;
        default: return QFrame::eventFilter(watched, event);
    }
}

}  // namespace app
