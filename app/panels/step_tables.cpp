#include "app/panels/step_tables.h"

#include <QPainter>
#include <algorithm>

#include "app/core/document.h"
#include "app/core/large_frame.h"
#include "app/core/text.h"
#include "app/core/theme.h"
#include "app/panels/follow_theme.h"
#include "pipeline/inspect/pixel_report.h"

namespace app {
namespace {

int sideOf() { return Theme::current().px(14); }

}  // namespace

StepTables::StepTables(QWidget* parent) : QWidget(parent) {
    setObjectName("stepTables");
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
    followTheme(this, [this] { updateGeometry(), update(); });
}

// Of the step's pixel in the z-buffer stage. In a large frame they take longer than a step may.
std::optional<StepTables::Fragments> StepTables::fragmentsAtStep(const Document& document) {
    const Stepper& stepper = document.stepper();
    const pipeline::FramePtr& frame = document.frames().shown();
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

void StepTables::showStep(const std::vector<pipeline::AlgorithmRow>& rows, const Document& document) {
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
    m_fragments = fragmentsAtStep(document);
    QStringList spoken;
    for (const pipeline::AlgorithmValue& one : m_variables)
        spoken += QStringLiteral("%1 = %2, %3").arg(toQString(one.shown), toQString(one.text), toQString(one.from));
    if (m_fragments) {
        spoken += m_fragments->title;
        for (const pipeline::FragmentReport& row : m_fragments->rows)
            spoken += tr("polygon %1, %2, %3")
                          .arg(row.polygon)
                          .arg(toQString(comparisonText(row).whole()), toQString(name(row.verdict)));
    }
    setAccessibleName(tr("Variables and fragments"));
    setAccessibleDescription(spoken.join(QStringLiteral("; ")));
    updateGeometry();
    update();
}

int StepTables::lineHeight() const { return QFontMetrics(Theme::current().mono(13)).height() + Theme::current().px(5); }
int StepTables::variablesHeight() const {
    return m_variables.empty() ? 0 : (int(m_variables.size()) + 1) * lineHeight() + Theme::current().px(16);
}
int StepTables::fragmentsHeight() const {
    return m_fragments ? (int(m_fragments->rows.size()) + 2) * lineHeight() + Theme::current().px(16) : 0;
}

void StepTables::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    int y = 0;
    if (height() >= wanted()) y = paintVariables(painter, y);
    if (m_fragments && height() >= fragmentsHeight()) paintFragments(painter, y);
}

int StepTables::paintVariables(QPainter& painter, int y) const {
    if (m_variables.empty()) return y;
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    const int line = lineHeight(), side = sideOf(), gap = theme.px(14);
    painter.setPen(c.line);
    painter.drawLine(0, y, width(), y);
    y += theme.px(8);
    const auto cell = [&](int left, int wide, const QFont& font, const QColor& color, int align, const QString& text) {
        painter.setFont(font);
        painter.setPen(color);
        painter.drawText(QRect(left, y, wide, line), align | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(text, Qt::ElideRight, wide));
    };
    cell(side, width() - 2 * side, theme.text(13, 600), c.text, Qt::AlignLeft, tr("Variables"));
    y += line;
    QFont bold = theme.mono(13);
    bold.setWeight(QFont::DemiBold);
    int names = 0, values = 0;
    for (const pipeline::AlgorithmValue& one : m_variables) {
        names = std::max(names, QFontMetrics(theme.mono(13)).horizontalAdvance(toQString(one.shown)));
        values = std::max(values, QFontMetrics(bold).horizontalAdvance(toQString(one.text)));
    }
    names = std::min(names, width() / 3), values = std::min(values, width() / 2);
    for (const pipeline::AlgorithmValue& one : m_variables) {
        cell(side, names, theme.mono(13), c.text, Qt::AlignLeft, toQString(one.shown));
        cell(side + names + gap, values, bold, c.text, Qt::AlignRight, toQString(one.text));
        const int from = side + names + values + 2 * gap;
        cell(from, std::max(0, width() - from - side), theme.text(12), c.text2, Qt::AlignLeft, toQString(one.from));
        y += line;
    }
    return y + theme.px(8);
}

void StepTables::paintFragments(QPainter& painter, int y) const {
    const Theme& theme = Theme::current();
    const ThemeColors& c = theme.colors();
    const int line = lineHeight(), side = sideOf(), gap = theme.px(10);
    painter.setPen(c.line);
    painter.drawLine(0, y, width(), y);
    y += theme.px(8);
    const auto cell = [&](int left, int wide, const QFont& font, const QColor& color, int align, const QString& text) {
        painter.setFont(font);
        painter.setPen(color);
        painter.drawText(QRect(left, y, wide, line), align | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(text, Qt::ElideRight, wide));
    };
    cell(side, width() - 2 * side, theme.text(13, 600), c.text, Qt::AlignLeft, m_fragments->title);
    cell(side, width() - 2 * side, theme.text(12), c.text2, Qt::AlignRight, tr("in the order they came"));
    y += line;
    const QFontMetrics numbers(theme.mono(13)), words(theme.text(13));
    int depth = numbers.horizontalAdvance('z'), relation = numbers.horizontalAdvance('<'), stored = depth;
    for (const pipeline::FragmentReport& row : m_fragments->rows) {
        const pipeline::ComparisonText text = comparisonText(row);
        depth = std::max(depth, numbers.horizontalAdvance(toQString(text.depth)));
        stored = std::max(stored, numbers.horizontalAdvance(toQString(text.stored)));
    }
    const int polygon = std::max(words.horizontalAdvance(tr("Polygon")), numbers.horizontalAdvance("0000"));
    const int lefts[] = {side, side + polygon + gap, side + polygon + depth + 2 * gap,
                         side + polygon + depth + relation + 3 * gap,
                         side + polygon + depth + relation + stored + 4 * gap};
    const int last = std::max(0, width() - lefts[4] - side);
    cell(lefts[0], polygon, theme.text(12), c.text2, Qt::AlignLeft, tr("Polygon"));
    cell(lefts[1], depth, theme.mono(12), c.text2, Qt::AlignRight, QStringLiteral("z"));
    cell(lefts[3], stored, theme.mono(12), c.text2, Qt::AlignRight, QStringLiteral("zbuffer"));
    cell(lefts[4], last, theme.text(12), c.text2, Qt::AlignLeft, tr("Verdict"));
    y += line;
    for (std::size_t i = 0; i < m_fragments->rows.size() && y + line <= height(); ++i) {
        const pipeline::FragmentReport& row = m_fragments->rows[i];
        const pipeline::ComparisonText text = comparisonText(row);
        const bool isTested = m_fragments->tested == i;
        if (isTested) painter.fillRect(QRect(side / 2, y, width() - side, line), c.tint);
        const QColor tone = came(row.verdict) || isTested ? c.text : c.text2;
        cell(lefts[0], polygon, theme.mono(13), tone, Qt::AlignLeft, QString::number(row.polygon));
        cell(lefts[1], depth, theme.mono(13), tone, Qt::AlignRight, toQString(text.depth));
        cell(lefts[2], relation, theme.mono(13), tone, Qt::AlignHCenter, toQString(text.relation));
        cell(lefts[3], stored, theme.mono(13), tone, Qt::AlignRight, toQString(text.stored));
        const QString verdict = isTested                                             ? tr("◐ being tested")
                                : row.verdict == pipeline::FragmentVerdict::WonStays ? tr("● in the buffer")
                                                                                     : toQString(name(row.verdict));
        cell(lefts[4], last, theme.text(13),
             isTested                                             ? c.accent
             : row.verdict == pipeline::FragmentVerdict::WonStays ? c.run
                                                                  : c.text2,
             Qt::AlignLeft, verdict);
        y += line;
    }
}

}  // namespace app
