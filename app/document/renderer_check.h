#pragma once
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <map>
#include <memory>
#include <optional>

#include "app/document/renderer_files.h"
#include "app/document/renderer_watch.h"
#include "app/frames/scene_step.h"
#include "app/jobs/background_job.h"
#include "pipeline/compare/handed_in/convention_choices.h"

namespace app {

class WorkList;

// Somebody else's renderer: its files, compared with the window's scene beside it, and again whenever the files
// or the scene change. What its stages are comes first, the names of known errors follow.
class RendererCheck : public QObject {
    Q_OBJECT
public:
    using ReportPtr = std::shared_ptr<const pipeline::foreign::Report>;
    enum class Work : unsigned char { None, Stages, Names };

    explicit RendererCheck(WorkList& work);
    ~RendererCheck() override;

    void begin(ScenePtr scene) { m_scene = std::move(scene); }  // another scene; setScene() follows
    void setScene(ScenePtr scene);                              // compared again soon

    // A folder, or files. What runs is stopped; conventions that were stated by hand are forgotten.
    void open(const QStringList& paths);
    void close();
    bool isOpen() const { return !m_paths.isEmpty(); }
    const QStringList& paths() const { return m_paths; }
    QString name() const;  // "mine/", "depth.npy", "3 files"
    // While nobody looks, changes of files and scene are remembered and nothing is compared.
    void setFollowed(bool followed);
    // How much of the report may be shown, as `compare --hints` has it; 3 to begin with.
    void setGiven(int hints);
    // For the stages' cards: the report, while somebody looks at it and its stages are given away. Else null.
    ReportPtr shownStages() const { return m_followed && m_given >= 1 ? m_report : nullptr; }
    void readAgain();
    void cancel();

    // The newest; null before the first, and where the files could not be compared. It may lag behind the scene.
    const ReportPtr& report() const { return m_report; }
    // Why there is none; files that could not be read beside others that could stand in the report.
    const pipeline::Errors& errors() const { return m_errors; }
    Work work() const { return m_work; }
    // Of the names: how many known errors have been tried, of how many.
    std::pair<std::size_t, std::size_t> tried() const;
    bool wasCancelled() const { return m_cancelled; }
    QString readAt() const { return m_readAt; }  // "14:02:31", empty before the first

    // How the files are read, by the keys of mine.toml; compared again at once. An empty value: as it is found.
    void state(const std::string& key, const std::string& value);
    const pipeline::foreign::StatedByHand& byHand() const { return m_byHand; }

    // A buffer that was handed in, in the type of `like`; the same for one report. Nothing where it was not handed in.
    std::optional<pipeline::AnyBuffer> buffer(const pipeline::AnyBuffer& like) const;
    QString whyNo(const pipeline::BufferName& buffer) const;

signals:
    void changed();   // anything of it
    void compared();  // report() or errors() are those of other files, or of another scene
    void opened();    // other files; the report follows

private:
    struct Kept;
    struct Progress;
    void compareSoon();
    void compare();
    void ask(bool names);
    void take(const std::shared_ptr<const pipeline::Result<pipeline::foreign::Report>>& result, bool names);

    ScenePtr m_scene;
    QStringList m_paths;
    int m_given = 3;
    bool m_followed = false, m_missed = false, m_cancelled = false;
    pipeline::foreign::StatedByHand m_byHand;
    std::shared_ptr<Kept> m_kept;  // of the scene; of the job's thread alone
    std::shared_ptr<Progress> m_progress;
    RendererWatch m_watch;
    QTimer m_soon;
    ReportPtr m_report;
    pipeline::Errors m_errors;
    QString m_readAt;
    Work m_work = Work::None;
    mutable std::map<std::string, pipeline::AnyBuffer> m_buffers;  // of m_report
    BackgroundJob m_job;
};

}  // namespace app
