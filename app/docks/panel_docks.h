#pragma once
#include <QObject>

#include "app/docks/panel_dock.h"
#include "app/docks/panel_table.h"

class QMainWindow;
class QToolBar;

namespace app {

// The window's docks, one for each row of the table of panels, and the rail from which they open.
class PanelDocks : public QObject {
    Q_OBJECT
public:
    PanelDocks(QMainWindow& window, Document& document, ViewArea& views);

    const Panels& panels() const { return m_panels; }
    PanelDock& operator[](PanelId id) const { return *m_all[int(id)]; }
    const QList<PanelDock*>& all() const { return m_all; }      // in the table's order
    const QList<PanelDock*>& left() const { return m_left; }    // from top to bottom
    const QList<PanelDock*>& sides() const { return m_sides; }  // the left ones, then the right ones
    QToolBar& rail() const { return *m_rail; }

    void showSetting(const QString& key);  // in the panel of settings, in front
    void putBack();                        // all in their first places, none floating
    // Why a panel is hidden until a question is answered; empty if it is not.
    QString whyHidden(PanelId id) const;
    void enable(bool hasScene);  // the actions that show panels

private:
    void tab();

    QMainWindow& m_window;
    Document& m_document;
    Panels m_panels;
    QToolBar* m_rail;
    QList<PanelDock*> m_left, m_sides, m_all;  // each a part of the next
};

}  // namespace app
