#include "app/view3d/label_places.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/view3d/label_words.h"
#include "app/view3d/obstacles.h"

namespace app {

namespace {

// Pixels of the design.
constexpr double kLetterGap = 21, kTipGap = 17, kBeyondTip = 14, kBorder = 16, kBeside = 14, kAbove = 20, kMark = 10;

QRectF around(glm::dvec2 p, double r) { return {p.x - r, p.y - r, 2 * r, 2 * r}; }

glm::dvec2 unit(glm::dvec2 v, glm::dvec2 otherwise) {
    const double length = glm::length(v);
    return length > 0 ? v / length : otherwise;
}

// A few steps that push letters off each other and off tips; each step moves by what is missing.
void relax(std::vector<PlacedLabel>& labels, const std::vector<glm::dvec2>& tips, double scale) {
    for (int step = 0; step < 24; ++step)
        for (PlacedLabel& a : labels) {
            if (a.label.kind != Label::Kind::Letter) continue;
            glm::dvec2 push{0.0};
            for (const PlacedLabel& b : labels) {
                if (&a == &b || b.label.kind != Label::Kind::Letter) continue;
                const glm::dvec2 d = a.at - b.at;
                const double missing = kLetterGap * scale - glm::length(d);
                // Two letters in one place part sideways, in the order of the list.
                if (missing > 0) push += 0.5 * missing * unit(d, {&a < &b ? -1.0 : 1.0, 0});
            }
            for (const glm::dvec2& tip : tips) {
                const glm::dvec2 d = a.at - tip;
                const double missing = kTipGap * scale - glm::length(d);
                if (missing > 0) push += missing * unit(d, {0, -1});
            }
            a.at += 0.6 * push;
        }
}

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

glm::dvec2 inside(glm::dvec2 at, QSizeF size, glm::dvec2 view) {
    const glm::dvec2 half{size.width() / 2 + 8, size.height() / 2 + 4};
    return {std::clamp(at.x, half.x, std::max(half.x, view.x - half.x)),
            std::clamp(at.y, half.y, std::max(half.y, view.y - half.y))};
}

double overlap(const QRectF& a, const QRectF& b) {
    const QRectF both = a & b;
    return both.isEmpty() ? 0 : both.width() * both.height();
}

bool isInside(glm::dvec2 p, glm::dvec2 view) { return p.x >= 0 && p.y >= 0 && p.x <= view.x && p.y <= view.y; }

// Where a vector leads out of the view: its letter stands beside the shaft there. Nothing where the tip is seen, or where
// it begins outside as well.
std::optional<glm::dvec2> exitOf(const Label& letter, const ViewFrame& view) {
    const Projected foot = project(view.camera, view.size, letter.foot);
    Projected tip = project(view.camera, view.size, letter.at);
    if (!foot.inFront || !isInside(foot.at, view.size) || (tip.inFront && isInside(tip.at, view.size))) return {};
    // The part of it that is before the observer.
    if (!tip.inFront)
        tip = project(view.camera, view.size,
                      glm::mix(letter.foot, letter.at, 0.99 * foot.depth / (foot.depth - tip.depth)));
    double t = 1;
    const glm::dvec2 d = tip.at - foot.at;
    for (int i = 0; i < 2; ++i)
        if (d[i] != 0) t = std::min(t, ((d[i] > 0 ? view.size[i] : 0) - foot.at[i]) / d[i]);
    const glm::dvec2 along = unit(d, {0, -1}),
                     across = along.y > 0 ? glm::dvec2(along.y, -along.x) : glm::dvec2(-along.y, along.x);
    return foot.at + t * d + kBeyondTip * view.scale * (across - along);
}

// A letter on what lies over the view would not be seen: off it by the shortest way that stays inside.
void leave(PlacedLabel& letter, const std::vector<QRectF>& taken, glm::dvec2 view) {
    const QSizeF size = letter.size;
    const glm::dvec2 half = glm::dvec2(size.width(), size.height()) / 2.0;
    for (const QRectF& other : taken) {
        if (overlap(boxOf(letter), other) == 0) continue;
        const glm::dvec2 own = letter.at;
        double least = 1e300;
        for (const glm::dvec2 tried : {glm::dvec2(own.x, other.top() - half.y - 2),
                                       {own.x, other.bottom() + half.y + 2},
                                       {other.left() - half.x - 2, own.y},
                                       {other.right() + half.x + 2, own.y}}) {
            const double way = glm::length(tried - own);
            if (way >= least ||
                glm::any(glm::greaterThan(glm::abs(tried - inside(tried, size, view)), glm::dvec2(0.5))))
                continue;
            least = way;
            letter.at = tried;
        }
    }
}

// A place that a label may take, and what it costs where nothing is in its way, in square pixels of the design.
struct Place {
    glm::dvec2 at;
    double cost = 0;
};

// Around a mark: above it and below it, then at its sides, inwards rather than outwards, then farther away.
std::vector<Place> captionPlaces(const PlacedLabel& caption, const ViewFrame& view) {
    const double s = view.scale, line = caption.size.height(), half = caption.size.width() / 2;
    const double inwards = caption.mark.x > view.size.x / 2 ? -1 : 1;
    std::vector<Place> places;
    const auto add = [&](double x, double y, double cost) {
        places.push_back({caption.mark + glm::dvec2(x, y), cost});
    };
    for (const double lines : {0, 1, 2, 3})
        for (const double sign : {-1, 1})
            for (const double aside : {0, -1, 1})
                add(aside * (half - 8 * s), sign * (kAbove * s + lines * line),
                    (sign < 0 ? 0 : 5) + 20 * std::abs(aside) + (caption.atBorder ? 30 : 0));
    for (const double side : {-1, 1})
        for (const double away : {0, 40, 80})
            for (const double lines : {0, -1, 1, -2, 2, -3, 3, -4, 4})
                add(side * (half + (kBeside + away) * s), lines * line,
                    (side == inwards ? 10 : 15) + (side == inwards || !caption.atBorder ? 0 : 1e4));
    return places;
}

// Beyond the end, and around it.
std::vector<Place> axisPlaces(const PlacedLabel& axis, glm::dvec2 foot, double scale) {
    const glm::dvec2 along = kBeyondTip * scale * unit(axis.mark - foot, {0, -1}), across{-along.y, along.x};
    const glm::dvec2 end = axis.mark;
    // A thin line behind a letter counts more than a few pixels' way.
    return {{end + along},
            {end + along + across, 6},
            {end + along - across, 6},
            {end + 2.0 * along, 8},
            {end + across, 10},
            {end - across, 10},
            {end - along + 1.2 * across, 14},
            {end - along - 1.2 * across, 14}};
}

// Up or down by lines and farther away, on its own side of the corner or on the other one.
std::vector<Place> planePlaces(const PlacedLabel& plane, double scale) {
    std::vector<Place> places;
    for (const double side : {1, -1})
        for (const double away : {0, 50, 100, 150})
            for (const int lines : {0, -1, 1, -2, 2, -3, 3}) {
                const glm::dvec2 own = plane.at - plane.mark;
                const double x = own.x + std::copysign(away * scale, own.x);
                places.push_back(
                    {plane.mark + glm::dvec2(side * x, own.y + lines * plane.size.height()), side < 0 ? 60.0 : 0});
            }
    return places;
}

// At the middle of its arc, or a little off.
std::vector<Place> anglePlaces(const PlacedLabel& angle, double scale) {
    const glm::dvec2 step{angle.size.width() / 2 + 6 * scale, 0.8 * angle.size.height()};
    std::vector<Place> places;
    for (const double y : {0.0, -0.5, 0.5, -1.0, 1.0, -1.5, 1.5, -2.0, 2.0, -3.0, 3.0})
        for (const double x : {0.0, -0.25, 0.25, -0.5, 0.5, -1.0, 1.0, -1.5, 1.5})
            places.push_back({angle.mark + step * glm::dvec2(x, y), 15 * (x * x + y * y)});
    return places;
}

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

    void place(PlacedLabel& label, const std::vector<Place>& places) {
        // Square pixels of the design: what a place is worth that was had; what a pixel farther off costs, and words that
        // the line to the mark crosses.
        constexpr double kStay = 250, kAway = 8, kCrossing = 500;
        constexpr double kLed = 24;  // pixels of the design
        const double s = m_view.scale, area = s * s;
        const auto kept = std::ranges::find_if(m_before, [&](const PlacedLabel& other) {
            return other.label.kind == label.label.kind && other.label.text == label.label.text &&
                   other.atBorder == label.atBorder;
        });
        double least = 1e300;
        PlacedLabel tried = label;
        for (std::size_t i = 0; i < places.size(); ++i) {
            Place place = places[i];
            place.at = inside(place.at, label.size, m_view.size);
            tried.at = place.at;
            const double away = glm::length(nearest(boxOf(tried), label.mark) - label.mark);
            tried.place = i;
            tried.led = away > kLed * s;
            double cost = area * place.cost + kAway * s * away;
            if (kept != m_before.end() && kept->place == i) cost -= kStay * area;
            if (cost < least) cost += weight(boxOf(tried), least - cost);
            if (tried.led && cost < least) cost += kCrossing * area * crossings(tried);
            if (cost >= least) continue;
            least = cost;
            label = tried;
        }
        take(boxOf(label));
    }

private:
    // Words that an arrow or an arc runs through are harder to read than words on a face.
    static constexpr double kOnLine = 5;

    // Lines too short to be seen as such, of which some stand in hundreds, are in nobody's way.
    void see(const Obstacle& obstacle) {
        constexpr double kShortest = 8;
        const auto outline = outlineOf(obstacle, m_view);
        if (outline && std::max(outline->bounds.width(), outline->bounds.height()) > 2 * kShortest * m_view.scale &&
            outline->bounds.intersects(QRectF(0, 0, m_view.size.x, m_view.size.y)))
            m_outlines.push_back({*outline, obstacle.size() == 2 ? kOnLine : 1});
    }
    // What lies under a box, as far as it is below `limit`; words on words are worse than words on a picture.
    double weight(const QRectF& box, double limit) const {
        constexpr double kWords = 10;
        double sum = 0;
        for (const QRectF& other : m_taken) sum += kWords * overlap(box, other);
        for (const auto& [outline, cost] : m_outlines) {
            if (sum >= limit) break;
            sum += cost * covered(outline, box);
        }
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
    struct Seen {
        Outline outline;
        double cost;  // of a square pixel of it
    };
    std::vector<Seen> m_outlines;
};

void placeWords(std::vector<PlacedLabel>& labels, const std::vector<glm::dvec2>& tips, const ViewFrame& view,
                Chooser& chooser) {
    using Kind = Label::Kind;
    for (const glm::dvec2& tip : tips) chooser.take(tip, 6);
    for (const PlacedLabel& placed : labels) {
        if (placed.label.kind == Kind::Caption) chooser.take(placed.mark, kMark);
        if (placed.label.kind == Kind::Letter || placed.label.kind == Kind::Note) chooser.take(boxOf(placed));
    }
    for (PlacedLabel& angle : labels)
        if (angle.label.kind == Kind::Angle) chooser.place(angle, anglePlaces(angle, view.scale));
    // An axis that ends outside has its name there.
    for (PlacedLabel& axis : labels)
        if (axis.label.kind == Kind::Axis && isInside(axis.mark, view.size))
            chooser.place(axis, axisPlaces(axis, project(view.camera, view.size, axis.label.foot).at, view.scale));
    for (PlacedLabel& plane : labels)
        if (plane.label.kind == Kind::Plane) chooser.place(plane, planePlaces(plane, view.scale));
    // Those at the border have the fewest places.
    for (const bool atBorder : {true, false})
        for (PlacedLabel& caption : labels)
            if (caption.label.kind == Kind::Caption && caption.atBorder == atBorder)
                chooser.place(caption, captionPlaces(caption, view));
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
    std::vector<PlacedLabel> result;
    std::vector<glm::dvec2> tips;
    for (const Label& label : drawing.labels) {
        PlacedLabel placed{.label = label};
        const Projected p = project(view.camera, view.size, label.at);
        if (label.kind == Label::Kind::Caption) {
            markCaption(placed, view);
            placed.size = sizeOf(placed.label);
            result.push_back(placed);
            continue;
        }
        placed.size = sizeOf(label);
        if (const auto exit = label.kind == Label::Kind::Letter ? exitOf(label, view) : std::nullopt) {
            placed.at = placed.mark = inside(*exit, placed.size, view.size);
            result.push_back(placed);
            continue;
        }
        if (!p.inFront) continue;
        const glm::dvec2 foot = project(view.camera, view.size, label.foot).at;
        placed.mark = p.at;
        const bool isThere = label.kind == Label::Kind::Note || label.kind == Label::Kind::Angle;
        placed.at = isThere ? p.at : p.at + kBeyondTip * view.scale * unit(p.at - foot, {0, -1});
        if (label.kind == Label::Kind::Plane) placed.at.x += (p.at.x < foot.x ? -0.5 : 0.5) * placed.size.width();
        if (label.kind == Label::Kind::Letter) tips.push_back(p.at);
        result.push_back(placed);
    }
    relax(result, tips, view.scale);
    std::vector<QRectF> withMarks = taken;
    for (const PlacedLabel& placed : result)
        if (placed.atBorder) withMarks.push_back(around(placed.mark, kMark * view.scale));
    for (PlacedLabel& placed : result) {
        if (placed.label.kind != Label::Kind::Letter || !isInside(placed.mark, view.size)) continue;
        placed.at = inside(placed.at, placed.size, view.size);
        leave(placed, withMarks, view.size);
    }
    Chooser chooser(drawing, view, taken, before);
    placeWords(result, tips, view, chooser);
    return result;
}

}  // namespace app
