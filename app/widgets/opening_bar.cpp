#include "app/widgets/opening_bar.h"

#include <QProgressBar>
#include <QPushButton>

#include "app/document/scene_opener.h"

namespace app {

OpeningBar::OpeningBar(const SceneOpener& opener, QWidget* parent) : ProgressLine(parent), m_opener(opener) {
    setObjectName("openingBar");
    bar()->setAccessibleName(tr("How far the file has been read"));
    link()->setText(tr("Cancel   Esc"));
    link()->setObjectName("cancelOpening");
    link()->setAccessibleName(tr("Cancel opening"));
    connect(link(), &QPushButton::clicked, this, &OpeningBar::cancelAsked);
    connect(&opener, &SceneOpener::changed, this, &OpeningBar::showProgress);
}

void OpeningBar::showProgress() {
    setVisible(m_opener.busy());
    const bool isRead = m_opener.share() >= 1;  // the rest takes as long as it takes
    setShare(isRead ? std::nullopt : std::optional(m_opener.share()));
    tell((isRead ? tr("Preparing %1") : tr("Reading %1")).arg(m_opener.name()));
}

}  // namespace app
