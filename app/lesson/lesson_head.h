#pragma once
#include <QWidget>

#include "app/lesson/lesson_run.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace app {

// The progress of a lesson, one segment per page: filled if done; the open page is half filled, and ringed until its
// question is settled.
class PageSegments : public QWidget {
    Q_OBJECT
public:
    PageSegments(const LessonRun& run, QWidget* parent);
    void showPages();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const LessonRun& m_run;
};

// Above a page: the way back to all lessons, the lesson's name, Only this, close; its pages and points. Quiet, the way back
// is an arrow, and Only this stands in a menu with the handout.
class LessonHead : public QWidget {
    Q_OBJECT
public:
    LessonHead(const LessonRun& run, QWidget* parent);
    void showRun();
    void setQuiet(bool quiet);
    QToolButton& onlyThis() { return *m_only; }

signals:
    void leaveAsked();  // to all lessons, or to one's own scene
    void handoutAsked();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void makeMenu();
    void fitTitle();

    const LessonRun& m_run;
    bool m_isQuiet = false;
    QPushButton* m_all;
    QLabel *m_title, *m_whole, *m_place, *m_points;
    QToolButton *m_only, *m_more, *m_close;
    PageSegments* m_segments;
};

// Below a page, always in sight: Back and Next. Quiet, it has those alone that lead somewhere.
class LessonFoot : public QWidget {
    Q_OBJECT
public:
    LessonFoot(LessonRun& run, QWidget* parent);
    void showRun();
    void setQuiet(bool quiet);
    void takeFocus();  // Next

private:
    LessonRun& m_run;
    bool m_isQuiet = false;
    QPushButton *m_back, *m_next;
    QLabel* m_why;
};

}  // namespace app
