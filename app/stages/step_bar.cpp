#include "app/stages/step_bar.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <cmath>

#include "app/look/accessible.h"
#include "app/look/text.h"
#include "app/widgets/fitting_font.h"
#include "app/widgets/follow_theme.h"

namespace app {

using pipeline::Moment;
using pipeline::StageId;

StageNames::StageNames(int width) {
    const Theme& theme = Theme::current();
    for (const StageId stage : pipeline::kStages) texts << toQString(stageInfo(stage).label);
    const QFont wanted = theme.text(12, 600);
    font = fittingFont(wanted, texts, width, wanted.pixelSize() - 1);
    if (font == wanted) return;
    for (QString& text : texts) text = text.section(' ', 0, 0);  // "Shadow"
    font = fittingFont(wanted, texts, width);
    // What fits to the pixel stays whole: elidedText also counts parts of a pixel.
    const QFontMetrics metrics(font);
    for (QString& text : texts)
        if (metrics.horizontalAdvance(text) > width) text = metrics.elidedText(text, Qt::ElideRight, width);
}

StepBar::StepBar(Stepper& stepper, QWidget* parent) : QWidget(parent), m_stepper(stepper) {
    setObjectName("stepBar");
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleRole(*this, QAccessible::Graphic);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Steps of the frame"));
    connect(&stepper, &Stepper::changed, this, [this] {
        describe();
        update();
    });
    followTheme(this, [this] { update(); });
}

void StepBar::setStage(StageId stage) {
    m_stage = stage;
    describe();
    update();
}

void StepBar::setCompact(bool compact) {
    m_compact = compact;
    update();
}

int StepBar::widthForNames() const {
    QFont font = Theme::current().text(12, 600);
    font.setPixelSize(std::max(12, font.pixelSize() * 3 / 4));
    int widest = 0;
    for (const StageId stage : pipeline::kStages)
        widest = std::max(widest,
                          QFontMetrics(font).horizontalAdvance(toQString(stageInfo(stage).label).section(' ', 0, 0)));
    const auto parts = int(pipeline::kStageCount);
    return parts * (widest + 1) + (parts - 1) * Theme::current().px(3) + int(std::ceil(2 * margin()));
}

void StepBar::describe() {
    const QString words = m_stepper.isInside() ? m_stepper.words() : tr("the whole frame");
    setAccessibleDescription(tr("%1. The arrow keys step, a drag goes anywhere.").arg(words));
}

QSize StepBar::sizeHint() const { return {Theme::current().px(600), Theme::current().px(40)}; }
QSize StepBar::minimumSizeHint() const { return {Theme::current().px(240), Theme::current().px(34)}; }

double StepBar::margin() const { return Theme::current().px(8); }

StepTrack StepBar::track() const {
    return {*m_stepper.steps(), width() - 2 * margin(), double(Theme::current().px(3))};
}

const std::vector<double>& StepBar::ticks(const StepTrack& track, StageId stage) const {
    if (m_ticks.steps != m_stepper.steps() || m_ticks.level != m_stepper.level() || m_ticks.width != track.width) {
        m_ticks = {m_stepper.steps(), m_stepper.level(), track.width, {}};
        for (const StageId id : pipeline::kStages) m_ticks.at[index(id)] = track.ticks(id, m_stepper.level());
    }
    return m_ticks.at[index(stage)];
}

// The line that the parts lie on.
QRectF StepBar::bar() const {
    const Theme& theme = Theme::current();
    return {margin(), height() / 2.0 + theme.px(6), width() - 2 * margin(), double(theme.px(5))};
}

double StepBar::xOf(Moment moment) const { return margin() + track().xOf(moment); }

std::optional<double> StepBar::handleX() const {
    if (!m_stepper.steps()) return std::nullopt;
    const Moment end = m_stepper.steps()->fitting({m_stage, m_stepper.steps()->total(m_stage)});
    return xOf(m_stepper.isInside() ? *m_stepper.moment() : end);
}

void StepBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!m_stepper.steps()) return;
    const StepTrack track = this->track();
    for (const StageId stage : pipeline::kStages) paintPart(painter, track, stage);
    paintFlags(painter, track);
    paintHandle(painter);
    if (!hasFocus()) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Theme::current().colors().focus, 2));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), Theme::current().px(4), Theme::current().px(4));
}

void StepBar::paintPart(QPainter& painter, const StepTrack& track, StageId stage) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    const pipeline::Steps& steps = *m_stepper.steps();
    const QRectF line = bar();
    const QRectF part(line.left() + track.partLeft(stage), line.top(), track.partWidth(), line.height());
    const bool runs = steps.runs(stage);
    const Moment here = *m_stepper.moment();
    const bool current = m_stage == stage;

    StageNames names(int(part.width()));
    names.font.setWeight(current ? QFont::DemiBold : QFont::Normal);
    painter.setFont(names.font);
    painter.setPen(current ? c.text : runs ? c.text2 : c.text3);
    painter.drawText(QRectF(part.left(), line.top() - theme.px(24), part.width(), theme.px(18)),
                     Qt::AlignLeft | Qt::AlignVCenter, names.texts[qsizetype(index(stage))]);
    painter.setBrush(Qt::NoBrush);
    if (!runs) {
        painter.setPen(QPen(c.outline, 1, Qt::DashLine));
        return painter.drawRect(part.adjusted(0.5, 0.5, -0.5, -0.5));
    }
    painter.fillRect(part, c.hover);
    double filled = part.right();
    if (m_stepper.isInside())
        filled = here.stage == stage ? line.left() + track.xOf(here) : here.stage > stage ? part.right() : part.left();
    QColor done = c.accent;
    if (!current) done.setAlphaF(0.55f);
    painter.fillRect(QRectF(part.topLeft(), QPointF(filled, part.bottom())), done);
    painter.setPen(QPen(c.outline, 1));
    for (const double tick : ticks(track, stage)) {
        const double x = std::round(line.left() + tick) - 0.5;
        painter.drawLine(QPointF(x, line.top() - theme.px(3)), QPointF(x, line.bottom() + theme.px(3)));
    }
}

void StepBar::paintFlags(QPainter& painter, const StepTrack& track) const {
    const Theme& theme = Theme::current();
    const double foot = bar().top(), side = theme.px(8);
    for (std::size_t i = 0; i < m_stepper.bookmarks().size(); ++i) {
        const double x = bar().left() + track.xOf(m_stepper.steps()->momentOf(m_stepper.bookmarks()[i]));
        QPainterPath flag(QPointF(x, foot));
        flag.lineTo(x, foot - 1.7 * side);
        flag.lineTo(x + side, foot - 1.4 * side);
        flag.lineTo(x, foot - 0.9 * side);
        painter.setPen(QPen(theme.colors().warn, 1.5));
        painter.setBrush(theme.colors().warn);
        painter.drawPath(flag);
    }
}

void StepBar::paintHandle(QPainter& painter) const {
    const Theme& theme = Theme::current();
    const double x = *handleX(), r = theme.px(6), top = bar().center().y() - r;
    QPainterPath handle(QPointF(x - r, top));
    handle.lineTo(x + r, top);
    handle.lineTo(x + r, top + 1.3 * r);
    handle.lineTo(x, top + 2.3 * r);
    handle.lineTo(x - r, top + 1.3 * r);
    handle.closeSubpath();
    painter.setPen(QPen(theme.colors().surface, 1.5));
    painter.setBrush(theme.colors().accent);
    painter.drawPath(handle);
}

std::optional<std::size_t> StepBar::bookmarkAt(QPointF place) const {
    const double reach = Theme::current().px(8);
    if (place.y() > bar().top()) return std::nullopt;
    for (std::size_t i = 0; i < m_stepper.bookmarks().size(); ++i) {
        const double x = xOf(m_stepper.steps()->momentOf(m_stepper.bookmarks()[i]));
        if (place.x() >= x - reach / 4 && place.x() <= x + reach && place.y() >= bar().top() - 1.7 * reach) return i;
    }
    return std::nullopt;
}

void StepBar::scrub(double x) {
    const Moment moment = track().momentAt(x - margin());
    m_stepper.goTo(snapped(*m_stepper.steps(), moment, m_stepper.level()));
}

void StepBar::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_stepper.steps()) return;
    m_stepper.setPlaying(false);
    if (const auto i = bookmarkAt(event->position())) return m_stepper.goTo(m_stepper.bookmarks()[*i]);
    scrub(event->position().x());
}

void StepBar::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) && m_stepper.steps()) scrub(event->position().x());
}

void StepBar::wheelEvent(QWheelEvent* event) {
    constexpr int kNotch = 120;  // eighths of a degree
    m_wheel += event->angleDelta().y();
    for (; m_wheel <= -kNotch; m_wheel += kNotch) m_stepper.step(1);
    for (; m_wheel >= kNotch; m_wheel -= kNotch) m_stepper.step(-1);
    event->accept();
}

void StepBar::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Right:
        case Qt::Key_Up: return m_stepper.step(1);
        case Qt::Key_Left:
        case Qt::Key_Down: return m_stepper.step(-1);
        default: QWidget::keyPressEvent(event);
    }
}

bool StepBar::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && m_stepper.steps()) {
        const auto& help = static_cast<QHelpEvent&>(*event);
        const pipeline::Steps& steps = *m_stepper.steps();
        QString text;
        if (const auto i = bookmarkAt(help.pos())) {
            text = tr("Bookmark %1: %2")
                       .arg(*i + 1)
                       .arg(toQString(steps.words(steps.momentOf(m_stepper.bookmarks()[*i]), m_stepper.level())));
        } else {
            const Moment at = snapped(steps, track().momentAt(help.pos().x() - margin()), m_stepper.level());
            text = toQString(stageInfo(at.stage).label) + QStringLiteral(": ") +
                   toQString(steps.words(at, m_stepper.level()));
        }
        QToolTip::showText(help.globalPos(), text, this);
        return true;
    }
    return QWidget::event(event);
}

}  // namespace app
