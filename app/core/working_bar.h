#pragma once
#include <QTimer>
#include <QWidget>

namespace app {

// A bar on top of a view, once what is on its way takes longer than a moment: what stands below is of before.
class WorkingBar : public QWidget {
public:
    explicit WorkingBar(QWidget* view);
    void setWorking(bool works);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QTimer m_slow;
};

}  // namespace app
