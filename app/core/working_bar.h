#pragma once
#include <QTimer>
#include <QWidget>

namespace app {

// A bar on top of a view, once what is on its way takes longer than a moment, and dashed where that has been stopped: what
// stands below is of before.
class WorkingBar : public QWidget {
public:
    explicit WorkingBar(QWidget* view);
    void setWorking(bool works);
    void setStopped(bool stopped);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void showState();

    bool m_works = false, m_stopped = false;
    QTimer m_slow;
};

}  // namespace app
