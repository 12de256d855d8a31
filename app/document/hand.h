#pragma once
#include <QObject>
#include <QString>

#include "app/frames/scene_step.h"
#include "lessons/lesson.h"

namespace app {

class Document;

// What a page of a lesson lets the user move in its pictures, and what follows it: the words beside it, and the play. A
// drag and a key are one step of undo each. Moves that the scene cannot have change nothing.
class Hand : public QObject {
    Q_OBJECT
public:
    explicit Hand(Document& document);

    // What is open: half a page, to whose values restore() goes back.
    struct Page {
        lessons::Half half{};
        std::vector<std::string> free{};  // keys of the settings that its question leaves to the user
        bool keepsFigure = false;         // one of its halves has a figure, whose place is kept on both
        bool isSettled = true;            // its question, if it has one
    };
    void take(const Page& page);
    void letGo();  // of all: there is nothing to move any more

    const Page& page() const { return m_page; }
    const lessons::Held& held() const { return m_page.half.held; }
    const std::vector<pipeline::Hold>& holds() const { return held().holds; }
    bool isEmpty() const { return holds().empty() && !held().play && !held().spot && !m_page.keepsFigure; }
    // Nothing where it is behind the eye, or has no place in the picture. As pipeline::placeOf says it.
    std::optional<pipeline::HoldPlace> placeOf(std::size_t hold) const;
    std::optional<pipeline::HoldPlace> ownPlaceOf(std::size_t hold) const;  // on the page, before the user moved it
    QString words(std::size_t hold) const;                                  // its value
    const QString& shown() const { return m_shown; }  // what the page shows of the newest frame; may be empty
    double value(std::size_t hold) const;             // of its first setting
    bool isPlayed() const { return m_played; }        // the play's condition has been true on this page
    // Whether settings whose keys begin so may be moved in a view: all, where no page says what may.
    bool allows(std::string_view beginning) const;
    bool isHeld(std::string_view key) const;  // whether a grip sets this setting
    // The object that a drag of its surface moves; nothing: none.
    std::optional<std::size_t> holdOfObject(std::size_t object) const;
    std::optional<std::size_t> holdOfEye() const;

    // A drag. Places as valuesAt() takes them.
    void begin(std::size_t hold, glm::dvec2 at);
    void moveTo(glm::dvec2 at, bool coarse);
    void end();
    void cancel();  // back to where it began
    bool isDragging() const { return m_start != nullptr; }

    void nudge(std::size_t hold, glm::ivec2 by, bool coarse);  // by a key: to the right, downwards
    void restore(std::size_t hold);

signals:
    void insideAsked();  // the instruments around the picture, or the picture alone again
    void taken();        // other things can be moved, or none
    void changed();      // places, words, or isPlayed()

private:
    enum class Moves { Live, Done };
    void set(const pipeline::Assignments& assignments, Moves moves);
    void follow();

    Document& m_document;
    Page m_page;
    QString m_shown;
    bool m_played = false, m_hasFrame = false;  // of the page, or of what the user has made of it
    ScenePtr m_start;                           // while it is dragged: the scene at its beginning
    std::size_t m_dragged = 0;
    glm::dvec2 m_from{0.0};
};

}  // namespace app
