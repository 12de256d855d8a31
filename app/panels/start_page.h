#pragma once
#include <QWidget>

#include "app/core/scene_gallery.h"

class QGridLayout;
class QScrollArea;
class QVBoxLayout;

namespace app {

class CardGrid;

// What the window shows before a scene is open: files, lessons, and the scenes that come with
// the program as pictures that the pipeline has just computed.
class StartPage : public QWidget {
    Q_OBJECT
public:
    // One lesson as its card shows it.
    struct LessonEntry {
        QString name, title, text, progress;  // name: what lessonChosen gives
        int page = 0, pages = 0;              // page 0: not begun
    };

    explicit StartPage(QWidget* parent = nullptr);

    void setLessons(const std::vector<LessonEntry>& lessons);
    void refreshRecent();
    void setDropHint(bool over);  // a file hangs over the window

signals:
    void openRequested();
    void fileChosen(const QString& file);
    void recentChosen(const QString& file);
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

    SceneGallery m_gallery;
    QWidget* m_left = nullptr;
    QVBoxLayout* m_recent = nullptr;
    QWidget* m_lessonHead = nullptr;
    CardGrid* m_lessons = nullptr;
    CardGrid* m_scenes = nullptr;
    class DropField* m_drop = nullptr;
};

}  // namespace app
