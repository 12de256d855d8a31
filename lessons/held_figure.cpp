#include "lessons/held_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "pipeline/core/elementary.h"
#include "pipeline/core/text.h"
#include "pipeline/scene/hold/code_figure.h"

namespace lessons {

namespace {

using pipeline::BufferId;
using pipeline::BufferName;
using Kind = FigureShape::Kind;

constexpr double kMargin = 28;  // of an axis, at both ends

std::string withMinus(std::string text) {
    if (text.starts_with('-')) text.replace(0, 1, "−");
    return text;
}

class Drawing {
public:
    Drawing(const FigureSource& source, const FigureRoom& room) : m_source(source), m_room(room) {}

    HeldFigure of(Figure figure) {
        switch (figure) {
            case Figure::Equation: equation(); break;
            case Figure::Codes: codes(); break;
            case Figure::Row: row(); break;
        }
        return std::move(m_figure);
    }

private:
    void line(std::string_view role, glm::dvec2 a, glm::dvec2 b) {
        m_figure.shapes.push_back({Kind::Line, role, {a, b}});
    }
    void box(std::string_view role, glm::dvec2 a, glm::dvec2 b) {
        m_figure.shapes.push_back({Kind::Box, role, {a, b}});
    }
    void dot(std::string_view role, glm::dvec2 at) { m_figure.shapes.push_back({Kind::Dot, role, {at}}); }
    void words(std::string_view role, glm::dvec2 at, std::string text, double anchor = 0.5) {
        m_figure.shapes.push_back({Kind::Words, role, {at}, std::move(text), anchor});
    }
    double end() const { return m_room.width - kMargin; }

    // An axis of equal factors from before the near planes of lessons to behind their far planes.
    double onDepths(double z) const {
        constexpr double kLow = 0.02, kHigh = 3000;
        const double share = pipeline::log(z / kLow) / pipeline::log(kHigh / kLow);
        return std::clamp(kMargin + share * (end() - kMargin), kMargin, std::max(kMargin, end()));
    }

    void codes() {
        const pipeline::CodeFigure figure = pipeline::codeFigure(m_source.scene);
        const double from = onDepths(figure.nearest), to = onDepths(figure.farthest);
        box("reach", {from, 50}, {std::max(to, from + 3), 112});
        const std::string count = fmt::format("{:.0f} {}", figure.codes, figure.codes == 1 ? "code" : "codes");
        words("of", {std::clamp((from + to) / 2, 50.0, std::max(50.0, end() - 50)), 18},
              m_source.tells ? count : "the objects");
        for (const double z : figure.marks)
            line(z >= figure.nearest && z <= figure.farthest ? "code in" : "code", {onDepths(z), 58},
                 {onDepths(z), 104});
        line("base", {kMargin, 104}, {end(), 104});
        for (const double z : {0.1, 1.0, 10.0, 100.0, 1000.0}) {
            line("base", {onDepths(z), 104}, {onDepths(z), 110});
            words("", {onDepths(z), 126}, figureNumber(z));
        }
        words("", {end(), 126}, "z", 1);
        for (const double side : {-1.0, 1.0}) {
            std::vector<glm::dvec2> lid;
            for (int i = 0; i <= 8; ++i) lid.emplace_back(4 + 2.5 * i, 81 + side * i * (8 - i) * 0.375);
            m_figure.shapes.push_back({Kind::Curve, "eye", std::move(lid)});
        }
        dot("eye", {14, 81});
        const double own = makeNear(m_source.half.state.scene);
        if (own != figure.near) {
            line("own", {onDepths(own), 70}, {onDepths(own), 106});
            words("", {onDepths(own), 62}, figureNumber(own));
        }
        track([&](double z) { return glm::dvec2(onDepths(z), 88); });
        m_figure.spoken =
            fmt::format("Depths that have a code of their own, on an axis from the eye to the far plane: {} marks; {}",
                        figure.marks.size(), m_source.tells ? count + " for the objects" : "some for the objects");
    }
    static double makeNear(const pipeline::Scene& scene) { return pipeline::codeFigure(scene).near; }

    template <class Place>
    void track(Place place) {
        const auto hold = holdOnFigure(m_source.half.held);
        if (!hold) return;
        const pipeline::Hold& held = m_source.half.held.holds[*hold];
        m_figure.track = {place(held.low), place(held.high)};
    }

    // Below the picture's columns, each buffer but the colours as a curve of its own scale.
    void row() {
        const auto& settings = m_source.scene.settings;
        const auto& spot = m_source.half.held.spot;
        const glm::ivec2 at =
            m_source.pixel.value_or(glm::ivec2(settings.width / 2, spot ? spot->row : settings.height / 2));
        if (at.x < 0 || at.y < 0 || at.x >= settings.width || at.y >= settings.height) return;
        std::vector<BufferName> names;
        for (const BufferName& name : shownBuffers(m_source.half.state))
            if (name.id != BufferId::Color && std::ranges::find(names, name) == names.end()) names.push_back(name);
        const auto seen = m_source.buffer({BufferId::PolygonId});
        if (!seen || names.empty()) return;
        const double x = m_room.left + (at.x + 0.5) * m_room.perColumn;
        line("own", {x, 22}, {x, 100});
        std::string said;
        for (std::size_t i = 0; i < std::min<std::size_t>(names.size(), 2); ++i) {
            const auto buffer = m_source.buffer(names[i]);
            if (!buffer || int(buffer->columns()) != settings.width || int(buffer->rows()) != settings.height) continue;
            curve(*buffer, *seen, at, i == 0 ? "curve" : "second");
            const bool isDrawn = seen->value(std::size_t(at.x), std::size_t(at.y)) >= 0;
            const double value = buffer->value(std::size_t(at.x), std::size_t(at.y), 0);
            said += (said.empty() ? "" : ",  ") + names[i].text() + ' ' +
                    (isDrawn && std::isfinite(value) ? figureNumber(value) : "nothing drawn");
        }
        words("of", {std::clamp(x, 120.0, std::max(120.0, m_room.width - 120)), 16}, said);
        words("", {12, 112}, fmt::format("row {}", at.y), 0);
        m_figure.spoken = fmt::format("Row {}, column {}: {}", at.y, at.x, said);
    }
    // From 28 at the row's largest number to 92 at its smallest, without the pixels in which nothing is seen.
    void curve(const pipeline::AnyBuffer& buffer, const pipeline::AnyBuffer& seen, glm::ivec2 at,
               std::string_view role) {
        const auto y = std::size_t(at.y);
        const auto valueAt = [&](std::size_t column) {
            return seen.value(column, y) >= 0 ? buffer.value(column, y, 0) : std::numeric_limits<double>::quiet_NaN();
        };
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (std::size_t column = 0; column < buffer.columns(); ++column)
            if (const double value = valueAt(column); std::isfinite(value))
                low = std::min(low, value), high = std::max(high, value);
        if (!(low <= high)) return;
        const double range = high > low ? high - low : 1;
        const auto place = [&](std::size_t column, double value) {
            return glm::dvec2(m_room.left + (double(column) + 0.5) * m_room.perColumn,
                              92 - 64 * ((value - low) / range));
        };
        std::vector<glm::dvec2> points;
        const auto endCurve = [&] {
            if (!points.empty()) m_figure.shapes.push_back({Kind::Curve, role, std::move(points)});
            points.clear();
        };
        for (std::size_t column = 0; column < buffer.columns(); ++column) {
            const double value = valueAt(column);
            std::isfinite(value) ? points.push_back(place(column, value)) : endCurve();
        }
        endCurve();
        if (const double value = valueAt(std::size_t(at.x)); std::isfinite(value))
            dot("at", place(std::size_t(at.x), value));
    }

    void equation() {
        const auto& size = m_source.frame.scene().settings;
        if (!m_source.pixel || m_source.pixel->x >= size.width || m_source.pixel->y >= size.height) return;
        const pipeline::PixelReport report = inspectShading(m_source.frame, *m_source.pixel);
        if (!report.covered || report.diffuse.empty() || report.evaluations.empty()) return;
        const int c = m_source.channel;
        const char letter = "rgb"[c];
        const std::string lamp = report.diffuse.size() > 1 ? "I_p" : "I_0";
        const auto sumOf = [&](const std::vector<pipeline::Vec3d>& terms) {
            double sum = 0;
            for (const pipeline::Vec3d& term : terms) sum += term[c];
            return sum;
        };
        const auto isThere = [](const pipeline::Vec3d& term) { return term.x > 0 || term.y > 0 || term.z > 0; };
        const pipeline::Scene& scene = m_source.frame.scene();
        const auto& material = scene.objects[std::size_t(report.object)].material;
        m_figure.terms = {{fmt::format("k_{} I_a", letter), report.ambient[c]},
                          {fmt::format("k_{} {} max(0, N·L)", letter, lamp), sumOf(report.diffuse)}};
        if (std::ranges::any_of(report.specular, isThere))
            m_figure.terms.push_back(
                {fmt::format("k_s {} max(0, {})ⁿ", lamp, usesHalfway(scene.settings.model, material) ? "N·H" : "R·V"),
                 sumOf(report.specular)});
        if (report.emission[c] > 0) m_figure.terms.push_back({fmt::format("e_{}", letter), report.emission[c]});
        m_figure.sumSymbol = fmt::format("I_{}", letter);
        m_figure.most = report.iMax;
        for (const FigureTerm& term : m_figure.terms) {
            m_figure.sum += term.value;
            m_figure.spoken +=
                (m_figure.spoken.empty() ? "" : " + ") + term.symbol + " " + termText(term.value, m_figure.most);
        }
        m_figure.spoken += " = " + termText(m_figure.sum, m_figure.most);
    }

    const FigureSource& m_source;
    const FigureRoom m_room;
    HeldFigure m_figure;
};

}  // namespace

HeldFigure figureOf(const FigureSource& source, const FigureRoom& room) {
    const bool hasRoom = room.width > 0 && std::isfinite(room.left) && std::isfinite(room.perColumn);
    if (!source.half.held.figure || !hasRoom) return {};
    return Drawing(source, room).of(*source.half.held.figure);
}

std::optional<std::size_t> holdOnFigure(const Held& held) {
    const std::string_view key = held.figure == Figure::Codes ? "camera.near" : "";
    for (std::size_t i = 0; i < held.holds.size(); ++i)
        if (held.holds[i].kind == pipeline::Hold::Kind::Number && held.holds[i].keys[0] == key) return i;
    return {};
}

std::string figureNumber(double value) { return withMinus(fmt::format("{:.4g}", value)); }
std::string termText(double value, double most) {
    return withMinus(fmt::format("{:.{}f}", value, std::abs(most) < 10 ? 3 : 1));
}

}  // namespace lessons
