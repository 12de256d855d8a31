#pragma once
#include <functional>

#include "app/document/document.h"
#include "lessons/questions/question.h"

namespace app {

// Reports what the user picks: the selection of a view; for a pixel, its polygon and the polygon's object.
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
