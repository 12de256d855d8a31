#include "app/tables/step_tables.h"

#include <QPainter>
#include <algorithm>

#include "app/document/document.h"
#include "app/frames/large_frame.h"
#include "app/look/text.h"
#include "app/look/theme.h"
#include "app/widgets/follow_theme.h"
#include "pipeline/inspect/pixel_report.h"

namespace app {
namespace {

constexpr double kLeastLetters = 13;

int sideOf() { return Theme::current().px(14); }

// A line of cells at a moving height.
struct Line {
    QPainter& painter;
    int y, height;

    void cell(int left, int wide, const QFont& font, const QColor& color, int align, const QString& text) const {
        painter.setFont(font);
        painter.setPen(color);
        painter.drawText(QRect(left, y, wide, height), align | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(text, Qt::ElideRight, wide));
    }
    void next() { y += height; }
};

// Below the rule that ends what is above.
Line beginTable(QPainter& painter, int y, int width, int height) {
    painter.setPen(Theme::current().colors().line);
    painter.drawLine(0, y, width, y);
    return {painter, y + Theme::current().px(8), height};
}

}  // namespace

StepTables::StepTables(const Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
    setObjectName("stepTables");
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
    followTheme(this, [this] { update(); });
    // The frame of a step may come after the step.
    connect(&document.frames(), &FrameFeed::frameReady, this, [this] {
        if (isVisible()) showFragments();
    });
}

// Of the step's pixel in the z-buffer stage. In a large frame they take longer than a step may.
std::optional<StepTables::Fragments> StepTables::fragmentsAtStep() const {
    const Stepper& stepper = m_document.stepper();
    const pipeline::FramePtr& frame = m_document.frames().shown();
    if (!stepper.isInside() || !stepper.steps() || !frame || isLarge(*frame)) return {};
    const pipeline::Moment at = *stepper.moment();
    const auto pixel = stepper.steps()->pixelOf(at);
    if (at.stage != pipeline::StageId::ZBuffer || !pixel) return {};
    Fragments fragments{tr("Fragments at %1, %2").arg(pixel->x).arg(pixel->y),
                        pipeline::inspectPixel(*frame, *pixel).fragments, std::nullopt};
    const auto first =
        std::ranges::find(fragments.rows, pipeline::FragmentVerdict::NotYet, &pipeline::FragmentReport::verdict);
    if (at.line > 0 && first != fragments.rows.end()) fragments.tested = std::size_t(first - fragments.rows.begin());
    return fragments;
}

pipeline::ComparisonText StepTables::Fragments::comparison(std::size_t row) const {
    return comparisonText(rows[row], {}, tested == row);
}

QString StepTables::Fragments::verdict(std::size_t row) const {
    return tested == row                                              ? tr("◐ being tested")
           : rows[row].verdict == pipeline::FragmentVerdict::WonStays ? tr("● in the buffer")
                                                                      : toQString(name(rows[row].verdict));
}

void StepTables::showStep(const std::vector<pipeline::AlgorithmRow>& rows) {
    m_variables.clear();
    for (const pipeline::AlgorithmRow& row : rows)
        for (pipeline::AlgorithmValue value : row.values) {
            if (value.range && value.from.empty())
                value.from = tr("%1, %2 to %3")
                                 .arg(toQString(value.range->name))
                                 .arg(value.range->first)
                                 .arg(value.range->last)
                                 .toStdString();
            const auto known = std::ranges::find(m_variables, value.shown, &pipeline::AlgorithmValue::shown);
            if (known == m_variables.end())
                m_variables.push_back(std::move(value));
            else
                *known = std::move(value);
        }
    showFragments();
}

void StepTables::showFragments() {
    m_fragments = fragmentsAtStep();
    QStringList spoken;
    for (const pipeline::AlgorithmValue& one : m_variables)
        spoken += QStringLiteral("%1 = %2, %3").arg(toQString(one.shown), toQString(one.text), toQString(one.from));
    if (m_fragments) {
        spoken += m_fragments->title;
        for (std::size_t i = 0; i < m_fragments->rows.size(); ++i)
            spoken += tr("polygon %1, %2, %3")
                          .arg(m_fragments->rows[i].polygon)
                          .arg(toQString(m_fragments->comparison(i).whole()), m_fragments->verdict(i));
    }
    setAccessibleName(tr("Variables and fragments"));
    setAccessibleDescription(spoken.join(QStringLiteral("; ")));
    update();
}

void StepTables::setLetters(double size) {
    m_letters = size;
    update();
}

// Of one table, with its heading; 0 without lines.
int StepTables::tableHeight(std::size_t lines, double letters) {
    return lines == 0 ? 0 : int(lines) * lineHeight(letters) + Theme::current().px(16);
}
int StepTables::lineHeight(double letters) {
    return QFontMetrics(Theme::current().mono(letters)).height() + Theme::current().px(5);
}
int StepTables::variablesHeight(double letters) const {
    return tableHeight(m_variables.empty() ? 0 : m_variables.size() + 1, letters);
}
int StepTables::fragmentsHeight(double letters) const {
    return tableHeight(m_fragments ? m_fragments->rows.size() + 2 : 0, letters);
}

void StepTables::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    double letters = m_letters;
    while (letters > kLeastLetters && height() < wanted(letters)) letters = std::max(letters - 1, kLeastLetters);
    if (height() < wanted(letters)) letters = m_letters;  // the fragments alone
    while (letters > kLeastLetters && height() < fragmentsHeight(letters))
        letters = std::max(letters - 1, kLeastLetters);
    int y = 0;
    if (height() >= wanted(letters)) y = paintVariables(painter, y, letters);
    if (m_fragments && height() >= fragmentsHeight(letters)) paintFragments(painter, y, letters);
}

int StepTables::paintVariables(QPainter& painter, int y, double letters) const {
    if (m_variables.empty()) return y;
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    const int side = sideOf(), gap = theme.px(14);
    Line row = beginTable(painter, y, width(), lineHeight(letters));
    row.cell(side, width() - 2 * side, theme.text(letters, 600), c.text, Qt::AlignLeft, tr("Variables"));
    row.next();
    QFont bold = theme.mono(letters);
    bold.setWeight(QFont::DemiBold);
    int names = 0, values = 0;
    for (const pipeline::AlgorithmValue& one : m_variables) {
        names = std::max(names, QFontMetrics(theme.mono(letters)).horizontalAdvance(toQString(one.shown)));
        values = std::max(values, QFontMetrics(bold).horizontalAdvance(toQString(one.text)));
    }
    // A width that a font rounds down would cut the last digits.
    names = std::min(names + 2, width() / 3), values = std::min(values + 2, width() / 2);
    for (const pipeline::AlgorithmValue& one : m_variables) {
        row.cell(side, names, theme.mono(letters), c.text, Qt::AlignLeft, toQString(one.shown));
        row.cell(side + names + gap, values, bold, c.text, Qt::AlignRight, toQString(one.text));
        const int from = side + names + values + 2 * gap;
        row.cell(from, std::max(0, width() - from - side), theme.text(letters - 1), c.text2, Qt::AlignLeft,
                 toQString(one.from));
        row.next();
    }
    return row.y + theme.px(8);
}

void StepTables::paintFragments(QPainter& painter, int y, double letters) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    const int side = sideOf(), gap = theme.px(10);
    Line row = beginTable(painter, y, width(), lineHeight(letters));
    row.cell(side, width() - 2 * side, theme.text(letters, 600), c.text, Qt::AlignLeft, m_fragments->title);
    row.cell(side, width() - 2 * side, theme.text(letters - 1), c.text2, Qt::AlignRight, tr("in the order they came"));
    row.next();
    const QFontMetrics numbers(theme.mono(letters)), words(theme.text(letters));
    int depth = numbers.horizontalAdvance('z'), stored = numbers.horizontalAdvance("zbuffer");
    const int relation = numbers.horizontalAdvance('<') + 2;
    for (std::size_t i = 0; i < m_fragments->rows.size(); ++i) {
        const pipeline::ComparisonText text = m_fragments->comparison(i);
        depth = std::max(depth, numbers.horizontalAdvance(toQString(text.depth)));
        stored = std::max(stored, numbers.horizontalAdvance(toQString(text.stored)));
    }
    depth += 2, stored += 2;
    const int polygon = std::max(words.horizontalAdvance(tr("Polygon")), numbers.horizontalAdvance("0000"));
    const int lefts[] = {side, side + polygon + gap, side + polygon + depth + 2 * gap,
                         side + polygon + depth + relation + 3 * gap,
                         side + polygon + depth + relation + stored + 4 * gap};
    const int last = std::max(0, width() - lefts[4] - side);
    row.cell(lefts[0], polygon, theme.text(letters - 1), c.text2, Qt::AlignLeft, tr("Polygon"));
    row.cell(lefts[1], depth, theme.mono(letters - 1), c.text2, Qt::AlignRight, QStringLiteral("z"));
    row.cell(lefts[3], stored, theme.mono(letters - 1), c.text2, Qt::AlignRight, QStringLiteral("zbuffer"));
    row.cell(lefts[4], last, theme.text(letters - 1), c.text2, Qt::AlignLeft, tr("Verdict"));
    row.next();
    for (std::size_t i = 0; i < m_fragments->rows.size() && row.y + row.height <= height(); ++i) {
        const pipeline::FragmentReport& one = m_fragments->rows[i];
        const pipeline::ComparisonText text = m_fragments->comparison(i);
        const bool isTested = m_fragments->tested == i;
        if (isTested) painter.fillRect(QRect(side / 2, row.y, width() - side, row.height), c.tint);
        const QColor tone = came(one.verdict) || isTested ? c.text : c.text2;
        row.cell(lefts[0], polygon, theme.mono(letters), tone, Qt::AlignLeft, QString::number(one.polygon));
        row.cell(lefts[1], depth, theme.mono(letters), tone, Qt::AlignRight, toQString(text.depth));
        row.cell(lefts[2], relation, theme.mono(letters), tone, Qt::AlignHCenter, toQString(text.relation));
        row.cell(lefts[3], stored, theme.mono(letters), tone, Qt::AlignRight, toQString(text.stored));
        row.cell(lefts[4], last, theme.text(letters),
                 isTested                                             ? c.accent
                 : one.verdict == pipeline::FragmentVerdict::WonStays ? c.run
                                                                      : c.text2,
                 Qt::AlignLeft, m_fragments->verdict(i));
        row.next();
    }
}

}  // namespace app
