#pragma once
#include <QApplication>

namespace app {

// The program's window loop. Where something that is done in it runs out of memory, that is given up and MemoryNotice says
// so: what is open and not saved yet is kept. A label shows its text as it is, and markup only where it asks for
// Qt::RichText: texts come from files, and Qt would guess.
class Application : public QApplication {
public:
    using QApplication::QApplication;
    bool notify(QObject* receiver, QEvent* event) override;
};

}  // namespace app
