#pragma once
#include <QObject>
#include <QTimer>
#include <functional>

namespace app {

class PanelDocks;

// Saves the theme and the places of panels a moment after each change, so that they survive a crash.
class LookKeeper : public QObject {
    Q_OBJECT
public:
    // `keepPanels` keeps the panels' places; nothing is kept while `isOther`, as in a talk, which has its own text
    // size.
    LookKeeper(QObject& window, const PanelDocks& docks, std::function<void()> keepPanels,
               std::function<bool()> isOther);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QTimer m_soon;
};

}  // namespace app
