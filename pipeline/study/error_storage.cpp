// What is lost by what a buffer is stored in; and the 8-bit colours, of which that is the larger part.
#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/scene/opacity.h"
#include "pipeline/scene/view.h"
#include "pipeline/study/error_rows.h"

namespace pipeline {
namespace {

// A depth format's number d at distance z and back, from OpenGL's perspective matrix: d = f (z - n) / (z (f - n)), 1 - d
// when reversed, n / z where the far plane is at infinity; orthographic (z - n) / (f - n). In long double: near the far plane 24 bits leave little of the others.
struct DepthFormula {
    long double near, far;
    bool perspective, reversed, infinite;

    long double stored(long double z) const {
        if (infinite) return std::min(near / z, 1.0L);
        const long double d = perspective ? far * (z - near) / (z * (far - near)) : (z - near) / (far - near);
        const long double clamped = std::clamp(d, 0.0L, 1.0L);
        return reversed ? 1 - clamped : clamped;
    }
    long double distance(long double d) const {
        if (infinite) return near / d;
        const long double forward = reversed ? 1 - d : d;
        return perspective ? near * far / (far - forward * (far - near)) : near + forward * (far - near);
    }
};

int bitsOf(DepthFormat format) {
    switch (format) {
        case DepthFormat::Fixed16: return 16;
        case DepthFormat::Fixed24: return 24;
        case DepthFormat::Fixed32: return 32;
        default: return 0;
    }
}

// How far apart the numbers of the format lie at d.
double stepAt(DepthFormat format, double d) {
    if (const int bits = bitsOf(format); bits > 0) return 1 / (std::exp2(bits) - 1);
    if (format == DepthFormat::Half || format == DepthFormat::ReversedHalf)
        return std::exp2(std::max(std::ilogb(d), -14) - 10);
    const float at = std::abs(float(d));
    return double(std::nextafter(at, 2.0f)) - double(at);
}

using Bytes = std::vector<std::array<int, 3>>;

Bytes bytesOf(const Buffer2D<Vec3d>& picture, double white) {
    Bytes bytes;
    for (const Vec3d& intensity : picture.pixels) {
        std::array<int, 3> pixel{};
        for (int c = 0; c < 3; ++c) {
            const double share = white > 0 ? std::clamp(intensity[c] / white, 0.0, 1.0) : 0;
            pixel[std::size_t(c)] = int(std::floor(255 * share + 0.5));
        }
        bytes.push_back(pixel);
    }
    return bytes;
}

Bytes bytesOf(const AnyBuffer& color) {
    Bytes bytes(color.count() / 3);
    for (std::size_t i = 0; i < color.count(); ++i) bytes[i / 3][i % 3] = int(color.flat(i));
    return bytes;
}

// Decibels of 255 over the RMSE; nothing for none.
std::optional<double> psnr(double rmse) {
    if (!(rmse > 0)) return {};
    return -20 * std::log10(rmse / 255);
}

// Luma of Rec. 709; over all windows of 8 x 8, of pictures smaller than that the whole.
double meanSsim(const Bytes& a, const Bytes& b, glm::ivec2 size) {
    const auto luma = [](const std::array<int, 3>& p) { return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]; };
    const double c1 = std::pow(0.01 * 255, 2), c2 = std::pow(0.03 * 255, 2);
    const glm::ivec2 window = glm::min(size, glm::ivec2(8));
    double sum = 0, windows = 0;
    // Windows that overlap by half: a fourth of the picture's pixels in each direction is enough for a mean.
    for (int top = 0; top + window.y <= size.y; top += std::max(1, window.y / 2))
        for (int left = 0; left + window.x <= size.x; left += std::max(1, window.x / 2)) {
            double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
            for (int j = top; j < top + window.y; ++j)
                for (int i = left; i < left + window.x; ++i) {
                    const std::size_t at = std::size_t(j) * std::size_t(size.x) + std::size_t(i);
                    const double p = luma(a[at]), q = luma(b[at]);
                    x += p, y += q, xx += p * p, yy += q * q, xy += p * q;
                }
            const double n = window.x * window.y;
            x /= n, y /= n;
            const double varianceX = xx / n - x * x, varianceY = yy / n - y * y, covariance = xy / n - x * y;
            sum += (2 * x * y + c1) * (2 * covariance + c2) / ((x * x + y * y + c1) * (varianceX + varianceY + c2));
            ++windows;
        }
    return windows > 0 ? sum / windows : 1;
}

void addBytes(const Bytes& a, const Bytes& b, glm::ivec2 size, ErrorKind kind, ErrorRows& rows) {
    double different = 0;
    std::vector<double> steps;
    for (std::size_t i = 0; i < a.size(); ++i) {
        different += a[i] != b[i];
        for (std::size_t c = 0; c < 3; ++c) steps.push_back(std::abs(a[i][c] - b[i][c]));
    }
    const ErrorSpread spread = spreadOf(std::move(steps));
    rows.put({BufferId::Color}, "pixels that differ", "pixels", kind, different);
    rows.put({BufferId::Color}, "RMSE", "steps of 255", kind, spread.rmse);
    rows.put({BufferId::Color}, "largest step", "steps of 255", kind, spread.largest);
    if (const auto decibels = psnr(spread.rmse)) rows.put({BufferId::Color}, "PSNR", "dB", kind, *decibels);
    rows.put({BufferId::Color}, "mean SSIM", "", kind, meanSsim(a, b, size));
}

}  // namespace

void addDepthStorage(const Frame& frame, const Picture& ours, ErrorRows& rows) {
    const Settings& settings = frame.scene().settings;
    const auto depth = frame.buffer({BufferId::Depth});
    if (settings.depthFormat == DepthFormat::Linear || !depth || ours.zView.empty()) return;
    const View view = makeView(frame.scene());
    const DepthFormula formula{view.near, view.far, view.perspective, isReversed(settings.depthFormat),
                               settings.depthFormat == DepthFormat::Infinite && view.perspective};
    std::vector<double> decoded;
    double steps = 0;
    for (std::size_t i = 0; i < depth->count(); ++i) {
        const double z = ours.zView.pixels[i], d = depth->flat(i);
        if (!std::isfinite(z)) continue;
        const double wanted = double(formula.stored(z));
        steps = std::max(steps,
                         double(std::abs(formula.stored(z) - (long double)(d))) / stepAt(settings.depthFormat, wanted));
        decoded.push_back(double(std::abs(formula.distance(d) - z)));
    }
    const ErrorSpread spread = spreadOf(std::move(decoded));
    rows.put({BufferId::Depth}, "largest in steps", "steps", ErrorKind::Storage, steps);
    rows.put({BufferId::Depth}, "RMSE", "world units", ErrorKind::Storage, spread.rmse);
    rows.put({BufferId::Depth}, "largest", "world units", ErrorKind::Storage, spread.largest);
}

void addColorStorage(const Frame& frame, ErrorRows& rows) {
    const auto color = frame.buffer({BufferId::Color});
    const double white = whiteOf(frame.scene());
    // What is scaled to 255: with several samples a pixel their mean.
    auto linear = frame.buffer({BufferId::Antialiased});
    if (!linear) linear = frame.buffer({BufferId::Intensity});
    if (!color || !linear || !(white > 0)) return;
    std::vector<double> steps;
    for (std::size_t i = 0; i < color->count(); ++i)
        steps.push_back(std::abs(color->flat(i) - 255 * std::clamp(linear->flat(i) / white, 0.0, 1.0)));
    const ErrorSpread spread = spreadOf(std::move(steps));
    rows.put({BufferId::Color}, "RMSE", "steps of 255", ErrorKind::Storage, spread.rmse);
    rows.put({BufferId::Color}, "largest step", "steps of 255", ErrorKind::Storage, spread.largest);
    if (const auto decibels = psnr(spread.rmse))
        rows.put({BufferId::Color}, "PSNR", "dB", ErrorKind::Storage, *decibels);
}

void addColor(const Frame& frame, const Picture& reference, ErrorRows& rows) {
    const auto color = frame.buffer({BufferId::Color});
    // What is seen at the pixels' centres says nothing of the mean of several samples.
    const bool whole = frame.scene().settings.antialiasing > 1;
    const Buffer2D<Vec3d>& shown = whole ? reference.antialiased : reference.intensity;
    if (!color || shown.empty()) return;
    addBytes(bytesOf(*color), bytesOf(shown, whiteOf(frame.scene())), reference.size, ErrorKind::Model, rows);
}

void addColor(const Frame& frame, const Frame& reference, ErrorRows& rows) {
    const auto ours = frame.buffer({BufferId::Color}), theirs = reference.buffer({BufferId::Color});
    const Settings& settings = frame.scene().settings;
    if (ours && theirs)
        addBytes(bytesOf(*ours), bytesOf(*theirs), {settings.width, settings.height}, ErrorKind::Arithmetic, rows);
}

}  // namespace pipeline
