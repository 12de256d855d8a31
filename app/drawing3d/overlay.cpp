#include "app/drawing3d/overlay.h"

#include <QCoreApplication>
#include <QPainterPath>
#include <QPixmapCache>
#include <QThread>
#include <algorithm>
#include <cmath>

#include "app/drawing3d/label_words.h"
#include "app/look/text.h"

namespace app {

namespace {

constexpr double kTextHalo = 5;  // pixels of the design

// Text with a halo in the view's colour, so that it reads on any picture; its middle is the origin.
void paintHaloedText(QPainter& painter, const Label& label, const QColor& ink, double halo) {
    QPainterPath path = pathOf(label);
    path.translate(-path.boundingRect().center());
    QColor back = Theme::current().colors().view;
    back.setAlphaF(0.88f);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.strokePath(path, QPen(back, halo, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, ink);
}

// The same around `at`. Stroking outlines took an eighth of the window's time while a hand drags: the few words of a
// view are stroked once and kept as pictures.
void paintText(QPainter& painter, glm::dvec2 at, const Label& label, const QColor& ink, double halo) {
    // A picture would be scaled; and only the window's thread has pictures to keep.
    const bool isWindow = QThread::currentThread() == QCoreApplication::instance()->thread();
    if (!isWindow || painter.transform().type() > QTransform::TxTranslate) {
        painter.save();
        painter.translate(toPoint(at));
        paintHaloedText(painter, label, ink, halo);
        painter.restore();
        return;
    }
    const double ratio = painter.device()->devicePixelRatio();
    const QString key = QStringList{toQString(label.text),
                                    fontOf(label.kind).key(),
                                    QString::number(int(label.kind)),
                                    ink.name(QColor::HexArgb),
                                    Theme::current().colors().view.name(),
                                    QString::number(ratio),
                                    QString::number(halo)}
                            .join('\n');
    QPixmap picture;
    if (!QPixmapCache::find(key, &picture)) {
        const QSizeF box = pathOf(label).boundingRect().size() + QSizeF(2 * halo, 2 * halo);
        picture = QPixmap(int(std::ceil(box.width() * ratio)), int(std::ceil(box.height() * ratio)));
        picture.setDevicePixelRatio(ratio);
        picture.fill(Qt::transparent);
        QPainter words(&picture);
        words.translate(QPointF(picture.width(), picture.height()) / (2 * ratio));
        paintHaloedText(words, label, ink, halo);
        QPixmapCache::insert(key, picture);
    }
    // On whole pixels of the screen, so that letters stay sharp.
    const QPointF corner = toPoint(at) - QPointF(picture.width(), picture.height()) / (2 * ratio);
    painter.drawPixmap(QPointF(std::round(corner.x() * ratio), std::round(corner.y() * ratio)) / ratio, picture);
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

// From a mark to the nearest point of its words.
void paintLeader(QPainter& painter, const PlacedLabel& placed, const QColor& ink, double scale) {
    QLineF line(toPoint(nearest(boxOf(placed), placed.mark)), toPoint(placed.mark));
    constexpr double kMarkLength = 8;
    if (line.length() <= kMarkLength * scale) return;
    line.setLength(line.length() - (placed.label.kind == Label::Kind::Caption ? kMarkLength * scale : 0));
    for (const QPen& pen : {QPen(Theme::current().colors().view, 3 * scale), QPen(ink, scale)}) {
        painter.setPen(pen);
        painter.drawLine(line);
    }
}

}  // namespace

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

void paintOverlay(QPainter& painter, const Drawing& drawing, const ViewFrame& view,
                  const std::vector<PlacedLabel>& labels) {
    const Theme& theme = Theme::current();
    const ThemeColors& colors = theme.colors();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (drawing.point) paintMarker(painter, *drawing.point, view, true);
    if (drawing.foot) paintMarker(painter, *drawing.foot, view, false);
    if (drawing.vertex) paintProbe(painter, *drawing.vertex, view);
    const auto paint = [&](const PlacedLabel& placed) {
        const Label::Kind kind = placed.label.kind;
        if (placed.led) paintLeader(painter, placed, colors.text2, view.scale);
        if (placed.atBorder) paintBorderMark(painter, placed, view.scale);
        const bool quiet = kind == Label::Kind::Caption;
        paintText(painter, placed.at, placed.label,
                  mixed(quiet ? colors.text2 : colorOf(placed.label.ink, colors), colors.view, placed.label.strength),
                  kTextHalo * view.scale);
    };
    // Letters over captions.
    for (const bool captions : {true, false})
        for (const PlacedLabel& placed : labels)
            if ((placed.label.kind == Label::Kind::Caption) == captions) paint(placed);
    painter.restore();
}

}  // namespace app
