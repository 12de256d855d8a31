#include "app/buffer_view/buffer_step.h"

#include <QPainter>
#include <QPushButton>
#include <utility>

#include "app/buffer_view/buffer_captions.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/canvas/projected_scene.h"
#include "app/look/theme.h"

namespace app {
namespace {

// Screen pixels for one at which four decimals have room, in the theme's lengths; and for a hall.
constexpr double kNumbersZoom = 68, kHallZoom = 93;

// What the step is at, where it is no pixel.
std::optional<lessons::Selection> elementOf(const Stepper& stepper) {
    using Kind = lessons::Selection::Kind;
    const pipeline::Moment at = *stepper.moment();
    const pipeline::Place place = stepper.steps()->placeOf(at);
    if (place.what == pipeline::Place::What::Element &&
        (place.kind == pipeline::ElementKind::Vertex || place.kind == pipeline::ElementKind::VertexTerms))
        return lessons::Selection{Kind::Vertex, std::size_t(place.number)};
    if (const auto polygon = stepper.steps()->polygonOf(at)) return lessons::Selection{Kind::Polygon, *polygon};
    return {};
}

}  // namespace

bool isAtLine(const Stepper& stepper) {
    return stepper.steps() && stepper.place() &&
           (stepper.place()->line || stepper.level() == pipeline::StepLevel::Line);
}

std::optional<glm::ivec2> stepPixel(const Stepper& stepper) {
    return isAtLine(stepper) ? stepper.steps()->pixelOf(*stepper.moment()) : std::nullopt;
}

// Lets the mouse through.
class StepMark::Layer : public QWidget {
public:
    Layer(QWidget* canvas, const StepMark& mark) : QWidget(canvas), m_mark(mark) {
        setObjectName("stepMark");
        setAttribute(Qt::WA_TransparentForMouseEvents);
        hide();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        m_mark.paint(painter);
    }

private:
    const StepMark& m_mark;
};

StepMark::StepMark(BufferView& view)
    : BufferFeature(view),
      m_layer(new Layer(view.canvas(), *this)),
      m_button(new QPushButton(tr("Follow"), view.canvas())) {
    m_button->setToolTip(tr("Keep the step in the middle of the view again."));
    m_button->setObjectName("followStep");
    m_button->hide();
    connect(m_button, &QPushButton::clicked, this, [this] {
        m_follows = true;
        show();
        this->view().takeKeys();
    });
    connect(&view.document().stepper(), &Stepper::changed, this, &StepMark::show);
    connect(&view.canvas()->placing(), &CanvasPlacing::changed, m_layer, qOverload<>(&QWidget::update));
    connect(&view.canvas()->placing(), &CanvasPlacing::moved, this, [this] {
        if (!m_isStepping || m_moves) return;
        m_follows = false;
        this->view().place();
    });
}

void StepMark::show() {
    const Stepper& stepper = view().document().stepper();
    const bool steps = isAtLine(stepper) && view().isOfPixels() && view().frame();
    const bool wasStepping = std::exchange(m_isStepping, steps);
    m_pixel.reset();
    m_outlines.clear();
    if (steps) {
        if (const auto pixel = stepPixel(stepper))
            m_pixel = QPoint(pixel->x, pixel->y);
        else if (const auto element = elementOf(stepper))
            m_outlines = outlinesOf(*view().frame(), *element);
    }
    m_layer->setVisible(m_pixel || !m_outlines.empty());
    m_layer->setGeometry(view().canvas()->rect());
    m_layer->update();
    if (steps && m_follows) follow();
    if (!steps && wasStepping) {
        if (m_follows) view().canvas()->placing().fit();
        m_follows = true;
    }
    if (steps || wasStepping) view().place();
}

void StepMark::follow() {
    CanvasPlacing& placing = view().canvas()->placing();
    m_moves = true;
    if (!m_pixel || isOfNames(bufferInfo(view().buffer().id)))
        placing.fit();
    else
        placing.follow(
            {.fits = false,
             .focus = {},
             .zoom = double(Theme::current().px(view().features().captions->isBare() ? kHallZoom : kNumbersZoom)),
             .center = QPointF(*m_pixel) + QPointF(0.5, 0.5)});
    m_moves = false;
}

// White with a black rim, outside of the pixel; for polygons their edges, for vertices a ring.
void StepMark::paint(QPainter& painter) const {
    const CanvasPlacing& placing = view().canvas()->placing();
    const Placement placement = placing.placement();
    painter.setRenderHint(QPainter::Antialiasing, m_outlines.size() > 0);
    painter.setBrush(Qt::NoBrush);
    for (const auto& [color, width] : {std::pair(QColor(Qt::black), 5), std::pair(QColor(Qt::white), 2)}) {
        painter.setPen(QPen(color, width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
        if (m_pixel) {
            const QPointF corner(*m_pixel);
            const QRectF pixel(placement.toWidget(placing.toShown(corner)),
                               placement.toWidget(placing.toShown(corner + QPointF(1, 1))));
            painter.drawRect(pixel.normalized().adjusted(-2.5, -2.5, 2.5, 2.5));
        }
        for (const QPolygonF& outline : m_outlines) {
            QPolygonF polygon;
            for (const QPointF& corner : outline) polygon << placement.toWidget(placing.toShown(corner));
            polygon.size() == 1 ? painter.drawEllipse(polygon[0], 9, 9) : painter.drawPolygon(polygon);
        }
    }
}

void StepMark::place(CanvasRoom& room) {
    m_layer->setGeometry(QRect(QPoint(), room.size));
    const bool resized = std::exchange(m_size, room.size) != room.size;
    if (resized && m_isStepping && m_follows && !m_moves) follow();
    m_button->setVisible(m_isStepping && !m_follows);
    if (m_button->isHidden()) return;
    m_button->setFont(Theme::current().text(12));
    m_button->adjustSize();
    m_button->move(room.size.width() - m_button->width() - CanvasRoom::kMargin - room.right, CanvasRoom::kMargin);
    room.right += m_button->width() + CanvasRoom::kMargin;
}

// The part that the step is in is nobody's choice.
void StepMark::write(lessons::BufferShown& state) const {
    if (m_isStepping && m_follows) state.zoom.reset();
}

// A part that a cue names stays.
pipeline::Errors StepMark::read(const lessons::BufferShown& state) {
    m_follows = !state.zoom;
    return {};
}

}  // namespace app
