#include "app/inspector/layers_section.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "app/look/numbers.h"
#include "app/widgets/follow_theme.h"

namespace app {

namespace {

constexpr int kColumns = 5;

}  // namespace

double addedBy(const std::vector<pipeline::LayerReport>& layers, std::size_t i, int channel) {
    double added = layers[i].alpha * layers[i].intensity[channel];
    for (std::size_t front = i + 1; front < layers.size(); ++front) added *= 1 - layers[front].alpha;
    return added;
}

LayersSection::LayersSection(QWidget* parent)
    : QWidget(parent), m_grid(new QGridLayout), m_sum(styled(new QLabel(this), {.tone = 2, .wraps = true})) {
    setAccessibleName(tr("Translucent layers"));
    auto* column = spaced(new QVBoxLayout(this), {});
    column->addLayout(m_grid);
    column->addWidget(m_sum);
}

void LayersSection::show(const pipeline::PixelReport& report, int channel) {
    const Theme& theme = Theme::current();
    qDeleteAll(m_cells);
    m_cells.clear();
    QStringList spoken;
    const auto add = [&](int row, const QStringList& words) {
        for (int c = 0; c < kColumns; ++c) {
            auto* cell = new QLabel(words[c], this);
            cell->setFont(row > 0 && c > 0 ? theme.mono(12) : theme.text(12));
            if (row == 0) cell->setProperty("tone", 2);
            m_grid->addWidget(cell, row, c, (c > 0 ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
            m_cells.push_back(cell);
        }
        if (row > 0) spoken << words.join(' ');
    };
    const QString name = QStringLiteral("rgb").mid(channel, 1);
    add(0, {tr("laid over it"), tr("z_view"), QStringLiteral("α"), QStringLiteral("I_%1").arg(name), tr("adds")});
    const auto& layers = report.layers;
    for (std::size_t i = 0; i < layers.size(); ++i)
        add(int(i) + 1,
            {tr("polygon %1").arg(layers[i].polygon), app::depth(layers[i].zView), number(layers[i].alpha, 2),
             number(layers[i].intensity[channel], 3), number(addedBy(layers, i, channel), 3)});
    m_grid->setHorizontalSpacing(theme.px(12));
    m_grid->setVerticalSpacing(theme.px(2));
    m_sum->setFont(theme.text(12));
    m_sum->setText(tr("They let %1 of the surface behind through: %1 · %2 + %3 = %4")
                       .arg(number(report.transmittance, 4), number(report.intensity[channel], 3),
                            number(report.translucent[channel], 3), number(report.composed[channel], 3)));
    m_sentence = layers.size() == 1 ? tr("1 layer") : tr("%1 layers, farthest first").arg(layers.size());
    setAccessibleDescription(spoken.join("; ") + ". " + m_sum->text());
}

}  // namespace app
