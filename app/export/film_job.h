#pragma once
#include <QStringList>
#include <filesystem>

#include "app/jobs/thread_job.h"
#include "pipeline/export/film/film.h"

namespace app {

// The contents of a film, by places that are valid in any frame.
struct FilmOrder {
    pipeline::BufferName buffer{pipeline::BufferId::Color};
    pipeline::StepLevel level = pipeline::StepLevel::Polygon;
    pipeline::Place from, to;
    int pictures = 120, milliseconds = 100;
    bool captions = true;
    bool algorithm = false;
    std::filesystem::path target;  // a file that ends in .gif, or a folder
};
// From before the first step of the buffer's stage to the stage's end.
FilmOrder filmOf(const pipeline::BufferName& buffer);
// "shadescope film pyramid.scene --buffer z_view --by polygon --pictures 120 -o film": the same film as a command, with
// the words of ChangedSettings.
QString filmCommand(const pipeline::Scene& scene, const QStringList& changes, const FilmOrder& order);

// Writes a film on a thread of its own. One job, one film.
class FilmJob : public ThreadJob {
    Q_OBJECT
public:
    FilmJob(std::shared_ptr<const pipeline::Scene> scene, FilmOrder order, QObject* parent = nullptr);

signals:
    void progressed(double share);
    void finished(const pipeline::FilmSummary& summary);
    void failed(const pipeline::Errors& errors);
};

}  // namespace app
