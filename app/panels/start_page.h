#pragma once
#include <QWidget>

#include "app/panels/start_shelf.h"

class QLabel;
class QVBoxLayout;

namespace app {

// What the window shows before a scene is open: files, and by lecture the lessons and the scenes that
// come with the program, as pictures that the pipeline has just computed.
class StartPage : public QWidget {
    Q_OBJECT
public:
    using LessonEntry = StartShelf::LessonEntry;

    explicit StartPage(QWidget* parent = nullptr);

    void setLessons(const std::vector<LessonEntry>& lessons) { m_shelf->setLessons(lessons); }
    void refreshRecent();
    void setDropHint(bool over);  // a file hangs over the window

signals:
    void openRequested();
    void fileChosen(const QString& file);
    void recentChosen(const QString& file);
    void viewChosen(const lessons::WindowState& state);
    void lessonChosen(const QString& name);
    void keysRequested();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeLeft();
    QWidget* makeRight();
    void fitLeft();

    QWidget* m_left = nullptr;
    QVBoxLayout *m_column = nullptr, *m_recent = nullptr;  // of the left side
    QLabel* m_themeLabel = nullptr;
    StartShelf* m_shelf = nullptr;
    class DropField* m_drop = nullptr;
};

}  // namespace app
