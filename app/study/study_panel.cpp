#include "app/study/study_panel.h"

#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QFileDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "app/look/text.h"
#include "app/study/study_bar.h"
#include "app/study/study_choice.h"
#include "app/study/study_details.h"
#include "app/study/study_pictures.h"
#include "app/study/study_plot.h"
#include "app/study/study_points.h"
#include "app/study/study_run.h"
#include "app/study/study_sweep.h"
#include "app/study/study_tabs.h"
#include "app/study/study_words.h"
#include "app/widgets/folding_panes.h"
#include "app/widgets/follow_theme.h"
#include "app/widgets/on_screen.h"
#include "app/widgets/surface.h"
#include "pipeline/export/json/study_json.h"
#include "pipeline/export/study/study_files.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/scene/key_places.h"
#include "pipeline/study/analysis_text.h"

namespace app {

using pipeline::PointAnalysis;
using pipeline::StudyReport;

StudyPanel::StudyPanel(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
    setObjectName("studyPanel");
    setWindowTitle(tr("Error against run time"));
    auto* bar = makeBar();
    const QList<QWidget*> parts{makePlot(), makeNumbers()};
    auto* panes = new FoldingPanes(parts, {tr("Plot"), tr("Points")}, this);
    panes->setWishes({750, 500});
    m_foot = new StudyBar(this);
    auto* column = spaced(new QVBoxLayout(this), {8, 8, 8, 6}, 6);
    column->addLayout(bar);
    column->addWidget(m_message);
    column->addWidget(panes, 1);
    column->addWidget(m_foot);
    connect(m_sweep, &StudySweep::changed, this, [this] { m_run->setSweep(m_sweep->sweep()); });
    connect(m_run, &StudyRun::reported, this, &StudyPanel::setReport);
    connect(m_run, &StudyRun::begun, panes, [panes] { panes->bringToFront(0); });
    connect(m_run, &StudyRun::told, m_foot, &StudyBar::tell);
    connect(&m_tabs->words(), &StudyWords::answered, m_foot,
            [this] { m_foot->setAnswers(m_report.points.empty() ? QStringList() : m_tabs->words().sentences()); });
    connect(m_choice, &StudyChoice::changed, this, &StudyPanel::analyse);
    connect(m_plot, &StudyPlot::chosen, this, [this](std::size_t point) { select(point); });
    connect(m_points, &StudyPoints::chosen, this, [this](std::size_t point) { select(point); });
    connect(m_pictures, &StudyPicturesView::useAsked, this, &StudyPanel::use);
    connect(&m_images, &StudyImages::ready, m_pictures, &StudyPicturesView::setPictures);
    connect(&document, &Document::sceneChanged, this, &StudyPanel::showSelected);
    followTheme(this, [this] {
        const Theme& theme = Theme::current();
        placePictures();
        setStyleSheet(QStringLiteral("#studyPanel { background: %1; }").arg(theme.colors().bg.name()));
        analyse();
    });
    setAttribute(Qt::WA_StyledBackground);
    m_run->setSweep(m_sweep->sweep());
}

// What is being measured goes on behind a closed panel, for studies take long; pictures are made for who sees them.
void StudyPanel::showEvent(QShowEvent*) {
    if (!focusWidget()) m_run->setFocus();
    showSelected();
}
void StudyPanel::hideEvent(QHideEvent* event) {
    m_images.forget();
    if (!event->spontaneous())
        for (QDialog* dialog : findChildren<QDialog*>()) dialog->close();
}

// Esc stops what is being measured, as anywhere; where nothing is, it closes.
void StudyPanel::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape) return QWidget::keyPressEvent(event);
    if (m_run->running())
        m_run->cancel();
    else
        close();
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
    m_tabs->words().setStudy(m_report, m_analysis);
    m_run->setAgain(any);
    const auto most = std::ranges::max_element(m_report.load);
    m_foot->setLoad(most != m_report.load.end() && *most >= 0 ? std::optional(*most) : std::nullopt);
    m_choice->setVisible(any);
    m_export->setEnabled(any);
    m_export->setToolTip(any ? tr("Writes tables, plots and a page into a folder.") : tr("Nothing is measured yet."));
    select(m_selected);
}

void StudyPanel::select(std::optional<std::size_t> point) {
    m_selected = point && *point < m_report.points.size() ? point : std::nullopt;
    m_plot->select(m_selected);
    m_points->select(m_selected);
    m_tabs->details().setPoint(m_selected ? &m_report.points[*m_selected] : nullptr,
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

// What is chosen, how far it is, and the one button.
QLayout* StudyPanel::makeBar() {
    m_sweep = new StudySweep(m_document, this);
    m_run = new StudyRun(m_document, this);
    m_message = styled(new QLabel(this), {.name = "studyMessage", .wraps = true});
    m_message->setTextFormat(Qt::PlainText);
    m_message->hide();
    m_export = new QPushButton(tr("Export"), this);
    m_export->setObjectName("studyExport");
    connect(m_export, &QPushButton::clicked, this, &StudyPanel::exportFiles);
    auto* bar = new QHBoxLayout;
    bar->addWidget(&m_sweep->names());
    bar->addWidget(m_run, 1);
    bar->addWidget(m_export);
    QWidget* setUp = makeSetUp();
    const auto show = [setUp] {
        setUp->show();
        setUp->raise();
        setUp->activateWindow();
    };
    connect(m_run, &StudyRun::setUpAsked, setUp, show);
    connect(m_sweep, &StudySweep::ownAsked, setUp, show);
    followTheme(this, [bar] { bar->setSpacing(Theme::current().px(8)); });
    return bar;
}

QWidget* StudyPanel::makeSetUp() {
    auto* dialog = new QDialog(this);
    dialog->setObjectName("studySetUpDialog");
    dialog->setWindowTitle(tr("Set up the study"));
    auto* fields = new QWidget;
    auto* open = new QPushButton(tr("Open a study"), fields);
    open->setToolTip(tr("Shows a study.json that the window or the command study wrote."));
    auto* inner = spaced(new QVBoxLayout(fields), {}, 12);
    inner->addWidget(m_sweep);
    inner->addWidget(&m_run->how());
    inner->addWidget(open, 0, Qt::AlignLeft);
    inner->addStretch(1);
    m_run->how().show();
    auto* close = new QPushButton(tr("Close"), dialog);
    close->setDefault(true);
    auto* column = spaced(new QVBoxLayout(dialog), {16, 12, 16, 12});
    auto* area = new FieldsArea(fields, dialog);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    column->addWidget(area, 1);
    column->addWidget(close, 0, Qt::AlignRight);
    connect(open, &QPushButton::clicked, dialog, &QDialog::close);
    connect(open, &QPushButton::clicked, this, &StudyPanel::openFile);
    connect(close, &QPushButton::clicked, dialog, &QDialog::close);
    followTheme(dialog, [dialog] {
        const Theme& theme = Theme::current();
        dialog->resize(onScreen(*dialog, theme.px(420), theme.px(340)));
    });
    return dialog;
}

QWidget* StudyPanel::makePlot() {
    auto* splitter = new QSplitter(Qt::Vertical, this);
    auto* content = new QWidget;
    content->setProperty("kind", "page");
    m_choice = new StudyChoice(content);
    m_plot = new StudyPlot(content);
    auto* column = spaced(new QVBoxLayout(content), {}, 0);
    column->addWidget(m_choice);
    column->addWidget(m_plot, 1);
    m_pictures = new StudyPicturesView(splitter);
    QWidget* frame = surface(m_pictures, splitter);
    m_tabs = new StudyTabs(*m_pictures, *frame);
    splitter->addWidget(surface(content, splitter));
    splitter->addWidget(frame);
    splitter->setStretchFactor(0, 2);
    splitter->setStretchFactor(1, 1);
    splitter->setChildrenCollapsible(false);
    followTheme(content, [this] {
        const Theme& theme = Theme::current();
        m_choice->layout()->setContentsMargins(theme.px(8), theme.px(6), theme.px(8), theme.px(6));
    });
    return splitter;
}

QWidget* StudyPanel::makeNumbers() {
    auto* splitter = new QSplitter(Qt::Vertical, this);
    m_points = new StudyPoints(splitter);
    splitter->addWidget(surface(m_points, splitter));
    splitter->addWidget(surface(m_tabs, splitter));
    splitter->setSizes({1, 1});  // as high as each other, where their contents allow it
    splitter->setChildrenCollapsible(false);
    followTheme(splitter, [this, splitter] {
        splitter->setMinimumWidth(Theme::current().px(330));
        m_tabs->setFont(Theme::current().text(13, 500));
    });
    return splitter;
}

// Below the plot where there is height for both; in a low window the plot has all of it.
void StudyPanel::placePictures() { m_tabs->setLow(height() < Theme::current().px(820)); }

void StudyPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    placePictures();
}

void StudyPanel::tell(const QString& words) {
    m_message->setText(words);
    m_message->setVisible(!words.isEmpty());
}

void StudyPanel::openFile() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Open a study"), QString(), tr("Studies (*.json)"));
    if (!file.isEmpty()) openStudy(file);
}

bool StudyPanel::openStudy(const QString& file) {
    const std::string name = file.toStdString();
    const auto text = pipeline::readFile(name);
    auto report = text ? pipeline::studyFromJson(*text, name)
                       : pipeline::Result<pipeline::StudyReport>(pipeline::namedAt({name}, text.errors()));
    if (!report) {
        tell(toQString(format(report.errors())));
        return false;
    }
    tell({});
    setReport(std::move(report).value());
    return true;
}

void StudyPanel::exportFiles() {
    const QString folder =
        QFileDialog::getExistingDirectory(this, tr("Export the study to a folder"), QDir::homePath());
    if (!folder.isEmpty()) exportTo(folder);
}

bool StudyPanel::exportTo(const QString& folder) {
    const auto written = writeStudyFiles(m_report, m_analysis, m_tabs->words().limits(), {}, folder.toStdString());
    tell(written ? tr("%1 files are in %2.").arg(written->size()).arg(folder) : toQString(format(written.errors())));
    return bool(written);
}

}  // namespace app
