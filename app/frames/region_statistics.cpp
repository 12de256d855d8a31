#include "app/frames/region_statistics.h"

#include <QStringList>
#include <algorithm>
#include <cmath>

#include "app/look/number_format.h"
#include "app/look/numbers.h"
#include "app/look/text.h"

namespace app {

namespace {

constexpr std::size_t kMostDistinct = 500'000;  // numbers that are sorted for it: some 30 ms

QString shortest(std::optional<double> value) {
    if (!value) return QStringLiteral("–");
    return chosenText(*value).value_or(sixDigits(*value));
}

}  // namespace

RegionStatistics regionStatistics(const pipeline::AnyBuffer& buffer, const Region& region, int channel) {
    RegionStatistics result;
    const glm::ivec2 size(int(buffer.columns()), int(buffer.rows()));
    const glm::ivec2 first = glm::max(region.first(), glm::ivec2(0)), last = glm::min(region.last(), size - 1);
    std::vector<double> values;
    double mean = 0, squares = 0;
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            const double value = buffer.value(std::size_t(x), std::size_t(y), channel);
            ++result.count;
            if (std::isnan(value)) ++result.nan;
            if (std::isinf(value)) ++result.infinite;
            if (value < 0) ++result.negative;
            if (!std::isfinite(value)) continue;
            ++result.finite;
            result.min = std::min(result.min.value_or(value), value);
            result.max = std::max(result.max.value_or(value), value);
            const double before = value - mean;
            mean += before / double(result.finite);
            squares += before * (value - mean);
            if (values.size() <= kMostDistinct) values.push_back(value);
        }
    if (result.finite == 0) return result;
    result.mean = mean;
    result.deviation = std::sqrt(squares / double(result.finite));
    if (values.size() > kMostDistinct) return result;
    std::ranges::sort(values);
    result.distinct = std::size_t(std::ranges::unique(values).begin() - values.begin());
    return result;
}

QString regionText(const pipeline::AnyBuffer& buffer, const Region& region, lessons::ShownChannel channel,
                   const QStringList& names) {
    std::vector<RegionStatistics> columns;
    QStringList head{toQString(buffer.name.text())};
    for (int c = 0; c < buffer.channels(); ++c) {
        if (channel != lessons::ShownChannel::All && c != index(channel)) continue;
        columns.push_back(regionStatistics(buffer, region, c));
        head << (c < names.size() ? names[c] : QString());
    }
    QStringList lines{head.join('\t')};
    const auto line = [&](const char* name, const auto& text) {
        QString row = QString::fromUtf8(name);
        for (const RegionStatistics& column : columns) row += '\t' + text(column);
        lines << row;
    };
    using S = RegionStatistics;
    line("minimum", [](const S& s) { return shortest(s.min); });
    line("maximum", [](const S& s) { return shortest(s.max); });
    line("mean", [](const S& s) { return shortest(s.mean); });
    line("deviation", [](const S& s) { return shortest(s.deviation); });
    line("NaN", [](const S& s) { return QString::number(s.nan); });
    line("infinite", [](const S& s) { return QString::number(s.infinite); });
    line("negative", [](const S& s) { return QString::number(s.negative); });
    line("distinct", [](const S& s) {
        return s.distinct ? QString::number(*s.distinct) : s.finite ? QStringLiteral("many") : QStringLiteral("–");
    });
    const glm::ivec2 first = region.first(), extent = region.last() - first + 1;
    lines << QStringLiteral("%1 × %2 from %3, %4").arg(extent.x).arg(extent.y).arg(first.x).arg(first.y);
    return lines.join('\n');
}

}  // namespace app
