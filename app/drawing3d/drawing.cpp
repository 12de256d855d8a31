#include "app/drawing3d/drawing.h"

#include <algorithm>
#include <cmath>

#include "app/look/numbers.h"

namespace app {

Ink inkOf(VectorCode code) {
    switch (code) {
        case VectorCode::N: return Ink::N;
        case VectorCode::L: return Ink::L;
        case VectorCode::V: return Ink::V;
        case VectorCode::R: return Ink::R;
        case VectorCode::H: return Ink::H;
        case VectorCode::None: break;
    }
    return Ink::Text;
}

QColor colorOf(Ink ink, const ThemeColors& colors) {
    switch (ink) {
        case Ink::N: return colors.N;
        case Ink::L: return colors.L;
        case Ink::V: return colors.V;
        case Ink::R: return colors.R;
        case Ink::H: return colors.H;
        case Ink::Grid: return colors.line;
        case Ink::Edge: return colors.text2;
        case Ink::Outline: return colors.outline;
        case Ink::Text: return colors.text;
        case Ink::Hint: return colors.text3;
    }
    return colors.text;
}

QColor mixed(const QColor& a, const QColor& b, double shareOfA) {
    if (shareOfA == 1) return a;
    const auto channel = [&](int x, int y) { return int(std::lround(x * shareOfA + y * (1 - shareOfA))); };
    return {channel(a.red(), b.red()), channel(a.green(), b.green()), channel(a.blue(), b.blue())};
}

int decimalsOf(double value) {
    if (value == 0 || !std::isfinite(value)) return 0;
    return std::clamp(2 - int(std::floor(std::log10(std::abs(value)))), 0, 9);
}

std::string threeDigits(double value) { return number(value, decimalsOf(value)).toStdString(); }

void dimAllBut(const std::vector<VectorCode>& codes, Drawing& drawing) {
    if (codes.empty()) return;
    constexpr double kFaint = 0.35;
    const auto strength = [&](Ink ink) { return std::ranges::find(codes, ink, inkOf) == codes.end() ? kFaint : 1.0; };
    for (InkedSolid& vector : drawing.vectors) vector.strength = strength(vector.ink);
    for (Label& label : drawing.labels)
        if (label.kind == Label::Kind::Letter) label.strength = strength(label.ink);
}

}  // namespace app
