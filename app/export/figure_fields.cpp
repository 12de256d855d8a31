#include "app/export/figure_fields.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleValidator>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <cmath>

#include "app/export/figure_size_fields.h"
#include "app/look/text.h"
#include "app/widgets/buffer_chooser.h"
#include "app/widgets/follow_theme.h"

namespace app {
namespace {

std::optional<double> numberIn(const QLineEdit& field) {
    bool isNumber = false;
    const double value = field.text().toDouble(&isNumber);
    return isNumber && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

QString shortNumber(double value) { return QString::number(value, 'g', 6); }

}  // namespace

FigureFields::FigureFields(const Document& document, const FigureOrder& first, QWidget* parent)
    : QWidget(parent), m_document(document), m_order(first), m_size(new FigureSizeFields(this)) {
    auto* column = new QVBoxLayout(this);
    for (QWidget* part : {makeContent(), makeLook(), makeCaption(), static_cast<QWidget*>(m_size)})
        column->addWidget(part);
    column->addStretch(1);
    connect(m_size, &FigureSizeFields::changed, this, &FigureFields::changed);
    followTheme(this, [column] { column->setSpacing(Theme::current().px(16)); });
    setFocusProxy(m_buffer);
    connect(&document.pointing(), &Pointing::pixelChanged, this, [this] { showBuffer(), emit changed(); });
    showBuffer();
}

QWidget* FigureFields::makeContent() {
    auto* part = new QWidget(this);
    auto* form = new QFormLayout(part);
    form->setContentsMargins(0, 0, 0, 0);
    m_buffer = new BufferChooser(m_document, part);
    m_buffer->setObjectName("figureBuffer");
    m_buffer->setName(m_order.buffer);
    connect(m_buffer, &BufferChooser::chosen, this, [this](const pipeline::BufferName& name) {
        m_order.buffer = name;
        m_buffer->setName(name);
        for (QLineEdit* field : m_ends) field->clear();  // they were of other values
        showBuffer();
        emit changed();
    });
    m_part = new QComboBox(part);
    m_part->setObjectName("figurePart");
    m_part->addItem(tr("whole buffer"));
    if (const auto& seen = m_order.part)
        m_part->addItem(
            tr("in view, %1 × %2").arg(seen->last.x - seen->first.x + 1).arg(seen->last.y - seen->first.y + 1));
    m_part->setCurrentIndex(m_part->count() - 1);
    connect(m_part, &QComboBox::currentIndexChanged, this, &FigureFields::changed);
    auto* range = new QHBoxLayout;
    const auto end = [&](const char* name, const QString& words, const std::optional<double>& value) {
        auto* field = new QLineEdit(value ? shortNumber(*value) : QString(), part);
        field->setObjectName(name);
        field->setAccessibleName(words);
        field->setToolTip(tr("Empty: the range of all drawn values"));
        field->setAlignment(Qt::AlignRight);
        auto* validator = new QDoubleValidator(field);
        validator->setLocale(QLocale::c());
        field->setValidator(validator);
        connect(field, &QLineEdit::textChanged, this, &FigureFields::changed);
        return field;
    };
    const auto& kept = m_order.range;
    m_ends[0] = end("figureFirst", tr("First value of the palette"), kept ? std::optional(kept->first) : std::nullopt);
    m_ends[1] = end("figureLast", tr("Last value of the palette"), kept ? std::optional(kept->last) : std::nullopt);
    range->addWidget(m_ends[0], 1);
    range->addWidget(new QLabel(tr("to"), part));
    range->addWidget(m_ends[1], 1);
    form->addRow(tr("Buffer"), m_buffer);
    form->addRow(tr("Part"), m_part);
    form->addRow(tr("Range"), range);
    followTheme(part, [this] {
        for (QLineEdit* field : m_ends) field->setFont(Theme::current().mono(12));
    });
    return part;
}

QCheckBox* FigureFields::check(const char* name, const QString& text, bool on) {
    auto* box = new QCheckBox(text, this);
    box->setObjectName(name);
    box->setChecked(on);
    connect(box, &QCheckBox::toggled, this, &FigureFields::changed);
    return box;
}

QWidget* FigureFields::makeLook() {
    auto* part = new QWidget(this);
    auto* column = spaced(new QVBoxLayout(part), {});
    m_bar = check("figureBar", tr("Palette bar with unit"), true);
    m_mark = check("figureMark", tr("Marked pixel"), true);
    m_grid = check("figureGrid", tr("Grid of pixels"), false);
    m_edges = check("figureEdges", tr("Polygon edges"), false);
    m_scale = check("figureScale", tr("Scale bar"), false);
    m_unit = new QLabel(part), m_pixel = new QLabel(part);
    for (const auto& [box, words] : {std::pair(m_bar, m_unit),
                                     std::pair(m_mark, m_pixel),
                                     std::pair<QCheckBox*, QLabel*>(m_grid, nullptr),
                                     {m_edges, nullptr},
                                     {m_scale, nullptr}}) {
        auto* row = new QHBoxLayout;
        row->addWidget(box, 1);
        if (words) {
            words->setProperty("tone", 2);
            row->addWidget(words);
        }
        column->addLayout(row);
    }
    followTheme(part, [this] { m_pixel->setFont(Theme::current().mono(12)); });
    return part;
}

QWidget* FigureFields::makeCaption() {
    auto* part = new QWidget(this);
    auto* column = spaced(new QVBoxLayout(part), {});
    m_caption = new QPlainTextEdit(part);
    m_caption->setObjectName("figureCaption");
    m_caption->setAccessibleName(tr("Caption"));
    m_caption->setTabChangesFocus(true);
    auto* name = new QLabel(tr("Caption"), part);
    name->setBuddy(m_caption);
    m_asMade = new QPushButton(tr("As made"), part);
    m_asMade->setObjectName("figureAsMade");
    m_asMade->setProperty("kind", "link");
    m_asMade->setAutoDefault(false);
    m_asMade->setEnabled(false);
    m_asMade->setToolTip(tr("Write the caption from the buffer, the scene and the marked pixel"));
    connect(m_caption, &QPlainTextEdit::textChanged, this, [this] {
        m_order.caption = m_caption->toPlainText();
        m_asMade->setEnabled(true);
        emit changed();
    });
    connect(m_asMade, &QPushButton::clicked, this, [this] {
        m_order.caption.reset();
        m_asMade->setEnabled(false);
        emit changed();
    });
    auto* row = new QHBoxLayout;
    row->addWidget(name, 1);
    row->addWidget(m_asMade);
    column->addLayout(row);
    column->addWidget(m_caption);
    followTheme(part, [this] { m_caption->setFixedHeight(5 * QFontMetrics(Theme::current().text(13)).lineSpacing()); });
    return part;
}

// What is known without the figure.
void FigureFields::showBuffer() {
    const pipeline::BufferInfo& info = bufferInfo(m_order.buffer.id);
    const bool isOfCamera = info.domain == pipeline::Domain::Pixel;
    m_edges->setEnabled(isOfCamera);
    m_edges->setToolTip(isOfCamera ? QString() : tr("The buffer is no picture of the camera."));
    const auto pixel = m_document.pointing().pixel();
    m_mark->setEnabled(pixel.has_value());
    m_mark->setToolTip(pixel ? QString() : tr("Pick a pixel first."));
    m_pixel->setText(pixel ? QStringLiteral("%1, %2").arg(pixel->x).arg(pixel->y) : QString());
    const bool hasBar = info.palette != pipeline::Palette::Color && info.palette != pipeline::Palette::Direction;
    for (QWidget* field : std::initializer_list<QWidget*>{m_bar, m_ends[0], m_ends[1]}) field->setEnabled(hasBar);
    m_bar->setToolTip(hasBar ? QString() : tr("Colours and directions have no palette."));
    m_unit->setText(hasBar ? toQString(info.unit) : QString());
}

FigureOrder FigureFields::order() const {
    FigureOrder order = m_order;
    if (m_part->currentIndex() == 0) order.part.reset();
    const auto first = numberIn(*m_ends[0]), last = numberIn(*m_ends[1]);
    const bool hasRange = m_ends[0]->isEnabled() && first && last && *first != *last;
    order.range = hasRange ? std::optional(pipeline::PaletteRange{*first, *last}) : std::nullopt;
    order.pixel = m_mark->isChecked() ? m_document.pointing().pixel() : std::nullopt;
    order.hasBar = m_bar->isChecked() || !m_bar->isEnabled(), order.hasGrid = m_grid->isChecked();
    order.hasEdges = m_edges->isChecked(), order.hasScale = m_scale->isChecked();
    m_size->addTo(order);
    return order;
}

void FigureFields::show(const pipeline::Figure& figure) {
    const QString caption = toQString(figure.caption);
    m_ends[0]->setPlaceholderText(shortNumber(figure.range.first));
    m_ends[1]->setPlaceholderText(shortNumber(figure.range.last));
    if (m_order.caption || m_caption->toPlainText() == caption) return;
    const QSignalBlocker blocker(m_caption);
    m_caption->setPlainText(caption);
}

void FigureFields::remember() const { m_size->remember(); }

}  // namespace app
