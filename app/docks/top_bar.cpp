#include "app/docks/top_bar.h"

#include <QLabel>
#include <QMenuBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/stages/stage_strip.h"
#include "app/widgets/elided_label.h"
#include "app/widgets/follow_theme.h"

namespace app {

TopBar::TopBar(Document& document, QWidget* parent)
    : QWidget(parent),
      m_menus(new QMenuBar(this)),
      m_title(new ElidedLabel(this)),
      m_strip(new StageStrip(document, this)) {
    auto* column = spaced(new QVBoxLayout(this), {}, 0);
    auto* row = spaced(new QHBoxLayout, {0, 3, 8, 3});
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
    followTheme(this, [this, command] {
        const Theme& theme = Theme::current();
        m_title->setFont(theme.text());
        command->setFont(theme.text(12));
    });
}

}  // namespace app
