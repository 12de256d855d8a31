#pragma once
#include <QObject>
#include <functional>
#include <optional>

#include "app/jobs/background_job.h"
#include "lessons/games/wrong_picture.h"

namespace app {

// A round of the wrong picture, without a widget: the game of each picture, the marked box, and the points so far. The
// game computes in the background; until it is done, other requests have no effect.
class BugRound : public QObject {
    Q_OBJECT
public:
    using Phase = lessons::WrongPicture::Phase;

    // What belongs to one picture.
    struct Turn {
        int marked = -1;                             // the box that accuse() is about
        int cause = -1;                              // that nameCause() is about
        QString verdict;                             // to the last mark or cause
        QString error;                               // why there is no picture
        std::optional<pipeline::BufferName> opened;  // the last buffer that was looked at
        std::optional<glm::ivec2> lookedAt;          // likewise the last pixel
        std::optional<glm::ivec2> worst;             // once it is over: the pixel that differs most
    };
    struct Score {
        std::uint64_t seed = 0;
        std::size_t number = 0;     // of this picture, from 0
        int total = 0, solved = 0;  // points, in pictures
        bool isOwn = false;         // the scene and the defect were chosen
    };

    explicit BugRound(QObject* parent = nullptr);

    // As many pictures as there are in a round; the same seed gives the same ones.
    void begin(std::uint64_t seed, std::size_t number = 0);
    // One picture with a scene and a defect that a teacher has chosen; the next picture is the round's again. Refuses a
    // defect that does not change the scene's picture.
    void begin(std::shared_ptr<const pipeline::Scene> scene, pipeline::Defect defect);
    const lessons::WrongPicture* game() const { return m_game.get(); }  // null until the frames are there
    bool isIn(Phase phase) const { return m_game && m_game->phase() == phase; }
    bool busy() const { return m_job.busy(); }
    const Turn& turn() const { return m_turn; }
    const Score& score() const { return m_score; }
    const QString& text() const { return m_text; }  // said last: to a look, a mark, a cause, a hint, or the reveal

    void look(const pipeline::BufferName& buffer);
    void look(glm::ivec2 pixel);
    bool lookAt(const QString& columnAndRow);  // "12, 40"; false: no pixel, and says so
    void lookAtStage(int stage);               // from 0: its main buffer
    void mark(int box);
    void accuse();         // in the phase of stages
    void name(int cause);  // chosen for nameCause()
    void nameCause();      // in the phase of causes
    void giveHint();
    void next();     // once it is over
    void proceed();  // accuse, name the cause, or go to the next picture, as the phase has it
    void say(const QString& text);

signals:
    void begun();    // with another picture, or without one
    void changed();  // anything that can be shown
    void said(const QString& text);
    void bufferOpened();
    void pixelLookedAt();
    void stageFound();  // the causes come
    void revealed();

private:
    void compute(const std::function<pipeline::Result<lessons::Riddle>()>& riddle);
    void run(std::function<QString(lessons::WrongPicture&)> work, std::function<void(const QString&)> done);

    BackgroundJob m_job;
    std::shared_ptr<lessons::WrongPicture> m_game;
    Turn m_turn;
    Score m_score;
    QString m_text;
};

}  // namespace app
