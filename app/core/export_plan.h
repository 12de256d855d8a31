#pragma once
#include <QString>
#include <QStringList>
#include <vector>

#include "lessons/derived_buffer.h"
#include "pipeline/export/export_frame.h"

namespace app {

// A buffer in the list of what can be exported.
struct ExportRow {
    pipeline::BufferName name;
    std::uint64_t bytes = 0;  // as an array, before compression
    QString whyNot;           // why the frame does not have it, or empty
};

// Every buffer that the frame's scene can have, in the order of the stages, then the derived ones.
std::vector<ExportRow> exportRows(const pipeline::Frame& frame, const lessons::DerivedRecipe& recipe);

// "0.9 MB", "60 B".
QString sizeText(std::uint64_t bytes);

// What a shell needs quoted is quoted.
QString shellWord(const QString& word);

// The scene as a command takes it: its file, or its name.
QString sceneWord(const pipeline::Scene& scene);

// The command line that writes the same files, with the words of ChangedSettings; buffers are named only where they are
// not `allBuffers`, the names an export takes by itself, the recipe where a derived buffer needs it.
QString exportCommand(const pipeline::Scene& scene, const QStringList& changes, const pipeline::ExportRequest& request,
                      const lessons::DerivedRecipe& recipe, bool allBuffers);

// The files of the request's derived buffers, which no frame holds, at the size of the scene's picture.
std::vector<pipeline::PlannedFile> plannedDerived(const pipeline::Scene& scene, const pipeline::ExportRequest& request);

}  // namespace app
