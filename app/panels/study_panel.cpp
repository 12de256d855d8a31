#include "app/panels/study_panel.h"

#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "app/core/text.h"
#include "app/panels/follow_theme.h"
#include "app/panels/study_choice.h"
#include "app/panels/study_details.h"
#include "app/panels/study_pictures.h"
#include "app/panels/study_plot.h"
#include "app/panels/study_points.h"
#include "app/panels/study_run.h"
#include "app/panels/study_sweep.h"
#include "app/panels/study_words.h"
#include "app/panels/surface.h"
#include "pipeline/study/analysis_text.h"

namespace app {

using pipeline::PointAnalysis;
using pipeline::StudyReport;

StudyPanel::StudyPanel(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
    setObjectName("studyPanel");
    setWindowTitle(tr("Error against run time"));
    auto* splitter = new QSplitter(Qt::Horizontal, this);
    splitter->addWidget(makeLeft());
    splitter->addWidget(makeMiddle());
    splitter->addWidget(makeRight());
    splitter->setStretchFactor(1, 1);
    splitter->setChildrenCollapsible(false);
    const Theme& now = Theme::current();
    splitter->setSizes({now.px(300), now.px(840), now.px(540)});
    auto* column = new QVBoxLayout(this);
    column->addWidget(splitter);
    connect(m_sweep, &StudySweep::changed, this, [this] { m_run->setSweep(m_sweep->sweep()); });
    connect(m_run, &StudyRun::reported, this, &StudyPanel::setReport);
    connect(m_choice, &StudyChoice::changed, this, &StudyPanel::analyse);
    connect(m_plot, &StudyPlot::chosen, this, [this](std::size_t point) { select(point); });
    connect(m_points, &StudyPoints::chosen, this, [this](std::size_t point) { select(point); });
    connect(m_pictures, &StudyPicturesView::useAsked, this, &StudyPanel::use);
    connect(&m_images, &StudyImages::ready, m_pictures, &StudyPicturesView::setPictures);
    connect(&document, &Document::sceneChanged, this, &StudyPanel::showSelected);
    followTheme(this, [this, column, splitter] {
        const Theme& theme = Theme::current();
        column->setContentsMargins(theme.px(8), theme.px(8), theme.px(8), theme.px(8));
        splitter->setHandleWidth(theme.px(8));
        setStyleSheet(QStringLiteral("#studyPanel { background: %1; }").arg(theme.colors().bg.name()));
        analyse();
    });
    setAttribute(Qt::WA_StyledBackground);
    m_run->setSweep(m_sweep->sweep());
}

// What is being measured goes on behind a closed panel, for studies take long; pictures are made for who sees them.
void StudyPanel::showEvent(QShowEvent*) { showSelected(); }
void StudyPanel::hideEvent(QHideEvent*) { m_images.forget(); }

// Esc stops what is being measured, as anywhere; where nothing is, it closes.
void StudyPanel::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape) return QWidget::keyPressEvent(event);
    if (m_run->running())
        m_run->cancel();
    else
        close();
}

QWidget* StudyPanel::makeLeft() {
    auto* content = new QWidget;
    content->setProperty("kind", "page");
    auto* column = new QVBoxLayout(content);
    m_sweep = new StudySweep(m_document, content);
    m_run = new StudyRun(m_document, content);
    m_choice = new StudyChoice(content);
    m_words = new StudyWords(content);
    m_message = new QLabel(content);
    m_message->setObjectName("studyMessage");
    m_message->setWordWrap(true);
    m_message->hide();
    auto* open = new QPushButton(tr("Open a study"), content);
    open->setToolTip(tr("Shows a study.json that the window or the command study wrote."));
    m_export = new QPushButton(tr("Export"), content);
    m_export->setObjectName("studyExport");
    auto* files = new QHBoxLayout;
    files->addWidget(open);
    files->addWidget(m_export);
    for (QWidget* part :
         {static_cast<QWidget*>(m_sweep), static_cast<QWidget*>(m_run), static_cast<QWidget*>(m_choice)})
        column->addWidget(part);
    column->addLayout(files);
    column->addWidget(m_message);
    column->addWidget(m_words);
    column->addStretch(1);
    connect(open, &QPushButton::clicked, this, &StudyPanel::openFile);
    connect(m_export, &QPushButton::clicked, this, &StudyPanel::exportFiles);
    auto* area = scrolling(content, this);
    followTheme(content, [column, area] {
        const Theme& theme = Theme::current();
        column->setContentsMargins(theme.px(12), theme.px(12), theme.px(12), theme.px(12));
        column->setSpacing(theme.px(16));
        area->setMinimumWidth(theme.px(296));
    });
    return surface(area, this);
}

QWidget* StudyPanel::makeMiddle() {
    auto* splitter = new QSplitter(Qt::Vertical, this);
    m_plot = new StudyPlot(splitter);
    m_pictures = new StudyPicturesView(splitter);
    splitter->addWidget(surface(m_plot, splitter));
    splitter->addWidget(surface(m_pictures, splitter));
    splitter->setStretchFactor(0, 2);
    splitter->setStretchFactor(1, 1);
    splitter->setChildrenCollapsible(false);
    return splitter;
}

QWidget* StudyPanel::makeRight() {
    auto* splitter = new QSplitter(Qt::Vertical, this);
    m_points = new StudyPoints(splitter);
    m_details = new StudyDetails;
    splitter->addWidget(surface(m_points, splitter));
    splitter->addWidget(surface(scrolling(m_details, splitter), splitter));
    splitter->setChildrenCollapsible(false);
    // With the left side and the plot it fits a screen of 1280 by 720 in the projector's letters.
    followTheme(splitter, [splitter] { splitter->setMinimumWidth(Theme::current().px(300)); });
    return splitter;
}

void StudyPanel::setReport(StudyReport report) {
    // The same setting stays selected while its study grows.
    const bool sameStudy = report.axes == m_report.axes && report.scene == m_report.scene;
    std::optional<std::size_t> number;
    if (m_selected && sameStudy) number = m_report.points[*m_selected].number;
    m_report = std::move(report);
    std::optional<std::size_t> again;
    for (std::size_t i = 0; i < m_report.points.size(); ++i)
        if (number == m_report.points[i].number) again = i;
    m_selected = again;
    m_choice->setReport(m_report);
    analyse();
}

void StudyPanel::analyse() {
    m_analysis = pipeline::analyse(m_report, m_choice->choice());
    const bool any = !m_report.points.empty();
    pipeline::Plot plot = plotOf(m_report, m_analysis);
    if (!any) plot.subtitle = tr("Choose what to vary, then measure.").toStdString();
    QStringList tips;
    for (const PointAnalysis& point : m_analysis.points)
        tips << toQString(point.label) + '\n' +
                    (point.placed() ? tr("%1 ms (%2 to %3)\n%4 %5\n%6")
                                          .arg(toQString(pipeline::timeText(*point.time)),
                                               toQString(pipeline::timeText(point.interval.first)),
                                               toQString(pipeline::timeText(point.interval.second)),
                                               toQString(measureText(m_analysis.choice)),
                                               toQString(pipeline::errorText(*point.error)),
                                               point.onFront() ? tr("on the front") : tr("dominated"))
                                    : toQString(point.missing));
    m_plot->setPlot(std::move(plot), tips);
    m_points->setStudy(m_report, m_analysis);
    m_words->setStudy(m_report, m_analysis);
    m_words->setVisible(any);
    m_choice->setVisible(any);
    m_export->setEnabled(any);
    m_export->setToolTip(any ? tr("Writes tables, plots and a page into a folder.") : tr("Nothing is measured yet."));
    select(m_selected);
}

void StudyPanel::select(std::optional<std::size_t> point) {
    m_selected = point && *point < m_report.points.size() ? point : std::nullopt;
    m_plot->select(m_selected);
    m_points->select(m_selected);
    m_details->setPoint(m_selected ? &m_report.points[*m_selected] : nullptr,
                        m_selected ? m_analysis.points[*m_selected].label : std::string());
    showSelected();
}

pipeline::Result<pipeline::Scene> StudyPanel::selectedScene() const {
    if (!m_document.hasScene()) return pipeline::Error{{}, "no scene is open"};
    if (m_document.scene().name != m_report.scene)
        return pipeline::Error{{}, "this study is of " + m_report.scene + ", another scene is open"};
    return sceneAt(m_document.scene(), m_report.axes, m_report.points[*m_selected].values);
}

// Title and pictures of the selected point: with the settings of the open scene that the sweep does not change.
void StudyPanel::showSelected() {
    if (!isVisible()) return;
    if (!m_selected) {
        m_images.forget();
        return m_pictures->setPoint({}, {}, {});
    }
    const PointAnalysis& point = m_analysis.points[*m_selected];
    const auto scene = selectedScene();
    const QString numbers =
        point.placed() ? tr("%1 ms, %2 %3")
                             .arg(toQString(pipeline::timeText(*point.time)), toQString(m_analysis.choice.measure),
                                  toQString(pipeline::errorText(*point.error)))
                       : toQString(point.missing);
    m_pictures->setPoint(point.label.empty() ? tr("the only setting") : toQString(point.label), numbers,
                         scene ? QString() : toQString(format(scene.errors().front())));
    if (!scene) {
        m_images.forget();
        return m_pictures->setPictures({});
    }
    m_pictures->setWaiting();
    m_images.ask(std::make_shared<const pipeline::Scene>(m_document.scene()), m_report.axes,
                 m_report.points[*m_selected]);
}

void StudyPanel::use() {
    if (!m_selected) return;
    const auto scene = selectedScene();
    if (!scene) return;
    m_document.replace(*scene, tr("settings: %1").arg(toQString(m_analysis.points[*m_selected].label)));
}

}  // namespace app
