#include "pipeline/buffers/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/buffers/verdict.h"

namespace pipeline {

namespace {

constexpr Color8 hex(unsigned rgb) { return {(rgb >> 16) & 0xffu, (rgb >> 8) & 0xffu, rgb & 0xffu}; }

// Ember: lightness falls evenly, for every kind of colour vision.
constexpr std::array kEmber{hex(0xfff3c4), hex(0xfbd08a), hex(0xf0a56b), hex(0xda7b66), hex(0xb75a70),
                            hex(0x8a4576), hex(0x5d3672), hex(0x332a5e), hex(0x141b3c)};
// Slope: 0 in the middle.
constexpr std::array kSlope{hex(0x0b3c6f), hex(0x3f7fb5), hex(0x9cc3df), hex(0xf1efea),
                            hex(0xe9b68a), hex(0xc0703a), hex(0x7a3209)};
constexpr std::array kEight{hex(0x80b6ce), hex(0xfbdfb3), hex(0x2ca069), hex(0xe1a6ab),
                            hex(0x927ad4), hex(0x7c8118), hex(0x9ef0f1), hex(0x9f8396)};
constexpr std::array kVerdict{hex(0x5e9a98), hex(0xc18d62), hex(0x927deb), hex(0xc7d3fa), hex(0xeede5c), hex(0xf6b7cf)};
constexpr std::array kTruth{hex(0x000000), hex(0xffffff)};
constexpr std::string_view kVerdictLetters = "KBDOCT";

// Lit, shadowed, acne, leak; what is wrong is a colour. No verdict: black, as the ground of a picture.
constexpr std::array kShadowVerdict{hex(0xf1efea), hex(0x332a5e), hex(0xda7b66), hex(0x9cc3df)};

constexpr Color8 kNan = hex(0xff00c8), kWhite = hex(0xffffff), kBlack = hex(0x000000);

// 0 at first, 1 at last, clamped. A range without length has everything at its start.
double position(double value, double first, double last) {
    return first == last ? 0.0 : std::clamp((value - first) / (last - first), 0.0, 1.0);
}

std::uint8_t toByte(double fraction) { return static_cast<std::uint8_t>(std::lround(255 * fraction)); }

Color8 onScale(std::span<const Color8> stops, double t) {
    const double at = t * static_cast<double>(stops.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    const glm::dvec3 mixed = glm::mix(glm::dvec3(stops[i]), glm::dvec3(stops[i + 1]), at - static_cast<double>(i));
    return Color8(glm::round(mixed));
}

Color8 inCategory(double value) {
    if (value < 0) return kWhite;
    return kEight[static_cast<std::size_t>(std::fmod(value, double(kEight.size())))];
}

Color8 ofVerdict(double code) {
    if (!(code >= 0 && code < double(Verdict::NotYet))) return kWhite;
    return kVerdict[kVerdictLetters.find(letter(static_cast<Verdict>(code)))];
}

Color8 ofShadowVerdict(double value) {
    if (!(value >= 0 && value < double(kShadowVerdict.size()))) return kBlack;
    return kShadowVerdict[static_cast<std::size_t>(value)];
}

bool unitVectors(const BufferInfo& info) { return info.palette == Palette::Direction && info.unit.empty(); }

}  // namespace

std::span<const Color8> paletteStops(Palette palette) {
    switch (palette) {
        case Palette::Sequential: return kEmber;
        case Palette::Diverging: return kSlope;
        case Palette::Categorical: return kEight;
        case Palette::Verdict: return kVerdict;
        case Palette::ShadowVerdict: return kShadowVerdict;
        case Palette::Truth: return kTruth;
        case Palette::Direction:
        case Palette::Color: break;
    }
    return {};
}

PaletteRange fittingRange(const AnyBuffer& buffer, const BufferStatistics& found, DepthFormat format) {
    const BufferInfo& info = *buffer.info;
    switch (info.palette) {
        case Palette::Sequential: {
            if (info.id == BufferId::Shadow || info.id == BufferId::Transmittance) return {1, 0};
            const bool reversed = info.id == BufferId::Depth && isReversed(format);
            const bool nearIsLess = std::isinf(info.neutral) && !reversed;
            return nearIsLess ? PaletteRange{found.min, found.max} : PaletteRange{found.max, found.min};
        }
        case Palette::Diverging: {
            const double end = std::max(std::abs(found.min), std::abs(found.max));
            return {-end, end};
        }
        case Palette::Categorical:
        case Palette::Verdict:
        case Palette::ShadowVerdict: return {found.min, found.max};
        case Palette::Truth: return {0, 1};
        case Palette::Direction: return unitVectors(info) ? PaletteRange{-1, 1} : PaletteRange{found.min, found.max};
        case Palette::Color: return {0, info.element == Element::UInt8 ? 255 : found.max};
    }
    return {};
}

Color8 paletteColor(Palette palette, double value, double first, double last) {
    if (std::isnan(value)) return kNan;
    if (std::isinf(value)) return value > 0 ? kWhite : kBlack;
    switch (palette) {
        case Palette::Sequential: return onScale(kEmber, position(value, first, last));
        case Palette::Diverging: return onScale(kSlope, position(value, first, last));
        case Palette::Categorical: return inCategory(value);
        case Palette::Verdict: return ofVerdict(value);
        case Palette::ShadowVerdict: return ofShadowVerdict(value);
        case Palette::Truth: return value == 0 ? kBlack : kWhite;
        case Palette::Direction:
        case Palette::Color: break;
    }
    return Color8(toByte(position(value, first, last)));
}

Color8 elementColor(const AnyBuffer& buffer, std::size_t x, std::size_t y, PaletteRange range) {
    const Palette palette = buffer.info->palette;
    if (buffer.channels() != 3) return paletteColor(palette, buffer.value(x, y), range.first, range.last);
    Color8 color;
    for (int c = 0; c < 3; ++c) {
        const double value = buffer.value(x, y, c);
        if (std::isnan(value)) return kNan;
        color[c] = paletteColor(Palette::Color, value, range.first, range.last)[c];
    }
    return color;
}

}  // namespace pipeline
