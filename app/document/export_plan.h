#pragma once
#include <QString>
#include <QStringList>
#include <vector>

#include "lessons/derived_buffer.h"
#include "pipeline/export/export_frame.h"

namespace app {

// A buffer in the list of exportable buffers.
struct ExportRow {
    pipeline::BufferName name;
    std::uint64_t bytes = 0;  // as an array, before compression
    QString whyNot;           // the reason if the frame does not have it
};

// All buffers that the frame's scene can have, in the order of the stages, then the derived ones.
std::vector<ExportRow> exportRows(const pipeline::Frame& frame, const lessons::DerivedRecipe& recipe);

// "0.9 MB", "60 B".
QString sizeText(std::uint64_t bytes);

// Quoted if a shell needs it.
QString shellWord(const QString& word);

// The scene as an argument of a command: its file, or its name.
QString sceneWord(const pipeline::Scene& scene);

// --where and --mix with the recipe, if one of the buffers is derived after it.
QStringList recipeWords(const std::vector<pipeline::BufferName>& buffers, const lessons::DerivedRecipe& recipe);

// The command line that writes the same files, with the words of ChangedSettings. It names the buffers unless they are
// `allBuffers`, the default of an export, and gives the recipe if a derived buffer needs it.
QString exportCommand(const pipeline::Scene& scene, const QStringList& changes, const pipeline::ExportRequest& request,
                      const lessons::DerivedRecipe& recipe, bool allBuffers);

// The files of the request's derived buffers, which are in no frame, in the size of the scene's picture.
std::vector<pipeline::PlannedFile> plannedDerived(const pipeline::Scene& scene, const pipeline::ExportRequest& request);

}  // namespace app
