#include "tests/app/color_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace test {

namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

double linear(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }

Triple linear(const QColor& c) { return {linear(c.redF()), linear(c.greenF()), linear(c.blueF())}; }

Triple operator*(const Matrix& m, const Triple& v) {
    Triple r{};
    for (std::size_t i = 0; i < 3; ++i) r[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return r;
}

const Matrix& simulation(Vision vision) {
    static const Matrix normal{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    static const Matrix protan{
        {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
    static const Matrix deutan{
        {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
    static const Matrix tritan{
        {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};
    switch (vision) {
        case Vision::Normal: return normal;
        case Vision::Protan: return protan;
        case Vision::Deutan: return deutan;
        case Vision::Tritan: return tritan;
    }
    return normal;
}

Triple lab(const QColor& color, Vision vision) {
    Triple rgb = simulation(vision) * linear(color);
    for (double& v : rgb) v = std::clamp(v, 0.0, 1.0);
    static const Matrix xyzFromRgb{
        {{0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}}};
    static const Triple white{0.95047, 1.0, 1.08883};
    const Triple xyz = xyzFromRgb * rgb;
    Triple f{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double t = xyz[i] / white[i];
        f[i] = t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
    }
    return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

constexpr double kDegree = std::numbers::pi / 180;

double hue(double a, double b) {
    const double h = std::atan2(b, a) / kDegree;
    return a == 0 && b == 0 ? 0 : h < 0 ? h + 360 : h;
}

}  // namespace

double luminance(const QColor& color) {
    const Triple c = linear(color);
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}

double contrast(const QColor& a, const QColor& b) {
    const double x = luminance(a) + 0.05, y = luminance(b) + 0.05;
    return std::max(x, y) / std::min(x, y);
}

// After G. Sharma, W. Wu, E. N. Dalal, "The CIEDE2000 Color-Difference Formula: Implementation
// Notes, Supplementary Test Data, and Mathematical Observations", Color Research & Application 30 (2005).
double deltaE00(const QColor& first, const QColor& second, Vision vision) {
    const auto [l1, a1, b1] = lab(first, vision);
    const auto [l2, a2, b2] = lab(second, vision);
    const double meanC = (std::hypot(a1, b1) + std::hypot(a2, b2)) / 2;
    const double g = 0.5 * (1 - std::sqrt(std::pow(meanC, 7) / (std::pow(meanC, 7) + std::pow(25.0, 7))));
    const double c1 = std::hypot((1 + g) * a1, b1), c2 = std::hypot((1 + g) * a2, b2);
    const double h1 = hue((1 + g) * a1, b1), h2 = hue((1 + g) * a2, b2);

    double dh = h2 - h1, meanH = h1 + h2;
    if (c1 * c2 == 0) {
        dh = 0;
    } else if (std::abs(h1 - h2) <= 180) {
        meanH /= 2;
    } else {
        dh += h2 <= h1 ? 360 : -360;
        meanH = (meanH + (meanH < 360 ? 360 : -360)) / 2;
    }
    const double dL = l2 - l1, dC = c2 - c1, dH = 2 * std::sqrt(c1 * c2) * std::sin(dh / 2 * kDegree);

    const double meanL = (l1 + l2) / 2, meanCp = (c1 + c2) / 2;
    const double t = 1 - 0.17 * std::cos((meanH - 30) * kDegree) + 0.24 * std::cos(2 * meanH * kDegree) +
                     0.32 * std::cos((3 * meanH + 6) * kDegree) - 0.20 * std::cos((4 * meanH - 63) * kDegree);
    const double sL = 1 + 0.015 * std::pow(meanL - 50, 2) / std::sqrt(20 + std::pow(meanL - 50, 2));
    const double sC = 1 + 0.045 * meanCp, sH = 1 + 0.015 * meanCp * t;
    const double rotation = 30 * std::exp(-std::pow((meanH - 275) / 25, 2));
    const double rC = 2 * std::sqrt(std::pow(meanCp, 7) / (std::pow(meanCp, 7) + std::pow(25.0, 7)));
    const double rT = -std::sin(2 * rotation * kDegree) * rC;
    return std::sqrt(std::pow(dL / sL, 2) + std::pow(dC / sC, 2) + std::pow(dH / sH, 2) + rT * (dC / sC) * (dH / sH));
}

}  // namespace test
