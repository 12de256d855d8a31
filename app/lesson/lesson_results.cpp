#include "app/lesson/lesson_results.h"

#include "app/look/text.h"

namespace app {

QString LessonResults::file() { return toQString(lessons::resultsFile().string()); }

LessonResults::LessonResults() {
    if (const auto file = lessons::resultsFile(); !file.empty())
        if (auto read = lessons::readResults(file)) m_all = std::move(read).value();
}

lessons::Progress LessonResults::progress(const QString& lesson, const QString& page) const {
    const auto pages = m_all.lessons().find(lesson.toStdString());
    if (pages == m_all.lessons().end()) return {};
    const auto one = pages->second.find(page.toStdString());
    return one == pages->second.end() ? lessons::Progress() : one->second;
}

void LessonResults::keep(const lessons::Lesson& lesson, const lessons::Page& page, const lessons::Progress& progress) {
    m_all.put(lesson, page, progress);
    // Where the folder cannot be written to, the results last until the program ends.
    if (const auto file = lessons::resultsFile(); !file.empty()) writeResults(m_all, file);
}

void LessonResults::forget() {
    m_all.forget();
    if (const auto file = lessons::resultsFile(); !file.empty()) writeResults(m_all, file);
}

}  // namespace app
