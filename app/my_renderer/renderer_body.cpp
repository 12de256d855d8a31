#include "app/my_renderer/renderer_body.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/document/document.h"
#include "app/look/accessible.h"
#include "app/look/numbers.h"
#include "app/look/text.h"
#include "app/my_renderer/renderer_conventions.h"
#include "app/my_renderer/renderer_error.h"
#include "app/my_renderer/renderer_finding.h"
#include "app/my_renderer/renderer_head.h"
#include "app/my_renderer/renderer_values.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/section.h"
#include "app/widgets/standing_row.h"
#include "pipeline/compare/report/compare_text.h"

namespace app {

namespace foreign = pipeline::foreign;

namespace {

QString commaList(const std::vector<std::string>& lines) {
    QStringList all;
    for (const std::string& line : lines) all << toQString(line);
    return all.join(QStringLiteral(", "));
}

QVBoxLayout* closeColumn(QWidget* parent) {
    auto* column = spaced(new QVBoxLayout(parent), {});
    return column;
}

}  // namespace

RendererStages::RendererStages(RendererFinding& finding, QWidget* parent) : QWidget(parent), m_finding(finding) {
    QVBoxLayout* column = closeColumn(this);
    column->setSpacing(0);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_rows[i] = new StandingRow(pipeline::kStages[i], this);
        column->addWidget(m_rows[i]);
        connect(m_rows[i], &QAbstractButton::clicked, this, [this, i] { m_finding.goToStage(m_rows[i]->stage()); });
    }
    connect(&finding.document(), &Document::stageChanged, this, [this] {
        for (StandingRow* row : m_rows) row->setOnShow(row->stage() == m_finding.document().stage());
    });
}

void RendererStages::showReport() {
    const foreign::Report& report = *m_finding.report();
    for (StandingRow* row : m_rows) {
        row->setVisible(report.options.hints >= 1 || report.agrees());
        const foreign::StageVerdict& verdict = report.stages[index(row->stage())];
        QString line = toQString(verdict.own);
        // What differs, where no own run says more.
        for (const std::size_t i : verdict.findings)
            if (line.isEmpty() && !report.findings[i].agrees)
                line = toQString(report.findings[i].name.text() + ": " + findingText(report.findings[i]));
        row->show(verdict.standing, line, report.firstWrong == row->stage());
        row->setOnShow(row->stage() == m_finding.document().stage());
    }
}

RendererHints::RendererHints(RendererFinding& finding, QWidget* parent) : QWidget(parent), m_finding(finding) {
    QVBoxLayout* column = closeColumn(this);
    m_list = rendererText("rendererHints", 12, 400, this);
    m_next = rendererButton(tr("Next hint"), "nextHint", this);
    m_choice = new QComboBox(this);
    m_choice->setObjectName("hintChoice");
    nameComboBox(*m_choice, tr("What is given away at once"));
    m_choice->addItems({tr("Give nothing away"), tr("Give the stage away"), tr("Give stage and place away"),
                        tr("Give stage, place and name away")});
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_choice->setMinimumContentsLength(12);
    connect(m_choice, &QComboBox::activated, &finding, &RendererFinding::setHints);
    connect(m_next, &QPushButton::clicked, &finding, &RendererFinding::giveNextHint);
    for (QWidget* part : std::initializer_list<QWidget*>{m_list, m_next, m_choice}) column->addWidget(part);
}

void RendererHints::showReport() {
    const auto given = foreign::hints(*m_finding.report());
    QStringList lines;
    for (std::size_t i = 0; i < given.size(); ++i) lines << tr("%1  %2").arg(i + 1).arg(toQString(given[i]));
    m_list->setText(lines.join('\n'));
    m_list->setVisible(!lines.isEmpty());
    m_next->setVisible(m_finding.hints() < 3);
    m_choice->setCurrentIndex(RendererFinding::keptHints());
}

RendererBody::RendererBody(RendererFinding& finding, QWidget* parent) : QWidget(parent), m_finding(finding) {
    QVBoxLayout* rows = closeColumn(this);
    rows->setSpacing(0);
    m_stages = new RendererStages(finding, this);
    m_error = new RendererError(this);
    m_goToWorst = rendererButton(tr("Go to worst pixel"), "goToWorst", this);
    m_goToWorst->setProperty("kind", "primary");
    m_goToWorst->setToolTip(tr("Pick the pixel that differs most; again: the next one (Alt+W)"));
    auto* button = spaced(new QHBoxLayout, {12, 2, 12, 8});
    button->addWidget(m_goToWorst);
    button->addStretch(1);
    rows->addWidget(m_stages);
    rows->addWidget(m_error);
    rows->addLayout(button);
    makeSections();
    for (Section* part : {m_place, m_contractPart, m_conventionPart, m_filePart, m_hintPart}) rows->addWidget(part);
    rows->addStretch(1);
    connect(m_goToWorst, &QPushButton::clicked, &finding, &RendererFinding::goToWorst);
    connect(m_error, &RendererError::lessonAsked, this, &RendererBody::lessonAsked);
    connect(m_error, &RendererError::rowsStated, this, &RendererBody::stateRows);
    connect(&finding, &RendererFinding::changed, this, &RendererBody::showReport);
    connect(&finding.document().pointing(), &Pointing::pixelChanged, this, &RendererBody::showPlace);
    connect(&finding.document().pointing(), &Pointing::selectionChanged, this, &RendererBody::showPlace);
    showReport();
}

void RendererBody::makeSections() {
    m_values = new RendererValues(m_finding.document(), this);
    m_contracts = rendererText("rendererContracts", 12, 400, this);
    m_conventions = new RendererConventions(m_finding.check(), this);
    m_files = rendererText("rendererFiles", 12, 400, this);
    m_hints = new RendererHints(m_finding, this);
    m_place = new Section(tr("At the pixel"), m_values, nullptr, this);
    m_contractPart = new Section(tr("Contracts"), m_contracts, nullptr, this);
    m_conventionPart = new Section(tr("Conventions"), m_conventions, nullptr, this);
    m_filePart = new Section(tr("Files"), m_files, nullptr, this);
    m_hintPart = new Section(tr("Hints"), m_hints, nullptr, this);
    for (Section* part : {m_conventionPart, m_filePart, m_hintPart}) part->setFolded(true), part->setKeepsSentence();
}

void RendererBody::stateRows(bool other) {
    const bool bottomUp = std::ranges::any_of(m_finding.report()->conventions.files,
                                              [](const foreign::ReadFile& file) { return file.reading.bottomUp; });
    m_finding.check().state("rows", bottomUp != other ? "bottom-up" : "top-down");
}

void RendererBody::showReport() {
    setVisible(m_finding.report() != nullptr);
    if (!m_finding.report()) return;
    const foreign::Report& report = *m_finding.report();
    m_stages->showReport();
    m_error->show(report);
    if (report.options.hints < 3) m_error->hide();
    m_goToWorst->setVisible(report.options.hints >= 2 && !report.agrees());
    m_goToWorst->setEnabled(m_finding.canGoToWorst());
    m_conventions->show(report);
    m_conventionPart->setSentence(m_conventions->sentence());
    showContracts();
    showFiles();
    m_hintPart->setVisible(!report.agrees());
    m_hintPart->setSentence(tr("%1 of 3 given").arg(m_finding.hints()));
    m_hints->showReport();
    showPlace();
}

void RendererBody::showContracts() {
    const foreign::Report& report = *m_finding.report();
    m_contractPart->setVisible(!report.broken.empty() && report.options.hints >= 2);
    QStringList lines;
    for (const foreign::BrokenContract& one : report.broken) lines << toQString(contractText(one));
    m_contracts->setText(lines.join('\n'));
    m_contractPart->setSentence(tr("%1 do not hold").arg(report.broken.size()));
}

void RendererBody::showFiles() {
    const foreign::Report& report = *m_finding.report();
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

void RendererBody::showPlace() {
    if (!m_finding.report()) return;
    m_values->show(*m_finding.report());
    m_place->setVisible(!m_values->isEmpty() && m_finding.report()->options.hints >= 2);
    m_place->setSentence(m_values->title());
    m_place->setKeepsSentence();
}

}  // namespace app
