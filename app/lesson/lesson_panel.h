#pragma once
#include <QWidget>

#include "app/lesson/lesson_run.h"
#include "app/lesson/lesson_shelf.h"

class QListView;
class QScrollArea;
class QStackedWidget;

namespace app {

class ErrorList;
class HandoutButton;
class LessonEnd;
class LessonFoot;
class LessonHead;
class LessonKeys;
class LessonPage;

// A page of a lesson, and the window set to it; the list of lessons while none is open.
class LessonPanel : public QWidget {
    Q_OBJECT
public:
    explicit LessonPanel(Document& document, QWidget* parent = nullptr);

    LessonShelf& shelf() { return *m_shelf; }
    LessonRun& run() { return m_run; }
    // Opens a lesson where it was left, from its beginning when it was read to its end. False when there is none of
    // that name.
    bool open(const QString& name);
    // One that did not come with the program, by its folder, which is its name then.
    bool openOwn(lessons::Lesson lesson);
    void goTo(int page) { m_run.goTo(page); }  // from 0; within the open lesson
    void close();                              // back to the list
    void writeHandout();                       // of the open lesson; asks where to
    LessonKeys& keys() { return *m_keys; }

    const lessons::Lesson* lesson() const { return m_run.lesson(); }  // null when none is open
    int page() const { return m_run.page(); }                         // from 0
    // Whether the window hides panels that the page does not need; saved in the program's settings.
    bool isOnlyThis() const;
    void setOnlyThis(bool only);
    // Whether the page has the window to itself: a hand holds its picture, and what the page does not need is hidden.
    bool isHeld() const;
    // For the bar over the views; empty where nothing is to be clicked.
    QString banner() const;

signals:
    void opens();   // a lesson, while none is open: the scene on show is still the user's
    void closed();  // the scene on show is the lesson's
    void showViews(const lessons::WindowState& window);  // what the page wants the views to show
    void onlyThisChanged();
    void pageChanged();
    void bannerChanged();

private:
    QWidget* makeList();
    QWidget* makeLesson();
    void showPage();
    void showChange();
    void settle();
    void askToForget();

    Document& m_document;
    LessonShelf* m_shelf;
    LessonRun m_run;
    QStackedWidget* m_stack;
    ErrorList* m_errors;
    QListView* m_list = nullptr;
    QScrollArea* m_scroll = nullptr;
    LessonHead* m_head = nullptr;
    LessonPage* m_page = nullptr;
    LessonEnd* m_end = nullptr;
    LessonFoot* m_foot = nullptr;
    HandoutButton* m_handout = nullptr;
    class KeptInSight* m_sight;
    LessonKeys* m_keys = nullptr;
};

}  // namespace app
