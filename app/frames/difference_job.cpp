#include "app/frames/difference_job.h"

#include "app/frames/buffer_place.h"
#include "app/frames/large_frame.h"

namespace app {
namespace {

// Buffers are immutable, and those that were asked about are kept: one place holds one content.
bool isSame(const DifferenceJob::Question& a, const DifferenceJob::Question& b) {
    return placeOf(a.a) == placeOf(b.a) && placeOf(a.b) == placeOf(b.b) && a.channel == b.channel &&
           a.metric == b.metric && a.drawnA == b.drawnA && a.drawnB == b.drawnB;
}

// Of other frames at most.
bool looksAlike(const DifferenceJob::Question& a, const DifferenceJob::Question& b) {
    return a.a.name == b.a.name && a.b.name == b.b.name && a.a.shape == b.a.shape && a.channel == b.channel &&
           a.metric == b.metric;
}

pipeline::BufferDifference compare(const DifferenceJob::Question& q, const pipeline::CompareControl& control = {}) {
    return compareBuffers(q.a, q.b, q.channel, q.metric, q.drawnA, q.drawnB, control);
}

}  // namespace

DifferenceJob::DifferenceJob(QObject* parent) : QObject(parent) {
    connect(&m_job, &BackgroundJob::progressed, this, [this](double share) {
        m_share = share;
        emit progressed();
    });
}

std::optional<pipeline::BufferDifference> DifferenceJob::answer(const Question& question) {
    if (m_asked && isSame(*m_asked, question)) return m_answer;
    if (!m_asked || !looksAlike(*m_asked, question)) m_answer.reset();
    m_asked = question;
    m_cancelled = false;
    if (question.a.count() <= kManyNumbers) {
        m_job.forget();
        return m_answer = compare(question);
    }
    start();
    return m_answer;
}

void DifferenceJob::start() {
    m_share = 0;
    m_job.ask(
        [question = *m_asked](const BackgroundJob::Control& control) {
            return compare(question, {control.stop, control.progress});
        },
        [this](const pipeline::BufferDifference& found) {
            m_answer = found;
            emit ready();
        });
}

void DifferenceJob::cancel() {
    if (!busy()) return;
    m_job.forget();
    m_cancelled = true;
    m_answer.reset();
    emit progressed();
}

void DifferenceJob::retry() {
    if (!m_cancelled) return;
    m_cancelled = false;
    start();
    emit progressed();
}

}  // namespace app
