#pragma once
#include <QStackedWidget>

namespace app {

// A stack that takes the room of the page on show: those that are not may need more, and another room after every theme.
class FittingStack : public QStackedWidget {
public:
    explicit FittingStack(QWidget* parent) : QStackedWidget(parent) {
        connect(this, &QStackedWidget::currentChanged, this, [this] { updateGeometry(); });
    }
    QSize sizeHint() const override {
        return currentWidget() ? currentWidget()->sizeHint() : QStackedWidget::sizeHint();
    }
    QSize minimumSizeHint() const override {
        return currentWidget() ? currentWidget()->minimumSizeHint() : QStackedWidget::minimumSizeHint();
    }
};

}  // namespace app
