#pragma once
#include <functional>

#include "app/core/document.h"
#include "lessons/question.h"

namespace app {

// Tells what somebody picks of a scene: what is selected in a view, and of a pixel its polygon and that one's object.
class PickWatch : public QObject {
    Q_OBJECT
public:
    using Took = std::function<void(const lessons::Thing& thing)>;
    PickWatch(Document& document, QObject* parent, Took took);

private:
    void takePixel();
    void takeSelection();

    Document& m_document;
    Took m_took;
};

}  // namespace app
