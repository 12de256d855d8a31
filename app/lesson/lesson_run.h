#pragma once
#include <QElapsedTimer>

#include "app/document/document.h"
#include "app/jobs/background_job.h"
#include "app/lesson/lesson_results.h"
#include "lessons/expression/changed_frames.h"
#include "lessons/lesson.h"
#include "lessons/questions/attempt.h"

namespace app {

// A page's texts, filled in from frames of its own.
struct PageTexts {
    lessons::PageFrames frames;
    std::shared_ptr<lessons::ChangedFrames> changed;
    std::string text, question, then;  // Markdown
    std::vector<std::string> options;
    pipeline::Errors errors;  // what of them could not be filled in
};

// A lesson that somebody takes: which page is open, what has been answered, what the window is set to and what it hides.
// Judges and speaks by frames of the page's own, whatever the window shows. Knows no widget.
class LessonRun : public QObject {
    Q_OBJECT
public:
    explicit LessonRun(Document& document, QObject* parent = nullptr);

    void open(const lessons::Lesson& lesson, int page);  // which outlives this, or is closed before
    void close();
    // From 0; as many as the lesson has pages: its end.
    void goTo(int page);
    // To the next page or the one before, as a clicker does. False where an open question stays.
    bool turn(int by);
    void setWindow();  // to the half that is open

    const lessons::Lesson* lesson() const { return m_lesson; }  // null where none is open
    int page() const { return m_page; }
    int pageCount() const { return m_lesson ? int(m_lesson->pages.size()) : 0; }
    bool isAtEnd() const { return m_lesson && m_page == pageCount(); }
    const lessons::Page& current() const { return m_lesson->pages[std::size_t(m_page)]; }
    // Of the question on the page; null where it has none.
    lessons::Attempt* attempt() { return m_attempt ? &*m_attempt : nullptr; }
    bool isSettled() const { return !m_attempt || m_attempt->isSettled(); }
    const std::optional<PageTexts>& texts() const { return m_texts; }  // nothing until they are there
    // Whether the window shows another scene than the half that is open.
    bool isElsewhere() const;
    // To evaluate what is asked; only with texts().
    lessons::Context context() const;
    // How far a question of kind until is; nothing where it is of another kind, or the window's frame is on its way.
    std::optional<lessons::Gauge> gauge() const;

    pipeline::Result<lessons::Verdict> check(const lessons::Given& given);
    pipeline::Result<std::string> hint();
    void showMe();

    lessons::Progress progress(int page) const;
    double points(int page) const;
    double pointsSoFar() const;
    double pointsOf() const;  // of the pages with a point to their name so far
    LessonResults& results() { return m_results; }

signals:
    void pageChanged();                                  // another page, its end, or none
    void filled();                                       // texts() are there
    void changed();                                      // a try, a hint, or the question is settled
    void showViews(const lessons::WindowState& window);  // how the half that is open looks at its scene
    void failed(const pipeline::Errors& errors);

private:
    const lessons::Half& half() const;
    void fill();
    void keep();

    Document& m_document;
    LessonResults m_results;
    const lessons::Lesson* m_lesson = nullptr;
    int m_page = 0;
    std::optional<lessons::Attempt> m_attempt;
    std::optional<PageTexts> m_texts;
    QElapsedTimer m_since;
    BackgroundJob m_job;
};

// The points of a page with this progress; what a right answer to it gives.
double pointsOf(const lessons::Page& page, const lessons::Progress& progress);
double fullPoints(const lessons::Page& page);

}  // namespace app
