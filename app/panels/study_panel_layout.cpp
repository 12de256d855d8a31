// What of the study stands where.
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "app/panels/follow_theme.h"
#include "app/panels/on_screen.h"
#include "app/panels/study_choice.h"
#include "app/panels/study_panel.h"
#include "app/panels/study_pictures.h"
#include "app/panels/study_plot.h"
#include "app/panels/study_points.h"
#include "app/panels/study_run.h"
#include "app/panels/study_sweep.h"
#include "app/panels/study_tabs.h"
#include "app/panels/surface.h"

namespace app {

// What is chosen, how far it is, and the one button.
QLayout* StudyPanel::makeBar() {
    m_sweep = new StudySweep(m_document, this);
    m_run = new StudyRun(m_document, this);
    m_message = new QLabel(this);
    m_message->setObjectName("studyMessage");
    m_message->setTextFormat(Qt::PlainText);
    m_message->setWordWrap(true);
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
    auto* inner = new QVBoxLayout(fields);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->addWidget(m_sweep);
    inner->addWidget(&m_run->how());
    inner->addWidget(open, 0, Qt::AlignLeft);
    inner->addStretch(1);
    m_run->how().show();
    auto* close = new QPushButton(tr("Close"), dialog);
    close->setDefault(true);
    auto* column = new QVBoxLayout(dialog);
    auto* area = new FieldsArea(fields, dialog);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    column->addWidget(area, 1);
    column->addWidget(close, 0, Qt::AlignRight);
    connect(open, &QPushButton::clicked, dialog, &QDialog::close);
    connect(open, &QPushButton::clicked, this, &StudyPanel::openFile);
    connect(close, &QPushButton::clicked, dialog, &QDialog::close);
    followTheme(dialog, [dialog, column, inner] {
        const Theme& theme = Theme::current();
        column->setContentsMargins(theme.px(16), theme.px(12), theme.px(16), theme.px(12));
        inner->setSpacing(theme.px(12));
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
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
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
    followTheme(content, [this, column] {
        const Theme& theme = Theme::current();
        m_choice->layout()->setContentsMargins(theme.px(8), theme.px(6), theme.px(8), theme.px(6));
        column->setSpacing(0);
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

}  // namespace app
