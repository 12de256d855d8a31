#pragma once
#include <QWidget>
#include <optional>
#include <vector>

#include "app/start/scene_gallery.h"
#include "app/start/start_fit.h"
#include "app/start/start_lessons.h"
#include "app/start/start_order.h"
#include "app/start/start_view_card.h"

class QBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;

namespace app {

class LectureShelf;
class Segmented;

// The scenes, first pictures and lessons of the start page by lecture, with a filter over all of them. One lecture fills
// the page; both scroll, unless they stand beside each other.
class StartShelf : public QWidget {
    Q_OBJECT
public:
    explicit StartShelf(QWidget* parent = nullptr);

    void setLessons(const std::vector<StartLesson>& lessons);
    void setTalk(std::size_t lecture, const StartTalk& talk);
    const std::vector<StartLecture>& lectures() const { return m_order; }
    void setWatched(bool watched) { m_gallery.setWatched(watched); }
    void fit(const StartFit& fit);
    void focusFirst();

signals:
    void fileChosen(const QString& file);
    void viewChosen(const lessons::WindowState& state);
    void lessonChosen(const QString& name);
    void talkChosen(const QString& file);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeTop();
    void addLecture(const StartLecture& lecture);
    void showPicture(std::size_t picture);
    void filter();
    void arrange();
    void openScene(const std::string& name);
    std::optional<std::size_t> one() const;  // the lecture that fills the page; nothing: both are shown
    LectureShelf* firstHit() const;

    SceneGallery m_gallery;
    std::vector<StartLecture> m_order;
    std::vector<StartLesson> m_allLessons;
    Segmented* m_which;
    QLineEdit* m_filter;
    QLabel* m_keys;
    QPushButton* m_none;  // clears the filter
    QScrollArea* m_area;
    QWidget* m_page;
    QBoxLayout* m_columns;
    struct Lecture {
        LectureShelf* shelf;
        bool hasHit;  // of the filter
    };
    std::vector<Lecture> m_lectures;
    StartFit m_fit;
};

}  // namespace app
