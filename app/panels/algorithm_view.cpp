#include "app/panels/algorithm_view.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <algorithm>

#include "app/core/spoken.h"
#include "app/core/text.h"
#include "app/panels/code_words.h"
#include "app/panels/folded_text.h"
#include "app/panels/follow_theme.h"
#include "lessons/talk_words.h"

namespace app {

using pipeline::AlgorithmRow;
using pipeline::LineStatus;

namespace {

constexpr double kPitch = 1.62;  // of a line, in sizes of its letters

}  // namespace

AlgorithmView::AlgorithmView(QWidget* parent) : QWidget(parent) {
    setObjectName("algorithmView");
    setFocusPolicy(Qt::StrongFocus);
    speakAs(*this, QAccessible::StaticText);
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

}  // namespace app
