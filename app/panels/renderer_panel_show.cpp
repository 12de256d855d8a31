// The parts of a RendererPanel, as its report says.
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>

#include "app/core/document.h"
#include "app/core/numbers.h"
#include "app/core/text.h"
#include "app/panels/renderer_panel.h"
#include "app/panels/renderer_values.h"
#include "app/panels/section.h"
#include "app/panels/standing_row.h"
#include "pipeline/compare/compare_text.h"

namespace app {

namespace foreign = pipeline::foreign;

namespace {

QString commaList(const std::vector<std::string>& lines) {
    QStringList all;
    for (const std::string& line : lines) all << toQString(line);
    return all.join(QStringLiteral(", "));
}

}  // namespace

void RendererPanel::showWork() {
    const RendererCheck::Work work = m_renderer.work();
    const bool cancelled = work == RendererCheck::Work::None && m_renderer.wasCancelled();
    m_work->setVisible(work != RendererCheck::Work::None || cancelled);
    m_cancel->setText(cancelled ? tr("Go on") : tr("Cancel"));
    const auto [done, all] = m_renderer.tried();
    m_bar->setVisible(!cancelled);
    m_bar->setRange(0, work == RendererCheck::Work::Names && all > 0 ? int(all) : 0);
    m_bar->setValue(int(done));
    m_working->setText(cancelled                            ? tr("Cancelled.")
                       : work != RendererCheck::Work::Names ? tr("Stages")
                       : all == 0                           ? tr("Known errors")
                                                            : tr("Known errors %1 of %2").arg(done).arg(all));
}

void RendererPanel::showStages() {
    const foreign::Report& report = *m_report;
    for (StandingRow* row : m_rows) {
        row->setVisible(report.options.hints >= 1 || report.agrees());
        const foreign::StageVerdict& verdict = report.stages[index(row->stage())];
        QString line = toQString(verdict.own);
        // What differs, where no own run says more.
        for (const std::size_t i : verdict.findings)
            if (line.isEmpty() && !report.findings[i].agrees)
                line = toQString(report.findings[i].name.text() + ": " + findingText(report.findings[i]));
        row->show(verdict.standing, line, report.firstWrong == row->stage());
        row->setOnShow(row->stage() == m_document.stage());
    }
}

void RendererPanel::showContracts() {
    m_contractPart->setVisible(!m_report->broken.empty() && m_report->options.hints >= 2);
    QStringList lines;
    for (const foreign::BrokenContract& one : m_report->broken) lines << toQString(contractText(one));
    m_contracts->setText(lines.join('\n'));
    m_contractPart->setSentence(tr("%1 do not hold").arg(m_report->broken.size()));
}

void RendererPanel::showFiles() {
    const foreign::Report& report = *m_report;
    QStringList lines;
    for (const pipeline::Error& error : report.in->errors) lines << toQString(format(error)).trimmed();
    const auto missing = report.notHandedIn();
    if (!missing.empty()) lines << tr("Not handed in: %1").arg(commaList(missing));
    for (const foreign::Finding& finding : report.findings) {
        if (finding.nan > 0) lines << tr("%1 holds %2 NaN.").arg(toQString(finding.file), count(qint64(finding.nan)));
        if (finding.infinite > 0 && finding.name.buffer.id != pipeline::BufferId::ZView)
            lines << tr("%1 holds %2 infinite numbers.").arg(toQString(finding.file), count(qint64(finding.infinite)));
    }
    for (const std::string& other : report.in->others) lines << toQString(other) + '.';
    m_files->setText(lines.isEmpty() ? tr("All files were read.") : lines.join('\n'));
    const auto failed = report.in->errors.size();
    m_filePart->setSentence(failed > 0 ? tr("%1 read, %2 not").arg(report.findings.size()).arg(failed)
                                       : tr("%1 read").arg(report.findings.size()));
}

void RendererPanel::showHints() {
    m_hintPart->setVisible(!m_report->agrees());
    const auto given = foreign::hints(*m_report);
    QStringList lines;
    for (std::size_t i = 0; i < given.size(); ++i) lines << tr("%1  %2").arg(i + 1).arg(toQString(given[i]));
    m_hintList->setText(lines.join('\n'));
    m_hintList->setVisible(!lines.isEmpty());
    m_nextHint->setVisible(m_hints < 3);
    m_hintChoice->setCurrentIndex(keptHints());
    m_hintPart->setSentence(tr("%1 of 3 given").arg(m_hints));
}

void RendererPanel::showPlace() {
    if (!m_report) return;
    m_values->show(*m_report);
    m_place->setVisible(!m_values->isEmpty() && m_report->options.hints >= 2);
    m_place->setSentence(m_values->title());
    m_place->setKeepsSentence();
}

}  // namespace app
