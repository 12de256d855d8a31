#pragma once
#include <QWidget>
#include <vector>

#include "app/core/scene_gallery.h"
#include "app/core/start_order.h"

class QBoxLayout;
class QLabel;
class QLineEdit;

namespace app {

class CardGrid;
class Segmented;
class StartCard;
class StartViewCard;

// The scenes, views and lessons of the start page by lecture, in the order of the slides, with a filter over all of them.
class StartShelf : public QWidget {
    Q_OBJECT
public:
    // One lesson as its card shows it.
    struct LessonEntry {
        QString name, title, text, progress;  // name: what lessonChosen gives
        int page = 0, pages = 0;              // page 0: not begun
        std::string lecture{};                // its header
    };

    explicit StartShelf(QWidget* parent = nullptr);

    void setLessons(const std::vector<LessonEntry>& lessons);
    void setWatched(bool watched) { m_gallery.setWatched(watched); }
    void focusFirst();

signals:
    void fileChosen(const QString& file);
    void viewChosen(const lessons::WindowState& state);
    void lessonChosen(const QString& name);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Group {
        QWidget* heading;
        CardGrid* cards;
    };
    struct Lecture {
        QWidget* whole;
        std::vector<StartViewCard*> views;
        std::vector<Group> groups;
        Group lessons;
    };
    void addLecture(const StartLecture& lecture);
    Group makeGroup(const QString& title, QWidget* parent);
    void showPicture(std::size_t picture);
    void filter();

    SceneGallery m_gallery;
    QLineEdit* m_filter;
    Segmented* m_which;
    QLabel* m_none;
    QBoxLayout *m_columns, *m_below;  // the lectures; what belongs to none
    std::vector<Lecture> m_lectures;
    std::vector<StartCard*> m_sceneCards;  // as the gallery has them
};

}  // namespace app
