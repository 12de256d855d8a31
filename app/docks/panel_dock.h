#pragma once
#include <QDockWidget>

class QHBoxLayout;

namespace app {

struct PanelRow;

// A dock in the window's look: a surface with round corners and a heading by which it is moved.
class PanelDock : public QDockWidget {
    Q_OBJECT
public:
    // Its toggleViewAction() brings it to the front, and closes it where it is there.
    PanelDock(const PanelRow& row, QWidget* content, QWidget* parent);

    const PanelRow& row() const { return m_row; }
    // Neither hidden nor behind another tab.
    bool isInFront() const;
    // Buttons at the right of the heading.
    void addButton(QAction* action, const QString& icon);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void toggle();

    const PanelRow& m_row;
    QHBoxLayout* m_heading;
};

}  // namespace app
