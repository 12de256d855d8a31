#pragma once
#include <QString>
#include <optional>

#include "app/jobs/background_job.h"
#include "lessons/derived_buffer.h"

namespace app {

// Computes one derived buffer of the newest requested frame, off the GUI thread.
class DerivedJob : public QObject {
    Q_OBJECT
public:
    explicit DerivedJob(QObject* parent = nullptr);

    // Repeating the last request costs nothing. Running rays continue if they are valid for the new frame too.
    void ask(const pipeline::FramePtr& frame, const pipeline::BufferName& name, const lessons::DerivedRecipe& recipe);
    void cancel();  // stops until ask() asks for something else
    void retry();   // restarts after cancel()
    void forget();

    // The newest result; it may lag behind the frame. Empty before the first, and if the buffer cannot be computed.
    const std::optional<lessons::DerivedBuffer>& made() const { return m_made; }
    // The reason if there is no result, one sentence. Empty if there is one or it is on its way.
    const QString& why() const { return m_why; }
    const pipeline::Errors& errors() const { return m_errors; }  // errors in the recipe
    bool busy() const { return m_job.busy(); }
    bool wasCancelled() const { return m_cancelled; }
    double share() const { return m_share; }  // progress of the rays, 0 to 1

signals:
    void changed();

private:
    struct Question {
        pipeline::FramePtr frame;
        pipeline::BufferName name{pipeline::BufferId::Mix};
        lessons::DerivedRecipe recipe;
        bool operator==(const Question&) const = default;
    };
    void start();
    void refuse(const QString& why, pipeline::Errors errors = {});

    std::optional<Question> m_asked;
    std::optional<lessons::DerivedBuffer> m_made;
    QString m_why;
    pipeline::Errors m_errors;
    bool m_cancelled = false;
    double m_share = 0;
    // The newest rays; used by the job's thread only.
    std::shared_ptr<std::shared_ptr<const lessons::KnownRays>> m_rays;
    BackgroundJob m_job;
};

}  // namespace app
