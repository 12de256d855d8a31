#pragma once
#include <QStringList>
#include <QWidget>
#include <functional>

#include "app/core/document.h"
#include "app/panels/lesson_shelf.h"
#include "lessons/attempt.h"

class QLabel;
class QListView;
class QScrollArea;
class QStackedWidget;
class QToolButton;

namespace app {

class ErrorList;
class ProseView;
class QuestionCard;

// A page of a lesson, and the window set to it; the list of lessons while none is open.
class LessonPanel : public QWidget {
    Q_OBJECT
public:
    explicit LessonPanel(Document& document, QWidget* parent = nullptr);

    // Asked before another scene takes the place of the one on show; where it says no, the panel stays as it is.
    void setMayLeave(std::function<bool()> mayLeave) { m_mayLeave = std::move(mayLeave); }

    const LessonShelf& shelf() const { return *m_shelf; }
    // Opens a lesson where it was left, from its beginning when it was read to its end. False when
    // there is none of that name, or the scene on show is to stay.
    bool open(const QString& name);
    // One that did not come with the program, by its folder, which is its name then.
    bool openOwn(lessons::Lesson lesson);
    void goTo(int page);  // from 0; within the open lesson
    void close();         // back to the list

    const lessons::Lesson* lesson() const { return m_lesson; }  // null when none is open
    int page() const { return m_page; }                         // from 0

signals:
    void showBuffers(const QStringList& names);  // what the page wants the views to show, in their order

private:
    QWidget* makeList();
    QWidget* makePage();
    bool mayShow(const lessons::Page& page) const;
    void showPage(int page);
    void setWindow();  // to the page on show
    void takeFrame();  // fills the page's numbers in once the frame of its own scene is there
    void check(const QString& typed);
    const lessons::Page& current() const { return m_lesson->pages[std::size_t(m_page)]; }

    Document& m_document;
    std::function<bool()> m_mayLeave = [] { return true; };
    LessonShelf* m_shelf;
    QStackedWidget* m_stack;
    ErrorList* m_errors;
    QListView* m_list = nullptr;
    QLabel* m_place = nullptr;
    QToolButton *m_previous = nullptr, *m_next = nullptr;
    QScrollArea* m_scroll = nullptr;
    ProseView *m_heading = nullptr, *m_text = nullptr;
    QuestionCard* m_question = nullptr;

    const lessons::Lesson* m_lesson = nullptr;  // of the shelf
    int m_page = 0;
    std::optional<lessons::Attempt> m_attempt;  // at the page's question
    pipeline::FramePtr m_pageFrame;             // of the page's own scene; null until it is there
};

}  // namespace app
