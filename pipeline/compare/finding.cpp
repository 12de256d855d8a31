#include "pipeline/compare/finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/buffers/verdict.h"
#include "pipeline/compare/handed_in/reading_cost.h"
#include "pipeline/compare/open_pixels.h"

namespace pipeline::foreign {

namespace {

using enum BufferId;

bool isLit(BufferId id) { return id == Color || id == Intensity || id == Diffuse || id == Specular || id == Shadow; }

// Whether a value stands between those of the neighbours, as it does where an edge has moved by a pixel.
class Neighbours {
public:
    Neighbours(const Values& mine, const Values& right, Measure measure, double tolerance)
        : m_mine(mine), m_right(right), m_measure(measure), m_tolerance(tolerance) {}

    // one(other): about each pixel next to it.
    template <class Function>
    bool any(std::size_t i, Function one) const {
        const int x = int(i % m_right.columns), y = int(i / m_right.columns);
        for (int v = std::max(0, y - 1); v <= std::min(int(m_right.rows) - 1, y + 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(int(m_right.columns) - 1, x + 1); ++u)
                if (one(std::size_t(v) * m_right.columns + std::size_t(u))) return true;
        return false;
    }
    bool explain(std::size_t i) const {
        if (any(i, [&](std::size_t other) { return isLike(i, other); })) return true;
        if (m_measure != Measure::Largest) return false;
        for (int c = 0; c < m_right.channels; ++c) {  // between the least and the largest
            double low = HUGE_VAL, high = -HUGE_VAL;
            any(i, [&](std::size_t other) {
                if (m_right.there[other])
                    low = std::min(low, m_right.at(other)[c]), high = std::max(high, m_right.at(other)[c]);
                return false;
            });
            const double room = m_tolerance + 0.25 * std::max(0.0, high - low);  // planes go on beyond their samples
            const double v = m_mine.at(i)[c];
            if (!(v >= low - room && v <= high + room)) return false;
        }
        return true;
    }

private:
    bool isLike(std::size_t i, std::size_t other) const {
        if (!m_mine.there[i] || !m_right.there[other]) return m_mine.there[i] == m_right.there[other];
        const double *a = m_mine.at(i), *b = m_right.at(other);
        if (m_measure == Measure::Same) return a[0] == b[0];
        double largest = 0;
        for (int c = 0; c < m_right.channels; ++c) largest = std::max(largest, std::abs(a[c] - b[c]));
        return largest <= (m_measure == Measure::Angle ? 0.05 : 2 * m_tolerance);
    }
    const Values& m_mine;
    const Values& m_right;
    Measure m_measure;
    double m_tolerance;
};

bool isBlack(const Values& values, std::size_t i) {
    return values.at(i)[0] < 0.5 && values.at(i)[1] < 0.5 && values.at(i)[2] < 0.5;
}

// Whether all three channels are between the bounds of a pixel, within a tolerance. No bounds: they are not.
template <class Channels>
bool isBetween(const double* channels, const std::vector<Channels>& low, const std::vector<Channels>& high,
               std::size_t pixel, double tolerance) {
    if (low.empty()) return false;
    for (int c = 0; c < 3; ++c)
        if (channels[c] < double(low[pixel][c]) - tolerance || channels[c] > double(high[pixel][c]) + tolerance)
            return false;
    return true;
}

// Whether what is open in S explains the value.
bool shadowExplains(const ReadFile& file, const Reference& reference, std::size_t i, double tolerance) {
    const BufferId id = file.file->name.buffer.id;
    if (reference.shadowOpen.empty() || !isLit(id)) return false;
    const double* const mine = file.mine.at(i);
    if (id == Color) return isBetween(mine, reference.colorLow, reference.colorHigh, i, tolerance);
    if (id == Intensity) return isBetween(mine, reference.intensityLow, reference.intensityHigh, i, tolerance);
    const auto& open = reference.shadowOpen[std::size_t(file.file->name.buffer.light)];
    return !open.empty() && open[i] != 0;
}

// Whether an edge of a shadow of theirs is near: where they have none, a shadow is missing and no edge has moved.
class TheirShadows {
public:
    TheirShadows(const ReadFile& file, const Values& right, const Reference& reference, Measure measure,
                 double tolerance)
        : m_reference(reference), m_columns(right.columns) {
        const bool isS = file.file->name.buffer.id == Shadow;
        if (reference.shadowed.empty() || !isLit(file.file->name.buffer.id)) return;
        m_shadowed.assign(right.count(), kUnknown);
        for (std::size_t i = 0; i < right.count(); ++i) {
            if (!file.mine.there[i] || !right.there[i]) continue;
            if (!isS && reference.shadowContrast[i] < kLeastContrast) continue;
            const double allowed = file.mine.allowed(i, tolerance);
            const bool close = differenceAt(measure, file.mine, right, i) <= allowed;
            m_shadowed[i] = close == (reference.shadowed[i] != 0);
        }
    }
    bool isEdgeNear(std::size_t i) const {
        if (m_reference.grazing[i]) return true;
        const int x = int(i % m_columns), y = int(i / m_columns), rows = int(m_shadowed.size() / m_columns);
        for (int v = std::max(0, y - kShadowBand); v <= std::min(rows - 1, y + kShadowBand); ++v)
            for (int u = std::max(0, x - kShadowBand); u <= std::min(int(m_columns) - 1, x + kShadowBand); ++u)
                if (m_shadowed[std::size_t(v) * m_columns + std::size_t(u)] == m_reference.shadowed[i]) return true;
        return false;
    }

private:
    static constexpr std::uint8_t kUnknown = 2;
    static constexpr double kLeastContrast = 8;  // of 255
    const Reference& m_reference;
    std::size_t m_columns;
    std::vector<std::uint8_t> m_shadowed;  // as theirs is
};

// Elements that right renderers need not agree on. saysDrawn: the file tells by itself where something is drawn.
// nDotL: of the light of an S; may be null.
bool isLeft(const ReadFile& file, const Reference& reference, bool saysDrawn, const Values& right, const Values* nDotL,
            std::size_t i) {
    const BufferName& name = file.file->name.buffer;
    if (name.id == PolygonsVerdict) {
        const auto verdicts = reference.frame->buffer({PolygonsVerdict});
        const auto verdict = Verdict(int(verdicts->flat(i)));
        return !goesOn(verdict) && verdict != Verdict::BackFacing;
    }
    if (nDotL && nDotL->numbers[i] <= 0) return true;
    if (right.domain != Domain::Pixel) return !reference.values.at(name.text()).there[i];
    // Where nothing is drawn these have no value.
    return !saysDrawn && !reference.context.covered[i];
}

}  // namespace

namespace {

double strayShare(Domain domain) {
    return domain == Domain::Pixel ? kStrayPixels : domain == Domain::Texel ? kStrayTexels : 0;
}

}  // namespace

std::string_view name(Class of) {
    switch (of) {
        case Class::Equal: return "equal";
        case Class::Tolerated: return "within tolerance";
        case Class::Allowed: return "allowed";
        case Class::Wrong: return "wrong";
        case Class::Missing: return "missing";
        case Class::Extra: return "extra";
        case Class::Left: return "not compared";
    }
    return {};
}

Finding compareValues(const ReadFile& file, const Reference& reference) {
    return compareValues(file, reference.values.at(file.file->name.buffer.text()), reference);
}

Finding compareValues(const ReadFile& file, const Values& right, const Reference& reference) {
    const BufferName& buffer = file.file->name.buffer;
    const bool saysDrawn = !drawnIn(file.file->name, file.mine).empty();
    const Tolerance& row = *toleranceOf(buffer.id);
    Finding out;
    out.name = file.file->name, out.file = file.file->fileName();
    out.stage = bufferInfo(buffer.id).stage, out.reading = file.reading;
    out.tolerance = reference.tolerances.at(buffer.text()), out.unit = row.unit;
    out.columns = right.columns;
    out.nan = file.file->numbers.nan, out.infinite = file.file->numbers.infinite;
    out.classes.assign(right.count(), Class::Equal);
    const bool picture = right.domain == Domain::Pixel;
    const bool isColor = buffer.id == Color;
    const Neighbours neighbours(file.mine, right, row.measure, out.tolerance);
    double worst = -1, squares = 0;
    std::size_t numbers = 0;
    const OpenPixels open(reference);
    const TheirShadows shadows(file, right, reference, row.measure, out.tolerance);
    const Values* const nDotL =
        buffer.id == Shadow ? reference.values.find("n_dot_l." + std::to_string(buffer.light)) : nullptr;
    const auto classify = [&](std::size_t i, double& difference) {
        const bool here = file.mine.there[i] != 0, there = right.there[i] != 0;
        difference = 0;
        if (isLeft(file, reference, saysDrawn, right, nDotL, i)) return Class::Left;
        if (!here && !there) return Class::Equal;
        const double allowed = file.mine.allowed(i, out.tolerance);
        if (here && there) {
            difference = differenceAt(row.measure, file.mine, right, i);
            if (difference == 0) return Class::Equal;
            if (difference <= allowed) return Class::Tolerated;
        } else {
            difference = HUGE_VAL;
        }
        if (picture && reference.isSmaller && reference.outline[i]) return Class::Allowed;
        if (picture && !reference.outline.empty() && reference.outline[i] && neighbours.explain(i) && open.isOpen(i))
            return Class::Allowed;
        if (shadowExplains(file, reference, i, allowed) && shadows.isEdgeNear(i)) return Class::Allowed;
        if (isColor && isBlack(file.mine, i) && reference.context.covered[i]) return Class::Missing;
        if (isColor && !reference.context.covered[i]) return Class::Extra;
        if (!picture && !here) return Class::Left;  // a vertex without a place of theirs
        return here && there ? Class::Wrong : here ? Class::Extra : Class::Missing;
    };
    for (std::size_t i = 0; i < right.count(); ++i) {
        double difference = 0;
        const Class of = out.classes[i] = classify(i, difference);
        ++out.counts[std::size_t(of)];
        const bool nothing = of == Class::Equal &&
                             (isColor ? !reference.context.covered[i] && isBlack(file.mine, i) : !file.mine.there[i]);
        if (nothing) --out.counts[std::size_t(of)];
        if (of == Class::Left || nothing) continue;
        ++out.compared;
        if (std::isfinite(difference) && of != Class::Allowed) {
            out.largest = std::max(out.largest, difference);
            squares += difference * difference, ++numbers;
        }
        const bool bad = isBad(of);
        const double weight = std::isfinite(difference) ? difference : 0;
        if (bad && weight > worst) worst = weight, out.worst = i;
    }
    if (numbers > 0) out.rms = std::sqrt(squares / double(numbers));
    out.agrees = double(out.bad()) <= strayShare(right.domain) * double(out.compared);
    return out;
}

void leaveOut(const std::vector<std::uint8_t>& elements, Finding& finding) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
        Class& of = finding.classes[i];
        if (!elements[i] || !isBad(of)) continue;
        --finding.counts[std::size_t(of)], --finding.compared;
        of = Class::Left, ++finding.counts[std::size_t(of)];
    }
    const Domain domain = bufferInfo(finding.name.buffer.id).domain;
    finding.agrees = double(finding.bad()) <= strayShare(domain) * double(finding.compared);
}

std::string shortNumber(double value) {
    if (value == 0) return "0";
    const double magnitude = std::abs(value);
    if (magnitude >= 1e6 || magnitude < 1e-3) return fmt::format("{:.2g}", value);
    return fmt::format("{:.3g}", value);
}

std::string placeText(const Finding& finding, std::size_t element) {
    const BufferInfo& info = bufferInfo(finding.name.buffer.id);
    if (info.domain == Domain::Vertex) return fmt::format("vertex {}", element);
    if (info.domain == Domain::Polygon) return fmt::format("polygon {}", element);
    return fmt::format("pixel {}, {}", element % finding.columns, element / finding.columns);
}

std::string valueText(const Finding& finding, const Values& values, std::size_t element) {
    if (!values.there[element]) return "nothing";
    const double* const v = values.at(element);
    const BufferId id = finding.name.buffer.id;
    if (id == Color) return fmt::format("{:.0f} {:.0f} {:.0f}", v[0], v[1], v[2]);
    if (id == PolygonsVerdict) return v[0] != 0 ? "kept" : "dropped";
    if (id == VerticesScreen) return fmt::format("({}, {})", shortNumber(v[0]), shortNumber(v[1]));
    if (values.channels == 1) return fmt::format("{:.6g}", v[0]);
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", v[0], v[1], v[2]);
}

std::string toleranceText(const Finding& finding) {
    if (finding.tolerance == 0) return {};
    const std::string_view unit = finding.unit;
    return fmt::format("{}{}{}", shortNumber(finding.tolerance), unit.empty() || unit == "\u00b0" ? "" : " ", unit);
}

std::string findingText(const Finding& finding) {
    const Measure measure = toleranceOf(finding.name.buffer.id)->measure;
    const std::string_view unit = finding.unit, space = unit.empty() || unit == "\u00b0" ? "" : " ";
    const std::string px = finding.isPicture() ? " px" : "";
    if (finding.bad() > 0 && !finding.agrees) {
        std::string parts;
        const auto add = [&](Class of) {
            if (finding.count(of) > 0)
                parts += fmt::format("{}{}{} {}", parts.empty() ? "" : ", ", finding.count(of), px, name(of));
        };
        if (finding.isPicture()) {
            for (const Class of : {Class::Wrong, Class::Missing, Class::Extra}) add(of);
            parts += fmt::format(" of {}", finding.compared);
        } else {
            parts = fmt::format("{} of {} differ", finding.bad(), finding.compared);
        }
        return measure == Measure::Same || finding.largest == 0
                   ? parts
                   : fmt::format("{}, up to {}{}{}", parts, shortNumber(finding.largest), space, unit);
    }
    std::string text =
        measure == Measure::Same
            ? fmt::format("{} of {} equal", finding.compared - finding.count(Class::Allowed) - finding.bad(),
                          finding.compared)
            : fmt::format("{}{}{}", shortNumber(finding.largest), space, unit);
    if (finding.count(Class::Allowed) > 0)
        text += fmt::format("; {}{} at edges, allowed", finding.count(Class::Allowed), px);
    if (finding.bad() > 0) text += fmt::format("; {}{} stray", finding.bad(), px);
    return text;
}

}  // namespace pipeline::foreign
