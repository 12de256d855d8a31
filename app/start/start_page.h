#pragma once
#include <QWidget>
#include <functional>

#include "app/start/start_shelf.h"

class QComboBox;
class QPushButton;
class QVBoxLayout;

namespace app {

class StartLine;

// What the window shows before a scene is open: files and tools at the left; by lecture the scenes, as pictures that the
// pipeline has just computed, and the lessons.
class StartPage : public QWidget {
    Q_OBJECT
public:
    explicit StartPage(QWidget* parent = nullptr);

    void setLessons(const std::vector<StartLesson>& lessons) { m_shelf->setLessons(lessons); }
    // icon: of resources/icons. run gets the line, for a menu below it.
    void addTool(const QString& icon, const QString& text, const QString& tip,
                 const std::function<void(QWidget& line)>& run);
    QPushButton& newButton() const { return *m_new; }
    void refreshRecent();
    void setDropHint(bool over);  // a file hangs over the window

signals:
    void openRequested();
    void fileChosen(const QString& file);
    void recentChosen(const QString& file);
    void viewChosen(const lessons::WindowState& state);
    void lessonChosen(const QString& name);
    void talkChosen(const QString& file);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeLeft();
    QWidget* makeButtons(QWidget* left);
    void makeThemes(QWidget* left);
    void fit();
    void fitLeft(const StartFit& fit);
    void refreshTalks();

    QWidget *m_left = nullptr, *m_slogan = nullptr, *m_themes = nullptr;
    QVBoxLayout *m_column = nullptr, *m_recent = nullptr, *m_tools = nullptr, *m_right = nullptr;
    QPushButton* m_new = nullptr;
    QComboBox* m_themeList = nullptr;
    QList<StartLine*> m_lines;  // of recent files
    StartShelf* m_shelf = nullptr;
    class DropField* m_drop = nullptr;
};

}  // namespace app
