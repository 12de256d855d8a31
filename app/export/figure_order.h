#pragma once
#include <QStringList>
#include <optional>

#include "lessons/derived_buffer.h"
#include "pipeline/export/figure/figure.h"

namespace app {

// What the dialog asks for, as the options of the command `figure` say it.
struct FigureOrder {
    pipeline::BufferName buffer{pipeline::BufferId::Color};
    std::optional<pipeline::Figure::Part> part{};   // nothing: the whole buffer
    std::optional<pipeline::PaletteRange> range{};  // nothing: all that is drawn
    std::optional<glm::ivec2> pixel{};              // marked
    std::optional<QString> caption{};               // nothing: as made
    bool hasBar = true, hasGrid = false, hasEdges = false, hasScale = false, isForProjector = false;
    double width = 84, letters = 8, dotsPerInch = 300;  // mm, pt
    pipeline::FigureFormat format = pipeline::FigureFormat::Svg;
};

// The buffers that a frame must hold for it, derived buffers aside.
pipeline::BufferSet buffersFor(const FigureOrder& order);
// Leaves out what the buffer does not have: a part that reaches beyond it, a pixel outside of the part, edges in a buffer
// of texels.
void fit(FigureOrder& order, const pipeline::AnyBuffer& buffer);
// `buffer` is the order's, of the frame or derived from it, and the order fits it; `meaning` begins the caption.
pipeline::Figure figureOf(const FigureOrder& order, const pipeline::Frame& frame, pipeline::AnyBuffer buffer,
                          std::string_view meaning);

QString endingOf(pipeline::FigureFormat format);  // "svg"
// The command that writes the same file; `changes` are the words of ChangedSettings.
QString figureCommand(const pipeline::Scene& scene, const QStringList& changes, const FigureOrder& order,
                      const lessons::DerivedRecipe& recipe, const QString& file);

}  // namespace app
