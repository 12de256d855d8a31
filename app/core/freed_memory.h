#pragma once
#include <QObject>
#include <QTimer>

namespace app {

class Document;

// The heap keeps what a frame frees for the next one (pipeline/core/memory.h). Of the scenes that were open before, much of
// it has the wrong size: once another scene is shown and the window rests, the system gets back what is free.
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
