#include "app/lesson/lesson_shelf.h"

#include <QSettings>
#include <algorithm>

#include "app/look/text.h"

namespace app {

namespace {

QString progressKey(const lessons::Lesson& lesson) {
    QString name = toQString(lesson.name);  // of one's own: a folder
    return QStringLiteral("lessons/%1/page").arg(name.replace(u'/', u'|'));
}

}  // namespace

LessonShelf::LessonShelf(QObject* parent) : QAbstractListModel(parent) {
    lessons::Library library = lessons::allLessons();
    for (lessons::Lesson& lesson : library.lessons) add(std::move(lesson));
    m_errors = std::move(library.errors);
}

int LessonShelf::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_lessons.size()); }

QVariant LessonShelf::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const lessons::Lesson& lesson = *m_lessons[std::size_t(index.row())];
    const int pages = int(lesson.pages.size()), reached = page(lesson), returning = int(returningPages(lesson));
    switch (role) {
        case Qt::DisplayRole:
        case Qt::AccessibleTextRole: return toQString(lesson.title) + '\n' + data(index, ProgressRole).toString();
        case ProgressRole:
            return reached == 0           ? tr("Not begun, %1 pages").arg(pages - returning)
                   : reached == pages     ? tr("Read, %1 pages").arg(pages - returning)
                   : reached <= returning ? tr("Begun, %1 pages").arg(pages - returning)
                                          : tr("Page %1 of %2").arg(reached - returning).arg(pages - returning);
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
    const auto found =
        std::ranges::find(m_lessons, name.toStdString(), [](const auto& lesson) { return lesson->name; });
    return found == m_lessons.end() ? nullptr : found->get();
}

// What its author has return comes when the reader has done the lesson that it is from.
void LessonShelf::add(lessons::Lesson lesson) {
    for (lessons::Page& page : lesson.pages)
        if (page.from) m_returning[page.from->lesson].push_back(page);
    std::erase_if(lesson.pages, [](const lessons::Page& page) { return page.from.has_value(); });
    m_lessons.push_back(std::make_unique<lessons::Lesson>(std::move(lesson)));
}

void LessonShelf::setReturning(const lessons::Lesson& lesson, const lessons::Results& results) {
    if (lesson.returns.empty()) return;
    std::vector<std::string> done = results.done();
    std::erase(done, lesson.name);
    const auto wasAsked = [&](const auto& from) {
        return std::ranges::any_of(from.second, [&](const lessons::Page& page) { return results.find(lesson, page); });
    };
    auto from = std::ranges::find_if(m_returning, wasAsked);
    if (from == m_returning.end() && done.size() > 1) from = m_returning.find(done[done.size() - 2]);
    const auto own = std::ranges::find(m_lessons, &lesson, [](const auto& other) { return other.get(); });
    std::vector<lessons::Page>& pages = (*own)->pages;
    std::erase_if(pages, [](const lessons::Page& page) { return page.from.has_value(); });
    if (from != m_returning.end()) pages.insert(pages.begin(), from->second.begin(), from->second.end());
}

void LessonShelf::put(lessons::Lesson lesson) {
    const auto same = std::ranges::find(m_lessons, lesson.name, [](const auto& other) { return other->name; });
    if (same != m_lessons.end()) {
        std::erase_if(lesson.pages, [](const lessons::Page& page) { return page.from.has_value(); });
        **same = std::move(lesson);
        const QModelIndex row = index(int(same - m_lessons.begin()));
        return emit dataChanged(row, row);
    }
    beginInsertRows({}, rowCount(), rowCount());
    add(std::move(lesson));
    endInsertRows();
}

// Kept is the number among the lesson's own pages; below 0 one that returns, -1 the last of them.
int LessonShelf::page(const lessons::Lesson& lesson) const {
    const int kept = QSettings().value(progressKey(lesson), 0).toInt(), returning = int(returningPages(lesson));
    if (kept == 0) return 0;
    // A lesson may have become shorter since.
    return std::clamp(returning + kept + (kept < 0), 1, int(lesson.pages.size()));
}

void LessonShelf::setPage(const lessons::Lesson& lesson, int page) {
    const int own = page - int(returningPages(lesson));
    QSettings().setValue(progressKey(lesson), own <= 0 ? own - 1 : own);
    const auto at = std::ranges::find(m_lessons, &lesson, [](const auto& other) { return other.get(); });
    const QModelIndex row = index(int(at - m_lessons.begin()));
    emit dataChanged(row, row);
}

void LessonShelf::forgetPages() {
    QSettings().remove(QStringLiteral("lessons"));
    if (rowCount() > 0) emit dataChanged(index(0), index(rowCount() - 1));
}

}  // namespace app
