#include "app/panels/renderer_panel.h"

#include <QAccessible>
#include <QApplication>
#include <QClipboard>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/core/document.h"
#include "app/core/text.h"
#include "app/core/worst_pixels.h"
#include "app/panels/follow_theme.h"
#include "app/panels/renderer_conventions.h"
#include "app/panels/renderer_error.h"
#include "app/panels/renderer_values.h"
#include "app/panels/section.h"
#include "app/panels/standing_row.h"
#include "pipeline/compare/compare_text.h"

namespace app {

namespace foreign = pipeline::foreign;
using foreign::Standing;

namespace {

constexpr const char* kHints = "renderer/hints";

Standing wholeStanding(const foreign::Report& report) {
    if (report.agrees()) return Standing::Agrees;
    return report.firstWrong && report.options.hints >= 1 ? Standing::WrongHere : Standing::CannotTell;
}

}  // namespace

RendererPanel::RendererPanel(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_renderer(document.renderer()), m_scroll(new QScrollArea(this)) {
    setObjectName("rendererPanel");
    setAccessibleName(tr("My renderer"));
    setFocusPolicy(Qt::StrongFocus);
    m_hints = keptHints();
    auto* content = new QWidget(m_scroll);
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    makeEmpty(*column);
    m_parts = new QWidget(content);
    auto* parts = new QVBoxLayout(m_parts);
    parts->setContentsMargins(0, 0, 0, 0);
    parts->setSpacing(0);
    makeHead(*parts);
    makeParts(*parts);
    column->addWidget(m_parts, 1);
    m_scroll->setWidget(content);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    content->setAutoFillBackground(false);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(m_scroll);
    connect(&m_renderer, &RendererCheck::opened, this, [this] {
        m_begins = true;
        m_hints = keptHints();
    });
    connect(&m_renderer, &RendererCheck::compared, this, &RendererPanel::take);
    connect(&m_renderer, &RendererCheck::changed, this, &RendererPanel::showState);
    connect(m_error, &RendererError::lessonAsked, this, &RendererPanel::lessonAsked);
    connect(m_error, &RendererError::rowsStated, this, [this](bool other) {
        const bool bottomUp = std::ranges::any_of(m_report->conventions.files,
                                                  [](const foreign::ReadFile& file) { return file.reading.bottomUp; });
        m_renderer.state("rows", bottomUp != other ? "bottom-up" : "top-down");
    });
    connect(&document, &Document::pixelChanged, this, &RendererPanel::showPlace);
    connect(&document, &Document::selectionChanged, this, &RendererPanel::showPlace);
    connect(&document, &Document::stageChanged, this, [this] {
        for (StandingRow* row : m_rows) row->setOnShow(row->stage() == m_document.stage());
    });
    take();
}

int RendererPanel::keptHints() { return std::clamp(QSettings().value(kHints, 3).toInt(), 0, 3); }

void RendererPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_renderer.setFollowed(true);
}

void RendererPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    m_renderer.setFollowed(false);
}

// A report of its own, as texts look at how much may be given away.
void RendererPanel::take() {
    m_report.reset();
    // The names come after the stages: whoever has gone on to a pixel stays there.
    const std::vector<glm::ivec2> before = std::exchange(m_worst, {});
    if (m_renderer.report()) {
        auto report = std::make_shared<foreign::Report>(*m_renderer.report());
        report->options.hints = m_hints;
        m_worst = worstPixels(*report);
        m_report = std::move(report);
    }
    if (m_worst != before) m_nextWorst = 0;
    m_renderer.setGiven(m_hints);
    showAll();
    if (!m_report || !std::exchange(m_begins, false)) return;
    emit begun();
    if (!m_report->agrees()) goToWorst();
    QAccessibleEvent alert(m_heading, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
    emit m_document.said(tr("Compared %1: %2").arg(m_renderer.name(), toQString(headline(*m_report))));
}

void RendererPanel::setHints(int hints) {
    QSettings().setValue(kHints, hints);
    m_hints = hints;
    take();
}

void RendererPanel::showAll() {
    showState();
    m_body->setVisible(m_report != nullptr);
    m_mark->setVisible(m_report != nullptr);
    m_evidence->setVisible(m_report != nullptr);
    if (!m_report) return;
    const foreign::Report& report = *m_report;
    m_mark->show(wholeStanding(report));
    m_heading->setText(toQString(headline(report)));
    m_evidence->setText(toQString(evidence(report)));
    m_evidence->setVisible(!m_evidence->text().isEmpty());
    showStages();
    m_error->show(report);
    if (report.options.hints < 3) m_error->hide();
    const bool givesPlace = report.options.hints >= 2;
    m_goToWorst->setVisible(givesPlace && !report.agrees());
    m_goToWorst->setEnabled(!m_worst.empty() || report.firstDifference());
    m_goToWorst->setToolTip(tr("Pick the pixel that differs most; again: the next one (Alt+W)"));
    m_conventions->show(report);
    m_conventionPart->setSentence(m_conventions->sentence());
    showContracts();
    showFiles();
    showHints();
    showPlace();
}

void RendererPanel::showState() {
    const bool open = m_renderer.isOpen();
    m_empty->setVisible(!open);
    m_parts->setVisible(open);
    if (!open) return;
    const QString read = m_renderer.readAt();
    m_source->setText(read.isEmpty() ? m_renderer.name() : tr("%1  read %2").arg(m_renderer.name(), read));
    m_source->setToolTip(tr("Watched: compared again whenever it changes") + "<br>" +
                         m_renderer.paths().join('\n').toHtmlEscaped());
    if (!m_report) {
        const bool works = m_renderer.work() != RendererCheck::Work::None;
        m_heading->setText(!m_document.hasScene()        ? tr("Open the scene that your renderer draws")
                           : works                       ? tr("Your files are being compared")
                           : m_renderer.wasCancelled()   ? tr("The comparison was cancelled")
                           : m_renderer.errors().empty() ? tr("Your files are compared next")
                                                         : tr("The files cannot be compared"));
    }
    const pipeline::Errors& errors = m_renderer.errors();
    m_errors->setVisible(!errors.empty());
    m_errors->setText(toQString(format(errors)).trimmed());
    showWork();
}

void RendererPanel::goToStage(StandingRow& row) {
    m_document.setStage(row.stage());
    if (!m_report) return;
    // The first of its buffers that differs, else the first that was handed in.
    const foreign::Finding* shown = nullptr;
    for (const std::size_t i : m_report->stages[index(row.stage())].findings) {
        const foreign::Finding& finding = m_report->findings[i];
        if (!shown || (shown->agrees && !finding.agrees)) shown = &finding;
    }
    if (shown) emit showAsked(shown->name.buffer);
}

void RendererPanel::goToWorst() {
    if (!m_report) return;
    using Kind = lessons::Selection::Kind;
    if (const foreign::Finding* first = m_report->firstDifference(); first && m_nextWorst == 0) {
        m_document.setStage(first->stage);
        const foreign::Finding* const picture = firstWrongPicture(*m_report);
        emit showAsked(picture ? picture->name.buffer : first->name.buffer);
        if (m_worst.empty() && first->worst) {
            const auto domain = bufferInfo(first->name.buffer.id).domain;
            if (domain == pipeline::Domain::Polygon || domain == pipeline::Domain::Vertex)
                m_document.select(lessons::Selection{domain == pipeline::Domain::Polygon ? Kind::Polygon : Kind::Vertex,
                                                     *first->worst});
        }
    }
    if (m_worst.empty()) return;
    m_document.pick(m_worst[m_nextWorst]);
    m_nextWorst = (m_nextWorst + 1) % m_worst.size();
}

QString RendererPanel::text() const {
    if (!m_report) return {};
    QStringList lines;
    for (const foreign::TextLine& line : reportText(*m_report, false, 100)) lines << toQString(line.text);
    return lines.join('\n') + '\n';
}

void RendererPanel::copyFinding() {
    if (!m_report) return;
    QApplication::clipboard()->setText(text());
    emit m_document.said(tr("Copied the finding as text."));
}

void RendererPanel::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy)) return copyFinding();
    if (event->key() == Qt::Key_W && event->modifiers() == Qt::NoModifier) return goToWorst();
    if (event->key() == Qt::Key_F5) return m_renderer.readAgain();
    QWidget::keyPressEvent(event);
}

}  // namespace app
