#include "app/lesson/lesson_shelf.h"

#include <QSettings>
#include <algorithm>
#include <map>

#include "app/look/text.h"
#include "lessons/questions/returning.h"

namespace app {

namespace {

QString progressKey(const lessons::Lesson& lesson) {
    QString name = toQString(lesson.name);  // of one's own: a folder
    return QStringLiteral("lessons/%1/page").arg(name.replace(u'/', u'|'));
}

lessons::Lesson ownPages(lessons::Lesson lesson) {
    std::erase_if(lesson.pages, [](const lessons::Page& page) { return page.from.has_value(); });
    return lesson;
}

}  // namespace

LessonShelf::LessonShelf(QObject* parent) : QAbstractListModel(parent) {
    lessons::Library library = lessons::allOutlines();
    for (lessons::Lesson& lesson : library.lessons)
        m_lessons.push_back({std::make_unique<lessons::Lesson>(std::move(lesson))});
    m_errors = std::move(library.errors);
}

int LessonShelf::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_lessons.size()); }

QVariant LessonShelf::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const lessons::Lesson& lesson = listed(index.row());
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

std::size_t LessonShelf::rowOf(const QString& name) const {
    const auto isNamed = [name = name.toStdString()](const Row& row) { return row.lesson->name == name; };
    return std::size_t(std::ranges::find_if(m_lessons, isNamed) - m_lessons.begin());
}

const lessons::Lesson* LessonShelf::findListed(const QString& name) const {
    const std::size_t row = rowOf(name);
    return row < m_lessons.size() ? m_lessons[row].lesson.get() : nullptr;
}

const lessons::Lesson* LessonShelf::find(const QString& name) {
    const std::size_t at = rowOf(name);
    if (at == m_lessons.size()) return nullptr;
    Row& row = m_lessons[at];
    if (row.isWhole) return row.lesson.get();
    auto lesson = lessons::readLesson(row.lesson->folder);
    if (!lesson) {
        m_errors = lesson.errors();
        return nullptr;
    }
    *row.lesson = ownPages(std::move(lesson).value());
    row.isWhole = true;
    return row.lesson.get();
}

// What its author has return comes when the reader has done the lesson that it is from.
void LessonShelf::setReturning(const lessons::Lesson& lesson, const lessons::Results& results) {
    if (lesson.returns.empty()) return;
    // What any lesson has return, by the name of the lesson that it is from.
    std::map<std::string, std::map<std::size_t, lessons::Lesson::Return>> returning;
    for (const Row& row : m_lessons)
        for (const lessons::Lesson::Return& one : row.lesson->returns) returning[one.lesson].emplace(one.page, one);
    std::vector<std::string> done = results.done();
    std::erase(done, lesson.name);
    const auto wasAsked = [&](const auto& from) {
        const lessons::Lesson* source = findListed(toQString(from.first));
        return source && std::ranges::any_of(from.second, [&](const auto& one) {
                   const std::size_t own = one.first - 1 + returningPages(*source);
                   return own < source->pages.size() &&
                          results.find(lesson.name, lessons::headingAgain(source->pages[own].heading));
               });
    };
    auto from = std::ranges::find_if(returning, wasAsked);
    if (from == returning.end() && done.size() > 1) from = returning.find(done[done.size() - 2]);
    std::vector<lessons::Page>& pages = m_lessons[rowOf(toQString(lesson.name))].lesson->pages;
    std::erase_if(pages, [](const lessons::Page& page) { return page.from.has_value(); });
    if (from == returning.end()) return;
    std::vector<lessons::Lesson::Return> wanted;
    for (const auto& [page, one] : from->second) wanted.push_back(one);
    const auto again = lessons::readReturning(wanted, [](std::string_view name) { return lessons::otherLesson(name); });
    if (again)
        pages.insert(pages.begin(), again->begin(), again->end());
    else
        m_errors = again.errors();
}

void LessonShelf::put(lessons::Lesson lesson) {
    const std::size_t same = rowOf(toQString(lesson.name));
    if (same < m_lessons.size()) {
        *m_lessons[same].lesson = ownPages(std::move(lesson));
        m_lessons[same].isWhole = true;
        return emit dataChanged(index(int(same)), index(int(same)));
    }
    beginInsertRows({}, rowCount(), rowCount());
    m_lessons.push_back({std::make_unique<lessons::Lesson>(ownPages(std::move(lesson))), true});
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
    const QModelIndex row = index(int(rowOf(toQString(lesson.name))));
    emit dataChanged(row, row);
}

void LessonShelf::forgetPages() {
    QSettings().remove(QStringLiteral("lessons"));
    if (rowCount() > 0) emit dataChanged(index(0), index(rowCount() - 1));
}

}  // namespace app
