#pragma once
#include <QAbstractButton>

namespace app {

// A panel that is closed, as an upright tab at the window's edge; dashed while it may not be opened.
class EdgeTab : public QAbstractButton {
    Q_OBJECT
public:
    explicit EdgeTab(QWidget* parent);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace app
