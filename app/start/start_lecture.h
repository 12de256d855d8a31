#pragma once
#include <QWidget>
#include <map>

#include "app/start/start_fit.h"
#include "app/start/start_lessons.h"
#include "app/start/start_view_card.h"
#include "pipeline/formats/built_in_scenes.h"

class QLabel;
class QScrollArea;

namespace app {

class SceneGrid;
class StartCard;

// A lecture on the start page: its first card, its scenes in the order of the slides, and its lessons beside or below
// them. Where there is no height for all, scenes and lessons scroll on their own.
class LectureShelf : public QWidget {
    Q_OBJECT
public:
    LectureShelf(const StartLecture& lecture, const std::vector<pipeline::BuiltInScene>& scenes, QWidget* parent);

    StartViewCard& first() const { return *m_first; }
    StartLessons& lessons() const { return *m_lessons; }
    const std::map<std::string, StartCard*>& cards() const { return m_cards; }  // by their scenes' names
    void fit(const StartFit& fit, bool withTitle);
    int wantedHeight() const;  // at its width, with nothing that scrolls
    // Leaves what the typed words match. Whether there is anything.
    bool filter(const QString& typed);
    void openFirst();   // that is left
    void focusFirst();  // the same

signals:
    void sceneChosen(const std::string& name);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void place();
    int gap() const;

    QWidget* m_title;
    StartViewCard* m_first;
    SceneGrid* m_grid;
    QScrollArea* m_scenes;
    StartLessons* m_lessons;
    std::map<std::string, StartCard*> m_cards;
    StartFit m_fit;
};

}  // namespace app
