#include "app/frames/stepper.h"

#include <algorithm>
#include <array>

#include "app/jobs/free_in_background.h"
#include "app/look/text.h"

namespace app {

using pipeline::Moment;
using pipeline::Place;

namespace {

constexpr int kTickMs = 33;
// Steps a second at speed 1, per level: what the eye can follow, finer steps faster, lines as fast as they are read.
constexpr std::array<double, pipeline::kStepLevelCount> kStepsPerSecond{1, 2, 4, 30, 60, 2};

}  // namespace

Stepper::Stepper(QObject* parent) : QObject(parent) {
    m_timer.setInterval(kTickMs);
    connect(&m_timer, &QTimer::timeout, this, &Stepper::tick);
    m_count.setSingleShot(true);
    m_count.setInterval(150);
    connect(&m_count, &QTimer::timeout, this, &Stepper::request);
    connect(&m_job, &BackgroundJob::busyChanged, this, &Stepper::busyChanged);
}

void Stepper::setWhole(pipeline::FramePtr whole) {
    m_whole = std::move(whole);
    if (!m_whole) {
        m_job.forget();
        m_timer.stop(), m_count.stop();
        m_steps.reset(), m_place.reset(), m_bookmarks.clear();
        m_waiting = 0;
        emit changed();
        return;
    }
    if (isInside())
        request();
    else
        m_count.start();
}

void Stepper::request() {
    m_count.stop();
    if (!m_whole) return;
    const auto find = [this, whole = m_whole, at = m_place](const BackgroundJob::Control& control) {
        if (!m_counted || m_counted->frame() != whole) m_counted = std::make_shared<const pipeline::Steps>(whole);
        Answer answer{m_counted, nullptr};
        if (at) answer.shown = freedInBackground(m_counted->frameAt(m_counted->momentOf(*at), 0, control.stop));
        return answer;
    };
    // What is being found may finish, so that pictures come while the scrubber is dragged.
    m_job.ask(
        find, [this](const Answer& answer) { take(answer); }, BackgroundJob::Running::Finish);
}

void Stepper::take(const Answer& answer) {
    const bool counted = m_steps != answer.steps;
    m_steps = answer.steps;
    if (counted && m_waiting != 0) step(std::exchange(m_waiting, 0));
    if (answer.shown && isInside()) emit shown(answer.shown);
    if (counted) emit changed();
}

std::optional<Moment> Stepper::moment() const {
    if (!m_steps) return std::nullopt;
    return m_steps->momentOf(m_place.value_or(Place{m_stage}));
}

bool Stepper::isLeftOut() const { return isInside() && m_steps && !m_steps->runs(m_place->stage); }

bool isStillDrawing(const Stepper& stepper) {
    using pipeline::StageId;
    if (!stepper.isInside()) return false;
    const auto at = stepper.moment();
    if (!at) return stepper.place()->stage <= StageId::ZBuffer;
    return *at < Moment{StageId::ZBuffer, stepper.steps()->total(StageId::ZBuffer)};
}

QString Stepper::words() const {
    if (isLeftOut()) return tr("%1, left out").arg(toQString(stageInfo(m_place->stage).label));
    const auto at = moment();
    return at ? toQString(m_steps->words(*at, m_level)) : QString();
}

void Stepper::goTo(const Place& place) {
    m_place = place;
    request();
    emit stageReached(place.stage);
    emit changed();
}

void Stepper::goTo(Moment moment) {
    if (!m_steps) return;
    if (moment >= m_steps->last()) return toLast();
    goTo(m_steps->placeOf(moment));
}

void Stepper::leave() {
    if (!isInside()) return;
    m_timer.stop();
    m_place.reset();
    emit left();
    emit changed();
}

void Stepper::setStage(pipeline::StageId stage) {
    m_stage = stage;
    if (!isInside()) emit changed();
}

void Stepper::toLast() {
    leave();
    emit stageReached(pipeline::StageId::Shading);
}

bool Stepper::canStep(int direction) const {
    if (!m_whole) return false;
    if (!m_steps) return direction < 0 || m_stage != pipeline::StageId::Shading;
    if (isInside() && direction > 0) return true;  // at least to the whole frame
    return direction > 0 ? *moment() < m_steps->last() : *moment() > m_steps->first();
}

void Stepper::step(int direction) {
    if (!m_steps) {  // comes as soon as they are counted
        m_waiting = direction;
        return request();
    }
    const auto to = direction > 0 ? m_steps->next(*moment(), m_level) : m_steps->previous(*moment(), m_level);
    if (to) goTo(*to);
}

void Stepper::toFirst() {
    Place start{pipeline::StageId::Transform};
    start.what = Place::What::Start;
    goTo(start);
}

void Stepper::setLevel(Level level) {
    if (level == m_level) return;
    m_level = level;
    emit changed();
}

void Stepper::setShowsAlgorithm(bool shows) {
    if (std::exchange(m_showsAlgorithm, shows) != shows) emit changed();
}

void Stepper::setPlaying(bool playing) {
    if (playing == isPlaying() || (playing && !m_whole)) return;
    if (playing) {
        if (!isInside()) toFirst();  // from the end again from the beginning
        m_due = 1;
        m_timer.start();
    } else {
        m_timer.stop();
    }
    emit changed();
}

void Stepper::setSpeed(double speed) {
    m_speed = std::clamp(speed, 0.25, 16.0);
    emit changed();
}

void Stepper::setStop(const QObject* who, std::optional<Moment> moment) {
    moment ? (void)m_stops.insert_or_assign(who, *moment) : (void)m_stops.erase(who);
}

void Stepper::setHeld(const QObject* who, bool held) { held ? (void)m_held.insert(who) : (void)m_held.erase(who); }

void Stepper::tick() {
    if (!m_steps || !m_held.empty()) return;
    m_due += m_speed * kStepsPerSecond[std::size_t(m_level)] * kTickMs / 1000;
    std::optional<Moment> to;
    for (; m_due >= 1; --m_due)
        if (const auto next = m_steps->next(to.value_or(*moment()), m_level)) to = next;
    if (!to) return;
    const QObject* whose = nullptr;
    for (const auto& [who, moment] : m_stops)
        if (moment > *this->moment() && moment <= *to) to = moment, whose = who;
    if (!whose) return goTo(*to);
    m_timer.stop();
    goTo(*to);
    emit stopped(whose);
}

int Stepper::bookmarkHere() const {
    const auto at = moment();
    for (std::size_t i = 0; at && isInside() && i < m_bookmarks.size(); ++i)
        if (m_steps->momentOf(m_bookmarks[i]) == *at) return int(i);
    return -1;
}

void Stepper::toggleBookmark() {
    if (!isInside() || !m_steps) return;
    if (const int here = bookmarkHere(); here >= 0) {
        m_bookmarks.erase(m_bookmarks.begin() + here);
    } else {
        m_bookmarks.push_back(*m_place);
        std::ranges::sort(m_bookmarks, {}, [this](const Place& place) { return m_steps->momentOf(place); });
    }
    emit changed();
}

void Stepper::setBookmarks(std::vector<pipeline::Place> bookmarks) {
    m_bookmarks = std::move(bookmarks);
    emit changed();
}

}  // namespace app
