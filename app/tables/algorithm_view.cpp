#include "app/tables/algorithm_view.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "app/look/accessible.h"
#include "app/look/text.h"
#include "app/look/theme.h"
#include "app/tables/code_words.h"
#include "app/widgets/folded_text.h"
#include "app/widgets/follow_theme.h"
#include "lessons/pages/talk_words.h"

namespace app {

using pipeline::AlgorithmRow;
using pipeline::LineStatus;

namespace {

constexpr double kPitch = 1.62;  // of a line, in sizes of its letters

bool isGrey(LineStatus status) {
    return status == LineStatus::NotTaken || status == LineStatus::LeftOut || status == LineStatus::Elsewhere;
}

}  // namespace

AlgorithmView::AlgorithmView(QWidget* parent) : QWidget(parent) {
    setObjectName("algorithmView");
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleRole(*this, QAccessible::StaticText);
    setAccessibleName(tr("Algorithm"));
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    followTheme(this, [this] {
        updateGeometry();
        update();
    });
}

void AlgorithmView::setLetters(double size, double least) {
    m_letters = size, m_least = least;
    updateGeometry();
    update();
}

void AlgorithmView::setMostLines(int lines) {
    m_most = lines;
    updateGeometry();
    update();
}

void AlgorithmView::setShowsLoop(bool shows) {
    m_showsLoop = shows;
    updateGeometry();
    update();
}

void AlgorithmView::setState(std::optional<pipeline::AlgorithmState> state) {
    m_state = std::move(state);
    m_rows = m_state ? rowsOf(*m_state) : std::vector<AlgorithmRow>();
    QString spoken = m_state ? toQString(m_state->walk.algorithm.row->title) : tr("No algorithm");
    for (const AlgorithmRow& row : m_rows)
        if (row.status == LineStatus::Now)
            spoken += tr(". Line %1 of %2: %3. %4 %5")
                          .arg(row.number)
                          .arg(m_rows.size())
                          .arg(toQString(row.text), toQString(row.named), toQString(row.remark));
    setAccessibleDescription(spoken.trimmed());
    updateGeometry();
    update();
}

// Of a lit branch the comparison; of any other line its values, or the remark.
QString AlgorithmView::valuesOf(const AlgorithmRow& row) const {
    const bool isBranch = row.taken.has_value();
    if (row.status == LineStatus::Now && isBranch) return toQString(row.valuesText);
    if (isBranch || row.valuesText.empty()) return toQString(row.remark);
    return toQString(row.valuesText);
}

AlgorithmView::Sheet AlgorithmView::layOut(int width) const {
    const Theme& theme = Theme::current();
    Sheet sheet;
    const int gap = theme.px(8), edge = theme.px(6);
    int longest = 0;
    for (double size = m_letters;; size -= 0.5) {
        sheet.code = theme.mono(size), sheet.words = theme.text(size * 0.92);
        const QFontMetrics metrics(sheet.code);
        sheet.numbers = edge + metrics.horizontalAdvance("00") + gap;
        sheet.indent = metrics.horizontalAdvance("  ");
        longest = 0;
        for (const AlgorithmRow& row : m_rows)
            longest = std::max(longest, row.indent * sheet.indent + codeWidth(sheet.code, toQString(row.text)));
        if (sheet.numbers + longest + gap <= width || size <= m_least) break;
    }
    const auto [first, last] = lessons::rowsAround(m_rows, std::size_t(m_most));
    sheet.above = first, sheet.below = m_rows.size() - last;
    const int line = int(QFontMetrics(sheet.code).ascent() * kPitch + 0.5);
    int y = sheet.above > 0 ? line : 0;
    for (std::size_t i = first; i < last; ++i) {
        sheet.placed.push_back(place(sheet, i, QRect(0, y, width, line)));
        y = sheet.placed.back().rect.bottom() + 1;
    }
    sheet.height = y + (sheet.below > 0 ? line : 0);
    if (m_showsLoop && innermostLoop(m_rows)) {
        sheet.loop = QRect(sheet.numbers, sheet.height + line / 3, width - sheet.numbers - gap, line);
        sheet.height += line / 3 + line;
    }
    return sheet;
}

bool AlgorithmView::showsNumbers(const AlgorithmRow& row) const {
    return !row.valuesText.empty() && (!row.taken || row.status == LineStatus::Now);
}

QString AlgorithmView::wayOf(const AlgorithmRow& row) {
    return (*row.taken ? QStringLiteral("● ") : QStringLiteral("– ")) + toQString(row.remark);
}

// `line`: the first of its lines.
AlgorithmView::Placed AlgorithmView::place(const Sheet& sheet, std::size_t number, QRect line) const {
    const AlgorithmRow& row = m_rows[number];
    const int gap = Theme::current().px(8), left = sheet.numbers + row.indent * sheet.indent;
    const auto codeFits = [&](int room) {
        return [&, room](const QString& part) { return codeWidth(sheet.code, part) <= room; };
    };
    Placed placed;
    placed.row = number, placed.rect = line, placed.line = line.height();
    const int room = line.width() - left - gap;
    placed.code = foldedAtSpaces(toQString(row.text), codeFits(room), codeFits(room - sheet.hanging()));
    const QString values = valuesOf(row);
    const QFontMetrics metrics(showsNumbers(row) ? bold(sheet.code) : sheet.words);
    const auto valuesFit = [&](const QString& part) {
        return metrics.horizontalAdvance(part) <= line.width() - sheet.valuesLeft(row) - gap;
    };
    const bool isBranch = row.status == LineStatus::Now && row.taken;  // its comparison is below it
    const int end = left + (placed.code.size() > 1 ? sheet.hanging() : 0) + codeWidth(sheet.code, placed.code.back());
    placed.valuesBelow =
        isBranch || (!values.isEmpty() && end + 2 * gap + metrics.horizontalAdvance(values) > line.width());
    placed.values = placed.valuesBelow ? foldedAtSpaces(values, valuesFit, valuesFit) : QStringList(values);
    const int way = isBranch ? QFontMetrics(sheet.words).horizontalAdvance(wayOf(row)) : 0;
    placed.wayBelow =
        isBranch && !placed.values.isEmpty() &&
        sheet.valuesLeft(row) + metrics.horizontalAdvance(placed.values.back()) + way + 3 * gap > line.width();
    const qsizetype lines = placed.code.size() + (placed.valuesBelow ? placed.values.size() : 0) + placed.wayBelow;
    placed.rect.setHeight(int(lines) * line.height());
    return placed;
}

int AlgorithmView::heightForWidth(int width) const { return layOut(width).height; }
QSize AlgorithmView::sizeHint() const {
    const int width = std::max(this->width(), Theme::current().px(360));
    return {Theme::current().px(420), heightForWidth(width)};
}
QSize AlgorithmView::minimumSizeHint() const {
    return {Theme::current().px(200), heightForWidth(std::max(1, width()))};
}

QRect AlgorithmView::currentRect() const {
    for (const Placed& placed : layOut(width()).placed)
        if (m_rows[placed.row].status == LineStatus::Now) return placed.rect;
    return {};
}

QStringList AlgorithmView::codeLines(int number) const {
    for (const Placed& placed : layOut(width()).placed)
        if (m_rows[placed.row].number == number) return placed.code;
    return {};
}

void AlgorithmView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Right:
        case Qt::Key_Down: return emit stepAsked(1);
        case Qt::Key_Left:
        case Qt::Key_Up: return emit stepAsked(-1);
        default: QWidget::keyPressEvent(event);
    }
}

void AlgorithmView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !(event->modifiers() & Qt::ControlModifier))
        return QWidget::mousePressEvent(event);
    for (const Placed& placed : layOut(width()).placed)
        if (placed.rect.contains(event->position().toPoint())) return emit lineAsked(m_rows[placed.row].number);
}

void AlgorithmView::contextMenuEvent(QContextMenuEvent* event) {
    if (!m_state) return;
    QMenu menu;
    menu.addAction(tr("Copy as text"), this, [this] { emit copyAsked(pipeline::AlgorithmFormat::Text); });
    menu.addAction(tr("Copy as LaTeX"), this, [this] { emit copyAsked(pipeline::AlgorithmFormat::Latex); });
    menu.exec(event->globalPos());
}

void AlgorithmView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) update();
    QWidget::changeEvent(event);
}

void AlgorithmView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& theme = Theme::current();
    const Sheet sheet = layOut(width());
    for (const Placed& placed : sheet.placed) paintRow(painter, sheet, placed);
    painter.setFont(sheet.words);
    painter.setPen(theme.colors().text2);
    const auto say = [&](std::size_t count, const QString& where, int y) {
        if (count > 0)
            painter.drawText(QRect(sheet.numbers, y, width() - sheet.numbers, sheet.placed.front().line),
                             Qt::AlignVCenter, where.arg(count));
    };
    if (!sheet.placed.empty()) {
        say(sheet.above, tr("%1 lines above"), 0);
        say(sheet.below, tr("%1 lines below"), sheet.height - sheet.placed.front().line);
    }
    if (!sheet.loop.isEmpty()) paintLoop(painter, sheet);
    if (!hasFocus()) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.colors().focus, 2));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), theme.px(4), theme.px(4));
}

// From the first value to the last, with a handle where it is.
void AlgorithmView::paintLoop(QPainter& painter, const Sheet& sheet) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    const auto& range = *innermostLoop(m_rows)->range;
    const QString name = toQString(range.name), first = QString::number(range.first),
                  last = QString::number(range.last);
    const int gap = theme.px(8);
    QRect bar = sheet.loop;
    painter.setFont(sheet.words);
    painter.setPen(c.text2);
    painter.drawText(bar, Qt::AlignLeft | Qt::AlignVCenter, name);
    bar.setLeft(bar.left() + painter.fontMetrics().horizontalAdvance(name) + gap);
    painter.setFont(sheet.code);
    painter.setPen(c.text);
    painter.drawText(bar, Qt::AlignLeft | Qt::AlignVCenter, first);
    painter.drawText(bar, Qt::AlignRight | Qt::AlignVCenter, last);
    bar.setLeft(bar.left() + painter.fontMetrics().horizontalAdvance(first) + gap);
    bar.setRight(bar.right() - painter.fontMetrics().horizontalAdvance(last) - gap);
    const double share = (double(range.at - range.first) + 0.5) / (double(range.last - range.first) + 1);
    const int thick = theme.px(5), x = bar.left() + int(share * bar.width());
    const QRect track(bar.left(), bar.center().y() - thick / 2, bar.width(), thick);
    painter.fillRect(track, c.hover);
    painter.fillRect(QRect(track.topLeft(), QSize(x - track.left(), thick)), c.accent);
    painter.fillRect(QRect(x - theme.px(2), track.top() - thick, theme.px(4), 3 * thick), c.accent);
}

void AlgorithmView::paintRow(QPainter& painter, const Sheet& sheet, const Placed& placed) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    const AlgorithmRow& row = m_rows[placed.row];
    const bool isNow = row.status == LineStatus::Now;
    if (isNow) {
        painter.fillRect(placed.rect, c.tint);
        painter.fillRect(QRect(placed.rect.topLeft(), QSize(theme.px(4), placed.rect.height())), c.accent);
    }
    if (row.status == LineStatus::LeftOut) painter.fillRect(placed.rect, QBrush(c.hatch, Qt::BDiagPattern));
    QRect line(placed.rect.topLeft(), QSize(placed.rect.width(), placed.line));
    painter.setFont(sheet.code);
    painter.setPen(isNow ? c.accent : c.text2);
    painter.drawText(QRect(0, line.y(), sheet.numbers - theme.px(8), line.height()), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(row.number));
    painter.setPen(isGrey(row.status) ? c.text3 : c.text);
    const int left = sheet.numbers + row.indent * sheet.indent;
    for (qsizetype i = 0; i < placed.code.size(); ++i) {
        int x = left + (i > 0 ? sheet.hanging() : 0);
        for (const auto& [part, isWord] : wordsOf(placed.code[i])) {
            painter.setFont(isWord ? bold(sheet.code) : sheet.code);
            const int room = width() - x;
            painter.drawText(QRect(x, line.y(), room, line.height()), Qt::AlignVCenter,
                             QFontMetrics(painter.font()).elidedText(part, Qt::ElideRight, room));
            x += QFontMetrics(painter.font()).horizontalAdvance(part);
        }
        line.translate(0, placed.line);
    }
    paintValues(painter, sheet, placed);
}

void AlgorithmView::paintValues(QPainter& painter, const Sheet& sheet, const Placed& placed) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    const AlgorithmRow& row = m_rows[placed.row];
    const bool isBranch = row.status == LineStatus::Now && row.taken, isNumbers = showsNumbers(row);
    const int edge = theme.px(8);
    const qsizetype codeLines = placed.code.size() - (placed.valuesBelow ? 0 : 1);
    QRect where(placed.rect.x(), placed.rect.y() + int(codeLines) * placed.line, placed.rect.width() - edge,
                placed.line);
    if (placed.valuesBelow) where.setLeft(sheet.valuesLeft(row));
    painter.setFont(isNumbers ? bold(sheet.code) : sheet.words);
    painter.setPen(isGrey(row.status) ? c.text3 : isNumbers ? c.text : c.text2);
    for (const QString& part : placed.values) {
        painter.drawText(where, (isBranch ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(part, Qt::ElideRight, where.width()));
        where.translate(0, placed.line);
    }
    if (!isBranch) return;
    // Which way it goes, with a mark that does without colour: behind the comparison, or below it.
    if (!placed.wayBelow) where.translate(0, -placed.line);
    painter.setFont(sheet.words);
    painter.setPen(*row.taken ? c.run : c.text2);
    painter.drawText(where, (placed.wayBelow ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter, wayOf(row));
}

}  // namespace app
