#include "app/desktop/opening_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "app/core/scene_opener.h"
#include "app/panels/follow_theme.h"

namespace app {

OpeningBar::OpeningBar(const SceneOpener& opener, QWidget* parent)
    : QWidget(parent), m_opener(opener), m_name(new QLabel(this)), m_share(new QProgressBar(this)) {
    setObjectName("openingBar");
    m_share->setAccessibleName(tr("How far the file has been read"));
    m_share->setTextVisible(false);
    auto* cancel = new QPushButton(tr("Cancel   Esc"), this);
    cancel->setObjectName("cancelOpening");
    cancel->setAccessibleName(tr("Cancel opening"));
    cancel->setProperty("kind", "link");
    cancel->setFocusPolicy(Qt::TabFocus);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_name);
    row->addWidget(m_share);
    row->addWidget(cancel);
    connect(cancel, &QPushButton::clicked, this, &OpeningBar::cancelAsked);
    connect(&opener, &SceneOpener::changed, this, &OpeningBar::showProgress);
    followTheme(this, [this, row, cancel] {
        const Theme& theme = Theme::current();
        row->setSpacing(theme.px(8));
        m_name->setFont(theme.text(12));
        m_name->setIndent(theme.px(12));
        cancel->setFont(theme.text(12));
        m_share->setFixedSize(theme.px(160), theme.px(6));
    });
    hide();
}

void OpeningBar::showProgress() {
    setVisible(m_opener.busy());
    const bool isRead = m_opener.share() >= 1;  // the rest takes as long as it takes
    m_share->setRange(0, isRead ? 0 : 100);
    if (!isRead) m_share->setValue(int(100 * m_opener.share()));
    m_name->setText((isRead ? tr("Preparing %1") : tr("Reading %1")).arg(m_opener.name()));
}

}  // namespace app
