#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/study/plot.h"

namespace pipeline {

namespace {

// Advance widths in em of DejaVu Sans, by kinds of letters; wide ones and what is not ASCII as 0.84.
double advance(char32_t c) {
    if (c == ' ' || std::u32string_view(U"ijl'").find(c) != std::u32string_view::npos) return 0.32;
    if (std::u32string_view(U".,:;()[]|!If/-rt").find(c) != std::u32string_view::npos) return 0.42;
    if (c >= '0' && c <= '9') return 0.64;
    if (std::u32string_view(U"mwMW%@").find(c) != std::u32string_view::npos) return 0.99;
    if (c < 0x80) return c >= 'a' && c <= 'z' ? 0.62 : 0.74;
    return 0.84;
}

std::vector<Vec2<double>> polygon(int corners, double first, double inner) {
    std::vector<Vec2<double>> points;
    const int count = inner < 1 ? 2 * corners : corners;
    for (int i = 0; i < count; ++i) {
        const double angle = first + 2 * std::numbers::pi * i / count;
        const double radius = 0.5 * (inner < 1 && i % 2 == 1 ? inner : 1);
        points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return points;
}

}  // namespace

double textWidth(std::string_view text, double size) {
    double width = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        if ((c & 0xC0u) == 0x80u) continue;  // no first byte of a code point
        width += advance(c < 0x80 ? c : 0x2212);
    }
    return width * size;
}

std::vector<Vec2<double>> outline(PlotShape shape) {
    constexpr double kUp = -std::numbers::pi / 2;
    switch (shape) {
        case PlotShape::Square: return {{-0.44, -0.44}, {0.44, -0.44}, {0.44, 0.44}, {-0.44, 0.44}};
        case PlotShape::Triangle: return {{0, -0.5}, {0.5, 0.4}, {-0.5, 0.4}};
        case PlotShape::TriangleDown: return {{0, 0.5}, {-0.5, -0.4}, {0.5, -0.4}};
        case PlotShape::Diamond: return {{0, -0.5}, {0.5, 0}, {0, 0.5}, {-0.5, 0}};
        case PlotShape::Pentagon: return polygon(5, kUp, 1);
        case PlotShape::Star: return polygon(5, kUp, 0.45);
        case PlotShape::Cross: {
            constexpr double a = 0.18, b = 0.5;
            return {{-a, -b}, {a, -b}, {a, -a}, {b, -a}, {b, a},   {a, a},
                    {a, b},   {-a, b}, {-a, a}, {-b, a}, {-b, -a}, {-a, -a}};
        }
        case PlotShape::Disc: break;
    }
    return {};
}

std::vector<double> dashes(PlotDash dash) {
    switch (dash) {
        case PlotDash::Solid: return {};
        case PlotDash::Dashed: return {4, 2.5};
        case PlotDash::Dotted: return {1, 2.5};
        case PlotDash::DashDot: return {5, 2, 1, 2};
        case PlotDash::LongDash: return {8, 3};
    }
    return {};
}

}  // namespace pipeline
