#pragma once
#include <QList>
#include <QWidget>

namespace app {

// What Tab goes through in a window, as it is read: what stands above comes before what stands below, and within what no
// line from left to right parts, what stands left before what stands right. So each column of panels is read to its end.
QList<QWidget*> tabOrder(const QWidget& window);

// The next one, or the one before, from `now`; nothing where `now` is none of them.
QWidget* nextInTabOrder(const QWidget& window, QWidget* now, bool forward);

// Gives the next one the focus and scrolls to it. False where the focus is on none of them: what had it has just been
// hidden, and Qt knows what to do.
bool focusNext(const QWidget& window, bool forward);

}  // namespace app
