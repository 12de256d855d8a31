#include "app/inspector/math_view.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <cmath>

#include "app/look/accessible.h"
#include "app/look/text.h"
#include "app/widgets/follow_theme.h"
#include "pipeline/export/json/json.h"
#include "pipeline/inspect/equation_text.h"

namespace app {

namespace {

using pipeline::EquationLine;

QString written(const std::vector<EquationLine>& lines, pipeline::EquationFormat format) {
    return toQString(equationText(lines, format));
}

}  // namespace

MathView::MathView(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleRole(*this, QAccessible::Equation);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    m_fade.setSingleShot(true);
    m_fade.setInterval(1500);
    connect(&m_fade, &QTimer::timeout, this, [this] {
        m_changed.clear();
        update();
    });
    followTheme(this, [this] { layOut(); });
}

void MathView::setLines(std::vector<EquationLine> lines, bool showChange) {
    m_changed.clear();
    if (showChange) {
        // Words come and go; the lines between them keep their order.
        auto old = m_lines.begin();
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (isWords(lines[i])) continue;
            while (old != m_lines.end() && isWords(*old)) ++old;
            if (old == m_lines.end()) break;
            const auto before = leavesOf((old++)->formula), after = leavesOf(lines[i].formula);
            if (before.size() != after.size()) continue;
            for (std::size_t k = 0; k < after.size(); ++k)
                if (before[k] != after[k]) m_changed.emplace(int(i), int(k));
        }
    }
    m_lines = std::move(lines);
    if (!m_changed.empty()) m_fade.start();
    setAccessibleDescription(asText());
    layOut();
}

void MathView::setBaseSize(double logicalPixels) {
    m_baseSize = logicalPixels;
    layOut();
}

QString MathView::asText() const { return written(m_lines, pipeline::EquationFormat::Text).trimmed(); }
QString MathView::asMarkdown() const { return written(m_lines, pipeline::EquationFormat::Markdown); }
QString MathView::asLatex() const { return written(m_lines, pipeline::EquationFormat::Latex); }
QString MathView::asJson() const { return toQString(pipeline::toJson(m_lines).dump(2)); }

int MathView::heightForWidth(int width) const { return int(std::ceil(pageAt(width).height)); }

QSize MathView::sizeHint() const {
    const int width = Theme::current().px(420);
    return {width, heightForWidth(width)};
}

QSize MathView::minimumSizeHint() const {
    const int width = Theme::current().px(220);
    return {width, heightForWidth(std::max(width, this->width()))};
}

const MathPage& MathView::pageAt(int width) const {
    constexpr std::size_t kMostPages = 8;
    const auto found = m_pages.find(width);
    if (found != m_pages.end()) return found->second;
    if (m_pages.size() == kMostPages) m_pages.clear();
    return m_pages[width] = layoutEquation(m_lines, m_baseSize * Theme::current().scale(), width - 2);
}

void MathView::layOut() {
    m_pages.clear();
    point(-1);  // what was pointed at may be another part then, or gone
    updateGeometry();
    update();
}

void MathView::resizeEvent(QResizeEvent*) {
    point(-1);
    updateGeometry();
    update();
}

void MathView::paintEvent(QPaintEvent*) {
    const ThemeColors& colors = Theme::current().colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const MathPage& page = pageAt(width());
    const auto& parts = page.box.parts;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors.tint);
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i].leaf >= 0 && m_changed.contains({page.lineOfPart[i], parts[i].leaf}))
            painter.drawRoundedRect(parts[i].rect.adjusted(-3, 0, 3, 0), 3, 3);
    if (m_pointed >= 0) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(hasFocus() ? colors.focus : colors.outline, hasFocus() ? 2 : 1));
        painter.drawRoundedRect(parts[std::size_t(m_pointed)].rect.adjusted(-2, -1, 2, 1), 3, 3);
    }
    paintMath(painter, page.box, {1, 0});
    if (hasFocus() && m_pointed < 0) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colors.focus, 2));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
    }
}

int MathView::partAt(QPointF position) const {
    int found = -1;
    double area = 1e300;
    const auto& parts = pageAt(width()).box.parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double size = parts[i].rect.width() * parts[i].rect.height();
        if (parts[i].refers.isEmpty() || size >= area || !parts[i].rect.adjusted(-1, -1, 1, 1).contains(position))
            continue;
        found = int(i);
        area = size;
    }
    return found;
}

void MathView::point(int part) {
    if (part == m_pointed) return;
    m_pointed = part;
    const QString refers = part < 0 ? QString() : pageAt(width()).box.parts[std::size_t(part)].refers;
    setToolTip(part < 0 ? QString() : pageAt(width()).box.parts[std::size_t(part)].text + ": " + refers);
    setCursor(part < 0 ? Qt::ArrowCursor : Qt::PointingHandCursor);
    emit pointedAt(refers);
    update();
}

void MathView::mouseMoveEvent(QMouseEvent* event) { point(partAt(event->position() - QPointF(1, 0))); }

void MathView::leaveEvent(QEvent*) { point(-1); }

void MathView::focusOutEvent(QFocusEvent* event) {
    point(-1);
    QWidget::focusOutEvent(event);  // which takes the ring away
}

void MathView::mouseReleaseEvent(QMouseEvent* event) {
    const int part = partAt(event->position() - QPointF(1, 0));
    if (event->button() == Qt::LeftButton && part >= 0)
        emit activated(pageAt(width()).box.parts[std::size_t(part)].refers);
}

void MathView::walk(int step) {
    const int count = int(pageAt(width()).box.parts.size());
    for (int i = m_pointed < 0 && step < 0 ? count - 1 : m_pointed + step; i >= 0 && i < count; i += step)
        if (!pageAt(width()).box.parts[std::size_t(i)].refers.isEmpty()) return point(i);
}

// To the part above or below that is nearest sideways.
void MathView::walkLine(int step) {
    if (m_pointed < 0) return walk(step);
    const auto& parts = pageAt(width()).box.parts;
    const QRectF from = parts[std::size_t(m_pointed)].rect;
    int best = -1;
    double least = 1e300;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double down = step * (parts[i].rect.center().y() - from.center().y());
        if (parts[i].refers.isEmpty() || down < 0.8 * from.height()) continue;
        const double far = 10 * down + std::abs(parts[i].rect.center().x() - from.center().x());
        if (far < least) {
            least = far;
            best = int(i);
        }
    }
    if (best >= 0) point(best);
}

void MathView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Right: return walk(1);
        case Qt::Key_Left: return walk(-1);
        case Qt::Key_Down: return walkLine(1);
        case Qt::Key_Up: return walkLine(-1);
        case Qt::Key_Escape: return point(-1);
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (m_pointed >= 0) emit activated(pageAt(width()).box.parts[std::size_t(m_pointed)].refers);
            return;
        default: break;
    }
    if (event->matches(QKeySequence::Copy)) return QApplication::clipboard()->setText(asText());
    QWidget::keyPressEvent(event);
}

void MathView::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    const auto add = [&](const QString& name, QString (MathView::*write)() const) {
        menu.addAction(name, this, [this, write] { QApplication::clipboard()->setText((this->*write)()); });
    };
    add(tr("Copy as text"), &MathView::asText);
    add(tr("Copy as Markdown"), &MathView::asMarkdown);
    add(tr("Copy as LaTeX"), &MathView::asLatex);
    add(tr("Copy as JSON"), &MathView::asJson);
    menu.exec(event->globalPos());
}

}  // namespace app
