// Where a condition begins to hold inside the frame.
#include "app/core/text.h"
#include "app/panels/condition_bar.h"

namespace app {

void ConditionBar::runToStop() {
    const Stepper& stepper = m_document.stepper();
    if (!m_condition) return;
    if (!stepper.steps()) return say(tr("The steps of the frame are being counted."), false);
    const StepsPtr steps = stepper.steps();
    const pipeline::Moment from = stepper.isInside() && stepper.moment() ? *stepper.moment() : steps->first();
    m_searchedScene = m_document.frames().shown()->sharedScene();
    m_searching.ask(
        [condition = *m_condition, steps, from](const BackgroundJob::Control& control) {
            return nextStop(*steps, from, condition, control.stop, control.progress);
        },
        [this](const std::optional<lessons::ConditionStop>& found) {
            if (!found) return say(tr("No later step makes it hold at a pixel."), false);
            m_document.stepper().goTo(found->moment);
            m_document.pointing().pick(found->pixel);
            emit m_document.said(tr("The condition holds at %1, %2.").arg(found->pixel.x).arg(found->pixel.y));
        });
}

void ConditionBar::watchPlay() {
    Stepper& stepper = m_document.stepper();
    const auto forget = [&] {
        m_watching.forget();
        m_ahead.reset();
        stepper.setStop(this, {});
        stepper.setHeld(this, false);
    };
    if (!m_condition || !stepper.isPlaying() || !stepper.steps() || !stepper.moment()) return forget();
    const pipeline::Moment now = *stepper.moment();
    const bool known = m_ahead && m_ahead->steps == stepper.steps() && m_ahead->condition == m_condition->text &&
                       now >= m_ahead->from && !(m_ahead->stop && now > m_ahead->stop->moment);
    if (known) return;
    forget();
    stepper.setHeld(this, true);
    m_ahead = Ahead{stepper.steps(), now, m_condition->text, {}};
    m_watching.ask(
        [condition = *m_condition, steps = stepper.steps(), now](const BackgroundJob::Control& control) {
            return nextStop(*steps, now, condition, control.stop, control.progress);
        },
        [this](const std::optional<lessons::ConditionStop>& found) {
            if (m_ahead) m_ahead->stop = found;
            if (found) m_stopsAt = found->pixel;
            m_document.stepper().setStop(this, found ? std::optional(found->moment) : std::nullopt);
            m_document.stepper().setHeld(this, false);
            tell();  // how many, again
        });
}

}  // namespace app
