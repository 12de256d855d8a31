#include "app/bug_game/bug_round.h"

#include <QRegularExpression>
#include <utility>

#include "app/frames/stage_buffer.h"
#include "app/look/text.h"

namespace app {

using lessons::WrongPicture;
using pipeline::BufferName;

BugRound::BugRound(QObject* parent) : QObject(parent) {
    connect(&m_job, &BackgroundJob::busyChanged, this, &BugRound::changed);
}

void BugRound::begin(std::uint64_t seed, std::size_t number) {
    if (number == 0) m_score.total = m_score.solved = 0;
    m_score.seed = seed, m_score.number = number, m_score.isOwn = false;
    compute([=] { return lessons::makeRiddle(seed, number); });
}

void BugRound::begin(std::shared_ptr<const pipeline::Scene> scene, pipeline::Defect defect) {
    m_score.isOwn = true;
    compute([scene = std::move(scene), defect, seed = m_score.seed]() -> pipeline::Result<lessons::Riddle> {
        return lessons::ownRiddle(scene, defect, seed);
    });
}

void BugRound::compute(const std::function<pipeline::Result<lessons::Riddle>()>& riddle) {
    using Made = std::pair<std::shared_ptr<WrongPicture>, QString>;
    m_game.reset();
    m_turn.error.clear();
    m_job.ask(
        [riddle](const BackgroundJob::Control& control) -> Made {
            auto made = riddle();
            if (!made) return {nullptr, toQString(format(made.errors()))};
            std::shared_ptr<WrongPicture> game = WrongPicture::begin(std::move(made).value(), control.stop);
            if (game && !lessons::worstPixel(*game->right(), *game->wrong()))
                return {nullptr, tr("This error does not change this scene's picture. Choose another one.")};
            return {std::move(game), {}};
        },
        [this](const Made& made) {
            m_turn = {};
            m_turn.error = made.second;
            m_game = made.first;
            emit begun();
            if (!m_game) return void(emit changed());
            // The picture's own text is free: somebody who does not see the picture reads it.
            run([](WrongPicture& one) { return toQString(one.look(BufferName{pipeline::BufferId::Color})); },
                [this](const QString& text) { say(text); });
        });
    emit changed();
}

// An answer takes a while with many pixels.
void BugRound::run(std::function<QString(WrongPicture&)> work, std::function<void(const QString&)> done) {
    if (!m_game || m_job.busy()) return;
    m_job.ask([game = m_game, work = std::move(work)](const BackgroundJob::Control&) { return work(*game); },
              [this, done = std::move(done)](const QString& text) {
                  done(text);
                  emit changed();
              });
}

void BugRound::say(const QString& text) {
    m_text = text.trimmed();
    emit said(m_text);
}

void BugRound::look(const BufferName& buffer) {
    run([buffer](WrongPicture& game) { return toQString(game.look(buffer)); },
        [this, buffer](const QString& text) {
            m_turn.opened = buffer;
            say(text);
            emit bufferOpened();
        });
}

void BugRound::look(glm::ivec2 pixel) {
    run([pixel](WrongPicture& game) { return toQString(game.look(pixel)); },
        [this, pixel](const QString& text) {
            m_turn.lookedAt = pixel;
            say(text);
            emit pixelLookedAt();
        });
}

bool BugRound::lookAt(const QString& columnAndRow) {
    static const QRegularExpression kPair(QStringLiteral(R"(^\s*(\d+)\s*[, ;]\s*(\d+)\s*$)"));
    if (!m_game) return false;
    const auto found = kPair.match(columnAndRow);
    const pipeline::Settings& settings = m_game->wrong()->scene().settings;
    const glm::ivec2 pixel(found.captured(1).toInt(), found.captured(2).toInt());
    if (!found.hasMatch() || pixel.x >= settings.width || pixel.y >= settings.height) {
        say(tr("The picture has %1 × %2 pixels; type the column and the row, as 12, 40.")
                .arg(settings.width)
                .arg(settings.height));
        return false;
    }
    look(pixel);
    return true;
}

void BugRound::lookAtStage(int stage) {
    if (!m_game) return;
    const BufferName name = mainBuffer(pipeline::kStages[std::size_t(stage)], m_game->wrong()->scene());
    if (m_game->wrong()->buffer(name)) return look(name);
    say(toQString(name.text() + ": " + m_game->wrong()->whyAbsent(name)));
}

void BugRound::mark(int box) {
    if (!isIn(Phase::Stage) || m_game->isCleared(box)) return;
    m_turn.marked = box;
    emit changed();
}

void BugRound::accuse() {
    if (!isIn(Phase::Stage) || m_turn.marked < 0) return;
    run(
        [box = m_turn.marked](WrongPicture& game) {
            const WrongPicture::Answer answer = game.mark(box);
            return (answer.isRight ? QString() : tr("Not %1. ").arg(toQString(lessons::boxLabel(box)))) +
                   toQString(answer.why);
        },
        [this](const QString& text) {
            m_turn.marked = -1;
            m_turn.verdict = text.section('\n', 0, 0);
            say(text);
            if (isIn(Phase::Cause)) emit stageFound();
        });
}

void BugRound::name(int cause) {
    if (!isIn(Phase::Cause) || m_game->isExcluded(std::size_t(cause))) return;
    m_turn.cause = cause;
    emit changed();
}

void BugRound::nameCause() {
    if (!isIn(Phase::Cause) || m_turn.cause < 0) return;
    run(
        [cause = std::size_t(m_turn.cause)](WrongPicture& game) {
            const WrongPicture::Answer answer = game.name(cause);
            return answer.isRight ? toQString(game.reveal()) : toQString(answer.why);
        },
        [this](const QString& text) {
            m_turn.cause = -1;
            m_turn.verdict = isIn(Phase::Over) ? QString() : text.section('\n', 0, 0);
            say(text);
            if (!isIn(Phase::Over)) return;
            m_score.total += m_game->points(), ++m_score.solved;
            m_turn.worst = lessons::worstPixel(*m_game->right(), *m_game->wrong());
            emit revealed();
        });
}

void BugRound::giveHint() {
    if (!m_game || isIn(Phase::Over)) return;
    run([](WrongPicture& game) { return toQString(game.hint()); },
        [this](const QString& text) { say(text.isEmpty() ? tr("There is no other hint.") : text); });
}

void BugRound::next() {
    if (isIn(Phase::Over)) begin(m_score.seed, m_score.number + 1);
}

void BugRound::proceed() {
    if (!m_game) return;
    switch (m_game->phase()) {
        case Phase::Stage: return accuse();
        case Phase::Cause: return nameCause();
        case Phase::Over: return next();
    }
}

}  // namespace app
