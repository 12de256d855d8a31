#include "app/my_renderer/renderer_finding.h"

#include <QApplication>
#include <QClipboard>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "app/document/document.h"
#include "app/look/text.h"
#include "pipeline/compare/report/compare_text.h"
#include "pipeline/compare/report/worst_pixels.h"

namespace app {

namespace foreign = pipeline::foreign;

namespace {

constexpr const char* kHints = "renderer/hints";

}  // namespace

RendererFinding::RendererFinding(Document& document, QObject* parent)
    : QObject(parent), m_document(document), m_hints(keptHints()) {
    connect(&check(), &RendererCheck::opened, this, [this] {
        m_begins = true;
        m_hints = keptHints();
    });
    connect(&check(), &RendererCheck::compared, this, &RendererFinding::take);
    take();
}

RendererCheck& RendererFinding::check() const { return m_document.renderer(); }

int RendererFinding::keptHints() { return std::clamp(QSettings().value(kHints, 3).toInt(), 0, 3); }

void RendererFinding::setHints(int hints) {
    QSettings().setValue(kHints, hints);
    m_hints = hints;
    take();
}

void RendererFinding::giveNextHint() {
    m_hints = std::min(m_hints + 1, 3);
    take();
}

// A report of its own, as texts look at how much may be given away.
void RendererFinding::take() {
    m_report.reset();
    // The names come after the stages: whoever has gone on to a pixel stays there.
    const std::vector<glm::ivec2> before = std::exchange(m_worst, {});
    if (check().report()) {
        auto report = std::make_shared<foreign::Report>(*check().report());
        report->options.hints = m_hints;
        m_worst = worstPixels(*report);
        m_report = std::move(report);
    }
    if (m_worst != before) m_nextWorst = 0;
    check().setGiven(m_hints);
    emit changed();
    if (!m_report || !std::exchange(m_begins, false)) return;
    emit begun();
    if (!m_report->agrees()) goToWorst();
    emit m_document.said(tr("Compared %1: %2").arg(check().name(), toQString(headline(*m_report))));
}

bool RendererFinding::canGoToWorst() const { return m_report && (!m_worst.empty() || m_report->firstDifference()); }

void RendererFinding::goToWorst() {
    if (!m_report) return;
    using Kind = lessons::Selection::Kind;
    if (const foreign::Finding* first = m_report->firstDifference(); first && m_nextWorst == 0) {
        m_document.setStage(first->stage);
        const foreign::Finding* const picture = firstWrongPicture(*m_report);
        emit showAsked(picture ? picture->name.buffer : first->name.buffer);
        if (m_worst.empty() && first->worst) {
            const auto domain = bufferInfo(first->name.buffer.id).domain;
            if (domain == pipeline::Domain::Polygon || domain == pipeline::Domain::Vertex)
                m_document.pointing().select(lessons::Selection{
                    domain == pipeline::Domain::Polygon ? Kind::Polygon : Kind::Vertex, *first->worst});
        }
    }
    if (m_worst.empty()) return;
    m_document.pointing().pick(m_worst[m_nextWorst]);
    m_nextWorst = (m_nextWorst + 1) % m_worst.size();
}

void RendererFinding::goToStage(pipeline::StageId stage) {
    m_document.setStage(stage);
    if (!m_report) return;
    // The first of its buffers that differs, else the first that was handed in.
    const foreign::Finding* shown = nullptr;
    for (const std::size_t i : m_report->stages[index(stage)].findings) {
        const foreign::Finding& finding = m_report->findings[i];
        if (!shown || (shown->agrees && !finding.agrees)) shown = &finding;
    }
    if (shown) emit showAsked(shown->name.buffer);
}

QString RendererFinding::text() const {
    if (!m_report) return {};
    QStringList lines;
    for (const foreign::TextLine& line : reportText(*m_report, false, 100)) lines << toQString(line.text);
    return lines.join('\n') + '\n';
}

void RendererFinding::copy() {
    if (!m_report) return;
    QApplication::clipboard()->setText(text());
    emit m_document.said(tr("Copied the finding as text."));
}

}  // namespace app
