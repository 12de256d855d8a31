#include "pipeline/inspect/compare.h"
#include "pipeline/core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pipeline {

namespace {

using Metric = DifferenceMetric;

constexpr std::string_view kDifferenceName = "difference";
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// What values are, and what keeps them.
struct DifferenceData {
    BufferInfo info;
    std::vector<double> values;
};

bool isSame(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

BufferInfo infoOf(const BufferInfo& a, Metric metric) {
    BufferInfo info = a;
    info.name = kDifferenceName;
    info.element = Element::Real;
    info.channels = 1;
    info.perLight = false;
    if (isOfNames(a)) {
        info.meaning = "1 where the two are not the same.";
        info.unit = "";
    } else {
        info.meaning = metricTable()[std::size_t(metric)].words;
        if (metric != Metric::Error && metric != Metric::Absolute) info.unit = "";
    }
    info.palette = metric == Metric::Error && !isOfNames(a) ? Palette::Diverging : Palette::Sequential;
    info.neutral = 0;
    return info;
}

// Goes over the elements of two buffers of any types.
struct Comparer {
    BufferDifference& found;
    std::vector<double>& values;
    int channel;
    std::size_t channels;
    Metric metric;
    bool names;
    const std::vector<bool>&drawnA, &drawnB;
    const CompareControl& control;

    // Looked after now and then: it costs more than an element.
    bool goesOn(std::size_t i) const {
        constexpr std::size_t kOften = std::size_t{1} << 18;
        if (i % kOften != 0) return true;
        if (control.progress) control.progress(double(i) / double(values.size()));
        return !control.stop.stop_requested();
    }

    template <class A, class B>
    void operator()(std::span<const A> a, std::span<const B> b) {
        std::optional<std::size_t> firstOneSided;
        double sum = 0;
        for (std::size_t i = 0; i < values.size() && goesOn(i); ++i) {
            const bool inA = drawnA.empty() || drawnA[i], inB = drawnB.empty() || drawnB[i];
            if (!inA && !inB) continue;
            if (!found.drawn.empty()) found.drawn[i] = true;
            bool differs = inA != inB, oneSided = inA != inB;
            double largest = 0;
            for (std::size_t c = 0; c < channels && !oneSided; ++c) {
                if (channel >= 0 && c != std::size_t(channel)) continue;
                const double x = double(a[i * channels + c]), y = double(b[i * channels + c]);
                if (isSame(x, y)) continue;
                differs = true;
                if (!std::isfinite(x) || !std::isfinite(y))
                    oneSided = true;
                else if (const double e = names ? 1 : difference(metric, x, y); std::abs(e) > std::abs(largest))
                    largest = e;
            }
            found.differing += differs;
            values[i] = oneSided ? kNone : largest;
            if (oneSided) {
                ++found.oneSided;
                if (!firstOneSided) firstOneSided = i;
                continue;
            }
            ++found.compared;
            sum += std::abs(largest);
            if (std::abs(largest) > found.largest) {
                found.largest = std::abs(largest);
                found.worst = i;
            }
        }
        if (found.compared > 0) found.mean = sum / double(found.compared);
        if (!found.worst) found.worst = firstOneSided;
    }
};

// Where a pixel of the frame shows a polygon. Empty: everywhere, as in a picture, which has its background.
std::vector<bool> drawnPixels(const Frame& frame, const BufferInfo& info) {
    const bool isPicture = info.palette == Palette::Color && info.stage == StageId::Shading;
    if (info.domain != Domain::Pixel || isPicture) return {};
    const auto polygons = frame.buffer({BufferId::PolygonId});
    if (!polygons) return {};
    const auto ids = std::get<std::span<const std::int32_t>>(polygons->data);
    std::vector<bool> drawn(ids.size());
    std::transform(ids.begin(), ids.end(), drawn.begin(), [](std::int32_t id) { return id >= 0; });
    return drawn;
}

std::string shapeText(const AnyBuffer& buffer) {
    if (buffer.info->domain == Domain::Vertex) return fmt::format("{} vertices", buffer.rows());
    if (buffer.info->domain == Domain::Polygon) return plural(std::int64_t(buffer.rows()), "polygon");
    std::string text = fmt::format("{} × {}", buffer.columns(), buffer.rows());
    if (buffer.channels() > 1) text += fmt::format(" × {}", buffer.channels());
    return text;
}

}  // namespace

std::span<const MetricInfo, kMetricCount> metricTable() {
    static constexpr std::array<MetricInfo, kMetricCount> kTable{{
        {Metric::Error, "E", "error", "A − B"},
        {Metric::Absolute, "AE", "absolute error", "|A − B|"},
        {Metric::Squared, "SE", "squared error", "(A − B)²"},
        {Metric::RelativeAbsolute, "RAE", "relative absolute error", "|A − B| / max(|A|, |B|)"},
        {Metric::RelativeSquared, "RSE", "relative squared error", "(A − B)² / max(A², B²)"},
    }};
    return kTable;
}

double difference(DifferenceMetric metric, double a, double b) {
    const double e = a - b, scale = std::max(std::abs(a), std::abs(b));
    switch (metric) {
        case Metric::Error: return e;
        case Metric::Absolute: return std::abs(e);
        case Metric::Squared: return e * e;
        case Metric::RelativeAbsolute: return scale > 0 ? std::abs(e) / scale : 0;
        case Metric::RelativeSquared: return scale > 0 ? (e / scale) * (e / scale) : 0;
    }
    return e;
}

std::string whyNotComparable(const AnyBuffer& a, const AnyBuffer& b) {
    const bool same = a.info->domain == b.info->domain && a.channels() == b.channels() && a.shape == b.shape;
    return same ? std::string() : fmt::format("A is {}, B is {}.", shapeText(a), shapeText(b));
}

BufferDifference compareBuffers(const AnyBuffer& a, const AnyBuffer& b, int channel, DifferenceMetric metric,
                                const std::vector<bool>& pixelsA, const std::vector<bool>& pixelsB,
                                const CompareControl& control) {
    const std::vector<bool> rowsA = rowsWithValue(a), rowsB = rowsWithValue(b);
    const std::vector<bool>& drawnA = rowsA.empty() ? pixelsA : rowsA;
    const std::vector<bool>& drawnB = rowsB.empty() ? pixelsB : rowsB;
    const auto channels = std::size_t(a.channels());
    const std::size_t elements = a.count() / channels;
    auto data = std::make_shared<DifferenceData>(DifferenceData{infoOf(*a.info, metric), {}});
    data->values.resize(elements);

    BufferDifference found;
    if (!drawnA.empty() && !drawnB.empty()) found.drawn.resize(elements);
    std::visit(Comparer{found, data->values, a.channels() > 1 ? channel : -1, channels, metric, isOfNames(*a.info),
                        drawnA, drawnB, control},
               a.data, b.data);
    found.values = {a.name, &data->info, a.shape, std::span<const double>(data->values), nullptr};
    if (channels > 1) found.values.shape.pop_back();
    found.values.owner = std::move(data);
    return found;
}

bool isDifference(const BufferInfo& info) { return info.name == kDifferenceName; }

namespace {

StageDifference stageDifference(const Frame& a, const AnyBuffer& other, const std::vector<bool>& drawnInOther) {
    const AnyBuffer mine = *a.buffer(other.name);
    StageDifference row{.buffer = mine.name, .elements = mine.count() / std::size_t(mine.channels())};
    row.why = whyNotComparable(mine, other);
    if (!row.why.empty()) return row;
    const BufferDifference found =
        compareBuffers(mine, other, -1, Metric::Absolute, drawnPixels(a, *mine.info), drawnInOther);
    row.differing = found.differing, row.oneSided = found.oneSided;
    row.largest = found.largest, row.worst = found.worst;
    return row;
}

}  // namespace

StageDifference stageDifference(const Frame& a, const Frame& b, const BufferName& name) {
    return stageDifference(a, *b.buffer(name), drawnPixels(b, bufferInfo(name.id)));
}

StageDifference stageDifference(const Frame& a, const AnyBuffer& b) {
    return stageDifference(a, b, drawnPixels(a, *b.info));
}

}  // namespace pipeline
