#include "app/stages/stage_card.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/look/numbers.h"
#include "app/look/text.h"
#include "app/widgets/fitting_font.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/standing_row.h"

namespace app {

using pipeline::foreign::Standing;
namespace {

// Draws text from the left of `line` on and takes its width off `line`.
void write(QPainter& painter, QRect& line, const QString& text, const QFont& font, const QColor& color) {
    if (text.isEmpty() || line.width() <= 0) return;
    painter.setFont(font);
    painter.setPen(color);
    const QString fitting = painter.fontMetrics().elidedText(text, Qt::ElideRight, line.width());
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, fitting);
    line.setLeft(line.left() + painter.fontMetrics().horizontalAdvance(fitting));
}

QStringList labels() {
    QStringList all;
    for (const pipeline::StageId stage : pipeline::kStages) all.push_back(toQString(stageInfo(stage).label));
    return all;
}

QString fittingLine(const QString& text, const QFont& font, int width) {
    const QFontMetrics metrics(font);
    return fitting(text, [&](const QString& part) { return metrics.horizontalAdvance(part) <= width; });
}

// Three digits of a number from 10 000 on: "498k", "1.00M". The rounded value decides: 999 700 is 1.00M, not 1000k.
QString shortNumber(double value) {
    const auto [unit, letter] = value < 999.5e3 ? std::pair(1e3, 'k') : std::pair(1e6, 'M');
    const double shown = value / unit;
    return number(shown, shown < 9.995 ? 2 : shown < 99.95 ? 1 : 0) + QLatin1Char(letter);
}

}  // namespace

QColor stateColor(StageState state) {
    const ThemeColors& c = Theme::current().colors();
    switch (state) {
        case StageState::Ran: return c.run;
        case StageState::Reused: return c.reused;
        case StageState::LeftOut: return c.leftOut;
        case StageState::InProgress: return c.accent;
        case StageState::NotYet: break;
    }
    return c.text3;
}

void paintMark(QPainter& painter, QPointF centre, StageState state) {
    const double r = Theme::current().px(10) / 2.0 - 0.5;
    const QColor color = stateColor(state);
    painter.setPen(QPen(color, r / 2.5));
    painter.setBrush(Qt::NoBrush);
    switch (state) {
        case StageState::Ran:
            painter.setPen(Qt::NoPen);
            painter.setBrush(color);
            painter.drawEllipse(centre, r, r);
            break;
        case StageState::Reused: painter.drawEllipse(centre, r - 1, r - 1); break;
        case StageState::LeftOut: painter.drawLine(centre - QPointF(r, 0), centre + QPointF(r, 0)); break;
        case StageState::InProgress:
            painter.drawEllipse(centre, r - 1, r - 1);
            painter.setBrush(color);
            painter.drawPie(QRectF(centre.x() - r + 1, centre.y() - r + 1, 2 * r - 2, 2 * r - 2), 90 * 16, 180 * 16);
            break;
        case StageState::NotYet:
            painter.setPen(Qt::NoPen);
            painter.setBrush(color);
            painter.drawEllipse(centre, r / 3, r / 3);
            break;
    }
}

StageCard::StageCard(pipeline::StageId stage, QWidget* parent) : QAbstractButton(parent), m_stage(stage) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setObjectName(QStringLiteral("stage:") + toQString(stageInfo(stage).name));
    setText(toQString(stageInfo(stage).label));
    followTheme(this, [this] { updateGeometry(), update(); });
}

void StageCard::setStatus(const StageStatus& status) {
    m_status = status;
    setToolTip(status.tooltip);
    setAccessibleDescription(status.tooltip);
    setAccessibleName(QStringLiteral("%1: %2. %3").arg(text(), word(status.state), status.reason));
    update();
}

void StageCard::setOnShow(bool onShow) {
    m_onShow = onShow;
    update();
}

void StageCard::setCompact(bool compact) {
    m_compact = compact;
    updateGeometry();
    update();
}

QSize StageCard::sizeHint() const { return {Theme::current().px(180), Theme::current().px(m_compact ? 44 : 80)}; }
QSize StageCard::minimumSizeHint() const { return {Theme::current().px(80), sizeHint().height()}; }

void StageCard::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintBox(painter);
    const int side = theme.px(m_compact ? 10 : 12), lineHeight = theme.px(18);
    QRect box = rect().adjusted(side, theme.px(m_compact ? 4 : 9), -side, -theme.px(m_compact ? 3 : 6));
    box.setTop(box.top() + theme.px(m_compact ? 19 : 24));
    const Head head = this->head();
    if (head.isMarkBelow) {
        const int markWidth = theme.px(10);
        paintMark(painter, {box.right() - markWidth / 2.0, box.top() + lineHeight / 2.0}, m_status.state);
        box.setRight(box.right() - markWidth - theme.px(6));
    } else if (m_standing)
        paintStanding(painter, head);
    else
        paintState(painter, head);
    paintTitle(painter, head.title);
    const ThemeColors& c = theme.colors();
    if (m_standing) return paintFinding(painter, QRect(box.left(), box.top(), box.width(), lineHeight));
    if (m_status.state == StageState::LeftOut) {
        painter.setFont(theme.text(12));
        painter.setPen(c.text2);
        if (m_compact) box.setHeight(lineHeight);
        constexpr int kFlags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
        const QString reason = fitting(m_status.reason, [&](const QString& part) {
            const QRect taken = painter.fontMetrics().boundingRect(box, kFlags, part);
            return taken.height() <= box.height() && taken.width() <= box.width();
        });
        return painter.drawText(box, kFlags, reason.isEmpty() ? word(m_status.state) : reason);
    }
    paintNumbers(painter, QRect(box.left(), box.top(), box.width(), lineHeight));
    if (m_compact) return;
    QRect counts(box.left(), box.top() + lineHeight, box.width(), lineHeight);
    const QFontMetrics metrics(theme.text(12));
    const auto fits = [&](const QString& part) { return metrics.horizontalAdvance(part) <= counts.width(); };
    write(painter, counts, fittingCounts(m_status.counts, fits), theme.text(12), c.text2);
}

void StageCard::paintBox(QPainter& painter) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    const QRectF box = QRectF(rect()).adjusted(1, 1, -1, -1);
    QPainterPath shape;
    shape.addRoundedRect(box, theme.px(6), theme.px(6));
    const bool leftOut =
        m_standing ? *m_standing == pipeline::foreign::Standing::NoFile : m_status.state == StageState::LeftOut;
    painter.setClipPath(shape);
    painter.fillPath(shape, m_onShow ? c.tint : underMouse() ? c.hover : leftOut ? c.bg : c.surface);
    if (leftOut) {
        painter.setPen(QPen(c.hatch, 1));
        const int step = theme.px(8) * 3 / 2;  // 8 apart across the lines
        for (int x = -height(); x < width(); x += step) painter.drawLine(x, height(), x + height(), 0);
    }
    if (m_onShow) painter.fillRect(QRectF(box.left(), box.top(), box.width(), theme.px(3)), c.accent);
    if (m_status.progress) {
        const QRectF foot(box.left() + theme.px(12), box.bottom() - theme.px(6), box.width() - 2 * theme.px(12),
                          theme.px(3));
        painter.fillRect(foot, c.hover);
        painter.fillRect(QRectF(foot.left(), foot.top(), foot.width() * *m_status.progress, foot.height()), c.accent);
    }
    painter.setClipping(false);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_onShow ? c.accent : leftOut ? c.outline : c.line, 1, leftOut ? Qt::DashLine : Qt::SolidLine));
    painter.drawPath(shape);
    if (hasFocus()) {
        painter.setPen(QPen(c.focus, 2));
        painter.drawRoundedRect(box.adjusted(1, 1, -1, -1), theme.px(5), theme.px(5));
    }
}

// Of the longest title: the cards look alike.
int StageCard::titleWidth() const {
    const QFont font = Theme::current().text(titleSize(), 600);
    int widest = 0;
    for (const QString& label : labels()) widest = std::max(widest, QFontMetrics(font).horizontalAdvance(label));
    return numberWidth(font) + widest;
}

StageCard::Head StageCard::head() const {
    const Theme& theme = Theme::current();
    const int side = theme.px(m_compact ? 10 : 12), markWidth = theme.px(m_standing ? 15 : 10), gap = theme.px(6);
    Head head;
    head.line = head.title = QRect(side, theme.px(m_compact ? 4 : 9), width() - 2 * side, theme.px(20));
    head.isMarkBelow = m_compact && !m_standing && titleWidth() + gap + markWidth > head.line.width();
    if (head.isMarkBelow) return head;
    // The mark alone where the word would take room from the title.
    const QFont font = theme.text(12, 500);
    const int room = head.line.width() - titleWidth() - markWidth - 2 * gap - theme.px(2);  // 2 for rounding
    const QString whole = m_standing ? toQString(pipeline::foreign::words(*m_standing)) : word(m_status.state);
    if (!m_compact) head.state = fittingLine(whole, font, room);
    const int wordWidth = QFontMetrics(font).horizontalAdvance(head.state);
    head.title.setRight(head.line.right() - wordWidth - (wordWidth > 0 ? gap : 0) - markWidth - gap);
    return head;
}

// At the right of the line.
void StageCard::paintState(QPainter& painter, const Head& head) const {
    const Theme& theme = Theme::current();
    const int markWidth = theme.px(10), gap = theme.px(6);
    QRect state = head.line;
    state.setLeft(head.title.right() + gap);
    paintMark(painter, QPointF(state.left() + markWidth / 2.0, state.center().y() + 0.5), m_status.state);
    state.setLeft(state.left() + markWidth + gap);
    painter.setFont(theme.text(12, 500));
    painter.setPen(stateColor(m_status.state));
    painter.drawText(state, Qt::AlignLeft | Qt::AlignVCenter, head.state);
}

// The largest in which each stage's number and name fit side by side.
QFont StageCard::titleFont(int room) const {
    const Theme& theme = Theme::current();
    const int least = std::max(12, theme.px(0.75 * titleSize()));  // smaller letters are not read from the last row
    QFont font = theme.text(titleSize(), 600);
    const auto fits = [&](const QString& label) {
        return numberWidth(font) + QFontMetrics(font).horizontalAdvance(label) <= room;
    };
    while (font.pixelSize() > least && !std::ranges::all_of(labels(), fits)) font.setPixelSize(font.pixelSize() - 1);
    return font;
}

// Of the number before a name in this font, and the gap between them.
int StageCard::numberWidth(const QFont& title) {
    return QFontMetrics(title).horizontalAdvance(QStringLiteral("0")) + int(std::lround(0.5 * title.pixelSize()));
}

// The first word of a name that does not fit.
QString StageCard::titleIn(int room, const QFont& font) const {
    const bool fits = numberWidth(font) + QFontMetrics(font).horizontalAdvance(text()) <= room;
    return fits ? text() : text().section(' ', 0, 0);
}

void StageCard::paintTitle(QPainter& painter, QRect line) const {
    const ThemeColors& c = Theme::current().colors();
    const QFont font = titleFont(line.width());
    QFont number = font;
    number.setWeight(QFont::Medium);
    const QString name = titleIn(line.width(), font);
    painter.setFont(number);
    painter.setPen(c.text3);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, QString::number(index(m_stage) + 1));
    line.setLeft(line.left() + numberWidth(font));
    write(painter, line, name, font, c.text);
}

StageCard::Words StageCard::shownWords() const {
    const Head head = this->head();
    const QFont font = titleFont(head.title.width());
    const QString name = titleIn(head.title.width(), font);
    return {name, head.state, QFontMetrics(font).horizontalAdvance(name), head.title.width() - numberWidth(font)};
}

void StageCard::paintNumbers(QPainter& painter, const QRect& line) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    QRect rest = line;
    const QFont mono = fittingFont(theme.mono(12), {QStringLiteral("0.000 ms")}, line.width() - 2, theme.px(9));
    write(painter, rest, m_status.time, mono, c.text2);
    if (m_status.error.isEmpty()) return;
    rest.setLeft(rest.left() + theme.px(m_compact ? 8 : 12));
    const QFontMetrics digits(mono);
    const auto fits = [&](const QString& part) { return digits.horizontalAdvance(part) <= rest.width(); };
    const QString error = fittingError(m_status.error, fits);
    const int room = rest.width() - digits.horizontalAdvance(error);
    const bool hasLostUnit = m_status.error.contains(QLatin1Char(' ')) && !error.contains(QLatin1Char(' '));
    if (room < 0 || (m_compact && hasLostUnit)) return;  // a bare number beside the time says nothing
    if (!m_compact)
        write(painter, rest, fittingLine(QStringLiteral("error "), theme.text(12), room), theme.text(12), c.text2);
    write(painter, rest, error, mono, c.text2);
}

void StageCard::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && m_status.state != StageState::LeftOut) emit entered();
}

void StageCard::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Left: focusPreviousChild(); break;
        case Qt::Key_Right: focusNextChild(); break;
        case Qt::Key_Return:
        case Qt::Key_Enter: click(); break;
        default: QAbstractButton::keyPressEvent(event);
    }
}

void StageCard::setStanding(std::optional<Standing> standing, const QString& finding) {
    if (!standing && !m_standing) return;
    m_standing = standing, m_finding = finding;
    const QString word = standing ? toQString(words(*standing)) : app::word(m_status.state);
    setAccessibleName(QStringLiteral("%1: %2. %3").arg(text(), word, standing ? finding : m_status.reason));
    setToolTip(standing ? QStringLiteral("%1: %2<br>%3").arg(text(), word, finding.toHtmlEscaped()) : m_status.tooltip);
    update();
}

// The mark at the right, and the word before it.
void StageCard::paintStanding(QPainter& painter, const Head& head) const {
    const Theme& theme = Theme::current();
    const int side = theme.px(15), gap = theme.px(6);
    QRect line = head.line;
    app::paintStanding(painter, QRectF(line.right() - side, line.center().y() - side / 2.0, side, side), *m_standing);
    line.setLeft(head.title.right() + gap);
    painter.setFont(theme.text(12, 500));
    painter.setPen(standingColor(*m_standing));
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, head.state);
}

// Compact, the word; else what was found.
void StageCard::paintFinding(QPainter& painter, const QRect& line) const {
    const Theme& theme = Theme::current();
    const bool saysWord = m_compact || m_finding.isEmpty();
    painter.setFont(theme.text(12, saysWord ? 500 : 400));
    painter.setPen(saysWord ? standingColor(*m_standing) : theme.colors().text2);
    const QString text = saysWord ? toQString(words(*m_standing)) : m_finding;
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, line.width()));
}

QString withShortNumbers(QString text) {
    static const QRegularExpression grouped(QStringLiteral("\\d{1,3}(?:\\x{2009}\\d{3})+"));
    for (qsizetype from = 0;;) {
        const QRegularExpressionMatch match = grouped.match(text, from);
        if (!match.hasMatch()) return text;
        const double value = match.captured().remove(QChar(0x2009)).toDouble();
        const QString shown = value >= 10000 ? shortNumber(value) : match.captured();
        text.replace(match.capturedStart(), match.capturedLength(), shown);
        from = match.capturedStart() + shown.size();
    }
}

QString fittingError(QString error, const std::function<bool(const QString&)>& fits) {
    for (const QChar end : {QChar(','), QChar(' ')})
        if (!fits(error)) error = error.section(end, 0, 0);
    return error;
}

QString fittingCounts(const QString& counts, const std::function<bool(const QString&)>& fits) {
    if (const QString exact = fitting(counts, fits); !exact.isEmpty()) return exact;
    const QString brief = withShortNumbers(counts);
    const QString part = fitting(brief, fits);
    return part.isEmpty() ? fitting(QString(brief).remove(QStringLiteral(" polygons")), fits) : part;
}

QString fitting(QString text, const std::function<bool(const QString&)>& fits) {
    while (!text.isEmpty() && !fits(text)) {
        const auto sign =
            std::find_if(text.crbegin(), text.crend(), [](QChar c) { return c == u';' || c == u':' || c == u','; });
        text.truncate(std::max<qsizetype>(0, text.crend() - sign - 1));
    }
    return text;
}

}  // namespace app
