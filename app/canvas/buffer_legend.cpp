#include "app/canvas/buffer_legend.h"

#include <algorithm>
#include <map>

#include "app/look/numbers.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "pipeline/stages/cull.h"

namespace app {

using pipeline::AnyBuffer;
using pipeline::BufferId;
using pipeline::Frame;
using pipeline::Palette;

namespace {

QColor toColor(pipeline::Color8 c) { return {c.r, c.g, c.b}; }

}  // namespace

std::vector<LegendEntry> legendOf(const Frame& frame, const AnyBuffer& buffer, const std::vector<bool>& drawn) {
    std::vector<LegendEntry> legend;
    std::map<int, int> counts;
    std::visit(
        [&](const auto& numbers) {
            for (std::size_t i = 0; i < numbers.size();) {
                std::size_t end = i + 1;  // neighbours are often equal
                while (end < numbers.size() && numbers[end] == numbers[i]) ++end;
                const auto place = [](std::size_t at) { return std::ptrdiff_t(at); };
                const auto among = drawn.empty()
                                       ? std::ptrdiff_t(end - i)
                                       : std::count(drawn.begin() + place(i), drawn.begin() + place(end), true);
                if (numbers[i] >= 0 && among > 0) counts[int(numbers[i])] += int(among);
                i = end;
            }
        },
        buffer.data);
    const Palette palette = buffer.info->palette;
    double total = 0;
    for (const auto& [value, count] : counts) total += count;
    for (const auto& [value, count] : counts) {
        LegendEntry entry{toColor(paletteColor(palette, value, 0, 1)), Qt::NoBrush, {}};
        if (palette == Palette::Verdict) {
            const auto verdict = pipeline::Verdict(value);
            entry.hatch = hatchOfVerdict(pipeline::letter(verdict));
            entry.text =
                QString("%1 %2, %3").arg(QChar(pipeline::letter(verdict)), toQString(name(verdict))).arg(count);
        } else if (palette == Palette::ShadowVerdict) {
            entry.hatch = value == 2 ? Qt::BDiagPattern : value == 3 ? Qt::Dense6Pattern : Qt::NoBrush;
            entry.text = QString("%1, %2 %").arg(valueText(buffer, value), number(100.0 * count / total, 2));
        } else if (palette == Palette::Truth) {
            entry.text = QString(value == 0 ? "0 does not hold, %1" : "1 holds, %1").arg(count);
        } else {
            entry.text = QString::number(value);
            const auto& objects = frame.scene().objects;
            if (buffer.info->id == BufferId::ObjectId && std::size_t(value) < objects.size())
                entry.text += ' ' + onOneLine(objects[std::size_t(value)].name);
        }
        legend.push_back(entry);
    }
    return legend;
}

}  // namespace app
