#pragma once
#include <optional>

#include "app/jobs/background_job.h"
#include "pipeline/inspect/compare.h"

namespace app {

// The difference of two buffers, computed off the GUI thread if it takes long. The last answer is kept, so repeating a
// question costs nothing.
class DifferenceJob : public QObject {
    Q_OBJECT
public:
    // The question, in the terms of compareBuffers.
    struct Question {
        pipeline::AnyBuffer a, b;
        int channel = -1;
        pipeline::DifferenceMetric metric = pipeline::DifferenceMetric::Error;
        std::vector<bool> drawnA, drawnB;
    };

    explicit DifferenceJob(QObject* parent = nullptr);

    // The answer at once if the buffers are small. Otherwise ready() follows; until then the answer for the same
    // buffers of the last frame, or nothing.
    std::optional<pipeline::BufferDifference> answer(const Question& question);
    bool busy() const { return m_job.busy(); }
    void cancel();  // stops until another question
    void retry();   // restarts after cancel()
    bool wasCancelled() const { return m_cancelled; }
    double share() const { return m_share; }  // progress, 0 to 1

signals:
    void ready();
    void progressed();  // also after cancel()

private:
    void start();

    bool m_cancelled = false;
    double m_share = 0;
    std::optional<Question> m_asked;  // the newest
    std::optional<pipeline::BufferDifference> m_answer;
    BackgroundJob m_job;
};

}  // namespace app
