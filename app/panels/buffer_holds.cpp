#include "app/panels/buffer_holds.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "app/core/hand.h"
#include "app/core/text.h"
#include "app/core/theme.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_header.h"
#include "app/panels/buffer_view.h"
#include "app/panels/held_files.h"
#include "app/panels/hold_grip.h"

namespace app {

using pipeline::BufferId;
using Kind = pipeline::Hold::Kind;

namespace {

QFont playFont() { return Theme::current().text(21, 600); }

pipeline::Hold footOf(pipeline::Hold lamp) {
    lamp.kind = Kind::LampFoot;
    return lamp;
}

}  // namespace

// Lets the mouse through.
class BufferHolds::Layer : public QWidget {
public:
    Layer(QWidget* canvas, const BufferHolds& holds) : QWidget(canvas), m_holds(holds) {
        setObjectName("holds");
        setAttribute(Qt::WA_TransparentForMouseEvents);
        hide();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        m_holds.paint(painter);
    }

private:
    const BufferHolds& m_holds;
};

BufferHolds::BufferHolds(BufferView& view)
    : BufferFeature(view),
      m_hand(view.document().hand()),
      m_layer(new Layer(view.canvas(), *this)),
      m_files(new HeldFiles(m_hand, view.document(), &view)) {
    view.canvas()->installEventFilter(this);
    connect(&m_hand, &Hand::taken, this, &BufferHolds::make);
    connect(&m_hand, &Hand::changed, this, &BufferHolds::placeGrips);
    connect(&view.canvas()->placing(), &CanvasPlacing::changed, this, &BufferHolds::placeGrips);
    connect(&view.document().pointing(), &Pointing::pixelChanged, this, &BufferHolds::show);
}

bool BufferHolds::areShown() const {
    return m_isOn && view().isOfPixels() && (!m_hand.holds().empty() || m_hand.held().play);
}

void BufferHolds::setOn(bool on) {
    if (on == m_isOn) return;
    m_isOn = on;
    m_files->setOn(on);
    make();
}

void BufferHolds::setHeld(bool held) {
    if (held == m_isHeld) return;
    m_isHeld = held;
    view().header().setVisible(!held);
    view().canvas()->setGround(held ? Qt::black : QColor());
    show();
    view().refresh();
}

void BufferHolds::make() {
    m_dragged.reset();
    for (HoldGrip* grip : m_grips) grip->deleteLater(), grip->hide();
    m_grips.clear();
    m_fits = areShown();
    if (areShown())
        for (std::size_t i = 0; i < m_hand.holds().size(); ++i) {
            auto* grip = new HoldGrip(m_hand, i, view().canvas());
            connect(grip, &HoldGrip::grabbed, this, [this, i](QPointF at) { begin(i, at); });
            connect(grip, &HoldGrip::dragged, this, &BufferHolds::moveTo);
            connect(grip, &HoldGrip::dropped, this, &BufferHolds::end);
            m_grips.push_back(grip);
        }
    view().want();
    show();
}

pipeline::BufferSet BufferHolds::want() {
    pipeline::BufferSet wanted;
    const bool byItsSurface = std::ranges::any_of(
        m_hand.holds(), [](const auto& hold) { return hold.kind == Kind::Turn || hold.kind == Kind::Along; });
    if (areShown() && byItsSurface) wanted.set(index(BufferId::ObjectId));
    return wanted;
}

// A page that asks for N or L hides their buffers.
bool BufferHolds::showsVectors() const {
    const lessons::Hidden& hidden = view().document().hidden();
    const auto hides = [&](BufferId id) {
        return std::ranges::any_of(hidden.buffers, [&](const pipeline::BufferName& name) { return name.id == id; });
    };
    return !m_hand.holds().empty() && m_hand.holds()[0].kind == Kind::LampAtInfinity && !hides(BufferId::Normal) &&
           !hides(BufferId::LightVector);
}

void BufferHolds::show() {
    if (m_fits && view().shown()) fit();
    m_vectors.reset();
    const std::optional<glm::ivec2> pixel = view().document().pointing().pixel();
    if (areShown() && showsVectors() && pixel && view().frame()) m_vectors = vectorsInPicture(*view().frame(), *pixel);
    m_layer->setVisible(areShown());
    placeGrips();
}

// Once for each half of a page. All of the picture where a lamp may stand beside what is drawn. The place of the play is
// kept free after the answer too, so that nothing moves.
void BufferHolds::fit() {
    CanvasPlacing& placing = view().canvas()->placing();
    const CanvasContent& content = view().canvas()->content();
    if (content.size.isEmpty() || !placing.look().fits) return;
    m_fits = false;
    const bool isLamp = std::ranges::any_of(m_hand.holds(), [](const pipeline::Hold& hold) {
        return hold.kind == Kind::LampAtInfinity || hold.kind == Kind::LampTop;
    });
    QRectF part(QPointF(), QSizeF(content.size));
    if (!isLamp && !content.focus.isEmpty()) part = content.focus;
    const double room = view().canvas()->height(), play = Theme::current().px(56);
    if (room > 2 * play) part.setTop(part.top() - part.height() * play / (room - play));
    placing.follow({.fits = true, .focus = part, .zoom = 1, .center = {}});
}

void BufferHolds::place(CanvasRoom& room) {
    m_layer->setGeometry(QRect(QPoint(), room.size));
    placeGrips();
}

QPointF BufferHolds::onCanvas(glm::dvec2 picture) const {
    const CanvasPlacing& placing = view().canvas()->placing();
    return placing.placement().toWidget(placing.toShown({picture.x, picture.y}));
}

QLineF BufferHolds::trackOf(std::size_t hold) const {
    const auto isTracked = [](const pipeline::Hold& one) { return one.kind == Kind::Number; };
    const auto before = std::count_if(m_hand.holds().begin(), m_hand.holds().begin() + std::ptrdiff_t(hold), isTracked);
    const double side = HoldGrip::side(), x = side * (0.9 + 1.9 * double(before));
    const double low = view().canvas()->height() - side;
    return {x, low, x, std::max(low - 6 * side, 2 * side)};
}

glm::dvec2 BufferHolds::forHand(std::size_t hold, QPointF canvas) const {
    if (m_hand.holds()[hold].kind == Kind::Number) {
        const QLineF track = trackOf(hold);
        return glm::dvec2((canvas.y() - track.y1()) / track.dy());
    }
    const CanvasPlacing& placing = view().canvas()->placing();
    const QPointF picture = placing.toShown(placing.placement().toPicture(canvas));
    return {picture.x(), picture.y()};
}

void BufferHolds::placeGrips() {
    if (!view().document().hasScene()) return;
    const int top = m_hand.held().play ? Theme::current().px(60) : 0;
    const QSize room = view().canvas()->size();
    for (HoldGrip* grip : m_grips) {
        const std::size_t hold = grip->hold();
        const Kind kind = m_hand.holds()[hold].kind;
        const auto place = m_hand.placeOf(hold);
        std::optional<QPointF> at;
        if (kind == Kind::Eye)
            at = QPointF(room.width() - HoldGrip::side(), room.height() - HoldGrip::side());
        else if (place && kind == Kind::Number)
            at = trackOf(hold).pointAt(place->at.x);
        else if (place)
            at = onCanvas(place->at);
        grip->place(at, place && place->isBehind, top);
    }
    m_layer->update();
}

void BufferHolds::begin(std::size_t hold, QPointF at) {
    m_dragged = hold;
    m_pressed = m_last = m_at = at;
    m_hand.begin(hold, forHand(hold, at));
    m_grips[hold]->setDragged(true);
}

void BufferHolds::moveTo(QPointF at, Qt::KeyboardModifiers modifiers) {
    if (!m_dragged || !m_hand.isDragging()) return;
    m_at += (modifiers & Qt::ShiftModifier ? 0.1 : 1) * (at - m_last);
    m_last = at;
    m_hand.moveTo(forHand(*m_dragged, m_at), modifiers & Qt::ControlModifier);
}

void BufferHolds::end() {
    if (!m_dragged) return;
    m_grips[*m_dragged]->setDragged(false);
    m_dragged.reset();
    m_hand.end();
}

// A press that moved nothing picks, as it does where nothing is held: a question may ask for a click.
void BufferHolds::click(QPointF at) {
    m_hand.cancel();
    end();
    if (const auto pixel = view().canvas()->placing().pixelAt(at))
        view().document().pointing().pick(glm::ivec2(pixel->x(), pixel->y()));
}

std::optional<std::size_t> BufferHolds::holdAt(QPointF canvas) const {
    const auto pixel = view().canvas()->placing().pixelAt(canvas);
    if (pixel && view().frame())
        if (const auto ids = view().frame()->buffer({BufferId::ObjectId})) {
            const double id = ids->value(std::size_t(pixel->x()), std::size_t(pixel->y()));
            if (id >= 0)
                if (const auto hold = m_hand.holdOfObject(std::size_t(id))) return hold;
        }
    return m_hand.holdOfEye();
}

// The canvas sees the press afterwards, if at all: it would pick a pixel or move the picture.
bool BufferHolds::eventFilter(QObject*, QEvent* event) {
    if (m_grips.empty()) return false;
    const auto mouse = [event]() -> const QMouseEvent& { return *static_cast<QMouseEvent*>(event); };
    switch (event->type()) {
        case QEvent::MouseButtonPress: {
            if (mouse().button() != Qt::LeftButton || (mouse().modifiers() & Qt::ControlModifier)) return false;
            const auto hold = holdAt(mouse().position());
            if (!hold) return false;
            begin(*hold, mouse().position());
            m_grips[*hold]->setFocus(Qt::MouseFocusReason);
            return true;
        }
        case QEvent::MouseMove:
            if (!m_dragged) return false;
            moveTo(mouse().position(), mouse().modifiers());
            return true;
        case QEvent::MouseButtonRelease:
            if (!m_dragged) return false;
            if ((mouse().position() - m_pressed).manhattanLength() < QApplication::startDragDistance())
                click(mouse().position());
            else
                end();
            return true;
        default: return false;
    }
}

void BufferHolds::paint(QPainter& painter) const {
    const ThemeColors& dark = Theme::colors(ThemeId::Dark);
    const double thin = Theme::current().px(2);
    const auto line = [&](QPointF a, QPointF b, const QColor& color, Qt::PenStyle style = Qt::SolidLine) {
        painter.setPen(QPen(QColor(0, 0, 0, 170), 3 * thin, Qt::SolidLine, Qt::RoundCap));
        if (style == Qt::SolidLine) painter.drawLine(a, b);
        painter.setPen(QPen(color, 1.5 * thin, style, Qt::RoundCap));
        painter.drawLine(a, b);
    };
    for (const HoldGrip* grip : m_grips) {
        const pipeline::Hold& hold = m_hand.holds()[grip->hold()];
        if (grip->isHidden()) continue;
        const QPointF at = QRectF(grip->geometry()).center();
        if (hold.kind == Kind::Number) line(trackOf(grip->hold()).p1(), trackOf(grip->hold()).p2(), QColor(0x8A93A0));
        const auto leadTo = [&](const std::optional<glm::dvec2>& end) {
            if (end) line(at, onCanvas(*end), dark.L, Qt::DotLine);
        };
        if (hold.kind == Kind::LampAtInfinity) leadTo(projected(makeView(view().document().scene()), hold.point));
        if (hold.kind == Kind::LampTop)
            if (const auto foot = placeOf(view().document().scene(), footOf(hold))) leadTo(foot->at);
        if (hold.kind == Kind::Vertex)
            if (const auto before = m_hand.ownPlaceOf(grip->hold())) {
                painter.setBrush(Qt::NoBrush);
                painter.setPen(QPen(Qt::white, thin, Qt::DotLine));
                painter.drawEllipse(onCanvas(before->at), 3 * thin, 3 * thin);
                painter.drawLine(at, onCanvas(before->at));
            }
    }
    const std::optional<glm::ivec2> pixel = view().document().pointing().pixel();
    if (m_isHeld && pixel) {
        painter.setBrush(Qt::NoBrush);
        for (const auto& [color, width] : {std::pair(Qt::black, 2.5), std::pair(Qt::white, 1.25)}) {
            painter.setPen(QPen(color, width * thin));
            painter.drawEllipse(onCanvas(glm::dvec2(*pixel) + 0.5), 5 * thin, 5 * thin);
        }
    }
    if (m_vectors) {
        const auto polygon = [&](const std::vector<glm::dvec2>& points) {
            QPolygonF shape;
            for (const glm::dvec2 point : points) shape << onCanvas(point);
            return shape;
        };
        painter.setPen(QPen(dark.N, thin / 2, Qt::DashLine));
        painter.setBrush(QColor(dark.N.red(), dark.N.green(), dark.N.blue(), 45));
        painter.drawPolygon(polygon(m_vectors->horizon));
        painter.setBrush(Qt::NoBrush);
        const QPointF from = onCanvas(m_vectors->at);
        line(from, onCanvas(m_vectors->N), dark.N);
        line(from, onCanvas(m_vectors->L), dark.L, m_vectors->nDotL > 0 ? Qt::SolidLine : Qt::DotLine);
        painter.setPen(QPen(Qt::white, thin));
        painter.drawPolyline(polygon(m_vectors->arc));
        QFont symbols = Theme::current().formula(24);
        symbols.setBold(true), symbols.setItalic(true);
        painter.setFont(symbols);
        const auto letter = [&](glm::dvec2 end, const QString& name, const QColor& color) {
            QLineF away(from, onCanvas(end));
            away.setLength(away.length() + Theme::current().px(16));
            const double side = Theme::current().px(32);
            QPainterPath path;
            const QFontMetricsF metrics(painter.font());
            path.addText(away.p2() + QPointF(-metrics.horizontalAdvance(name) / 2, side / 4), painter.font(), name);
            painter.strokePath(path, QPen(Qt::black, 2 * thin));
            painter.fillPath(path, color);
        };
        letter(m_vectors->N, QStringLiteral("N"), dark.N);
        letter(m_vectors->L, QStringLiteral("L"), dark.L);
    }
    paintPlay(painter);
}

// Paints the sentence of the play. Once its condition has been true, paints what was found instead.
void BufferHolds::paintPlay(QPainter& painter) const {
    const auto& play = m_hand.held().play;
    if (!play) return;
    const QString done = toQString(play->done);
    const QString text = m_hand.isPlayed() && !done.isEmpty() ? QStringLiteral("● ") + done : toQString(play->text);
    const Theme& theme = Theme::current();
    painter.setFont(playFont());
    const QRect room = m_layer->rect().adjusted(theme.px(20), theme.px(14), -theme.px(20), 0);
    constexpr int kLayout = Qt::AlignTop | Qt::AlignHCenter | Qt::TextWordWrap;
    const QRect box = painter.boundingRect(room, kLayout, text);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 150));
    const int x = theme.px(12), y = theme.px(4);
    painter.drawRoundedRect(box.adjusted(-x, -y, x, y), theme.px(8), theme.px(8));
    painter.setPen(QColor(0xF2F4F7));
    painter.drawText(room, kLayout, text);
}

}  // namespace app
