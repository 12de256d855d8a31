#include "app/drawing3d/label_places.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/drawing3d/label_words.h"
#include "app/drawing3d/obstacles.h"
#include "app/drawing3d/place_choices.h"

namespace app {

namespace {

// Pixels of the design.
constexpr double kPastCorner = 14, kBorder = 16, kMark = 10, kTip = 6, kGap = 4, kLineRoom = 14;

QRectF around(glm::dvec2 p, double r) { return {p.x - r, p.y - r, 2 * r, 2 * r}; }

// Where the way from the middle of the view to a point crosses the border.
glm::dvec2 borderPoint(const Projected& p, glm::dvec2 size, double border) {
    const glm::dvec2 middle = size / 2.0, half = middle - border;
    glm::dvec2 d = p.at - middle;
    if (!std::isfinite(d.x) || !std::isfinite(d.y) || glm::length(d) == 0) d = {0, 1};
    const double reach = std::max(std::abs(d.x) / half.x, std::abs(d.y) / half.y);
    return middle + d / std::max(reach, 1e-300);
}

void markCaption(PlacedLabel& placed, const ViewFrame& view) {
    const Projected p = project(view.camera, view.size, placed.label.at);
    const double border = kBorder * view.scale;
    placed.mark = p.at;
    placed.atBorder = !p.inFront || p.at.x < border || p.at.y < border || p.at.x > view.size.x - border ||
                      p.at.y > view.size.y - border;
    if (!placed.atBorder) return;
    placed.label.text += placed.label.distance;
    placed.mark = borderPoint(p, view.size, border);
}

// The nearest place to `at` where a text and its halo are whole.
glm::dvec2 inside(glm::dvec2 at, QSizeF size, const ViewFrame& view) {
    const glm::dvec2 half = glm::dvec2(size.width(), size.height()) / 2.0 + view.scale * glm::dvec2(8, 4);
    return glm::clamp(at, half, glm::max(half, view.size - half));
}

double overlap(const QRectF& a, const QRectF& b) {
    const QRectF both = a & b;
    return both.isEmpty() ? 0 : both.width() * both.height();
}

bool isInside(glm::dvec2 p, glm::dvec2 view) { return p.x >= 0 && p.y >= 0 && p.x <= view.x && p.y <= view.y; }

// One label after the other takes the place that costs least.
class Chooser {
public:
    Chooser(const Drawing& drawing, const ViewFrame& view, const std::vector<QRectF>& taken,
            const std::vector<PlacedLabel>& before)
        : m_view(view), m_before(before), m_taken(taken) {
        for (const Obstacle& obstacle : drawing.obstacles) see(obstacle);
        for (const Label& label : drawing.labels)
            if (label.kind == Label::Kind::Letter) see({label.foot, label.at});
        for (const InkedLine& line : drawing.lines)
            if (line.strengthA > 0.5f && line.strengthB > 0.5f) see({line.a, line.b});
    }

    void take(const QRectF& box) { m_taken.push_back(box); }
    void take(glm::dvec2 at, double radius) { take(around(at, radius * m_view.scale)); }

    void place(PlacedLabel& label, const Target& target) {
        // Square pixels of the design: what a place is worth that was had; what a pixel farther off costs, and words that
        // the line to the mark crosses.
        constexpr double kStay = 250, kAway = 8, kCrossing = 500;
        constexpr double kLed = 24;  // pixels of the design
        const double s = m_view.scale, area = s * s;
        const auto kept = std::ranges::find_if(m_before, [&](const PlacedLabel& other) {
            return other.label.kind == label.label.kind && other.label.text == label.label.text &&
                   other.atBorder == label.atBorder;
        });
        const std::vector<Place> places = placesOf(label, target, m_view);
        double least = 1e300;
        PlacedLabel tried = label;
        for (std::size_t i = 0; i < places.size(); ++i) {
            tried.at = inside(places[i].at, label.size, m_view);
            const double away = glm::length(nearest(boxOf(tried), label.mark) - label.mark);
            tried.place = i;
            tried.led = target.isTip && away > kLed * s;
            double cost = area * places[i].cost + kAway * s * away;
            if (kept != m_before.end() && kept->place == i) cost -= kStay * area;
            if (cost < least) cost += weight(tried, least - cost);
            if (tried.led && cost < least) cost += kCrossing * area * crossings(tried);
            if (cost >= least) continue;
            least = cost;
            label = tried;
        }
        take(boxOf(label).adjusted(-kGap * s, 0, kGap * s, 0));
    }

private:
    // Words that an arrow or an arc runs through are harder to read than words on a face.
    static constexpr double kOnLine = 8;

    void see(const Obstacle& obstacle) {
        if (obstacle.size() == 2) return seeLine(obstacle[0], obstacle[1]);
        const auto outline = outlineOf(obstacle, m_view);
        if (outline && outline->bounds.intersects(QRectF(0, 0, m_view.size.x, m_view.size.y)))
            m_faces.push_back(*outline);
    }
    // Lines too short to be seen as such, of which some stand in hundreds, are in nobody's way.
    void seeLine(Vec3d a, Vec3d b) {
        constexpr double kShortest = 16;
        const auto seen = seenPart(a, b, m_view);
        if (seen && glm::length(seen->b - seen->a) > kShortest * m_view.scale)
            m_lines.push_back(lineOutline(seen->a, seen->b, kLineRoom * m_view.scale));
    }
    // What lies under a label, as far as it is below `limit`; words on words are worse than words on a picture. The halo of
    // a single letter is enough on a face.
    double weight(const PlacedLabel& label, double limit) const {
        constexpr double kWords = 10, kTouch = 400;  // the least, square pixels of the design
        const QRectF box = boxOf(label);
        double sum = 0;
        for (const QRectF& other : m_taken)
            if (const double both = overlap(box, other); both > 0)
                sum += kWords * both + kTouch * m_view.scale * m_view.scale;
        const auto add = [&](const std::vector<Outline>& outlines, double cost) {
            for (const Outline& outline : outlines) {
                if (sum >= limit) return;
                sum += cost * covered(outline, box);
            }
        };
        add(m_lines, kOnLine);
        if (label.label.kind != Label::Kind::Letter) add(m_faces, 1);
        return sum;
    }

    double crossings(const PlacedLabel& label) const {
        const glm::dvec2 end = nearest(boxOf(label), label.mark);
        const Outline line = lineOutline(label.mark, end, m_view.scale);
        return double(std::ranges::count_if(m_taken, [&](const QRectF& other) {
            return !other.contains(toPoint(label.mark)) && covered(line, other) > 0;
        }));
    }

    const ViewFrame& m_view;
    const std::vector<PlacedLabel>& m_before;
    std::vector<QRectF> m_taken;
    std::vector<Outline> m_faces, m_lines;
};

// A label's mark and its target; false where the view shows nothing of what it belongs to.
bool begin(PlacedLabel& placed, Target& target, const ViewFrame& view) {
    using Kind = Label::Kind;
    const Label& label = placed.label;
    if (label.kind == Kind::Caption) markCaption(placed, view);
    placed.size = sizeOf(label);
    if (label.kind == Kind::Caption) return true;
    if (label.kind == Kind::Letter || label.kind == Kind::Axis) {
        const auto seen = seenPart(label.foot, label.at, view);
        if (!seen) return false;
        target = {seen->a, seen->b, seen->isWhole};
        placed.at = placed.mark = seen->b;
        return true;
    }
    const Projected p = project(view.camera, view.size, label.at);
    if (!p.inFront) return false;
    placed.at = placed.mark = p.at;
    if (label.kind == Kind::Note && isInside(p.at, view.size)) placed.at = inside(p.at, placed.size, view);
    if (label.kind != Kind::Plane) return true;
    const glm::dvec2 d = p.at - project(view.camera, view.size, label.foot).at;
    if (glm::length(d) > 0) placed.at += kPastCorner * view.scale / glm::length(d) * d;
    placed.at.x += (d.x < 0 ? -0.5 : 0.5) * placed.size.width();
    return true;
}

}  // namespace

QRectF boxOf(const PlacedLabel& placed) {
    return {toPoint(placed.at) - QPointF(placed.size.width(), placed.size.height()) / 2, placed.size};
}

glm::dvec2 nearest(const QRectF& box, glm::dvec2 point) {
    return {std::clamp(point.x, box.left(), box.right()), std::clamp(point.y, box.top(), box.bottom())};
}

std::vector<PlacedLabel> placeLabels(const Drawing& drawing, const ViewFrame& view, const std::vector<QRectF>& taken,
                                     const std::vector<PlacedLabel>& before) {
    using Kind = Label::Kind;
    std::vector<PlacedLabel> result;
    std::vector<Target> targets;
    Chooser chooser(drawing, view, taken, before);
    for (const Label& label : drawing.labels) {
        PlacedLabel placed{.label = label};
        Target target;
        if (!begin(placed, target, view)) continue;
        if (label.kind == Kind::Letter && target.isTip) chooser.take(target.tip, kTip);
        if (label.kind == Kind::Caption) chooser.take(placed.mark, kMark);
        if (label.kind == Kind::Note) chooser.take(boxOf(placed));
        result.push_back(placed);
        targets.push_back(target);
    }
    const auto place = [&](Kind kind, const auto& isMeant) {
        for (std::size_t i = 0; i < result.size(); ++i)
            if (result[i].label.kind == kind && isMeant(i)) chooser.place(result[i], targets[i]);
    };
    const auto all = [](std::size_t) { return true; };
    // Those at the border have the fewest places.
    place(Kind::Letter, [&](std::size_t i) { return !targets[i].isTip; });
    place(Kind::Letter, [&](std::size_t i) { return targets[i].isTip; });
    for (const Kind kind : {Kind::Angle, Kind::Plane, Kind::Axis}) place(kind, all);
    place(Kind::Caption, [&](std::size_t i) { return result[i].atBorder; });
    place(Kind::Caption, [&](std::size_t i) { return !result[i].atBorder; });
    return result;
}

}  // namespace app
