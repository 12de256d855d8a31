#pragma once
#include <QLabel>
#include <QTimer>

namespace app {

// Over a talk: how to go on and how to leave, or all keys. It goes with the next key or after some seconds.
class TalkHint : public QLabel {
    Q_OBJECT
public:
    TalkHint(bool hasCues, QWidget* parent);

    void showKeys();

signals:
    void changed();  // its size

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QTimer m_time;  // from when it is first seen, which on a slow machine is late
};

}  // namespace app
