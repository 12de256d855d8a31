#include "app/view3d/overlay.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainterPath>
#include <QPixmapCache>
#include <QThread>
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/core/text.h"

namespace app {

namespace {

// Pixels of the design.
constexpr double kLetterGap = 21, kTipGap = 17, kBeyondTip = 14, kBorder = 16, kHalo = 5;

QPointF toPoint(glm::dvec2 p) { return {p.x, p.y}; }

glm::dvec2 unit(glm::dvec2 v, glm::dvec2 otherwise) {
    const double length = glm::length(v);
    return length > 0 ? v / length : otherwise;
}

QFont fontOf(Label::Kind kind) {
    const Theme& theme = Theme::current();
    switch (kind) {
        case Label::Kind::Letter: {
            QFont font = theme.formula(21);
            font.setBold(true);
            font.setItalic(true);
            return font;
        }
        case Label::Kind::Axis: {
            QFont font = theme.formula(16);
            font.setItalic(true);
            return font;
        }
        case Label::Kind::Note:
        case Label::Kind::Plane: return theme.mono(12);
        case Label::Kind::Caption: break;
    }
    return theme.text(12);
}

// Text with a halo in the view's colour, so that it reads on any picture; its middle is the origin.
void paintHaloedText(QPainter& painter, const QString& text, const QFont& font, const QColor& ink, double halo) {
    QPainterPath path;
    path.addText(-QFontMetricsF(font).tightBoundingRect(text).center(), font, text);
    QColor back = Theme::current().colors().view;
    back.setAlphaF(0.88f);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.strokePath(path, QPen(back, halo, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, ink);
}

// The same around `at`. Stroking outlines took an eighth of the window's time while a hand drags: the few words of a
// view are stroked once and kept as pictures.
void paintText(QPainter& painter, glm::dvec2 at, const QString& text, const QFont& font, const QColor& ink,
               double halo) {
    // A picture would be scaled; and only the window's thread has pictures to keep.
    const bool isWindow = QThread::currentThread() == QCoreApplication::instance()->thread();
    if (!isWindow || painter.transform().type() > QTransform::TxTranslate) {
        painter.save();
        painter.translate(toPoint(at));
        paintHaloedText(painter, text, font, ink, halo);
        painter.restore();
        return;
    }
    const double ratio = painter.device()->devicePixelRatio();
    const QString key = QStringList{text,
                                    font.key(),
                                    ink.name(QColor::HexArgb),
                                    Theme::current().colors().view.name(),
                                    QString::number(ratio),
                                    QString::number(halo)}
                            .join('\n');
    QPixmap picture;
    if (!QPixmapCache::find(key, &picture)) {
        const QSizeF box = QFontMetricsF(font).tightBoundingRect(text).size() + QSizeF(2 * halo, 2 * halo);
        picture = QPixmap(int(std::ceil(box.width() * ratio)), int(std::ceil(box.height() * ratio)));
        picture.setDevicePixelRatio(ratio);
        picture.fill(Qt::transparent);
        QPainter words(&picture);
        words.translate(QPointF(picture.width(), picture.height()) / (2 * ratio));
        paintHaloedText(words, text, font, ink, halo);
        QPixmapCache::insert(key, picture);
    }
    // On whole pixels of the screen, so that letters stay sharp.
    const QPointF corner = toPoint(at) - QPointF(picture.width(), picture.height()) / (2 * ratio);
    painter.drawPixmap(QPointF(std::round(corner.x() * ratio), std::round(corner.y() * ratio)) / ratio, picture);
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

// Where a text of this size may stand, the best first. At the border inwards; else above its mark, below it, at a side.
std::vector<glm::dvec2> captionPlaces(const PlacedLabel& placed, QSizeF size, const ViewFrame& view) {
    const double beside = 14 * view.scale, above = 18 * view.scale;
    const glm::dvec2 aside{size.width() / 2 + beside, 0};
    const double line = size.height();
    std::vector<glm::dvec2> places;
    const bool right = placed.mark.x > view.size.x / 2;
    const glm::dvec2 inwards = placed.mark + (right ? -aside : aside),
                     outwards = placed.mark + (right ? aside : -aside);
    if (!placed.atBorder) {
        places = {placed.mark - glm::dvec2(0, above), placed.mark + glm::dvec2(0, above), inwards, outwards};
        for (const double lines : {1.0, 2.0})
            for (const double sign : {-1.0, 1.0})
                places.push_back(placed.mark + glm::dvec2(0, sign * (above + lines * line)));
    }
    for (int lines = 0; lines <= 4; ++lines)
        for (const double sign : {-1.0, 1.0}) places.push_back(inwards + glm::dvec2(0, sign * lines * line));
    return places;
}

glm::dvec2 inside(glm::dvec2 at, QSizeF size, glm::dvec2 view) {
    const glm::dvec2 half{size.width() / 2 + 8, size.height() / 2 + 4};
    return {std::clamp(at.x, half.x, std::max(half.x, view.x - half.x)),
            std::clamp(at.y, half.y, std::max(half.y, view.y - half.y))};
}

QSizeF sizeOf(const Label& label) {
    const QFontMetricsF metrics(fontOf(label.kind));
    const QString text = toQString(label.text);
    if (label.kind == Label::Kind::Letter || label.kind == Label::Kind::Axis)
        return metrics.tightBoundingRect(text).size();
    return {metrics.horizontalAdvance(text), metrics.height()};
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

// What belongs to a plane, a length or an equation, gives way to letters by lines, up or down.
void movePlanes(std::vector<PlacedLabel>& labels, const std::vector<glm::dvec2>& tips, const ViewFrame& view) {
    const double r = 6 * view.scale;
    std::vector<QRectF> taken;
    for (const glm::dvec2& tip : tips) taken.push_back(QRectF(tip.x - r, tip.y - r, 2 * r, 2 * r));
    for (const PlacedLabel& placed : labels)
        if (placed.label.kind != Label::Kind::Caption && placed.label.kind != Label::Kind::Plane)
            taken.push_back(boxOf(placed));
    for (PlacedLabel& plane : labels) {
        if (plane.label.kind != Label::Kind::Plane) continue;
        const glm::dvec2 own = plane.at;
        const QSizeF size = plane.size;
        double least = 1e300;
        for (const int lines : {0, -1, 1, -2, 2, -3, 3}) {
            PlacedLabel tried = plane;
            tried.at = inside(own + glm::dvec2(0, lines * size.height()), size, view.size);
            double covered = 0;
            for (const QRectF& other : taken) covered += overlap(boxOf(tried), other);
            if (covered >= least) continue;
            least = covered;
            plane.at = tried.at;
            if (covered == 0) break;
        }
        taken.push_back(boxOf(plane));
    }
}

// One caption after the other, each at the place where it covers least.
void placeCaptions(std::vector<PlacedLabel>& labels, const std::vector<glm::dvec2>& tips, const ViewFrame& view,
                   std::vector<QRectF> taken) {
    const double mark = 7 * view.scale, tipRadius = 6 * view.scale;
    const auto around = [](glm::dvec2 p, double r) { return QRectF(p.x - r, p.y - r, 2 * r, 2 * r); };
    for (const glm::dvec2& tip : tips) taken.push_back(around(tip, tipRadius));
    for (const PlacedLabel& placed : labels)
        taken.push_back(placed.label.kind == Label::Kind::Caption ? around(placed.mark, mark) : boxOf(placed));
    for (PlacedLabel& caption : labels) {
        if (caption.label.kind != Label::Kind::Caption) continue;
        const QSizeF size = caption.size;
        double least = 1e300;
        for (const glm::dvec2& wanted : captionPlaces(caption, size, view)) {
            PlacedLabel tried = caption;
            tried.at = inside(wanted, size, view.size);
            // Moved off its own place by the border it may lie on its mark.
            double covered = 0;
            for (const QRectF& other : taken) covered += overlap(boxOf(tried), other);
            if (covered >= least) continue;
            least = covered;
            caption.at = tried.at;
            if (covered == 0) break;
        }
        taken.push_back(boxOf(caption));
    }
}

void paintBorderMark(QPainter& painter, const PlacedLabel& placed, double scale) {
    const ThemeColors& colors = Theme::current().colors();
    const QColor ink = colorOf(placed.label.ink, colors);
    painter.setPen(QPen(ink, 2.5 * scale));
    painter.setBrush(placed.label.ink == Ink::V ? QBrush(colors.view) : QBrush(ink));
    painter.drawEllipse(toPoint(placed.mark), 5.5 * scale, 5.5 * scale);
}

// White in black, seen on every picture: a square stands for a pixel, as in the buffer views.
void paintMarker(QPainter& painter, const Drawing::Marker& marker, const ViewFrame& view, bool square) {
    const Projected p = project(view.camera, view.size, marker.at);
    if (!p.inFront) return;
    const double s = view.scale;
    painter.setPen(QPen(Qt::black, 1.8 * s, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.setBrush(marker.hidden ? Qt::NoBrush : QBrush(Qt::white));
    if (square)
        painter.drawRect(QRectF(p.at.x - 3.5 * s, p.at.y - 3.5 * s, 7 * s, 7 * s));
    else
        painter.drawEllipse(toPoint(p.at), 4.2 * s, 4.2 * s);
}

}  // namespace

QRectF boxOf(const PlacedLabel& placed) {
    return {toPoint(placed.at) - QPointF(placed.size.width(), placed.size.height()) / 2, placed.size};
}

std::vector<PlacedLabel> placeLabels(const Drawing& drawing, const ViewFrame& view, const std::vector<QRectF>& taken) {
    std::vector<PlacedLabel> result;
    std::vector<glm::dvec2> tips;
    for (const Label& label : drawing.labels) {
        PlacedLabel placed{label, {}, {}, false, {}};
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
        placed.at =
            label.kind == Label::Kind::Note ? p.at : p.at + kBeyondTip * view.scale * unit(p.at - foot, {0, -1});
        if (label.kind == Label::Kind::Plane) placed.at.x += (p.at.x < foot.x ? -0.5 : 0.5) * placed.size.width();
        if (label.kind == Label::Kind::Letter) tips.push_back(p.at);
        result.push_back(placed);
    }
    relax(result, tips, view.scale);
    for (PlacedLabel& placed : result) {
        // An axis that ends outside has its name there.
        const bool isAway = placed.label.kind == Label::Kind::Axis || placed.label.kind == Label::Kind::Note;
        const bool isTip = placed.label.kind == Label::Kind::Letter;
        if (isAway || (isTip && !isInside(placed.mark, view.size))) continue;
        placed.at = inside(placed.at, placed.size, view.size);
        if (isTip) leave(placed, taken, view.size);
    }
    movePlanes(result, tips, view);
    placeCaptions(result, tips, view, taken);
    return result;
}

void paintProbe(QPainter& painter, Vec3d point, const ViewFrame& view) {
    const Projected p = project(view.camera, view.size, point);
    if (!p.inFront) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(Qt::black, 3 * view.scale), QPen(Qt::white, 1.5 * view.scale)}) {
        painter.setPen(pen);
        painter.drawEllipse(toPoint(p.at), 5 * view.scale, 5 * view.scale);
    }
    painter.restore();
}

void paintOverlay(QPainter& painter, const Drawing& drawing, const ViewFrame& view, const std::vector<QRectF>& taken) {
    const Theme& theme = Theme::current();
    const ThemeColors& colors = theme.colors();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (drawing.point) paintMarker(painter, *drawing.point, view, true);
    if (drawing.foot) paintMarker(painter, *drawing.foot, view, false);
    if (drawing.vertex) paintProbe(painter, *drawing.vertex, view);
    std::vector<PlacedLabel> labels = placeLabels(drawing, view, taken);
    // Letters over captions.
    std::ranges::stable_partition(labels, [](const PlacedLabel& p) { return p.label.kind == Label::Kind::Caption; });
    for (const PlacedLabel& placed : labels) {
        const Label::Kind kind = placed.label.kind;
        if (placed.atBorder) paintBorderMark(painter, placed, view.scale);
        const bool quiet = kind == Label::Kind::Caption;
        paintText(painter, placed.at, toQString(placed.label.text), fontOf(kind),
                  mixed(quiet ? colors.text2 : colorOf(placed.label.ink, colors), colors.view, placed.label.strength),
                  kHalo * view.scale);
    }
    painter.restore();
}

}  // namespace app
