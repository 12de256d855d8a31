#pragma once
#include <QObject>
#include <QTimer>

namespace app {

class Document;

// The heap keeps the memory of a freed frame for the next one (pipeline/core/memory.h). After another scene is opened,
// much of it has the wrong size. So it is returned to the system when the window rests.
class FreedMemory : public QObject {
    Q_OBJECT
public:
    explicit FreedMemory(Document& document, QObject* parent = nullptr);

signals:
    void givenBack();

private:
    void giveBack();

    bool m_due = false;  // another scene has been opened since
    QTimer m_rest;
};

}  // namespace app
