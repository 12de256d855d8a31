#pragma once
#include <QString>
#include <optional>

#include "app/core/background_job.h"
#include "lessons/derived_buffer.h"

namespace app {

// One derived buffer, made off the GUI thread: that of the newest frame it is asked for.
class DerivedJob : public QObject {
    Q_OBJECT
public:
    explicit DerivedJob(QObject* parent = nullptr);

    // What was asked last costs nothing. Rays that run go on where they are those of the new frame too.
    void ask(const pipeline::FramePtr& frame, const pipeline::BufferName& name, const lessons::DerivedRecipe& recipe);
    void cancel();  // what runs, until ask() asks something else
    void retry();   // what was cancelled
    void forget();

    // The newest that has come; it may lag behind the frame. Nothing before the first, and where there is none.
    const std::optional<lessons::DerivedBuffer>& made() const { return m_made; }
    // Why there is none, one sentence. Empty where there is one, or it is on its way.
    const QString& why() const { return m_why; }
    const pipeline::Errors& errors() const { return m_errors; }  // what is wrong with the recipe
    bool busy() const { return m_job.busy(); }
    bool wasCancelled() const { return m_cancelled; }
    double share() const { return m_share; }  // of the rays that are cast, 0 to 1

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
    // The newest rays: only the thread of the job looks into it.
    std::shared_ptr<std::shared_ptr<const lessons::KnownRays>> m_rays;
    BackgroundJob m_job;
};

}  // namespace app
