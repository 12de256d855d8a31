#include "pipeline/compare/handed_in/reading.h"
#include "pipeline/compare/handed_in/shadow_frame.h"
#include "pipeline/core/elementary.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include "pipeline/buffers/verdict.h"

namespace pipeline::foreign {

namespace {

using C = Coding;

double toLinear(double v) { return v <= 0.04045 ? v / 12.92 : pipeline::pow((v + 0.055) / 1.055, 2.4); }

double levelsOf(const NumberFile& file) { return file.kind == NumberKind::Levels16 ? 65535 : 255; }

// z_view of a depth v; infinite where it stands for nothing.
double zOf(double v, Coding coding, const View& view, double rayLength) {
    const double n = view.near, f = view.far;
    const auto window = [&](double d) {
        if (!view.perspective) return n + d * (f - n);
        const double below = f - d * (f - n);
        return below > 0 ? f * n / below : std::numeric_limits<double>::infinity();
    };
    switch (coding) {
        case C::MinusZ: return -v;
        case C::Distance: return v / rayLength;
        case C::Ndc: return window((v + 1) / 2);
        case C::Window: return window(v);
        case C::Reversed: return window(1 - v);
        case C::Inverse: return v > 0 ? 1 / v : std::numeric_limits<double>::infinity();
        case C::Linear: return n + v * (f - n);
        case C::LinearReversed: return f - v * (f - n);
        default: return v;
    }
}

// Whether a depth is what a z-buffer is cleared to.
bool isCleared(double v, double z, Coding coding, const View& view) {
    if (!std::isfinite(v) || !std::isfinite(z)) return true;
    if (coding == C::AsIs || coding == C::MinusZ || coding == C::Distance)
        return z == 0 || z >= view.far * (1 - 1e-12) || (view.perspective && z < 0);
    if (coding == C::Inverse) return v == 0 || z >= view.far;
    const double share = coding == C::Ndc ? (v + 1) / 2 : v;
    const bool reversed = coding == C::Reversed || coding == C::LinearReversed;
    return reversed ? share <= 0 : share >= 1;
}

// A picture's numbers in the order of the reading.
class FilePicture {
public:
    FilePicture(const HandedFile& file, const Reading& reading)
        : m_numbers(file.numbers),
          m_rows(m_numbers.rows()),
          m_columns(m_numbers.columns()),
          m_channels(m_numbers.channels()),
          m_reading(reading) {}
    // Channel c of pixel i, counted by rows from the top; the last channel where there is no c.
    double at(std::size_t i, std::size_t c) const {
        if (m_reading.bottomUp || m_reading.mirrored) {
            // 32 bits, as a division of 64 costs more than all else here; a picture has fewer pixels.
            const std::uint32_t columns = std::uint32_t(m_columns), y = std::uint32_t(i) / columns;
            const std::uint32_t x = std::uint32_t(i) - y * columns;
            i = (m_reading.bottomUp ? m_rows - 1 - y : y) * m_columns + (m_reading.mirrored ? m_columns - 1 - x : x);
        }
        if (m_reading.bgr && c < 3 && m_channels >= 3) c = 2 - c;
        return m_numbers.values[i * m_channels + std::min(c, m_channels - 1)];
    }

private:
    const NumberFile& m_numbers;
    std::size_t m_rows, m_columns, m_channels;
    Reading m_reading;
};

// What brings the colours of a file to 0 to 255.
double colorScale(const NumberFile& file) {
    if (file.kind != NumberKind::Real) return holdsLevels(file) ? 255 / levelsOf(file) : 1;
    double largest = 0;  // fractions, if none is above 1 by more than rounding
    for (const double v : file.values)
        if (std::isfinite(v)) largest = std::max(largest, v);
    return largest <= 4 ? 255 : 1;
}

// Of encoded colours two codes are the same, as two of 255 are of linear ones: far less in the dark, more in the light.
// The reference's own rounding is taken out, as it would be several codes there.
void readColor(const HandedFile& file, const FilePicture& picture, const Reading& reading,
               const ReadingContext& context, const Values& reference, Values& out) {
    constexpr double kCodes = 2.5;  // and half a one for rounding
    const double scale = colorScale(file.numbers);
    const auto linear = [coding = reading.coding](double v) {
        return coding == Coding::Srgb ? toLinear(v) : pipeline::pow(v, 2.2);
    };
    const bool encoded = reading.coding != Coding::AsIs;
    const double share = whiteOf(reading.coding) / context.iMax;  // of I_max that is white
    const double own = toleranceOf(BufferId::Color)->value;
    const bool exact = encoded && context.unrounded.size() == out.numbers.size();
    if (encoded) out.slack.assign(out.count(), -own);
    const auto isBackground = [&](std::size_t i) {
        if (!context.background) return false;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t channel = reading.bgr ? 2 - c : c;  // the background is in the order of the file
            const double v = scale * picture.at(i, c);
            if (std::abs(v - (*context.background)[channel]) > 0.5) return false;
        }
        return true;
    };
    // A file of steps has few values: each is decoded once.
    struct Decoded {
        double value = -1, slack = 0;
    };
    std::vector<Decoded> ofSteps(encoded && holdsLevels(file.numbers) ? std::size_t(levelsOf(file.numbers)) + 1 : 0);
    const auto decode = [&](double v) {
        if (share > 0) return Decoded{v * share, kCodes * share - own};
        const double step = linear(std::min(1.0, (v + kCodes) / 255)) - linear(std::max(0.0, (v - kCodes) / 255));
        return Decoded{255 * linear(v / 255), 127.5 * step - own};
    };
    const auto decoded = [&](double raw, double v) {
        const auto at = std::size_t(raw >= 0 ? raw : 0);
        if (at >= ofSteps.size() || double(at) != raw) return decode(v);
        if (ofSteps[at].value < 0) ofSteps[at] = decode(v);
        return ofSteps[at];
    };
    for (std::size_t i = 0; i < out.count(); ++i) {
        if (isBackground(i)) continue;  // zeros
        for (int c = 0; c < 3; ++c) {
            const double raw = picture.at(i, std::size_t(c));
            if (!std::isfinite(raw)) out.there[i] = 0;
            double v = std::clamp(scale * raw, 0.0, 255.0);
            if (encoded) {
                const Decoded one = decoded(raw, v);
                out.slack[i] = std::max(out.slack[i], one.slack);
                v = one.value;
                if (exact) v += reference.at(i)[c] - context.unrounded[3 * i + std::size_t(c)];
                // What is cut off may be any brighter.
                if (share > 0 && scale * raw > 254.5 && reference.at(i)[c] > v) v = reference.at(i)[c];
            }
            out.at(i)[c] = v;
        }
    }
}

// The least or the largest of the numbers, whichever is there more often: what a buffer of them was cleared to.
double commonestExtreme(const std::vector<double>& numbers) {
    double extremes[2] = {HUGE_VAL, -HUGE_VAL};
    for (const double v : numbers)
        if (std::isfinite(v)) extremes[0] = std::min(extremes[0], v), extremes[1] = std::max(extremes[1], v);
    const auto [least, largest] = extremes;
    return std::ranges::count(numbers, least) > std::ranges::count(numbers, largest) ? least : largest;
}

void readDepth(const HandedFile& file, const FilePicture& picture, const Reading& reading,
               const ReadingContext& context, const Values& reference, Values& out) {
    const double top = holdsLevels(file.numbers) ? levelsOf(file.numbers) : 1;
    const bool grey = reading.coding == Coding::Grey || reading.coding == Coding::GreyReversed;
    const bool inverse = reading.coding == Coding::WindowOfOwnPlanes;
    const bool fits = grey || inverse || reading.coding == Coding::LinearOfOwnPlanes;
    const double cleared = fits && !grey ? commonestExtreme(file.numbers.values) : 0;
    const auto isNothing = [&](double v) { return grey ? v <= 0 || v >= 1 : !std::isfinite(v) || v == cleared; };
    double offset = 0, slope = 0;
    if (fits) {  // z or 1 / z = offset + slope v through what is there in both, by least squares
        double n = 0, sv = 0, sz = 0, svv = 0, svz = 0;
        for (std::size_t i = 0; i < out.count(); ++i) {
            const double v = picture.at(i, 0) / top;
            if (!reference.there[i] || isNothing(v)) continue;
            const double z = inverse ? 1 / reference.at(i)[0] : reference.at(i)[0];
            n += 1, sv += v, sz += z, svv += v * v, svz += v * z;
        }
        const double below = n * svv - sv * sv;
        if (below > 0) slope = (n * svz - sv * sz) / below, offset = (sz - slope * sv) / n;
        if (grey && (slope < 0) != (reading.coding == Coding::GreyReversed)) slope = 0, offset = 0;
    }
    out.slack.assign(out.count(), 0);
    for (std::size_t i = 0; i < out.count(); ++i) {
        const double v = picture.at(i, 0) / top;
        double ray = 1;
        if (reading.coding == Coding::Distance && context.view.perspective) {
            const std::size_t x = i % out.columns, y = i / out.columns;
            const glm::dvec2 at =
                (glm::dvec2(double(x) + 0.5, double(y) + 0.5) - context.view.centre) / context.view.scale;
            ray = std::sqrt(1 + glm::dot(at, at));
        }
        const auto z = [&](double value) {
            if (!fits) return zOf(value, reading.coding, context.view, ray);
            const double fitted = offset + slope * value;
            return inverse ? 1 / fitted : fitted;
        };
        const double here = z(v);
        const bool nothing = fits ? isNothing(v) : isCleared(v, here, reading.coding, context.view);
        out.there[i] = !nothing && std::isfinite(here);
        out.at(i)[0] = out.there[i] ? here : 0;
        if (!out.there[i]) continue;
        const double step =
            holdsLevels(file.numbers) ? 1 / top : std::abs(v) * std::ldexp(1.0, 1 - file.numbers.digits);
        const double low = z(v - step), high = z(v + step);
        out.slack[i] = std::isfinite(high - low) ? std::abs(high - low) / 2 : context.view.far;
    }
}

Vec3d normalOf(Vec3d n, Coding coding, const View& view) {
    const auto towards = pointsTowards(coding);
    if (!towards) return n;
    return n.x * view.right + n.y * view.up + (*towards ? -n.z : n.z) * view.forward;
}

void readNormal(const HandedFile& file, const FilePicture& picture, const Reading& reading,
                const ReadingContext& context, Values& out) {
    const double top = holdsLevels(file.numbers) ? levelsOf(file.numbers) : 1;
    using enum Coding;
    const bool rgb = reading.coding == WorldRgb || reading.coding == ViewRgb || reading.coding == ViewTowardsRgb;
    const double degrees = 180 / std::acos(-1.0);
    if (holdsLevels(file.numbers)) out.slack.assign(out.count(), std::sqrt(3.0) / top * degrees);
    for (std::size_t i = 0; i < out.count(); ++i) {
        Vec3d n;
        for (int c = 0; c < 3; ++c) n[c] = picture.at(i, std::size_t(c)) / top;
        out.there[i] = std::isfinite(glm::dot(n, n)) && n != Vec3d(0);
        if (rgb) {
            n = 2.0 * n - 1.0;
            const double length = glm::length(n);
            out.there[i] = out.there[i] && length > 0.1;
            if (holdsLevels(file.numbers) && length > 0) n /= length;  // the steps leave no more of it
        }
        n = out.there[i] ? normalOf(n, reading.coding, context.view) : Vec3d(0);
        for (int c = 0; c < 3; ++c) out.at(i)[c] = n[c];
    }
}

void readIds(const HandedFile& file, const FilePicture& picture, const Reading& reading, const Values& reference,
             Values& out) {
    const bool colored = file.numbers.shape.size() == 3 && file.numbers.channels() >= 3;
    for (std::size_t i = 0; i < out.count(); ++i) {
        double id = picture.at(i, 0);
        if (colored) id += 256 * picture.at(i, 1) + 65536 * picture.at(i, 2);
        if (reading.coding == Coding::FromOne) id -= 1;
        out.at(i)[0] = std::isfinite(id) ? id : -1;
    }
    if (reading.coding == Coding::Permuted) {
        // Each id stands for the one that it overlaps most; nothing is one of them.
        std::map<double, std::map<double, std::size_t>> overlaps;
        for (std::size_t i = 0; i < out.count(); ++i)
            ++overlaps[out.at(i)[0]][reference.there[i] ? reference.at(i)[0] : -1];
        std::map<double, double> names;
        for (const auto& [id, over] : overlaps)
            names[id] = std::ranges::max_element(over, {}, [](const auto& entry) { return entry.second; })->first;
        for (double& id : out.numbers) id = names[id];
    }
    for (std::size_t i = 0; i < out.count(); ++i) out.there[i] = out.at(i)[0] >= 0;
}

void readVerdicts(const HandedFile& file, const Reading& reading, Values& out) {
    for (std::size_t i = 0; i < out.count(); ++i) {
        const double v = file.numbers.values[i];
        const bool code = v == double(Verdict::Kept) || v == double(Verdict::Clipped);
        const bool kept = reading.coding == Coding::Codes ? code : (v != 0) != (reading.coding == Coding::DroppedIsOne);
        out.at(i)[0] = kept ? 1 : 0;
        out.there[i] = std::isfinite(v);
    }
}

void readVertices(const HandedFile& file, const Reading& reading, const ReadingContext& context, Values& out) {
    const std::size_t width = file.numbers.columns();
    const auto& numbers = file.numbers.values;
    for (std::size_t i = 0; i < out.count(); ++i) {
        Vec3d p(0);
        for (std::size_t c = 0; c < std::min<std::size_t>(3, width); ++c) p[int(c)] = numbers[i * width + c];
        if (file.name.form != Form::AsTable) {  // to the picture
            const double w = file.name.form == Form::Clip && width == 4 ? numbers[i * width + 3] : 1;
            if (!(w > 0)) p = Vec3d(std::nan(""));
            p.x = (p.x / w + 1) / 2 * double(context.width), p.y = (1 - p.y / w) / 2 * double(context.height), p.z = 0;
        }
        if (file.name.buffer.id == BufferId::VerticesScreen) p.z = 0;  // the depth is the z-buffer's affair
        if (reading.coding == Coding::PixelFromCentre) p.x += 0.5, p.y += 0.5;
        if (reading.coding == Coding::FromTheFoot) p.y = double(context.height) - p.y;
        if (reading.coding == Coding::TowardsViewer) p.z = -p.z;
        if (reading.coding == Coding::View || reading.coding == Coding::ViewTowards)
            p = normalOf(p, reading.coding, context.view);
        out.there[i] = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
        for (int c = 0; c < out.channels; ++c) out.at(i)[c] = out.there[i] ? p[c] : 0;
    }
}

void readNumbersAsThey(const HandedFile& file, const FilePicture& picture, const Reading& reading,
                       const ReadingContext& context, const Values& reference, Values& out) {
    double scale = holdsLevels(file.numbers) ? 1 / levelsOf(file.numbers) : 1;
    if (file.name.buffer.id == BufferId::Overdraw) scale = 1;
    if (reading.coding == Coding::OfIMax) scale *= context.iMax;
    if (holdsLevels(file.numbers)) out.slack.assign(out.count(), scale);
    for (std::size_t i = 0; i < out.count(); ++i) {
        for (int c = 0; c < out.channels; ++c) {
            double v = scale * picture.at(i, std::size_t(c));
            if (reading.coding == Coding::Signed) v = 2 * v - 1;
            if (reading.coding == Coding::LitIsZero) v = 1 - v;
            if (reading.coding == Coding::CutAtZero && v == 0 && reference.at(i)[c] < 0) v = reference.at(i)[c];
            if (!std::isfinite(v)) out.there[i] = 0, v = 0;
            out.at(i)[c] = v;
        }
    }
}

}  // namespace

std::optional<std::array<double, 3>> backgroundOf(const HandedFile& file, const ReadingContext& context) {
    constexpr double kMost = 0.6;     // of the pixels where nothing is, at least
    constexpr double kFewest = 0.01;  // of all pixels: so many have to be free
    if (file.name.buffer.id != BufferId::Color || file.numbers.channels() < 3) return {};
    const std::size_t count = context.covered.size();
    const double scale = colorScale(file.numbers);
    std::optional<std::array<double, 3>> best;
    double share = kMost;
    for (const bool mirrored : {false, true})
        for (const bool bottomUp : {false, true}) {
            const FilePicture picture(file, {bottomUp, mirrored, false, Coding::AsIs});
            std::map<std::array<double, 3>, std::size_t> colors;
            std::size_t free = 0;
            for (std::size_t i = 0; i < count; ++i) {
                if (context.covered[i]) continue;
                std::array<double, 3> color{};
                for (std::size_t c = 0; c < 3; ++c) color[c] = std::round(scale * picture.at(i, c));
                ++free, ++colors[color];
            }
            if (double(free) < kFewest * double(count)) return {};
            const auto commonest = std::ranges::max_element(colors, {}, [](const auto& one) { return one.second; });
            const double here = double(commonest->second) / double(free);
            if (here > share) share = here, best = commonest->first;
        }
    if (best && (*best)[0] < 1 && (*best)[1] < 1 && (*best)[2] < 1) return {};
    return best;
}

std::vector<double> numbersAt(const HandedFile& file, const Reading& reading, std::size_t x, std::size_t y) {
    const FilePicture picture(file, reading);
    std::vector<double> out;
    for (std::size_t c = 0; c < file.numbers.channels(); ++c)
        out.push_back(picture.at(y * file.numbers.columns() + x, c));
    return out;
}

Values read(const HandedFile& file, const Reading& reading, const ReadingContext& context, const Values& reference) {
    Values out{reference.domain, reference.rows, reference.columns, reference.channels, {}, {}};
    out.numbers.assign(out.count() * std::size_t(out.channels), 0);
    out.there.assign(out.count(), 1);
    const FilePicture picture(file, reading);
    using enum BufferId;
    switch (file.name.buffer.id) {
        case Color: readColor(file, picture, reading, context, reference, out); break;
        case ZView: readDepth(file, picture, reading, context, reference, out); break;
        case Normal: readNormal(file, picture, reading, context, out); break;
        case ObjectId:
        case PolygonId: readIds(file, picture, reading, reference, out); break;
        case PolygonsVerdict: readVerdicts(file, reading, out); break;
        case VerticesWorld:
        case VerticesView:
        case VerticesScreen:
        case PolygonsNormal:
        case VerticesNormal: readVertices(file, reading, context, out); break;
        case ShadowBuffer:
            if (auto found = inFrameOf(file.numbers, reference, context.ofShadowBuffers))
                out = std::move(*found);
            else
                out.there.assign(out.count(), 0);
            break;
        default: readNumbersAsThey(file, picture, reading, context, reference, out); break;
    }
    return out;
}

}  // namespace pipeline::foreign
