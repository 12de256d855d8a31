#pragma once
#include <QList>
#include <QWidget>

namespace app {

// The order of Tab in a window, as one reads: upper parts before lower ones, and within a part that no horizontal line
// divides, left before right. So each column of panels is read to its end.
QList<QWidget*> tabOrder(const QWidget& window);

// The next one, or the one before, from `now`; nothing where `now` is none of them.
QWidget* nextInTabOrder(const QWidget& window, QWidget* now, bool forward);

// Gives the next one the focus and scrolls to it. False if none of them has the focus, as when the one that had it has
// just been hidden; then Qt chooses.
bool focusNext(const QWidget& window, bool forward);

}  // namespace app
