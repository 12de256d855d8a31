#pragma once
#include <QString>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/canvas/buffer_painter.h"
#include "app/canvas/palette_bar.h"
#include "pipeline/run/frame.h"

namespace app {

struct LegendEntry {
    QColor color;
    Qt::BrushStyle hatch = Qt::NoBrush;
    QString text;
};

// What is counted over all elements of a buffer.
struct ElementCounts {
    QString notice;              // "3 distinct values, 5 NaN"; what is worth telling, may be empty
    QString description;         // for a screen reader
    std::vector<int> histogram;  // from the least to the greatest value; empty where there is no range
};

// A buffer of a frame, made ready to be shown: everything a view needs that no widget decides.
struct ShownBuffer {
    pipeline::AnyBuffer buffer;
    pipeline::AnyBuffer source;  // the buffer that it is the luminance of, else the same
    BufferLook look;
    pipeline::BufferStatistics numbers;  // of the channel that is shown; none of bytes that are colours
    CanvasContent content;               // without the picked and hovered pixel
    PaletteBar::Scale scale;             // where there is a range to choose
    std::vector<LegendEntry> legend;     // where colours are names
    QString notice;                      // of the counts, and what features add
    QString empty;                       // "Nothing was drawn: …", else empty
    std::shared_ptr<const ElementCounts> counts = std::make_shared<const ElementCounts>();

    bool hasValue(QPoint pixel) const;  // else it stores what stands for none, as the checker shows
};

// What is shown, in words: "blue, before scaling".
QString captionOf(const pipeline::BufferInfo& info, lessons::ShownChannel channel);
// The channels' own names: r g b, x y z, or the three weights.
QStringList channelNames(const pipeline::BufferInfo& info);

// range: the user's; nothing for one that shows all. Gives
// nothing where the frame has no such buffer.
std::optional<ShownBuffer> showBuffer(const pipeline::Frame& frame, const pipeline::BufferName& name,
                                      lessons::ShownChannel channel, std::optional<pipeline::PaletteRange> range);

// A buffer that belongs to the picture of a frame without being one of its own: the other side of a
// comparison, or their difference. drawn: which elements hold something; empty: all. counts: taken over instead of counting.
// Incomplete when it is stopped.
ShownBuffer showBuffer(const pipeline::Frame& frame, const pipeline::AnyBuffer& buffer, const std::vector<bool>& drawn,
                       lessons::ShownChannel channel, std::optional<pipeline::PaletteRange> range,
                       const std::stop_token& stop = {}, std::shared_ptr<const ElementCounts> counts = {});

}  // namespace app
