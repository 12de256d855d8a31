#pragma once
#include <array>

#include <QTimer>
#include <QWidget>

#include "app/document/document.h"
#include "app/frames/stage_status.h"

namespace app {

class StageCard;
class FrameCard;

// The pipeline from left to right, and at the end the frame as a whole.
class StageStrip : public QWidget {
    Q_OBJECT
public:
    explicit StageStrip(Document& document, QWidget* parent = nullptr);

    void setCompact(bool compact);
    StageCard& card(pipeline::StageId stage) { return *m_cards[index(stage)]; }

private:
    void showStage();
    void showFrame();
    void showStandings();

    Document& m_document;
    std::array<StageCard*, pipeline::kStageCount> m_cards;
    FrameCard* m_frame;
    QTimer m_slow;  // work that takes longer than this shows
    QTimer m_next;  // while the scene moves
};

// Number, time and size of the frame.
class FrameCard : public QWidget {
    Q_OBJECT
public:
    explicit FrameCard(QWidget* parent = nullptr);

    void setStatus(const std::optional<FrameStatus>& status);
    void setCompact(bool compact);
    void setBusy(bool busy);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void fit();

    std::optional<FrameStatus> m_status;
    bool m_compact = false, m_busy = false;
};

}  // namespace app
