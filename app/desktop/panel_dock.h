#pragma once
#include <QDockWidget>

class QHBoxLayout;

namespace app {

// A dock in the window's look: a surface with round corners and a heading by which it is moved.
class PanelDock : public QDockWidget {
    Q_OBJECT
public:
    // Its toggleViewAction() brings it to the front, and closes it where it is there.
    // icon: of resources/icons, for the rail and the heading's buttons.
    PanelDock(const QString& title, const QString& icon, QWidget* content, QWidget* parent);

    const QString& iconName() const { return m_icon; }
    // Neither hidden nor behind another tab.
    bool isInFront() const;
    // Buttons at the right of the heading.
    void addButton(QAction* action, const QString& icon);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void toggle();

    QString m_icon;
    QHBoxLayout* m_heading;
};

}  // namespace app
