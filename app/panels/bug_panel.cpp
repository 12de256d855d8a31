#include "app/panels/bug_panel.h"

#include <QAccessible>
#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QRegularExpression>
#include <QShortcut>
#include <algorithm>
#include <chrono>
#include <utility>

#include "app/core/stage_buffer.h"
#include "app/core/text.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/bug_box.h"
#include "app/panels/math_view.h"

namespace app {

using lessons::WrongPicture;
using Phase = WrongPicture::Phase;
using pipeline::BufferName;

namespace {

// Four digits, to be told in a class.
std::uint64_t seedOfNow() {
    const auto now = std::uint64_t(std::chrono::system_clock::now().time_since_epoch().count());
    return 1000 + now / 1000 % 9000;
}

}  // namespace

BugPanel::~BugPanel() = default;

void BugPanel::begin(std::uint64_t seed, std::size_t number) {
    using Made = std::pair<std::shared_ptr<WrongPicture>, QString>;
    if (number == 0) m_total = m_solved = 0;
    m_seed = seed, m_number = number;
    m_game.reset();
    m_error.clear();
    m_job.ask(
        [seed, number](const BackgroundJob::Control& control) -> Made {
            auto riddle = lessons::makeRiddle(seed, number);
            if (!riddle) return {nullptr, toQString(format(riddle.errors()))};
            return {std::shared_ptr<WrongPicture>(WrongPicture::begin(std::move(riddle).value(), control.stop)), {}};
        },
        [this](const Made& made) {
            m_error = made.second;
            take(made.first);
        });
    showState();
}

void BugPanel::take(std::shared_ptr<WrongPicture> game) {
    m_game = std::move(game);
    m_marked = m_cause = -1;
    m_cursor.reset(), m_lookedAt.reset(), m_buffer.reset();
    m_verdict.clear();
    m_share = 0.5;
    fillBuffers();
    showPicture();
    if (!m_game) return showState();
    // The picture's own text is free: it is what somebody reads who does not see it.
    run([](WrongPicture& one) { return toQString(one.look(BufferName{pipeline::BufferId::Color})); },
        [this](const QString& text) { say(text); });
    m_picture->setFocus();
}

// What a game is asked takes a while with many pixels. Nothing else is asked meanwhile.
void BugPanel::run(std::function<QString(WrongPicture&)> work, std::function<void(const QString&)> done) {
    if (!m_game || m_job.busy()) return;
    m_job.ask([game = m_game, work = std::move(work)](const BackgroundJob::Control&) { return work(*game); },
              [this, done = std::move(done)](const QString& text) {
                  done(text);
                  showState();
              });
}

void BugPanel::say(const QString& text) {
    m_text->setPlainText(text.trimmed());
    QAccessibleEvent alert(m_text, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

QString BugPanel::said() const { return m_text->toPlainText(); }

void BugPanel::look(const BufferName& buffer) {
    run([buffer](WrongPicture& game) { return toQString(game.look(buffer)); },
        [this, buffer](const QString& text) {
            m_buffer = buffer;
            say(text);
            showBuffer(buffer);
        });
}

void BugPanel::look(glm::ivec2 pixel) {
    run([pixel](WrongPicture& game) { return toQString(game.look(pixel)); },
        [this, pixel](const QString& text) {
            m_lookedAt = m_cursor = pixel;
            say(text);
            for (BufferCanvas* canvas : {m_picture, m_opened}) canvas->setPicked(QPoint(pixel.x, pixel.y));
        });
}

void BugPanel::lookAtText() {
    static const QRegularExpression kPair(QStringLiteral(R"(^\s*(\d+)\s*[, ;]\s*(\d+)\s*$)"));
    const auto found = kPair.match(m_pixel->text());
    if (!m_game) return;
    const pipeline::Settings& settings = m_game->wrong()->scene().settings;
    const glm::ivec2 pixel(found.captured(1).toInt(), found.captured(2).toInt());
    if (!found.hasMatch() || pixel.x >= settings.width || pixel.y >= settings.height)
        return say(tr("The picture has %1 × %2 pixels; type the column and the row, as 12, 40.")
                       .arg(settings.width)
                       .arg(settings.height));
    m_pixel->clear();
    look(pixel);
}

// Without a look, as a finger on the picture.
void BugPanel::moveCursor(QPoint by) {
    if (!m_game) return;
    if (m_game->phase() == Phase::Over) return moveWipe(0.02 * by.x());
    const pipeline::Settings& settings = m_game->wrong()->scene().settings;
    const glm::ivec2 from = m_cursor.value_or(glm::ivec2(settings.width / 2, settings.height / 2));
    m_cursor = glm::ivec2(std::clamp(from.x + by.x(), 0, settings.width - 1),
                          std::clamp(from.y + by.y(), 0, settings.height - 1));
    m_picture->setHovered(QPoint(m_cursor->x, m_cursor->y));
    m_what->setText(tr("At %1, %2. Space looks at this pixel.").arg(m_cursor->x).arg(m_cursor->y));
}

void BugPanel::showStageBuffer(int stage) {
    if (!m_game) return;
    const BufferName name = mainBuffer(pipeline::kStages[std::size_t(stage)], m_game->wrong()->scene());
    if (m_game->wrong()->buffer(name)) return look(name);
    say(toQString(name.text() + ": " + m_game->wrong()->whyAbsent(name)));
}

void BugPanel::mark(int box) {
    if (!m_game || m_game->phase() != Phase::Stage || m_game->isCleared(box)) return;
    m_marked = box;
    showState();
}

void BugPanel::accuse() {
    if (!m_game || m_game->phase() != Phase::Stage || m_marked < 0) return;
    const int box = m_marked;
    run(
        [box](WrongPicture& game) {
            const WrongPicture::Answer answer = game.mark(box);
            return (answer.isRight ? QString() : tr("Not %1. ").arg(toQString(lessons::boxLabel(box)))) +
                   toQString(answer.why);
        },
        [this](const QString& text) {
            m_marked = -1;
            m_verdict = text.section('\n', 0, 0);
            say(text);
            if (m_game->phase() == Phase::Cause)
                QMetaObject::invokeMethod(m_causes[0], qOverload<>(&QWidget::setFocus), Qt::QueuedConnection);
        });
}

void BugPanel::name(int cause) {
    if (!m_game || m_game->phase() != Phase::Cause || m_game->isExcluded(std::size_t(cause))) return;
    m_cause = cause;
    showState();
}

void BugPanel::nameCause() {
    if (!m_game || m_game->phase() != Phase::Cause || m_cause < 0) return;
    const auto cause = std::size_t(m_cause);
    run(
        [cause](WrongPicture& game) {
            const WrongPicture::Answer answer = game.name(cause);
            return answer.isRight ? toQString(game.reveal()) : toQString(answer.why);
        },
        [this](const QString& text) {
            m_cause = -1;
            m_verdict = m_game->phase() == Phase::Over ? QString() : text.section('\n', 0, 0);
            say(text);
            if (m_game->phase() != Phase::Over) return;
            m_total += m_game->points(), ++m_solved;
            showReveal();
            m_picture->setFocus();
        });
}

void BugPanel::giveHint() {
    if (!m_game || m_game->phase() == Phase::Over) return;
    run([](WrongPicture& game) { return toQString(game.hint()); },
        [this](const QString& text) { say(text.isEmpty() ? tr("There is no other hint.") : text); });
}

void BugPanel::next() {
    if (m_game && m_game->phase() == Phase::Over) begin(m_seed, m_number + 1);
}

void BugPanel::pressPrimary() {
    if (!m_game) return;
    switch (m_game->phase()) {
        case Phase::Stage: return accuse();
        case Phase::Cause: return nameCause();
        case Phase::Over: return next();
    }
}

void BugPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (!m_game && !m_job.busy()) begin(seedOfNow());
}

void BugPanel::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter: return pressPrimary();
        case Qt::Key_Space:
            if (m_cursor && m_picture->hasFocus()) return look(*m_cursor);
            break;
        case Qt::Key_Escape: close(); return;
        default: break;
    }
    QWidget::keyPressEvent(event);
}

// Digits mark a box or choose a cause; Alt with a digit goes on showing a stage, as everywhere.
void BugPanel::addShortcuts() {
    const auto on = [this](const QKeySequence& keys, auto run) {
        connect(new QShortcut(keys, this, nullptr, nullptr, Qt::WidgetWithChildrenShortcut), &QShortcut::activated,
                this, run);
    };
    for (int digit = 0; digit < lessons::kBoxes; ++digit) {
        on(QKeySequence(Qt::Key_0 + digit), [this, digit] {
            const bool causes = m_game && m_game->phase() == lessons::WrongPicture::Phase::Cause;
            if (causes && digit >= 1 && digit <= int(m_causes.size()))
                return m_causes[std::size_t(digit - 1)]->setChecked(true);
            if (!causes) mark(digit);
        });
        if (digit > 0)
            on(QKeySequence(Qt::ALT | Qt::Key(Qt::Key_0 + digit)), [this, digit] { showStageBuffer(digit - 1); });
    }
    on(QKeySequence(Qt::Key_H), [this] { giveHint(); });
}

}  // namespace app
