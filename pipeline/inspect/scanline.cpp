#include "pipeline/inspect/scanline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "pipeline/core/text.h"
#include "pipeline/inspect/replay.h"
#include "pipeline/run/runner.h"

namespace pipeline {
namespace {

constexpr std::array kShadings{Shading::Flat, Shading::Gouraud, Shading::Phong};

template <class Real>
void addRuns(const FrameData<Real>& data, const Stop& stop, ScanlineSection& section) {
    if (!data.zBuffer) return;
    const Tile row{{0, section.row}, {section.width, section.row + 1}};
    const std::vector<FragmentRecord> record = replayTile(data, row, stop);
    // While stepping inside the stage some of a pixel's fragments are still to come; a whole frame may not have counted.
    const Buffer2D<std::int32_t>& overdraw = data.zBuffer->overdraw;
    std::vector<std::int32_t> arrived(std::size_t(section.width), 0);
    std::vector<std::size_t> last(std::size_t(section.width), record.size());
    std::vector<bool> came(record.size());
    for (std::size_t i = 0; i < record.size(); ++i) {
        const auto x = std::size_t(record[i].pixel.x);
        came[i] = overdraw.empty() || arrived[x] < overdraw.at(record[i].pixel);
        ++arrived[x];
        if (came[i] && record[i].won) last[x] = i;
    }
    std::map<int, std::vector<ScanlineRun::Sample>> samples;
    std::vector<int> order;  // of drawing
    for (std::size_t i = 0; i < record.size(); ++i) {
        if (!came[i]) continue;
        const int polygon = int(data.transform->topology->polygonOf(record[i].triangle));
        auto& of = samples[polygon];
        if (of.empty()) order.push_back(polygon);
        of.push_back({record[i].pixel.x, record[i].depth, last[std::size_t(record[i].pixel.x)] == i});
    }
    for (const int polygon : order) {
        auto& of = samples[polygon];
        std::ranges::stable_sort(of, {}, &ScanlineRun::Sample::x);
        for (std::size_t i = 0; i < of.size(); ++i) {
            const bool begins = i == 0 || of[i].x > of[i - 1].x + 1;
            if (begins) section.runs.push_back({polygon, {}});
            section.runs.back().samples.push_back(of[i]);
        }
    }
    // A painter compares z_view, whatever format the depths of the frame would have.
    section.storesDepth = data.keys.zBuffer.visibility == Visibility::ZBuffer && !data.zBuffer->depth.empty();
    section.nearIsLarger = section.storesDepth && isReversed(data.transform->depthFormat);
    if (data.shading) section.iMax = data.shading->iMax;
}

std::vector<Vec3d> intensitiesOf(const Frame& frame, int row) {
    const auto intensity = frame.buffer({BufferId::Intensity});
    const auto polygons = frame.buffer({BufferId::PolygonId}), layers = frame.buffer({BufferId::Layers});
    if (!intensity || !polygons) return {};
    std::vector<Vec3d> values(polygons->columns(), Vec3d(std::numeric_limits<double>::quiet_NaN()));
    for (std::size_t x = 0; x < values.size(); ++x) {
        const bool hasLayers = layers && layers->value(x, std::size_t(row)) > 0;
        if (polygons->value(x, std::size_t(row)) < 0 && !hasLayers) continue;
        for (int c = 0; c < 3; ++c) values[x][c] = intensity->value(x, std::size_t(row), c);
    }
    return values;
}

// What the lines of a table say beside the intensity, each sample looked at once: rows have many pixels and polygons.
struct SectionTable {
    struct Depth {
        std::size_t column;
        double depth;
    };
    std::vector<int> polygons;               // a column each, in the order of drawing
    std::vector<std::optional<int>> winner;  // per x
    std::vector<std::vector<Depth>>
        depths;  // per x, by column; of a polygon's fragments there the first one comes first
};

SectionTable tableOf(const ScanlineSection& section) {
    SectionTable table;
    table.winner.resize(std::size_t(section.width));
    table.depths.resize(std::size_t(section.width));
    std::map<int, std::size_t> columns;
    for (const ScanlineRun& run : section.runs) {
        const auto [column, isNew] = columns.try_emplace(run.polygon, table.polygons.size());
        if (isNew) table.polygons.push_back(run.polygon);
        for (const ScanlineRun::Sample& sample : run.samples) {
            const auto x = std::size_t(sample.x);
            table.depths[x].push_back({column->second, sample.depth});
            if (sample.stays && !table.winner[x]) table.winner[x] = run.polygon;
        }
    }
    for (auto& depths : table.depths) std::ranges::stable_sort(depths, {}, &SectionTable::Depth::column);
    return table;
}

}  // namespace

std::optional<int> ScanlineSection::winnerAt(int x) const {
    for (const ScanlineRun& run : runs)
        for (const ScanlineRun::Sample& sample : run.samples)
            if (sample.x == x && sample.stays) return run.polygon;
    return std::nullopt;
}

bool ScanlineSection::isShadedAt(int x) const {
    return std::ranges::any_of(intensity, [x](const std::vector<Vec3d>& values) {
        return std::size_t(x) < values.size() && std::isfinite(values[std::size_t(x)].x);
    });
}

std::pair<int, int> ScanlineSection::extent() const {
    int first = width, last = -1;
    const auto reach = [&](int x) { first = std::min(first, x), last = std::max(last, x); };
    for (const ScanlineRun& run : runs) reach(run.samples.front().x), reach(run.samples.back().x);
    for (int x = 0; x < width; ++x)
        if (isShadedAt(x)) reach(x);
    if (last < 0) return {0, width - 1};
    return {first, last};
}

bool ScanlineSection::empty() const {
    if (!runs.empty()) return false;
    for (int x = 0; x < width; ++x)
        if (isShadedAt(x)) return false;
    return true;
}

ScanlineSection scanlineSection(const Frame& frame, int row, const Stop& stop) {
    ScanlineSection section;
    section.row = row;
    section.width = frame.scene().settings.width;
    readStages(frame, [&](const auto& data) { addRuns(data, stop, section); });
    return section;
}

std::optional<ScanlineSection> shadedSection(const FramePtr& frame, int row, int threads, Stop stop) {
    ScanlineSection section = scanlineSection(*frame, row, stop);
    if (stop.stop_requested()) return std::nullopt;
    if (frame->until() != StageId::Shading) return section;  // inside an earlier stage nothing is shaded yet
    const auto same = std::ranges::find(kShadings, frame->scene().settings.shading) - kShadings.begin();
    section.intensity[std::size_t(same)] = intensitiesOf(*frame, row);
    for (std::size_t i = 0; i < kShadings.size(); ++i) {
        if (i == std::size_t(same)) continue;
        auto scene = std::make_shared<Scene>(frame->scene());
        scene->settings.shading = kShadings[i];
        FrameRequest request;
        request.wanted = sectionBuffers();
        request.threads = threads;
        request.stop = stop;
        const FramePtr other = runFrame(std::move(scene), request, frame);
        if (!other) return std::nullopt;
        section.intensity[i] = intensitiesOf(*other, row);
    }
    return section;
}

int middleDrawnRow(const Frame& frame) {
    const int height = frame.scene().settings.height;
    const auto polygons = frame.buffer({BufferId::PolygonId});
    const auto isDrawn = [&](int row) {
        for (std::size_t x = 0; x < polygons->columns(); ++x)
            if (polygons->value(x, std::size_t(row)) >= 0) return true;
        return false;
    };
    int first = 0, last = height - 1;
    if (!polygons) return height / 2;
    while (first < height && !isDrawn(first)) ++first;
    while (last > first && !isDrawn(last)) --last;
    return first < height ? first + (last - first) / 2 : height / 2;
}

std::string sectionCsv(const ScanlineSection& section) {
    const SectionTable table = tableOf(section);
    std::string out = "x,seen";
    for (const int polygon : table.polygons)
        out += fmt::format(",{}.{}", section.storesDepth ? "depth" : "z_view", polygon);
    for (std::size_t i = 0; i < kSectionShadings.size(); ++i)
        if (!section.intensity[i].empty())
            for (const char* channel : {"r", "g", "b"}) out += fmt::format(",{}.{}", kSectionShadings[i], channel);
    out += "\r\n";
    for (int x = 0; x < section.width; ++x) {
        const std::optional<int> winner = table.winner[std::size_t(x)];
        out += fmt::format("{},{}", x, winner ? std::to_string(*winner) : std::string());
        std::size_t written = 0;  // columns
        for (const auto& [column, depth] : table.depths[std::size_t(x)]) {
            if (column < written) continue;  // a further fragment of the same polygon
            out.append(column + 1 - written, ',');
            out += shortestText(depth);
            written = column + 1;
        }
        out.append(table.polygons.size() - written, ',');
        for (const std::vector<Vec3d>& intensity : section.intensity) {
            if (intensity.empty()) continue;
            const Vec3d value = intensity[std::size_t(x)];
            for (int c = 0; c < 3; ++c)
                out += std::isfinite(value[c]) ? ',' + shortestText(value[c]) : std::string(",");
        }
        out += "\r\n";
    }
    return out;
}

}  // namespace pipeline
