#include "pipeline/inspect/overlay_values.h"

#include <algorithm>
#include <cmath>

#include "pipeline/run/frame_data.h"
#include "pipeline/stages/rasterize.h"

namespace pipeline {

namespace {

template <class Real>
std::vector<double> areasOf(const FrameData<Real>& data) {
    const TransformOutput<Real>& in = *data.transform;
    std::vector<double> areas;
    for (std::size_t t = 0; t < in.topology->triangles.size(); ++t) {
        const std::size_t polygon = in.topology->polygonOf(t);
        if (areas.size() <= polygon) areas.resize(polygon + 1);
        const auto& v = in.topology->triangles[t].vertices;
        setUpTriangle<Real>(in.view, {in.viewSpace(v[0]), in.viewSpace(v[1]), in.viewSpace(v[2])}, std::uint32_t(t),
                            [&](const RasterTriangle<Real>& piece) {
                                constexpr double kUnits = 2.0 * double(kSubPixels) * double(kSubPixels);
                                areas[polygon] += double(piece.snapped.area2()) / kUnits;
                            });
    }
    return areas;
}

}  // namespace

std::vector<double> screenAreas(const Frame& frame) {
    return readStages(frame, [](const auto& data) { return areasOf(data); });
}

std::vector<DepthTests> depthTests(const Frame& frame) {
    const AnyBuffer came = *frame.buffer({BufferId::Overdraw}), won = *frame.buffer({BufferId::DepthWrites});
    const auto arrivals = std::get<std::span<const std::int32_t>>(came.data);
    const auto wins = std::get<std::span<const std::int32_t>>(won.data);
    std::vector<DepthTests> tests(arrivals.size());
    for (std::size_t i = 0; i < tests.size(); ++i) {
        tests[i] = arrivals[i] == 0        ? DepthTests::None
                   : wins[i] < arrivals[i] ? DepthTests::SomeLost
                   : wins[i] == 1          ? DepthTests::OneWon
                                           : DepthTests::Overwritten;
    }
    return tests;
}

bool mayBeNegative(const BufferInfo& info, ProjectionKind projection) {
    switch (info.id) {
        case BufferId::Expression:
        case BufferId::ZNdc: return true;
        case BufferId::ZView:
        case BufferId::Depth: return projection == ProjectionKind::Orthographic;  // what lies behind the eye is seen
        default: break;
    }
    return info.palette == Palette::Diverging || info.palette == Palette::Direction || isOfNames(info);
}

StrangeNumbers strangeNumbers(const AnyBuffer& buffer, int channel, const std::vector<bool>& drawn,
                              ProjectionKind projection) {
    const auto channels = std::size_t(buffer.channels());
    const bool negativeToo = !mayBeNegative(*buffer.info, projection);
    StrangeNumbers found;
    found.elements.resize(buffer.count() / channels, Strange::No);
    std::visit(
        [&](const auto& numbers) {
            for (std::size_t i = 0; i < found.elements.size(); ++i) {
                if (!drawn.empty() && !drawn[i]) continue;
                bool nan = false, infinite = false, negative = false;
                for (std::size_t c = 0; c < channels; ++c) {
                    if (channel >= 0 && channels > 1 && c != std::size_t(channel)) continue;
                    const double value = double(numbers[i * channels + c]);
                    nan |= std::isnan(value);
                    infinite |= std::isinf(value);
                    negative |= negativeToo && value < 0;
                }
                found.nan += nan;
                found.infinite += infinite;
                found.negative += negative;
                found.elements[i] = nan        ? Strange::Nan
                                    : infinite ? Strange::Infinite
                                    : negative ? Strange::Negative
                                               : Strange::No;
            }
        },
        buffer.data);
    return found;
}

}  // namespace pipeline
