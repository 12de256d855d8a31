// What of the study stands where.
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "app/panels/follow_theme.h"
#include "app/panels/study_choice.h"
#include "app/panels/study_panel.h"
#include "app/panels/study_pictures.h"
#include "app/panels/study_plot.h"
#include "app/panels/study_points.h"
#include "app/panels/study_run.h"
#include "app/panels/study_sweep.h"
#include "app/panels/study_tabs.h"
#include "app/panels/study_words.h"
#include "app/panels/surface.h"

namespace app {

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
    QWidget* frame = surface(m_pictures, splitter);
    m_tabs = new StudyTabs(*m_pictures, *frame);
    splitter->addWidget(surface(m_plot, splitter));
    splitter->addWidget(frame);
    splitter->setStretchFactor(0, 2);
    splitter->setStretchFactor(1, 1);
    splitter->setChildrenCollapsible(false);
    return splitter;
}

QWidget* StudyPanel::makeRight() {
    auto* splitter = new QSplitter(Qt::Vertical, this);
    m_points = new StudyPoints(splitter);
    splitter->addWidget(surface(m_points, splitter));
    splitter->addWidget(surface(m_tabs, splitter));
    splitter->setChildrenCollapsible(false);
    // With the left side and the plot it fits a screen of 1280 by 720 in the projector's letters.
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

}  // namespace app
