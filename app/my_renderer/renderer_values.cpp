#include "app/my_renderer/renderer_values.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <cmath>

#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {

namespace foreign = pipeline::foreign;
using pipeline::Domain;

namespace {

struct Place {
    Domain domain = Domain::Pixel;
    std::size_t element = 0;
    QString title;
};

// The selection goes before the pixel, which may still be picked.
std::optional<Place> placeOf(const Document& document, const foreign::Report& report) {
    using Kind = lessons::Selection::Kind;
    if (const auto& selection = document.pointing().selection()) {
        if (selection->kind == Kind::Vertex)
            return Place{Domain::Vertex, selection->index, RendererValues::tr("Vertex %1").arg(selection->index)};
        if (selection->kind == Kind::Polygon)
            return Place{Domain::Polygon, selection->index, RendererValues::tr("Polygon %1").arg(selection->index)};
    }
    const auto pixel = document.pointing().pixel();
    const auto width = int(report.reference->context.width), height = int(report.reference->context.height);
    if (!pixel || pixel->x >= width || pixel->y >= height) return {};
    return Place{Domain::Pixel, std::size_t(pixel->y) * std::size_t(width) + std::size_t(pixel->x),
                 RendererValues::tr("Pixel %1, %2").arg(pixel->x).arg(pixel->y)};
}

// In three digits: two vectors stand side by side in a narrow panel.
QString numbersOf(const foreign::Values& values, std::size_t element) {
    if (!values.there[element]) return RendererValues::tr("nothing");
    QStringList numbers;
    for (int c = 0; c < values.channels; ++c) {
        const double value = values.at(element)[c];
        const bool isSmall = std::abs(value) < 0.0005;
        numbers << (isSmall ? QStringLiteral("0") : QString::number(value, 'g', std::abs(value) >= 1000 ? 5 : 3));
    }
    return numbers.join(' ');
}

}  // namespace

RendererValues::RendererValues(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_grid(new QGridLayout),
      m_first(styled(new QLabel(this), {.name = "firstDifference", .size = 12, .weight = 600, .wraps = true})) {
    setObjectName("rendererValues");
    m_first->setTextFormat(Qt::PlainText);
    auto* column = spaced(new QVBoxLayout(this), {});
    column->addLayout(m_grid);
    column->addWidget(m_first);
    m_grid->setColumnStretch(1, 1);
    m_grid->setColumnStretch(2, 1);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_grid->setHorizontalSpacing(theme.px(8));
        m_grid->setVerticalSpacing(theme.px(2));
    });
}

QLabel* RendererValues::cell(const QString& text, bool isMono, bool differs) {
    auto* label = new QLabel(this);
    label->setTextFormat(Qt::PlainText);
    label->setText(text);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    followTheme(label, [label, isMono, differs] {
        const Theme& theme = Theme::current();
        label->setFont(isMono ? theme.mono(12) : theme.text(12));
        QColor tint = theme.colors().failed;
        tint.setAlpha(38);
        label->setStyleSheet(differs ? QStringLiteral("background: rgba(%1, %2, %3, 38); border-left: 3px solid %4; "
                                                      "padding-left: 4px;")
                                           .arg(tint.red())
                                           .arg(tint.green())
                                           .arg(tint.blue())
                                           .arg(theme.colors().failed.name())
                                     : QString());
    });
    return label;
}

void RendererValues::show(const foreign::Report& report) {
    while (QLayoutItem* item = m_grid->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_rows = 0;
    m_first->hide();
    const auto place = placeOf(m_document, report);
    m_titleText = place ? place->title : QString();
    if (!place) return;
    const foreign::Finding* first = nullptr;
    for (const foreign::Finding& finding : report.findings) {
        if (bufferInfo(finding.name.buffer.id).domain != place->domain || place->element >= finding.classes.size())
            continue;
        const bool differs = isBad(finding.classes[place->element]);
        if (differs && !first) first = &finding;
        const foreign::Values &mine = report.fileOf(finding).mine,
                              &right = report.reference->values.at(finding.name.buffer.text());
        ++m_rows;
        const bool isVector = mine.channels > 1;
        m_grid->addWidget(cell(toQString(finding.name.text()), true, false), m_rows * 2, 0, 1, isVector ? 3 : 1);
        const auto value = [&](const foreign::Values& values, bool isBadHere) {
            auto* label = cell(numbersOf(values, place->element), true, isBadHere);
            label->setToolTip(toQString(valueText(finding, values, place->element)).toHtmlEscaped());
            return label;
        };
        QLabel *const ofMine = value(mine, differs), *const ofReference = value(right, false);
        if (!isVector) {
            m_grid->addWidget(ofMine, m_rows * 2, 1);
            m_grid->addWidget(ofReference, m_rows * 2, 2);
            continue;
        }
        auto* both = new QWidget(this);  // three numbers need half of the width each
        auto* line = spaced(new QHBoxLayout(both), {});
        line->addWidget(ofMine, 1);
        line->addWidget(ofReference, 1);
        m_grid->addWidget(both, m_rows * 2 + 1, 0, 1, 3);
    }
    if (m_rows == 0) return;
    m_grid->addWidget(cell(tr("mine"), false, false), 0, 1);
    m_grid->addWidget(cell(tr("reference"), false, false), 0, 2);
    m_first->setText(first ? tr("First difference: %1.").arg(toQString(first->name.text()))
                           : tr("Everything handed in agrees here."));
    m_first->show();
}

}  // namespace app
