#pragma once
#include <QApplication>

namespace app {

// The program's event loop. If an operation runs out of memory, it is dropped and MemoryNotice says so; unsaved work is
// kept. Enter presses a push button or a tool button that has the focus. Labels show plain text unless they ask for
// Qt::RichText: texts come from files, and Qt would guess their format.
class Application : public QApplication {
public:
    using QApplication::QApplication;
    bool notify(QObject* receiver, QEvent* event) override;
};

}  // namespace app
