#pragma once
#include <QObject>
#include <QTimer>

class QWidget;

namespace app {

class PenLayer;

// The mouse over a talk: the spotlight follows it, and its cursor is hidden while it rests.
class TalkPointer : public QObject {
    Q_OBJECT
public:
    TalkPointer(QWidget& talk, PenLayer& pen);
    ~TalkPointer() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showCursor();

    QWidget& m_talk;
    PenLayer& m_pen;
    QTimer m_restTime;
    bool m_isHidden = false;
};

}  // namespace app
