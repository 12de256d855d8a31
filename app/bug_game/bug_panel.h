#pragma once
#include <QWidget>
#include <array>

#include "app/bug_game/bug_round.h"

namespace app {

class BugBox;
class BugCard;
class BugPictures;

// The wrong picture: a game in a window of its own. Somebody looks at buffers and pixels of a frame with a planted
// error, marks the first wrong stage, and names the cause. It can be played by the keys alone, and from its texts
// alone.
class BugPanel : public QWidget {
    Q_OBJECT
public:
    explicit BugPanel(QWidget* parent = nullptr);

    BugRound& round() { return m_round; }
    // The window's scene, for a picture of one's own; null: none is open.
    void setOpenScene(std::function<std::shared_ptr<const pipeline::Scene>()> open) { m_open = std::move(open); }

signals:
    void lessonAsked(const QString& lesson, const QString& heading);

protected:
    void showEvent(QShowEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* makeBoxes();
    void addShortcuts();
    void showBoxes();
    void setPicture();

    BugRound m_round;
    std::function<std::shared_ptr<const pipeline::Scene>()> m_open = [] { return nullptr; };
    std::array<BugBox*, lessons::kBoxes> m_boxes{};
    BugPictures* m_pictures;
    BugCard* m_card;
};

}  // namespace app
