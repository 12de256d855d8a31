#pragma once
#include <QObject>

class QMainWindow;

namespace app {

class Actions;
class StatusLine;
class ViewArea;
class WindowLayout;

// The layouts of panels and views that have a name: those of the program, and the user's own.
class Layouts : public QObject {
    Q_OBJECT
public:
    Layouts(QMainWindow& window, Actions& actions, ViewArea& views, WindowLayout& layout, StatusLine& status);

    void applyKept(const QString& name);

signals:
    void applied();

private:
    void addNamed(Actions& actions);
    void addKeptMenu(const Actions& actions);
    void apply(const char* arrangement, bool thumbnails);
    void keepThis();
    void reset();

    QMainWindow& m_window;
    ViewArea& m_views;
    WindowLayout& m_layout;
    StatusLine& m_status;
};

}  // namespace app
