#include "pipeline/compare/handed_in/picture_sample.h"

#include <algorithm>

namespace pipeline::foreign {

namespace {

std::vector<std::size_t> spread(std::size_t pixels, std::size_t most) {
    std::vector<std::size_t> out(std::min(pixels, most));
    for (std::size_t i = 0; i < out.size(); ++i) {
        const std::size_t j = std::min(i, out.size() - 1 - i);
        const std::size_t at = j * (pixels - 1) / std::max<std::size_t>(1, out.size() - 1);
        out[i] = i == j ? at : pixels - 1 - at;
    }
    return out;
}

// The elements of an array of pixels, so many numbers each.
template <class Number>
std::vector<Number> picked(const std::vector<Number>& from, std::size_t width, std::size_t channels,
                           const PictureSample& sample) {
    std::vector<Number> out;
    out.reserve(sample.rows.size() * sample.columns.size() * channels);
    for (const std::size_t y : sample.rows)
        for (const std::size_t x : sample.columns) {
            const auto first = from.begin() + std::ptrdiff_t((y * width + x) * channels);
            out.insert(out.end(), first, first + std::ptrdiff_t(channels));
        }
    return out;
}

}  // namespace

PictureSample::PictureSample(std::size_t width, std::size_t height, std::size_t mostColumns, std::size_t mostRows)
    : columns(spread(width, mostColumns)), rows(spread(height, mostRows)) {}

NumberFile PictureSample::of(const NumberFile& picture) const {
    NumberFile out{picture.name, picture.shape, {}, picture.kind, picture.digits, picture.nan, picture.infinite};
    out.shape[0] = rows.size(), out.shape[1] = columns.size();
    out.values = picked(picture.values, picture.columns(), picture.channels(), *this);
    return out;
}

Values PictureSample::of(const Values& picture) const {
    return {picture.domain,
            rows.size(),
            columns.size(),
            picture.channels,
            picked(picture.numbers, picture.columns, std::size_t(picture.channels), *this),
            picked(picture.there, picture.columns, 1, *this)};
}

std::vector<std::uint8_t> PictureSample::of(const std::vector<std::uint8_t>& pixels, std::size_t width) const {
    return picked(pixels, width, 1, *this);
}

ReadingContext PictureSample::of(const ReadingContext& context) const {
    ReadingContext out{.view = scaled(context.view, double(columns.size()) / double(context.width),
                                      double(rows.size()) / double(context.height)),
                       .sampleShift = context.sampleShift,
                       .opensPlanes = context.opensPlanes,
                       .iMax = context.iMax,
                       .covered = of(context.covered, context.width),
                       .width = columns.size(),
                       .height = rows.size(),
                       .ofShadowBuffers = context.ofShadowBuffers,
                       .background = context.background};
    if (!context.unrounded.empty()) out.unrounded = picked(context.unrounded, context.width, 3, *this);
    return out;
}

View scaled(View view, double x, double y) {
    view.scale = {view.scale.x * x, view.scale.y * y}, view.centre = {view.centre.x * x, view.centre.y * y};
    return view;
}

}  // namespace pipeline::foreign
