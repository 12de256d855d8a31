#include "app/buffer_view/buffer_holds.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_view.h"
#include "app/buffer_view/held_band.h"
#include "app/canvas/buffer_canvas.h"
#include "app/document/hand.h"
#include "app/holds/held_files.h"
#include "app/look/text.h"
#include "app/look/theme.h"

namespace app {

using pipeline::BufferId;
using HoldKind = pipeline::Hold::Kind;
using GripShape = HoldGrip::Look::Shape;
using What = HeldGrip::What;

namespace {

HoldGrip::Look lookOf(HoldKind kind) {
    switch (kind) {
        case HoldKind::LampAtInfinity:
        case HoldKind::LampTop: return {GripShape::Sun};
        case HoldKind::LampFoot: return {GripShape::Foot};
        case HoldKind::Eye: return {GripShape::Disc, QStringLiteral("◉")};
        case HoldKind::Turn: return {GripShape::Disc, QStringLiteral("↔")};
        case HoldKind::Along: return {GripShape::Disc, QStringLiteral("⤢")};
        case HoldKind::Number: return {GripShape::Square, QStringLiteral("↕")};
        case HoldKind::Vertex:
        case HoldKind::Rim: break;
    }
    return {};
}

}  // namespace

BufferHolds::BufferHolds(BufferView& view)
    : BufferFeature(view),
      m_hand(view.document().hand()),
      m_layer(new HoldMarks(view.canvas())),
      m_files(new HeldFiles(m_hand, view.document(), &view)),
      m_band(new HeldBand(view)),
      m_places(view, *m_band),
      m_inside(new QPushButton(view.canvas())) {
    m_inside->setObjectName("lookInside");
    m_inside->hide();
    connect(m_inside, &QPushButton::clicked, &m_hand, &Hand::insideAsked);
    view.canvas()->installEventFilter(this);
    connect(&m_hand, &Hand::taken, this, &BufferHolds::make);
    connect(&m_hand, &Hand::changed, this, &BufferHolds::placeGrips);
    connect(&view.canvas()->placing(), &CanvasPlacing::changed, this, &BufferHolds::placeGrips);
    connect(&view.document().pointing(), &Pointing::pixelChanged, this, &BufferHolds::show);
}

bool BufferHolds::areShown() const { return m_isOn && view().isOfPixels() && !m_hand.isEmpty(); }

void BufferHolds::setOn(bool on) {
    if (on == m_isOn) return;
    m_isOn = on;
    m_files->setOn(on);
    m_band->setOn(on);
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
    m_drag.reset();
    for (const HeldGrip& grip : m_grips) grip.button->deleteLater(), grip.button->hide();
    m_grips.clear();
    m_tracks = 0;
    // Once the page's view is set: that places the picture, too.
    m_fits = false;
    QMetaObject::invokeMethod(
        this, [this] { m_fits = areShown(), show(); }, Qt::QueuedConnection);
    const std::vector<pipeline::Hold>& holds = m_hand.holds();
    for (std::size_t i = 0; areShown() && i < holds.size(); ++i)
        add(What::Hold, i, toQString(holds[i].name), lookOf(holds[i].kind));
    if (const auto& spot = m_hand.held().spot; areShown() && spot)
        add(What::Spot, 0, toQString(spot->name), {GripShape::Disc, QStringLiteral("↔")});
    view().want();
    show();
}

void BufferHolds::add(What what, std::size_t hold, const QString& name, HoldGrip::Look look) {
    const std::size_t number = m_grips.size();
    const bool isOnFigure = what == What::Hold && holdOnFigure(m_hand.held()) == hold;
    QWidget* room = isOnFigure ? static_cast<QWidget*>(m_band) : view().canvas();
    auto* button = new HoldGrip(name, std::move(look), room);
    connect(button, &HoldGrip::grabbed, this, [this, number](QPointF at) { begin(number, at); });
    connect(button, &HoldGrip::dragged, this, &BufferHolds::moveTo);
    connect(button, &HoldGrip::dropped, this, &BufferHolds::end);
    connect(button, &HoldGrip::cancelled, this, &BufferHolds::cancel);
    connect(button, &HoldGrip::nudged, this,
            [this, number](QPoint by, bool isCoarse) { nudge(m_grips[number], by, isCoarse); });
    connect(button, &HoldGrip::restored, this, [this, number] { restore(m_grips[number]); });
    const bool hasTrack = what == What::Hold && !isOnFigure && m_hand.holds()[hold].kind == HoldKind::Number;
    m_grips.push_back({what, hold, button, hasTrack ? m_tracks++ : 0});
}

pipeline::BufferSet BufferHolds::want() {
    pipeline::BufferSet wanted;
    if (areShown() && std::ranges::any_of(m_hand.holds(), pipeline::movesObject)) wanted.set(index(BufferId::ObjectId));
    return wanted;
}

void BufferHolds::show() {
    if (m_fits && view().shown()) fit();
    m_places.follow(areShown());
    m_layer->setVisible(areShown());
    placeGrips();
}

// Once for each half of a page, with the frame of its scene, as PictureZoom does. All of the picture where a lamp may stand
// beside what is drawn. The play has a place of its own where it would be on what is drawn, after the answer too, so that
// nothing moves.
void BufferHolds::fit() {
    CanvasPlacing& placing = view().canvas()->placing();
    const CanvasContent& content = view().canvas()->content();
    if (content.size.isEmpty() || !placing.look().fits) return;
    m_fits = !showsScene();
    const bool isLamp = std::ranges::any_of(m_hand.holds(), [](const pipeline::Hold& hold) {
        return hold.kind == HoldKind::LampAtInfinity || hold.kind == HoldKind::LampTop;
    });
    QRectF part(QPointF(), QSizeF(content.size));
    if (!isLamp && !content.focus.isEmpty()) part = content.focus;
    const QRectF drawn = content.focus.isEmpty() ? part : content.focus;
    const double room = view().canvas()->height(), play = Theme::current().px(56);
    const double scale = std::min(view().canvas()->width() / part.width(), room / part.height());
    const double above = room / 2 + scale * (drawn.top() - part.center().y());
    // There is some air around what is worth looking at.
    if (above < play / 2 && room > 2 * play) part.setTop(part.top() - part.height() * play / (room - play));
    placing.follow({.fits = true, .focus = part, .zoom = 1, .center = {}});
}

void BufferHolds::place(CanvasRoom& room) {
    m_layer->setGeometry(QRect(QPoint(), room.size));
    placeGrips();
}

void BufferHolds::placeGrips() {
    if (!view().document().hasScene()) return;
    if (areShown()) {
        const QPoint corner = view().canvas()->mapTo(&view(), QPoint());
        const double left = m_places.onCanvas({0, 0}).x();
        m_band->show(left + corner.x() - m_band->x(), m_places.onCanvas({1, 0}).x() - left);
        for (const HeldGrip& grip : m_grips) grip.button->place(m_places.placeOf(grip));
        m_layer->show(m_places.marks(m_grips, m_isHeld));
    }
    placeInside();
}

// After the answer. Instruments would tell it before.
void BufferHolds::placeInside() {
    m_inside->setVisible(areShown() && m_hand.page().isSettled);
    if (m_inside->isHidden()) return;
    m_inside->setText(m_isHeld ? tr("Look inside") : tr("The picture alone"));
    m_inside->setToolTip(m_isHeld ? tr("Stages, buffers and the inspector") : tr("The lesson and its picture"));
    m_inside->adjustSize();
    const int margin = Theme::current().px(12);
    m_inside->move(view().canvas()->width() - m_inside->width() - margin, margin);
    m_inside->raise();
}

void BufferHolds::begin(std::size_t grip, QPointF at) {
    m_drag = {grip, at, at, at, view().document().pointing().pixel()};
    if (m_grips[grip].what == What::Hold) m_hand.begin(m_grips[grip].hold, m_places.forHand(m_grips[grip], at));
    m_grips[grip].button->setDragged(true);
}

void BufferHolds::moveTo(QPointF at, Qt::KeyboardModifiers modifiers) {
    if (!m_drag) return;
    m_drag->at += (modifiers & Qt::ShiftModifier ? 0.1 : 1) * (at - m_drag->last);
    m_drag->last = at;
    const HeldGrip& grip = m_grips[m_drag->grip];
    if (grip.what == What::Spot) return pickOnRow(int(std::floor(m_places.inPicture(m_drag->at).x())));
    if (m_hand.isDragging()) m_hand.moveTo(m_places.forHand(grip, m_drag->at), modifiers & Qt::ControlModifier);
}

void BufferHolds::end() {
    if (!m_drag) return;
    const HeldGrip& grip = m_grips[m_drag->grip];
    grip.button->setDragged(false);
    m_drag.reset();
    if (grip.what == What::Hold) m_hand.end();
}

void BufferHolds::cancel() {
    if (!m_drag) return;
    const HeldGrip& grip = m_grips[m_drag->grip];
    if (grip.what == What::Hold) m_hand.cancel();
    if (grip.what == What::Spot) view().document().pointing().pick(m_drag->pixelBefore);
    end();
}

void BufferHolds::nudge(const HeldGrip& grip, QPoint by, bool isCoarse) {
    const int onward = by.x() != 0 ? by.x() : -by.y();
    switch (grip.what) {
        case What::Hold: return m_hand.nudge(grip.hold, {by.x(), by.y()}, isCoarse);
        case What::Spot: return pickOnRow(int(grip.button->spoken().value) + onward * (isCoarse ? 10 : 1));
    }
}

void BufferHolds::restore(const HeldGrip& grip) {
    switch (grip.what) {
        case What::Hold: return m_hand.restore(grip.hold);
        case What::Spot: return view().document().pointing().pick(pickedPixel(m_hand.page().half.state));
    }
}

// A press that moved nothing picks, as it does where nothing is held: a question may ask for a click.
void BufferHolds::click(QPointF at) {
    const bool isSpot = m_grips[m_drag->grip].what == What::Spot;
    cancel();
    const auto pixel = view().canvas()->placing().pixelAt(at);
    if (pixel && isSpot) return pickOnRow(pixel->x());
    if (pixel) view().document().pointing().pick(glm::ivec2(pixel->x(), pixel->y()));
}

void BufferHolds::pickOnRow(int column) {
    const int last = view().document().scene().settings.width - 1;
    view().document().pointing().pick(glm::ivec2(std::clamp(column, 0, last), m_hand.held().spot->row));
}

std::optional<std::size_t> BufferHolds::gripAt(QPointF canvas) const {
    const auto pixel = view().canvas()->placing().pixelAt(canvas);
    std::optional<std::size_t> hold;
    if (pixel && view().frame())
        if (const auto ids = view().frame()->buffer({BufferId::ObjectId})) {
            const double id = ids->value(std::size_t(pixel->x()), std::size_t(pixel->y()));
            if (id >= 0) hold = m_hand.holdOfObject(std::size_t(id));
        }
    if (!hold) hold = m_hand.holdOfEye();
    const auto found = std::ranges::find_if(m_grips, [&](const HeldGrip& grip) {
        return hold ? grip.what == What::Hold && grip.hold == *hold : grip.what == What::Spot;
    });
    if (found == m_grips.end()) return {};
    return std::size_t(found - m_grips.begin());
}

// The canvas sees the press afterwards, if at all: it would pick a pixel or move the picture.
bool BufferHolds::eventFilter(QObject*, QEvent* event) {
    if (m_grips.empty()) return false;
    const auto mouse = [event]() -> const QMouseEvent& { return *static_cast<QMouseEvent*>(event); };
    switch (event->type()) {
        case QEvent::MouseButtonPress: {
            if (mouse().button() != Qt::LeftButton || (mouse().modifiers() & Qt::ControlModifier)) return false;
            const auto grip = gripAt(mouse().position());
            if (!grip) return false;
            begin(*grip, mouse().position());
            m_grips[*grip].button->setFocus(Qt::MouseFocusReason);
            return true;
        }
        case QEvent::MouseMove:
            if (!m_drag) return false;
            moveTo(mouse().position(), mouse().modifiers());
            return true;
        case QEvent::MouseButtonRelease:
            if (!m_drag) return false;
            if ((mouse().position() - m_drag->pressed).manhattanLength() < QApplication::startDragDistance())
                click(mouse().position());
            else
                end();
            return true;
        default: return false;
    }
}

}  // namespace app
