#pragma once
#include <QObject>

class QKeyEvent;
class QWidget;

namespace app {

class LessonFoot;
class LessonRun;
class QuestionCard;

// The keys of a lesson: they work in its panel and in the views beside it. They come before those of the window and its
// menus.
class LessonKeys : public QObject {
    Q_OBJECT
public:
    LessonKeys(QWidget& panel, LessonRun& run, QuestionCard& card, LessonFoot& foot);

    // The lesson's keys work there too: it is where the page's pictures are.
    void takeKeysOf(QWidget& views) { m_views = &views; }
    void pageShown();    // the page gets the keyboard focus once its texts are filled in
    void pageFilled();   // gives the focus to a page that waits for it
    void waitForNone();  // the end of a lesson is shown instead of a page

protected:
    bool eventFilter(QObject* to, QEvent* event) override;

private:
    bool takes(const QKeyEvent& event) const;
    void press(const QKeyEvent& event);

    QWidget& m_panel;
    LessonRun& m_run;
    QuestionCard& m_card;
    LessonFoot& m_foot;
    QWidget* m_views = nullptr;
    bool m_pageWaits = false;  // for its texts
    bool m_gripWaits = false;  // for the focus, until it is shown
};

}  // namespace app
