#include "app/desktop/top_bar.h"

#include <QLabel>
#include <QMenuBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/panels/elided_label.h"
#include "app/panels/follow_theme.h"
#include "app/panels/stage_strip.h"

namespace app {

TopBar::TopBar(Document& document, QWidget* parent)
    : QWidget(parent),
      m_menus(new QMenuBar(this)),
      m_title(new ElidedLabel(this)),
      m_strip(new StageStrip(document, this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* row = new QHBoxLayout;
    m_menus->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Preferred);
    m_title->setObjectName("title");
    m_title->setProperty("tone", 2);
    m_title->setAlignment(Qt::AlignCenter);
    auto* command = new QPushButton(tr("Run a command   Ctrl+Shift+P"), this);
    command->setObjectName("runCommand");
    connect(command, &QPushButton::clicked, this, &TopBar::commandAsked);
    row->addWidget(m_menus);
    row->addWidget(m_title, 1);
    row->addWidget(command);
    column->addLayout(row);
    column->addWidget(m_strip);
    followTheme(this, [this, row, command] {
        const Theme& theme = Theme::current();
        row->setContentsMargins(0, theme.px(3), theme.px(8), theme.px(3));
        m_title->setFont(theme.text());
        command->setFont(theme.text(12));
    });
}

}  // namespace app
