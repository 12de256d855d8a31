// What a RendererPanel is made of; what it shows is in renderer_panel.cpp.
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/core/icons.h"
#include "app/core/spoken.h"
#include "app/panels/follow_theme.h"
#include "app/panels/renderer_conventions.h"
#include "app/panels/renderer_error.h"
#include "app/panels/renderer_panel.h"
#include "app/panels/renderer_values.h"
#include "app/panels/section.h"
#include "app/panels/standing_row.h"

namespace app {

namespace {

// Beside each other where there is room, else below.
QPushButton* rendererButton(const QString& text, const char* name, QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setObjectName(name);
    button->setAutoDefault(true);
    return button;
}

}  // namespace

// Texts of files are shown as they are.
QLabel* RendererPanel::makeText(const char* name, double size, int weight) {
    auto* label = new QLabel(this);
    label->setObjectName(name);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    followTheme(label, [label, size, weight] { label->setFont(Theme::current().text(size, weight)); });
    return label;
}

void RendererPanel::makeEmpty(QVBoxLayout& column) {
    m_empty = new QWidget(this);
    auto* rows = new QVBoxLayout(m_empty);
    auto* heading = makeText("rendererDrop", 15, 600);
    heading->setText(tr("Drop the folder of your renderer here"));
    auto* what = makeText("rendererWhat", 13);
    what->setText(tr(
        "Shadescope compares what your renderer has written with this scene, and says which stage is the first that is "
        "wrong. Any of these files is enough: color.png, depth.npy, normal.npy, …"));
    auto* folder = rendererButton(tr("Choose a folder…"), "chooseFolder", m_empty);
    folder->setProperty("kind", "primary");
    auto* files = rendererButton(tr("Choose files…"), "chooseFiles", m_empty);
    auto* starter = makeText("rendererStarter", 12);
    starter->setProperty("tone", 2);
    starter->setText(
        tr("No files yet? shadescope compare --starter python -o mine writes a scene and a writer of files."));
    for (QWidget* part : std::initializer_list<QWidget*>{heading, what, folder, files, starter}) rows->addWidget(part);
    rows->addStretch(1);
    column.addWidget(m_empty, 1);
    connect(folder, &QPushButton::clicked, this, &RendererPanel::folderAsked);
    connect(files, &QPushButton::clicked, this, &RendererPanel::filesAsked);
    followTheme(m_empty, [rows] {
        const Theme& theme = Theme::current();
        rows->setContentsMargins(theme.px(12), theme.px(12), theme.px(12), theme.px(12));
        rows->setSpacing(theme.px(8));
    });
}

void RendererPanel::makeHead(QVBoxLayout& column) {
    auto* head = new QWidget(m_parts);
    auto* rows = new QVBoxLayout(head);
    auto* line = new QHBoxLayout;
    m_source = makeText("rendererSource", 12);
    m_source->setProperty("tone", 2);
    const auto tool = [&](const char* sign, const QString& tip, auto run) {
        auto* button = new QToolButton(head);
        button->setIcon(icon(sign));
        button->setToolTip(tip);
        button->setAccessibleName(tip);
        connect(button, &QToolButton::clicked, this, run);
        line->addWidget(button, 0, Qt::AlignTop);
        return button;
    };
    line->addWidget(m_source, 1);
    tool("open", tr("Choose another folder"), [this] { emit folderAsked(); });
    tool("copy", tr("Copy the finding as text (Ctrl+C)"), [this] { copyFinding(); });
    tool("close", tr("Close the folder"), [this] { m_renderer.close(); })->setObjectName("closeFolder");
    auto* said = new QHBoxLayout;
    m_mark = new StandingMark(head);
    m_heading = makeText("rendererHeading", 15, 600);
    said->addWidget(m_mark, 0, Qt::AlignTop);
    said->addWidget(m_heading, 1);
    m_evidence = makeText("rendererEvidence", 12);
    m_evidence->setProperty("tone", 2);
    m_errors = makeText("rendererErrors", 12);
    m_work = new QWidget(head);
    m_work->setObjectName("rendererWork");
    auto* work = new QHBoxLayout(m_work);
    work->setContentsMargins(0, 0, 0, 0);
    m_working = makeText("rendererWorking", 12);
    m_working->setWordWrap(false);
    m_bar = new QProgressBar(m_work);
    m_bar->setTextVisible(false);
    m_bar->setRange(0, 1000);
    m_bar->setAccessibleName(tr("How far the comparison is"));
    m_cancel = rendererButton(tr("Cancel"), "rendererCancel", m_work);
    connect(m_cancel, &QPushButton::clicked, this,
            [this] { m_renderer.wasCancelled() ? m_renderer.readAgain() : m_renderer.cancel(); });
    work->addWidget(m_working);
    work->addWidget(m_bar, 1);
    work->addWidget(m_cancel);
    rows->addLayout(line);
    rows->addLayout(said);
    for (QWidget* part : std::initializer_list<QWidget*>{m_evidence, m_errors, m_work}) rows->addWidget(part);
    column.addWidget(head);
    followTheme(head, [this, rows, said] {
        const Theme& theme = Theme::current();
        rows->setContentsMargins(theme.px(12), theme.px(8), theme.px(8), theme.px(8));
        rows->setSpacing(theme.px(5));
        said->setSpacing(theme.px(8));
        m_evidence->setContentsMargins(theme.px(32), 0, 0, 0);
        m_bar->setFixedHeight(theme.px(6));
        m_errors->setStyleSheet(QStringLiteral("color: %1;").arg(theme.colors().failed.name()));
    });
}

void RendererPanel::makeParts(QVBoxLayout& column) {
    m_body = new QWidget(m_parts);
    auto* rows = new QVBoxLayout(m_body);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_rows[i] = new StandingRow(pipeline::kStages[i], m_body);
        rows->addWidget(m_rows[i]);
        connect(m_rows[i], &QAbstractButton::clicked, this, [this, i] { goToStage(*m_rows[i]); });
    }
    m_error = new RendererError(m_body);
    rows->addWidget(m_error);
    m_goToWorst = rendererButton(tr("Go to worst pixel"), "goToWorst", m_body);
    m_goToWorst->setProperty("kind", "primary");
    connect(m_goToWorst, &QPushButton::clicked, this, &RendererPanel::goToWorst);
    auto* button = new QHBoxLayout;
    button->addWidget(m_goToWorst);
    button->addStretch(1);
    rows->addLayout(button);
    m_values = new RendererValues(m_document, m_body);
    m_contracts = makeText("rendererContracts", 12);
    m_conventions = new RendererConventions(m_renderer, m_body);
    m_files = makeText("rendererFiles", 12);
    auto* hints = new QWidget(m_body);
    auto* hintRows = new QVBoxLayout(hints);
    hintRows->setContentsMargins(0, 0, 0, 0);
    m_hintList = makeText("rendererHints", 12);
    m_nextHint = rendererButton(tr("Next hint"), "nextHint", hints);
    m_hintChoice = new QComboBox(hints);
    m_hintChoice->setObjectName("hintChoice");
    nameChoice(*m_hintChoice, tr("What is given away at once"));
    m_hintChoice->addItems({tr("Give nothing away"), tr("Give the stage away"), tr("Give stage and place away"),
                            tr("Give stage, place and name away")});
    m_hintChoice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_hintChoice->setMinimumContentsLength(12);
    connect(m_hintChoice, &QComboBox::activated, this, &RendererPanel::setHints);
    connect(m_nextHint, &QPushButton::clicked, this, [this] {
        m_hints = std::min(m_hints + 1, 3);
        take();
    });
    for (QWidget* part : std::initializer_list<QWidget*>{m_hintList, m_nextHint, m_hintChoice})
        hintRows->addWidget(part);
    m_place = new Section(tr("At the pixel"), m_values, nullptr, m_body);
    m_contractPart = new Section(tr("Contracts"), m_contracts, nullptr, m_body);
    m_conventionPart = new Section(tr("Conventions"), m_conventions, nullptr, m_body);
    m_filePart = new Section(tr("Files"), m_files, nullptr, m_body);
    m_hintPart = new Section(tr("Hints"), hints, nullptr, m_body);
    for (Section* part : {m_place, m_contractPart, m_conventionPart, m_filePart, m_hintPart}) rows->addWidget(part);
    for (Section* part : {m_conventionPart, m_filePart, m_hintPart}) part->setFolded(true), part->setKeepsSentence();
    rows->addStretch(1);
    column.addWidget(m_body, 1);
    followTheme(m_body, [button] {
        const Theme& theme = Theme::current();
        button->setContentsMargins(theme.px(12), theme.px(2), theme.px(12), theme.px(8));
    });
}

}  // namespace app
