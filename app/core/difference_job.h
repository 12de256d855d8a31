#pragma once
#include <optional>

#include "app/core/background_job.h"
#include "pipeline/inspect/compare.h"

namespace app {

// How two buffers differ, found off the GUI thread where that takes its time. The last answer is kept: asking the same
// again costs nothing.
class DifferenceJob : public QObject {
    Q_OBJECT
public:
    // What is asked; as compareBuffers takes it.
    struct Question {
        pipeline::AnyBuffer a, b;
        int channel = -1;
        pipeline::DifferenceMetric metric = pipeline::DifferenceMetric::Error;
        std::vector<bool> drawnA, drawnB;
    };

    explicit DifferenceJob(QObject* parent = nullptr);

    // At once where the buffers are small. Else ready() follows, and until then the answer for the same buffers of the
    // frame before, or nothing.
    std::optional<pipeline::BufferDifference> answer(const Question& question);
    bool busy() const { return m_job.busy(); }
    void cancel();  // what runs, until something else is asked
    void retry();   // what was cancelled
    bool wasCancelled() const { return m_cancelled; }
    double share() const { return m_share; }  // of what runs, 0 to 1

signals:
    void ready();
    void progressed();  // or cancelled

private:
    void start();

    bool m_cancelled = false;
    double m_share = 0;
    std::optional<Question> m_asked;  // the newest
    std::optional<pipeline::BufferDifference> m_answer;
    BackgroundJob m_job;
};

}  // namespace app
