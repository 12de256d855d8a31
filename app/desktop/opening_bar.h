#pragma once
#include "app/desktop/progress_line.h"

namespace app {

class SceneOpener;

// What is being read and how far it has got, with a button to cancel; hidden while nothing is.
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
