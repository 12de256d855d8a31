#include <algorithm>
#include <cmath>

#include "pipeline/buffers/palette.h"
#include "pipeline/compare/report/compare_html.h"

namespace pipeline::foreign {

namespace {

glm::ivec2 sizeOf(const Values& values) { return {int(values.columns), int(values.rows)}; }

// Both renderers' numbers in one range.
PaletteRange rangeOf(const Values& values, const BufferInfo& info) {
    if (info.palette == Palette::Direction) return {-1, 1};
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (std::size_t i = 0; i < values.count(); ++i)
        if (values.there[i])
            for (int c = 0; c < values.channels; ++c)
                low = std::min(low, values.at(i)[c]), high = std::max(high, values.at(i)[c]);
    if (!(low < high)) return {0, 1};
    if (info.palette == Palette::Color) return {0, high};
    if (info.palette == Palette::Diverging) return {-std::max(-low, high), std::max(-low, high)};
    return {low, high};
}

std::uint8_t byte(double share) { return std::uint8_t(std::lround(255 * std::clamp(share, 0.0, 1.0))); }

Buffer2D<Color8> pictureOf(const Values& values, const BufferInfo& info, PaletteRange range) {
    Buffer2D<Color8> out(sizeOf(values), Color8(0));
    for (std::size_t i = 0; i < values.count(); ++i) {
        if (!values.there[i]) continue;
        const double* const v = values.at(i);
        Color8& pixel = out.pixels[i];
        if (info.id == BufferId::Color)
            for (int c = 0; c < 3; ++c) pixel[c] = byte(v[c] / 255);
        else if (values.channels == 3)
            for (int c = 0; c < 3; ++c) pixel[c] = byte((v[c] - range.first) / (range.last - range.first));
        else
            pixel = paletteColor(info.palette, v[0], range.first, range.last);
    }
    return out;
}

}  // namespace

PicturePair picturesOf(const Report& report, const Finding& finding) {
    const BufferInfo& info = bufferInfo(finding.name.buffer.id);
    const Values& right = report.reference->values.at(finding.name.buffer.text());
    const PaletteRange range = rangeOf(right, info);
    return {pictureOf(report.fileOf(finding).mine, info, range), pictureOf(right, info, range)};
}

Buffer2D<Color8> differencePicture(const Report& report, const Finding& finding) {
    const Values& mine = report.fileOf(finding).mine;
    const Values& right = report.reference->values.at(finding.name.buffer.text());
    const Measure measure = toleranceOf(finding.name.buffer.id)->measure;
    Buffer2D<Color8> out(sizeOf(right), Color8(255));
    const double largest = finding.largest > 0 ? finding.largest : 1;
    for (std::size_t i = 0; i < right.count(); ++i) {
        if (!mine.there[i] && !right.there[i]) continue;
        const double d = differenceAt(measure, mine, right, i);
        if (d == 0) continue;
        out.pixels[i] = std::isnan(d) ? classColor(mine.there[i] ? Class::Extra : Class::Missing)
                                      : paletteColor(Palette::Sequential, d, 0, largest);
    }
    return out;
}

Color8 classColor(Class of) {
    switch (of) {
        case Class::Tolerated: return {0xB5, 0xCB, 0xE0};
        case Class::Allowed: return {0x5B, 0x8F, 0xC4};
        case Class::Wrong: return {0xC4, 0x47, 0x1B};
        case Class::Missing: return {0x33, 0x2A, 0x5E};
        case Class::Extra: return {0xF0, 0xDC, 0x4E};
        case Class::Equal:
        case Class::Left: break;
    }
    return {0xEE, 0xEE, 0xEE};
}

Buffer2D<Color8> classPicture(const Finding& finding, const Buffer2D<Color8>& reference) {
    Buffer2D<Color8> out(reference.size, Color8(255));
    for (std::size_t i = 0; i < out.pixels.size() && i < finding.classes.size(); ++i) {
        const Class of = finding.classes[i];
        if (of == Class::Equal || of == Class::Left) {
            const Color8& c = reference.pixels[i];  // a pale grey, so that the classes stand out
            const double grey = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
            const auto pale = std::uint8_t(std::lround(215 + grey * 33 / 255));
            out.pixels[i] = Color8(pale);
            continue;
        }
        // Hatches tell the classes apart without colour.
        const int x = int(i) % out.size.x, y = int(i) / out.size.x;
        const auto light = [](Color8 c) { return Color8((c[0] + 510) / 3, (c[1] + 510) / 3, (c[2] + 510) / 3); };
        const bool hatched = of == Class::Wrong     ? (x + y) % 8 < 2
                             : of == Class::Missing ? (x - y + 8 * out.size.y) % 8 < 2
                             : of == Class::Extra   ? x % 8 == 0 || y % 8 == 0
                             : of == Class::Allowed ? x % 4 == 0 && y % 4 == 0
                                                    : false;
        out.pixels[i] = hatched ? light(classColor(of)) : classColor(of);
    }
    return out;
}

}  // namespace pipeline::foreign
