#include "app/panels/lesson_shelf.h"

#include <QSettings>
#include <algorithm>

#include "app/core/text.h"

namespace app {

namespace {

QString progressKey(const lessons::Lesson& lesson) {
    return QStringLiteral("lessons/%1/page").arg(toQString(lesson.name));
}

}  // namespace

LessonShelf::LessonShelf(QObject* parent) : QAbstractListModel(parent), m_library(lessons::allLessons()) {}

int LessonShelf::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(m_library.lessons.size());
}

QVariant LessonShelf::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const lessons::Lesson& lesson = m_library.lessons[std::size_t(index.row())];
    const int pages = int(lesson.pages.size()), reached = page(lesson);
    switch (role) {
        case Qt::DisplayRole:
        case Qt::AccessibleTextRole: {
            const QString progress = reached == 0       ? tr("not begun, %1 pages").arg(pages)
                                     : reached == pages ? tr("read, %1 pages").arg(pages)
                                                        : tr("page %1 of %2").arg(reached).arg(pages);
            return toQString(lesson.title) + '\n' + progress;
        }
        case Qt::ToolTipRole:
        case SummaryRole: return toQString(lesson.summary);
        case NameRole: return toQString(lesson.name);
        case TitleRole: return toQString(lesson.title);
        case PageRole: return reached;
        case PagesRole: return pages;
        default: return {};
    }
}

const lessons::Lesson* LessonShelf::find(const QString& name) const {
    const auto found = std::ranges::find(m_library.lessons, name.toStdString(), &lessons::Lesson::name);
    return found == m_library.lessons.end() ? nullptr : &*found;
}

int LessonShelf::page(const lessons::Lesson& lesson) const {
    // A lesson may have become shorter since.
    return std::clamp(QSettings().value(progressKey(lesson), 0).toInt(), 0, int(lesson.pages.size()));
}

void LessonShelf::setPage(const lessons::Lesson& lesson, int page) {
    QSettings().setValue(progressKey(lesson), page);
    const QModelIndex row = index(int(&lesson - m_library.lessons.data()));
    emit dataChanged(row, row);
}

}  // namespace app
