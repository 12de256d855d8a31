#pragma once
#include "app/widgets/progress_line.h"

namespace app {

class SceneOpener;

// The file that is being read and its progress, with a button to cancel; hidden otherwise.
class OpeningBar : public ProgressLine {
    Q_OBJECT
public:
    OpeningBar(const SceneOpener& opener, QWidget* parent);

signals:
    void cancelAsked();

private:
    void showProgress();

    const SceneOpener& m_opener;
};

}  // namespace app
