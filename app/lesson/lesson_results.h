#pragma once
#include <QString>

#include "lessons/questions/results.h"

namespace app {

// The user's tries in lessons, as lessons/questions/results.h stores them; written after each change.
class LessonResults {
public:
    LessonResults();  // an unreadable file counts as empty, and is kept until the next try

    // page: its heading.
    lessons::Progress progress(const QString& lesson, const QString& page) const;
    void keep(const lessons::Lesson& lesson, const lessons::Page& page, const lessons::Progress& progress);
    void forget();  // everything, and the file
    const lessons::Results& all() const { return m_all; }
    bool isEmpty() const { return m_all.empty(); }

    static QString file();

private:
    lessons::Results m_all;
};

}  // namespace app
