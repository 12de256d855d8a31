#pragma once
#include <QAbstractListModel>
#include <memory>
#include <vector>

#include "lessons/library.h"
#include "lessons/questions/results.h"

namespace app {

// The lessons of the program and those opened from folders, with the reader's progress, which is saved in the program's
// settings. Knows no widget.
class LessonShelf : public QAbstractListModel {
    Q_OBJECT
public:
    enum Role {  // Qt::DisplayRole is the title and the progress, in two lines
        NameRole = Qt::UserRole,
        TitleRole,
        SummaryRole,
        PageRole,      // read last, from 1; 0 when not begun
        PagesRole,     // how many there are
        ProgressRole,  // both in words
    };

    explicit LessonShelf(QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

    // The lesson of a row as it is listed: its pages may have headings alone. Valid as long as the shelf is.
    const lessons::Lesson& listed(int row) const { return *m_lessons[std::size_t(row)].lesson; }
    const lessons::Lesson* findListed(const QString& name) const;  // null when there is no such lesson
    // The whole lesson, which is read when it is first asked for; null when there is none, or errors() says why.
    const lessons::Lesson* find(const QString& name);
    // Puts questions of an earlier lesson at its start: of the last but one that the reader has done. Questions that
    // were already asked stay. The lesson must not be open.
    void setReturning(const lessons::Lesson& lesson, const lessons::Results& results);
    // One of its own name takes the place of that which had it.
    void put(lessons::Lesson lesson);
    const pipeline::Errors& errors() const { return m_errors; }  // of lessons that cannot be read

    int page(const lessons::Lesson& lesson) const;  // as PageRole
    void setPage(const lessons::Lesson& lesson, int page);
    void forgetPages();  // of all lessons

private:
    struct Row {
        std::unique_ptr<lessons::Lesson> lesson;  // its own pages, and of an opened one those that return
        bool isWhole = false;
    };
    std::size_t rowOf(const QString& name) const;  // as many as there are: no such lesson

    std::vector<Row> m_lessons;
    pipeline::Errors m_errors;
};

}  // namespace app
