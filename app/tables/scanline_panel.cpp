#include "app/tables/scanline_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>

#include "app/jobs/write_file.h"
#include "app/look/text.h"
#include "app/tables/scanline_plot_view.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/save_dialog.h"
#include "pipeline/export/figure/plot_file.h"

namespace app {

ScanlinePanel::ScanlinePanel(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_spin(new QSpinBox(this)),
      m_name(new QLabel(tr("Row"), this)),
      m_said(new ElidedLabel(this)),
      m_csv(new QToolButton(this)),
      m_svg(new QToolButton(this)),
      m_plot(new ScanlinePlotView(this)) {
    setObjectName("scanlinePanel");
    auto* head = new QHBoxLayout;
    head->addWidget(m_name);
    head->addWidget(m_spin);
    head->addWidget(m_said, 1);
    head->addWidget(m_csv);
    head->addWidget(m_svg);
    auto* column = spaced(new QVBoxLayout(this), {}, 0);
    column->addLayout(head);
    column->addWidget(m_plot, 1);
    m_spin->setAccessibleName(tr("Row of the section"));
    m_spin->setToolTip(tr("The row of pixels, 0 on top; that of the picked pixel when one is picked."));
    m_spin->setKeyboardTracking(false);
    m_csv->setText(tr("CSV…"));
    m_csv->setToolTip(tr("Writes the curves as a table of numbers."));
    m_svg->setText(tr("SVG…"));
    m_svg->setToolTip(tr("Writes the plot as a picture."));
    m_said->setProperty("tone", "2");
    followTheme(this, [this, head] {
        const Theme& theme = Theme::current();
        for (QLabel* label : {m_name, m_said}) label->setFont(theme.text(12));
        m_spin->setFont(theme.mono(13));
        for (QToolButton* button : {m_csv, m_svg}) button->setFont(theme.text(12));
        head->setContentsMargins(theme.px(10), theme.px(4), theme.px(6), theme.px(4));
        head->setSpacing(theme.px(8));
    });

    connect(m_spin, &QSpinBox::valueChanged, this, &ScanlinePanel::setRow);
    connect(m_csv, &QToolButton::clicked, this, [this] { save(tr("Save the section"), "csv", csv()); });
    connect(m_svg, &QToolButton::clicked, this, [this] { save(tr("Save the plot"), "svg", svg()); });
    connect(m_plot, &ScanlinePlotView::hovered, this, [this](std::optional<int> x) {
        m_document.pointing().hover(x ? std::optional(glm::ivec2(*x, m_row)) : std::nullopt);
    });
    connect(m_plot, &ScanlinePlotView::picked, this,
            [this](int x) { m_document.pointing().pick(glm::ivec2(x, m_row)); });
    connect(m_plot, &ScanlinePlotView::rowAsked, this, [this](int by) {
        const auto pixel = m_document.pointing().pixel();
        if (pixel && pixel->y == m_row)
            m_document.pointing().pick(glm::ivec2(pixel->x, pixel->y + by));  // the mark goes along
        else
            setRow(m_row + by);
    });
    connect(&document.frames(), &FrameFeed::frameReady, this, &ScanlinePanel::compute);
    connect(&document, &Document::sceneOpened, this, [this] {
        m_isRowChosen = false;
        goTo(m_document.scene().settings.height / 2);
    });
    // Of another height it has other rows.
    connect(&document, &Document::sceneChanged, this, [this] { goTo(m_row); });
    connect(&document.pointing(), &Pointing::pixelChanged, this, [this] {
        if (m_document.pointing().pixel()) setRow(m_document.pointing().pixel()->y);
        showMarks();
    });
    connect(&document.pointing(), &Pointing::hoverChanged, this, &ScanlinePanel::showMarks);
    connect(&document.pointing(), &Pointing::channelChanged, this,
            [this] { m_plot->setSection(m_section, m_document.pointing().channel()); });
}

void ScanlinePanel::setRow(int row) {
    m_isRowChosen = true;
    goTo(row);
}

void ScanlinePanel::goTo(int row) {
    if (m_document.hasScene()) {
        const int last = m_document.scene().settings.height - 1;
        row = std::clamp(row, 0, last);
        const QSignalBlocker quiet(m_spin);
        m_spin->setRange(0, last);
        m_spin->setValue(row);
    }
    if (row == m_row) return;
    m_row = row;
    compute();
}

void ScanlinePanel::showEvent(QShowEvent*) {
    want();
    if (m_document.pointing().pixel()) setRow(m_document.pointing().pixel()->y);
    compute();
}

void ScanlinePanel::hideEvent(QHideEvent*) {
    m_job.forget();
    want();
}

void ScanlinePanel::want() {
    m_document.frames().want(this, isVisible() ? pipeline::sectionBuffers() : pipeline::BufferSet());
}

void ScanlinePanel::compute() {
    const pipeline::FramePtr frame = m_document.frames().shown();
    if (!isVisible() || !frame || m_row >= frame->scene().settings.height) return;
    m_job.ask(
        [frame, chosen = m_isRowChosen ? std::optional(m_row) : std::nullopt](const BackgroundJob::Control& control) {
            const int row = chosen ? *chosen : middleDrawnRow(*frame);
            auto section = shadedSection(frame, row, 0, control.stop);
            return section ? std::make_shared<const pipeline::ScanlineSection>(*std::move(section)) : nullptr;
        },
        [this](const std::shared_ptr<const pipeline::ScanlineSection>& section) {
            if (!section) return;
            m_section = section;
            if (!m_isRowChosen) setRow(section->row);
            m_plot->setSection(section, m_document.pointing().channel());
            m_plot->setSentence(tr("Nothing is drawn in row %1.").arg(section->row));
            m_said->setText(section->empty()
                                ? QString()
                                : tr("bold: seen, dashed: hidden; flat, Gouraud and Phong at the same points"));
            m_plot->setAccessibleDescription(
                tr("Row %1, %2 runs of polygons").arg(section->row).arg(section->runs.size()));
            for (QToolButton* button : {m_csv, m_svg}) button->setEnabled(!section->empty());
            showMarks();
        },
        BackgroundJob::Running::Finish);
}

void ScanlinePanel::showMarks() {
    const int row = m_section ? m_section->row : m_row;
    const auto inRow = [row](std::optional<glm::ivec2> pixel) {
        return pixel && pixel->y == row ? std::optional(pixel->x) : std::nullopt;
    };
    m_plot->setMarks(inRow(m_document.pointing().pixel()), inRow(m_document.pointing().hovered()));
}

QString ScanlinePanel::csv() const { return m_section ? toQString(sectionCsv(*m_section)) : QString(); }

QString ScanlinePanel::svg() const {
    if (!m_section || m_section->empty()) return {};
    const pipeline::PlotDrawing drawing =
        layOut(pipeline::ScanlinePlot{m_section.get(), m_document.pointing().channel(), std::nullopt, std::nullopt},
               {1200, 600, 16});
    constexpr std::array kThemes{pipeline::PlotTheme::Dark, pipeline::PlotTheme::Light, pipeline::PlotTheme::Projector};
    return toQString(plotSvg(drawing, kThemes[std::size_t(Theme::current().id())]));
}

void ScanlinePanel::save(const QString& title, const QString& ending, const QString& text) {
    const QString file = askWhereToSave(this, title, QStringLiteral("row_%1.%2").arg(m_row).arg(ending),
                                        QStringLiteral("*.%1").arg(ending), ending);
    if (file.isEmpty()) return;
    const auto errors = writeFile(file, text.toUtf8());
    errors.empty() ? emit m_document.said(tr("Wrote %1.").arg(file)) : emit m_document.notWritten(file, errors);
}

}  // namespace app
