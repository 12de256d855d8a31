#include "app/buffer_view/held_band.h"

#include <QPainter>
#include <algorithm>
#include <array>

#include "app/buffer_view/buffer_view.h"
#include "app/document/hand.h"
#include "app/frames/derived_buffers.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {

using lessons::FigureShape;

namespace {

// The dark theme's, as all that is on the black around a picture.
struct RoleLook {
    std::string_view role;
    QColor color;
    double width = 1;
    Qt::PenStyle style = Qt::SolidLine;
};
RoleLook lookOf(std::string_view role) {
    const ThemeColors& dark = Theme::colors(ThemeId::Dark);
    const std::array<RoleLook, 9> looks{{{"code", dark.L, 1.1},
                                         {"code in", Qt::white, 2},
                                         {"reach", QColor(90, 169, 255, 72)},
                                         {"base", QColor(0x6B7480)},
                                         {"own", Qt::white, 1.2, Qt::DotLine},
                                         {"curve", dark.L, 2},
                                         {"second", dark.N, 2},
                                         {"at", Qt::white},
                                         {"of", QColor(0x9CC9FF)}}};
    const auto found = std::ranges::find(looks, role, &RoleLook::role);
    return found == looks.end() ? RoleLook{"", dark.text2, 2} : *found;
}

QFont sized(QFont font, double pixels) {
    font.setPixelSize(std::max(1, int(pixels + 0.5)));
    return font;
}

// "k_r I_a": letters in italics, what is behind a "_" small and lower. Begins at `at`; returns its width.
double paintSymbol(QPainter* painter, QPointF at, const std::string& text, double pixels) {
    double x = at.x();
    const QString all = toQString(text);
    for (qsizetype i = 0; i < all.size(); ++i) {
        const bool isScript = i > 0 && all[i - 1] == '_';
        if (all[i] == '_') continue;
        const bool isVariable = all[i].isLetter() && i + 1 < all.size() && all[i + 1] == '_';
        QFont font = sized(Theme::current().text(), isScript ? 0.7 * pixels : pixels);
        font.setItalic(isVariable || isScript);
        if (painter) {
            painter->setFont(font);
            painter->drawText(QPointF(x, at.y() + (isScript ? 0.25 * pixels : 0)), all.mid(i, 1));
        }
        x += QFontMetricsF(font).horizontalAdvance(all[i]);
    }
    return x - at.x();
}

}  // namespace

HeldBand::HeldBand(BufferView& view) : QWidget(&view), m_view(view), m_hand(view.document().hand()) {
    setObjectName("heldFigure");
    setAttribute(Qt::WA_OpaquePaintEvent);
    hide();
    connect(&m_hand, &Hand::taken, this, &HeldBand::fitHeight);
    followTheme(this, [this] { fitHeight(); });
}

void HeldBand::setOn(bool on) {
    m_isOn = on;
    fitHeight();
}

void HeldBand::fitHeight() {
    setFixedHeight(Theme::current().px(108));
    setVisible(m_isOn && m_hand.page().keepsFigure);
}

double HeldBand::scale() const { return height() / lessons::kFigureHeight; }

void HeldBand::show(double left, double perColumn) {
    m_figure = {};
    Document& document = m_view.document();
    if (isHidden() || !document.hasScene()) return;
    if (const pipeline::FramePtr frame = m_view.frame()) {
        const auto bufferOf = [&](const pipeline::BufferName& name) -> std::optional<pipeline::AnyBuffer> {
            if (!pipeline::isDerived(name.id)) return frame->buffer(name);
            const lessons::DerivedBuffer* made = document.derived().made(name);
            return made ? std::optional(made->buffer) : std::nullopt;
        };
        m_figure = lessons::figureOf({.half = m_hand.page().half,
                                      .scene = document.scene(),
                                      .frame = *frame,
                                      .pixel = document.pointing().pixel(),
                                      .channel = std::clamp(document.pointing().channel(), 0, 2),
                                      .tells = m_hand.page().isSettled,
                                      .buffer = bufferOf},
                                     {width() / scale(), left / scale(), perColumn / scale()});
    }
    setAccessibleName(m_figure.empty() ? QString() : tr("Figure"));
    setAccessibleDescription(toQString(m_figure.spoken));
    update();
}

std::optional<QLineF> HeldBand::track() const {
    if (!m_figure.track) return {};
    const auto at = [this](glm::dvec2 point) { return QPointF(point.x, point.y) * scale(); };
    return QLineF(at((*m_figure.track)[0]), at((*m_figure.track)[1]));
}

void HeldBand::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), m_figure.empty() ? QColor(Qt::black) : QColor(0x0A0B0E));
    if (m_figure.empty()) return;
    painter.fillRect(QRect(0, 0, width(), 1), QColor(255, 255, 255, 31));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(scale(), scale());
    for (const FigureShape& shape : m_figure.shapes) paintShape(painter, shape);
    if (!m_figure.terms.empty()) paintEquation(painter);
}

void HeldBand::paintShape(QPainter& painter, const FigureShape& shape) const {
    const RoleLook look = lookOf(shape.role);
    QPolygonF points;
    for (const glm::dvec2 point : shape.points) points << QPointF(point.x, point.y);
    painter.setPen(QPen(look.color, look.width, look.style));
    painter.setBrush(Qt::NoBrush);
    switch (shape.kind) {
        case FigureShape::Kind::Line: return painter.drawLine(points[0], points[1]);
        case FigureShape::Kind::Box: return painter.fillRect(QRectF(points[0], points[1]), look.color);
        case FigureShape::Kind::Curve: return painter.drawPolyline(points);
        case FigureShape::Kind::Dot:
            painter.setPen(Qt::NoPen);
            painter.setBrush(look.color);
            return painter.drawEllipse(points[0], 4, 4);
        case FigureShape::Kind::Words: break;
    }
    painter.setFont(sized(Theme::current().mono(), 13));
    const QString text = toQString(shape.text);
    const double wide = painter.fontMetrics().horizontalAdvance(text);
    painter.drawText(points[0] - QPointF(shape.anchor * wide, 0), text);
}

// Each term above its number, and below them the bar up to I_max.
void HeldBand::paintEquation(QPainter& painter) const {
    constexpr double kSymbol = 16, kNumber = 28, kGap = 14, kBar = 8;
    const QFont numbers = sized(Theme::current().mono(), kNumber);
    struct Column {
        std::string symbol;
        QString number;
        QColor color;
    };
    const QColor ink(0xF2F4F7), quiet = Theme::colors(ThemeId::Dark).text2, sun = Theme::colors(ThemeId::Dark).L;
    const std::array<QColor, 3> parts{QColor(0x9AA3AF), sun, ink};
    std::vector<Column> columns;
    for (const lessons::FigureTerm& term : m_figure.terms) {
        if (!columns.empty()) columns.push_back({"", QStringLiteral("+"), ink});
        const bool isLit = columns.size() == 2;  // the second term follows the lamp
        columns.push_back({term.symbol, toQString(lessons::termText(term.value, m_figure.most)), isLit ? sun : ink});
    }
    columns.push_back({"", QStringLiteral("="), ink});
    columns.push_back({m_figure.sumSymbol, toQString(lessons::termText(m_figure.sum, m_figure.most)), ink});
    const QFontMetricsF metrics(numbers);
    const auto widthOf = [&](const Column& column) {
        return std::max(metrics.horizontalAdvance(column.number), paintSymbol(nullptr, {}, column.symbol, kSymbol));
    };
    double total = kGap * double(columns.size() - 1);
    for (const Column& column : columns) total += widthOf(column);
    const double wide = width() / scale();
    double x = (wide - total) / 2;
    for (const Column& column : columns) {
        const double own = widthOf(column);
        painter.setPen(quiet);
        paintSymbol(&painter, {x + (own - paintSymbol(nullptr, {}, column.symbol, kSymbol)) / 2, 38}, column.symbol,
                    kSymbol);
        painter.setPen(column.color);
        painter.setFont(numbers);
        painter.drawText(QPointF(x + (own - metrics.horizontalAdvance(column.number)) / 2, 78), column.number);
        x += own + kGap;
    }
    const QRectF bar(24, 104, wide - 48, kBar);
    painter.fillRect(bar, QColor(255, 255, 255, 26));
    double from = 0;
    for (std::size_t i = 0; i < m_figure.terms.size() && m_figure.most > 0; ++i) {
        const double share = std::clamp(m_figure.terms[i].value / m_figure.most, 0.0, 1 - from);
        painter.fillRect(QRectF(bar.left() + from * bar.width(), bar.top(), share * bar.width(), kBar),
                         parts[std::min<std::size_t>(i, 2)]);
        from += share;
    }
}

}  // namespace app
