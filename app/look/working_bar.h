#pragma once
#include <QTimer>
#include <QWidget>

namespace app {

// A bar at the top of a view while its next picture takes longer than a moment. The bar is dashed if the work was
// stopped: the view then shows the previous picture.
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
