#include <algorithm>

#include "app/buffer_view/buffer_view.h"
#include "app/buffer_view/held_band.h"
#include "app/buffer_view/hold_places.h"
#include "app/canvas/buffer_canvas.h"
#include "app/document/hand.h"
#include "app/look/text.h"
#include "app/look/theme.h"

namespace app {

using pipeline::BufferId;
using HoldKind = pipeline::Hold::Kind;

namespace {

pipeline::Hold footOf(pipeline::Hold lamp) {
    lamp.kind = HoldKind::LampFoot;
    return lamp;
}

}  // namespace

HoldPlaces::HoldPlaces(BufferView& view, HeldBand& band) : m_view(view), m_hand(view.document().hand()), m_band(band) {}

QPointF HoldPlaces::onCanvas(glm::dvec2 picture) const {
    const CanvasPlacing& placing = m_view.canvas()->placing();
    return placing.placement().toWidget(placing.toShown({picture.x, picture.y}));
}

QPointF HoldPlaces::inPicture(QPointF canvas) const {
    const CanvasPlacing& placing = m_view.canvas()->placing();
    return placing.toShown(placing.placement().toPicture(canvas));
}

glm::dvec2 HoldPlaces::forHand(const HeldGrip& grip, QPointF at) const {
    if (m_hand.holds()[grip.hold].kind == HoldKind::Number) {
        const QLineF track = trackOf(grip);
        const QPointF way = track.p2() - track.p1();
        return glm::dvec2(QPointF::dotProduct(at - track.p1(), way) / QPointF::dotProduct(way, way));
    }
    const QPointF picture = inPicture(at);
    return {picture.x(), picture.y()};
}

void HoldPlaces::follow(bool isShown) {
    m_vectors.reset();
    const std::optional<glm::ivec2> pixel = m_view.document().pointing().pixel();
    const bool isLamp = !m_hand.holds().empty() && m_hand.holds()[0].kind == HoldKind::LampAtInfinity;
    if (!isShown || !isLamp || !pixel || !m_view.frame() || hides(BufferId::Normal) || hides(BufferId::LightVector))
        return;
    m_vectors = vectorsInPicture(*m_view.frame(), *pixel);
    if (m_vectors && hides(BufferId::HalfwayVector)) m_vectors->H.reset();
}

// A page that asks for a vector hides its buffer.
bool HoldPlaces::hides(BufferId id) const {
    return std::ranges::any_of(m_view.document().hidden().buffers,
                               [&](const pipeline::BufferName& name) { return name.id == id; });
}

bool HoldPlaces::isOnBand(const HeldGrip& grip) const { return grip.button->parentWidget() == &m_band; }

QLineF HoldPlaces::trackOf(const HeldGrip& grip) const {
    if (isOnBand(grip)) return m_band.track().value_or(QLineF(0, 0, 1, 0));
    const double side = HoldGrip::side(), x = side * (0.9 + 1.9 * grip.track);
    const double low = m_view.canvas()->height() - side;
    return {x, low, x, std::max(low - 6 * side, 2 * side)};
}

HoldGrip::Place HoldPlaces::placeOf(const HeldGrip& grip) const {
    HoldGrip::Place place;
    Document& document = m_view.document();
    if (grip.what == HeldGrip::What::Spot) {
        const int columns = document.scene().settings.width, row = m_hand.held().spot->row;
        const glm::ivec2 at = document.pointing().pixel().value_or(glm::ivec2(columns / 8, row));
        place.middle = onCanvas(glm::dvec2(at) + 0.5);
        place.words = QStringLiteral("%1, %2").arg(at.x).arg(at.y);
        place.scale = {double(at.x), 0, columns - 1.0, 1};
        return place;
    }
    return placeOfHold(grip);
}

HoldGrip::Place HoldPlaces::placeOfHold(const HeldGrip& grip) const {
    HoldGrip::Place place;
    const bool isBelowPlay = m_hand.held().play && !isOnBand(grip);
    place.top = isBelowPlay ? Theme::current().px(60) : 0;
    const QSize room = m_view.canvas()->size();
    const pipeline::Hold& hold = m_hand.holds()[grip.hold];
    const auto found = m_hand.placeOf(grip.hold);
    place.isBehind = found && found->isBehind;
    place.isBeside = hold.kind == HoldKind::Number && !isOnBand(grip);
    if (hold.kind == HoldKind::Eye)
        place.middle = QPointF(room.width() - HoldGrip::side(), room.height() - HoldGrip::side());
    else if (found && hold.kind == HoldKind::Number)
        place.middle = trackOf(grip).pointAt(found->at.x);
    else if (found)
        place.middle = onCanvas(found->at);
    const bool tellsShown = grip.hold == 0 && !isOnBand(grip) && !m_hand.shown().isEmpty();
    place.words = tellsShown ? m_hand.shown() : m_hand.words(grip.hold);
    const double value = m_hand.value(grip.hold);
    place.scale = hasEnds(hold) ? AccessibleSlider::Scale{value, hold.low, hold.high, (hold.high - hold.low) / 100}
                                : AccessibleSlider::Scale{value, value - 180, value + 180, 1};
    return place;
}

HeldMarks HoldPlaces::marks(const std::vector<HeldGrip>& grips, bool hasRing) const {
    using Lead = HeldMarks::Lead;
    HeldMarks marks;
    Document& document = m_view.document();
    const pipeline::Scene& scene = document.scene();
    for (const HeldGrip& grip : grips) {
        if (grip.what != HeldGrip::What::Hold || grip.button->isHidden() || isOnBand(grip)) continue;
        const pipeline::Hold& hold = m_hand.holds()[grip.hold];
        const QPointF at = QRectF(grip.button->geometry()).center();
        const auto leadTo = [&](Lead::Kind kind, const std::optional<glm::dvec2>& end) {
            if (end) marks.leads.push_back({kind, at, onCanvas(*end)});
        };
        const auto placed = [](const std::optional<pipeline::HoldPlace>& place) {
            return place ? std::optional(place->at) : std::nullopt;
        };
        if (hold.kind == HoldKind::Number)
            marks.leads.push_back({Lead::Kind::Track, trackOf(grip).p1(), trackOf(grip).p2()});
        if (hold.kind == HoldKind::LampAtInfinity) leadTo(Lead::Kind::Lamp, projected(makeView(scene), hold.point));
        if (hold.kind == HoldKind::LampTop) leadTo(Lead::Kind::Lamp, placed(pipeline::placeOf(scene, footOf(hold))));
        if (hold.kind == HoldKind::Vertex) leadTo(Lead::Kind::Before, placed(m_hand.ownPlaceOf(grip.hold)));
    }
    const std::optional<glm::ivec2> pixel = document.pointing().pixel();
    if (hasRing && pixel) marks.ring = onCanvas(glm::dvec2(*pixel) + 0.5);
    if (m_vectors) {
        const auto polygon = [this](const std::vector<glm::dvec2>& points) {
            QPolygonF shape;
            for (const glm::dvec2 point : points) shape << onCanvas(point);
            return shape;
        };
        marks.vectors = {
            onCanvas(m_vectors->at),    onCanvas(m_vectors->N),
            onCanvas(m_vectors->L),     m_vectors->H ? std::optional(onCanvas(*m_vectors->H)) : std::nullopt,
            m_vectors->nDotL > 0,       polygon(m_vectors->arc),
            polygon(m_vectors->horizon)};
    }
    if (const auto& play = m_hand.held().play) {
        const QString done = toQString(play->done);
        marks.play = m_hand.isPlayed() && !done.isEmpty() ? QStringLiteral("● ") + done : toQString(play->text);
    }
    if (holdOnFigure(m_hand.held()) == std::size_t(0)) marks.shows = m_hand.shown();
    return marks;
}

}  // namespace app
