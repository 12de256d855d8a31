#include "app/export/figure_size_fields.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSettings>
#include <algorithm>
#include <array>

#include "app/widgets/follow_theme.h"
#include "app/widgets/segmented.h"

namespace app {
namespace {

struct PaperWidth {
    const char* name;
    double width;  // mm
};
constexpr std::array<PaperWidth, 3> kPaperWidths{{{"one column", 84}, {"two columns", 174}, {"slide", 254}}};
constexpr double kMostPrintedDots = 1200;  // more than a printer resolves

// What the last figure had.
FigureOrder lastFigure() {
    const QSettings kept;
    FigureOrder order;
    order.width = kept.value("figure/width", order.width).toDouble();
    order.letters = kept.value("figure/letters", order.letters).toDouble();
    order.dotsPerInch = kept.value("figure/dots", order.dotsPerInch).toDouble();
    order.format = pipeline::FigureFormat(std::clamp(kept.value("figure/format").toInt(), 0, 2));
    order.isForProjector = kept.value("figure/projector").toBool();
    return order;
}

QDoubleSpinBox* sizeField(const char* name, const QString& words, double low, double high, double value,
                          const QString& unit, QWidget* parent) {
    auto* spin = new QDoubleSpinBox(parent);
    spin->setObjectName(name);
    spin->setAccessibleName(words);
    spin->setLocale(QLocale::c());
    spin->setDecimals(1);
    spin->setRange(low, high);
    spin->setValue(value);
    spin->setSuffix(' ' + unit);
    return spin;
}

}  // namespace

FigureSizeFields::FigureSizeFields(QWidget* parent) : QWidget(parent), m_widths(new QComboBox(this)) {
    const FigureOrder last = lastFigure();
    m_width = sizeField("figureWidth", tr("Width in mm"), pipeline::kLeastFigure, pipeline::kMostFigure, last.width,
                        tr("mm"), this);
    m_letters = sizeField("figureLetters", tr("Text size in pt"), pipeline::kLeastLetters, pipeline::kMostLetters,
                          last.letters, tr("pt"), this);
    m_dots = sizeField("figureDots", tr("Dots per inch"), pipeline::kLeastDots, kMostPrintedDots, last.dotsPerInch,
                       tr("dots per inch"), this);
    m_dots->setDecimals(0);
    m_format = new Segmented({"SVG", "PDF", "PNG"}, this);
    m_format->setObjectName("figureFormat");
    m_format->setCurrent(int(last.format));
    m_colors = new Segmented({tr("light"), tr("projector")}, this);
    m_colors->setCurrent(last.isForProjector ? 1 : 0);
    auto* widths = new QWidget(this);
    makeWidth(widths);
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("Width"), widths);
    form->addRow(tr("Text size"), m_letters);
    form->addRow(tr("Format"), m_format);
    form->addRow(tr("PNG"), m_dots);
    form->addRow(tr("Colours"), m_colors);
    showDots();
    for (QDoubleSpinBox* spin : {m_width, m_letters, m_dots})
        connect(spin, &QDoubleSpinBox::valueChanged, this, &FigureSizeFields::changed);
    for (Segmented* choices : {m_format, m_colors})
        connect(choices, &Segmented::chosen, this, [this, choices](int choice) {
            choices->setCurrent(choice);
            showDots();
            emit changed();
        });
}

// The number, and the name of a usual one.
void FigureSizeFields::makeWidth(QWidget* row) {
    m_widths->setAccessibleName(tr("Usual widths"));
    for (const PaperWidth& one : kPaperWidths) m_widths->addItem(tr(one.name));
    m_widths->addItem(tr("own width"));
    const auto showName = [this] {
        const auto* own = std::ranges::find(kPaperWidths, m_width->value(), &PaperWidth::width);
        m_widths->setCurrentIndex(int(own - kPaperWidths.begin()));
    };
    showName();
    connect(m_width, &QDoubleSpinBox::valueChanged, this, showName);
    connect(m_widths, &QComboBox::activated, this, [this](int i) {
        if (std::size_t(i) < kPaperWidths.size()) m_width->setValue(kPaperWidths[std::size_t(i)].width);
    });
    auto* fields = spaced(new QHBoxLayout(row), {});
    fields->addWidget(m_width, 1);
    fields->addWidget(m_widths, 1);
}

void FigureSizeFields::showDots() {
    static_cast<QFormLayout*>(layout())->setRowVisible(m_dots, m_format->current() == int(pipeline::FigureFormat::Png));
}

void FigureSizeFields::addTo(FigureOrder& order) const {
    order.width = m_width->value(), order.letters = m_letters->value(), order.dotsPerInch = m_dots->value();
    order.format = pipeline::FigureFormat(m_format->current());
    order.isForProjector = m_colors->current() == 1;
}

void FigureSizeFields::remember() const {
    FigureOrder now;
    addTo(now);
    QSettings kept;
    kept.setValue("figure/width", now.width);
    kept.setValue("figure/letters", now.letters);
    kept.setValue("figure/dots", now.dotsPerInch);
    kept.setValue("figure/format", int(now.format));
    kept.setValue("figure/projector", now.isForProjector);
}

}  // namespace app
