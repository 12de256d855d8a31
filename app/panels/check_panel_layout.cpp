// What of the cases stands where.
#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/core/text.h"
#include "app/panels/check_bar.h"
#include "app/panels/check_details.h"
#include "app/panels/check_knob.h"
#include "app/panels/check_panel.h"
#include "app/panels/check_pictures.h"
#include "app/panels/follow_theme.h"
#include "app/panels/surface.h"

namespace app {

QWidget* CheckPanel::makeLeft() {
    auto* content = new QWidget(this);
    m_cases = new CheckCases(content);
    m_runOne = new QPushButton(tr("Run this case"), content);
    m_runOne->setObjectName("checkRunOne");
    m_command = new QLabel(content);
    m_command->setObjectName("checkCommand");
    m_command->setProperty("tone", 2);
    m_command->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_command->setMinimumWidth(1);  // its words are no reason for a wide window
    auto* foot = new QHBoxLayout;
    foot->addWidget(m_runOne);
    m_command->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    foot->addWidget(m_command, 1);
    foot->addStretch();
    auto* column = new QVBoxLayout(content);
    column->addWidget(m_cases, 1);
    column->addLayout(foot);
    connect(m_cases, &CheckCases::chosen, this, &CheckPanel::select);
    connect(m_cases, &CheckCases::openAsked, this, &CheckPanel::openAsScene);
    connect(m_runOne, &QPushButton::clicked, this, [this] { run({{std::string(chosenCase().id)}, {}}); });
    followTheme(content, [this, column, foot] {
        const Theme& theme = Theme::current();
        column->setContentsMargins(theme.px(12), theme.px(10), theme.px(12), theme.px(12));
        column->setSpacing(theme.px(8));
        foot->setSpacing(theme.px(8));
        m_command->setFont(theme.mono(12));
        fitGroups();
    });
    return surface(content, this);
}

QWidget* CheckPanel::makeRight() {
    auto* content = new QWidget(this);
    m_details = new CheckDetails(content);
    m_message = new QLabel(content);
    m_message->setObjectName("checkMessage");
    m_message->setWordWrap(true);
    m_message->hide();
    m_pictures = new CheckPictures(content);
    m_knob = new CheckKnob(content);
    m_noKnob = new QLabel(tr("Nothing in this case can be turned: it is as stiff as it is."), content);
    m_noKnob->setAlignment(Qt::AlignCenter);
    m_noKnob->setProperty("tone", 2);
    auto* column = new QVBoxLayout(content);
    column->addWidget(m_details);
    column->addWidget(m_message);
    column->addWidget(m_pictures, 2);
    column->addWidget(m_knob, 2);
    column->addWidget(m_noKnob);
    column->addStretch(0);
    connect(m_details, &CheckDetails::openAsked, this, &CheckPanel::openAsScene);
    connect(m_knob, &CheckKnob::changed, this, &CheckPanel::turnKnob);
    followTheme(content, [this, column] {
        const int margin = Theme::current().px(12);
        column->setContentsMargins(0, 0, 0, 0);
        m_message->setContentsMargins(margin, 0, margin, 0);
    });
    auto* area = scrolling(content, this);
    followTheme(area, [area, content] { area->setMinimumWidth(content->minimumSizeHint().width()); });
    return surface(area, this);
}

// In a narrow window the groups are a list, and the command, which the manual has, goes.
void CheckPanel::fitGroups() {
    const bool isNarrow = width() < Theme::current().px(1180);
    m_bar->setNarrow(isNarrow);
    m_command->setVisible(!isNarrow);
}

void CheckPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitGroups();
}

}  // namespace app
