#include "app/inspector/inspector_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QPixmap>
#include <QScrollArea>
#include <QStackedLayout>
#include <QVBoxLayout>

#include "app/inspector/equation_section.h"
#include "app/inspector/fragments_section.h"
#include "app/inspector/layers_section.h"
#include "app/inspector/terms_section.h"
#include "app/inspector/why_section.h"
#include "app/look/number_format.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "app/look/working_bar.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/section.h"
#include "pipeline/formats/built_in_scenes.h"

namespace app {

InspectorPanel::InspectorPanel(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
    build();
    connect(m_why, &WhySection::bufferAsked, this, &InspectorPanel::bufferAsked);
    connect(m_equation, &EquationSection::bufferAsked, this, &InspectorPanel::bufferAsked);
    connect(m_equation, &EquationSection::settingAsked, this, &InspectorPanel::settingAsked);
    connect(&document, &Document::sceneOpened, this, [this] {
        refresh();
        m_equation->forget();  // also what has just been shown: it is still of the scene before
    });
    connect(&document.inspection(), &PixelInspection::changed, this, &InspectorPanel::refresh);
    connect(&document.inspection(), &PixelInspection::busyChanged, m_working, &WorkingBar::setWorking);
    connect(&document.work(), &WorkList::changed, this, [this, &document] {
        const WorkList& work = document.work();
        m_working->setStopped(work.isStopped(&document.inspection()) || work.isStopped(&document.frames()));
    });
    connect(&document.pointing(), &Pointing::channelChanged, this, &InspectorPanel::refresh);
    connect(&NumberStyle::current(), &NumberStyle::changed, this, &InspectorPanel::refresh);
    connect(m_fragments, &FragmentsSection::polygonAsked, this, [this](std::uint32_t polygon) {
        m_document.pointing().select(lessons::Selection{lessons::Selection::Kind::Polygon, polygon});
    });
    connect(&document.pointing(), &Pointing::selectionChanged, this, [this] {
        const auto& thing = m_document.pointing().selection();
        const bool isPolygon = thing && thing->kind == lessons::Selection::Kind::Polygon;
        m_fragments->setSelected(isPolygon ? std::optional(std::uint32_t(thing->index)) : std::nullopt);
    });
    followTheme(this, [this] { styleHeader(); });
    // The projector has room for one thing at a time: the equation.
    connect(&Theme::current(), &Theme::changed, this, [this, before = Theme::current().id()]() mutable {
        if (Theme::current().id() != before) m_whyFold->setFolded(Theme::current().id() == ThemeId::Projector);
        before = Theme::current().id();
    });
    m_whyFold->setFolded(Theme::current().id() == ThemeId::Projector);
    refresh();
}

void InspectorPanel::build() {
    m_empty = new QLabel(tr("Click a pixel to see why it has its colour."), this);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setTextFormat(Qt::PlainText);  // a scene's words are its author's
    m_empty->setMargin(16);

    auto* page = new QWidget(this);
    page->setProperty("kind", "page");
    m_swatch = new QLabel(page);
    m_swatch->setAccessibleName(tr("Colour of the pixel"));
    m_title = new QLabel(page);
    m_title->setTextFormat(Qt::RichText);
    m_title->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_place = new QLabel(page);
    m_place->setWordWrap(true);
    m_value = new QLabel(page);
    m_value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_unit = new QLabel(tr("sRGB, 8 bit"), page);
    for (QLabel* label : {m_place, m_unit}) label->setProperty("tone", "2");
    auto* header = new QGridLayout;
    header->setContentsMargins(12, 10, 12, 10);
    header->setHorizontalSpacing(10);
    header->setVerticalSpacing(1);
    header->addWidget(m_swatch, 0, 0, 2, 1);
    header->addWidget(m_title, 0, 1);
    header->addWidget(m_place, 1, 1);
    header->addWidget(m_value, 0, 2, Qt::AlignRight | Qt::AlignBaseline);
    header->addWidget(m_unit, 1, 2, Qt::AlignRight | Qt::AlignTop);
    header->setColumnStretch(1, 1);

    m_why = new WhySection(m_document);
    m_equation = new EquationSection(m_document);
    m_terms = new TermsSection(m_document);
    m_layers = new LayersSection;
    m_fragments = new FragmentsSection;
    m_whyFold = new Section(tr("Why this colour"), m_why);
    m_equationFold = new Section(tr("Equation"), m_equation, m_equation->switcher());
    m_termsFold = new Section(tr("Terms"), m_terms);
    m_layersFold = new Section(tr("Layers"), m_layers);
    m_fragmentsFold = new Section(tr("Fragments"), m_fragments);
    for (Section* section : {m_termsFold, m_layersFold, m_fragmentsFold}) section->setKeepsSentence();
    auto* column = spaced(new QVBoxLayout(page), {}, 0);
    column->addLayout(header);
    for (Section* section : {m_whyFold, m_equationFold, m_termsFold, m_layersFold, m_fragmentsFold})
        column->addWidget(section);
    column->addStretch();

    m_scroll = new QScrollArea(this);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setWidget(page);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_working = new WorkingBar(this);
    auto* stack = new QStackedLayout(this);
    stack->addWidget(m_empty);
    stack->addWidget(m_scroll);
}

void InspectorPanel::styleHeader() {
    const Theme& theme = Theme::current();
    m_empty->setFont(theme.text(13));
    m_title->setFont(theme.text(16, 600));
    m_place->setFont(theme.text(12));
    m_value->setFont(theme.mono(14));
    m_unit->setFont(theme.text(12));
    m_swatch->setFixedSize(theme.px(32), theme.px(32));
    m_swatch->setFrameShape(QFrame::Box);
    if (m_shown) {
        showLayers();
        const pipeline::Color8 color = m_shown->report.color;
        QPixmap swatch(m_swatch->size());
        swatch.fill(QColor(color.r, color.g, color.b));
        m_swatch->setPixmap(swatch);
    }
    setMinimumWidth(theme.px(300));
}

void InspectorPanel::refresh() {
    m_shown = m_document.inspection().newest();
    auto* stack = static_cast<QStackedLayout*>(layout());
    if (!m_shown) {
        tellEmpty();
        return stack->setCurrentWidget(m_empty);
    }
    const pipeline::Frame& frame = *m_shown->frame;
    const pipeline::PixelReport& report = m_shown->report;
    showHeader();
    m_why->show(frame, report);
    m_whyFold->setSentence(m_why->sentence());
    const bool isLit = !report.evaluations.empty();  // not before the shading stage, nor where outlines are drawn
    const bool isLaid = !report.layers.empty() && report.isShaded;  // of translucent surfaces, maybe over nothing
    m_equationFold->setVisible(isLit || isLaid);
    m_termsFold->setVisible(isLit);
    m_layersFold->setVisible(isLaid);
    showLayers();
    m_fragments->show(frame, report);
    m_fragmentsFold->setSentence(m_fragments->sentence());
    if (isLit || isLaid) {
        m_equation->show(frame, report);
        m_equationFold->setSentence(m_equation->sentence());
    }
    if (isLit) {
        m_terms->show(report, m_document.pointing().channel());
        m_termsFold->setSentence(
            tr("of I in %1").arg(QStringList{tr("red"), tr("green"), tr("blue")}[m_document.pointing().channel()]));
    }
    stack->setCurrentWidget(m_scroll);
}

void InspectorPanel::showLayers() {
    if (m_shown->report.layers.empty() || !m_shown->report.isShaded) return;
    m_layers->show(m_shown->report, m_document.pointing().channel());
    m_layersFold->setSentence(m_layers->sentence());
}

// What there is to look at in this scene, until a pixel is picked.
void InspectorPanel::tellEmpty() {
    QString look = m_document.hasScene() ? toQString(m_document.scene().look) : QString();
    if (const auto known = pipeline::builtInSceneOf(m_document.kept().file.toStdString()); known && look.isEmpty())
        look = toQString(known->look);
    m_empty->setText((look.isEmpty() ? QString() : look + "\n\n") + tr("Click a pixel to see why it has its colour."));
}

void InspectorPanel::showHeader() {
    styleHeader();  // fonts set while it was hidden do not outlive its way into the window
    const pipeline::PixelReport& r = m_shown->report;
    const QString place = QString("%1, %2").arg(r.pixel.x).arg(r.pixel.y);
    m_title->setText(tr("Pixel") +
                     QString(" <span style=\"font-family:'JetBrains Mono','DejaVu Sans Mono'\">%1</span>").arg(place));
    m_value->setText(QString("%1 %2 %3").arg(int(r.color.r)).arg(int(r.color.g)).arg(int(r.color.b)));
    if (r.covered) {
        const QString object = onOneLine(m_shown->frame->scene().objects[std::size_t(r.object)].name);
        m_place->setText(tr("Polygon %1 of %2, row 0 on top").arg(r.polygon).arg(object));
    } else {
        m_place->setText(!r.layers.empty()                      ? tr("Background, behind translucent surfaces.")
                         : isStillDrawing(m_document.stepper()) ? tr("Nothing is drawn here yet.")
                                                                : tr("Background: nothing was drawn here."));
    }
    setAccessibleDescription(tr("Pixel %1, colour %2. %3").arg(place, m_value->text(), m_place->text()));
}

}  // namespace app
