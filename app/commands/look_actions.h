#pragma once
#include <QObject>
#include <QTimer>

namespace app {

class Actions;

// The window's theme and its text size.
class LookActions : public QObject {
    Q_OBJECT
public:
    LookActions(QWidget& window, Actions& actions);

private:
    void addThemes(Actions& actions);
    void addTextSizes(Actions& actions);
    void growText(double by);

    QTimer m_grows;       // while it runs, steps of the text size are added up
    double m_growth = 0;  // that is still to come
};

}  // namespace app
