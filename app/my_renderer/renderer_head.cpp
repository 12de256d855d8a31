#include "app/my_renderer/renderer_head.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>

#include "app/document/document.h"
#include "app/look/icons.h"
#include "app/look/text.h"
#include "app/my_renderer/renderer_finding.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/standing_row.h"
#include "pipeline/compare/report/compare_text.h"

namespace app {

namespace foreign = pipeline::foreign;
using foreign::Standing;
using Work = RendererCheck::Work;

namespace {

Standing wholeStanding(const foreign::Report& report) {
    if (report.agrees()) return Standing::Agrees;
    return !report.possiblyWrong.empty() && report.options.hints >= 1 ? Standing::WrongHere : Standing::CannotTell;
}

}  // namespace

QLabel* rendererText(const char* name, double size, int weight, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(name);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    followTheme(label, [label, size, weight] { label->setFont(Theme::current().text(size, weight)); });
    return label;
}

QPushButton* rendererButton(const QString& text, const char* name, QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setObjectName(name);
    button->setAutoDefault(true);
    return button;
}

RendererWork::RendererWork(RendererFinding& finding, QWidget* parent) : QWidget(parent), m_finding(finding) {
    setObjectName("rendererWork");
    auto* row = spaced(new QHBoxLayout(this), {});
    m_words = rendererText("rendererWorking", 12, 400, this);
    m_words->setWordWrap(false);
    m_bar = new QProgressBar(this);
    m_bar->setTextVisible(false);
    m_bar->setRange(0, 1000);
    m_bar->setAccessibleName(tr("How far the comparison is"));
    m_cancel = rendererButton(tr("Cancel"), "rendererCancel", this);
    connect(m_cancel, &QPushButton::clicked, this,
            [&check = finding.check()] { check.wasCancelled() ? check.readAgain() : check.cancel(); });
    row->addWidget(m_words);
    row->addWidget(m_bar, 1);
    row->addWidget(m_cancel);
    followTheme(this, [this] { m_bar->setFixedHeight(Theme::current().px(6)); });
}

void RendererWork::showState() {
    const RendererCheck& check = m_finding.check();
    const bool cancelled = check.work() == Work::None && check.wasCancelled();
    setVisible(check.work() != Work::None || cancelled);
    m_cancel->setText(cancelled ? tr("Go on") : tr("Cancel"));
    const auto [done, all] = check.tried();
    m_bar->setVisible(!cancelled);
    m_bar->setRange(0, check.work() == Work::Names && all > 0 ? int(all) : 0);
    m_bar->setValue(int(done));
    m_words->setText(cancelled                     ? tr("Cancelled.")
                     : check.work() != Work::Names ? tr("Stages")
                     : all == 0                    ? tr("Known errors")
                                                   : tr("Known errors %1 of %2").arg(done).arg(all));
}

RendererHead::RendererHead(RendererFinding& finding, QWidget* parent) : QWidget(parent), m_finding(finding) {
    auto* rows = spaced(new QVBoxLayout(this), {12, 8, 8, 8}, 5);
    auto* said = spaced(new QHBoxLayout, {}, 8);
    QLayout* source = makeSource();
    m_mark = new StandingMark(this);
    m_heading = rendererText("rendererHeading", 15, 600, this);
    said->addWidget(m_mark, 0, Qt::AlignTop);
    said->addWidget(m_heading, 1);
    m_evidence = rendererText("rendererEvidence", 12, 400, this);
    m_evidence->setProperty("tone", 2);
    m_errors = rendererText("rendererErrors", 12, 400, this);
    m_work = new RendererWork(finding, this);
    rows->addLayout(source);
    rows->addLayout(said);
    for (QWidget* part : std::initializer_list<QWidget*>{m_evidence, m_errors, m_work}) rows->addWidget(part);
    connect(&finding.check(), &RendererCheck::changed, this, &RendererHead::showState);
    connect(&finding, &RendererFinding::changed, this, &RendererHead::showReport);
    connect(&finding, &RendererFinding::begun, this, [this] {
        QAccessibleEvent alert(m_heading, QAccessible::Alert);
        QAccessible::updateAccessibility(&alert);
    });
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        m_evidence->setContentsMargins(theme.px(32), 0, 0, 0);
        m_errors->setStyleSheet(QStringLiteral("color: %1;").arg(theme.colors().failed.name()));
    });
    showReport();
}

QLayout* RendererHead::makeSource() {
    auto* line = new QHBoxLayout;
    m_source = rendererText("rendererSource", 12, 400, this);
    m_source->setProperty("tone", 2);
    line->addWidget(m_source, 1);
    const auto tool = [&](const char* sign, const QString& tip, auto run) {
        auto* button = new QToolButton(this);
        button->setIcon(icon(sign));
        button->setToolTip(tip);
        button->setAccessibleName(tip);
        connect(button, &QToolButton::clicked, this, run);
        line->addWidget(button, 0, Qt::AlignTop);
        return button;
    };
    tool("open", tr("Choose another folder"), [this] { emit folderAsked(); });
    tool("copy", tr("Copy the finding as text (Ctrl+C)"), [this] { m_finding.copy(); });
    tool("close", tr("Close the folder"), [this] { m_finding.check().close(); })->setObjectName("closeFolder");
    return line;
}

void RendererHead::showReport() {
    showState();
    const auto& report = m_finding.report();
    m_mark->setVisible(report != nullptr);
    m_evidence->setVisible(report != nullptr);
    if (!report) return;
    m_mark->show(wholeStanding(*report));
    m_heading->setText(toQString(headline(*report)));
    m_evidence->setText(toQString(evidence(*report)));
    m_evidence->setVisible(!m_evidence->text().isEmpty());
}

void RendererHead::showState() {
    const RendererCheck& check = m_finding.check();
    if (!check.isOpen()) return;
    const QString read = check.readAt();
    m_source->setText(read.isEmpty() ? check.name() : tr("%1  read %2").arg(check.name(), read));
    m_source->setToolTip(tr("Watched: compared again whenever it changes") + "<br>" +
                         check.paths().join('\n').toHtmlEscaped());
    if (!m_finding.report())
        m_heading->setText(!m_finding.document().hasScene() ? tr("Open the scene that your renderer draws")
                           : check.work() != Work::None     ? tr("Your files are being compared")
                           : check.wasCancelled()           ? tr("The comparison was cancelled")
                           : check.errors().empty()         ? tr("Your files are compared next")
                                                            : tr("The files cannot be compared"));
    m_errors->setVisible(!check.errors().empty());
    m_errors->setText(toQString(format(check.errors())).trimmed());
    m_work->showState();
}

}  // namespace app
