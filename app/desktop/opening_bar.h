#pragma once
#include <QWidget>

class QLabel;
class QProgressBar;

namespace app {

class SceneOpener;

// What is being read and how far it has got, with a button to cancel; hidden while nothing is.
class OpeningBar : public QWidget {
    Q_OBJECT
public:
    OpeningBar(const SceneOpener& opener, QWidget* parent);

signals:
    void cancelAsked();

private:
    void showProgress();

    const SceneOpener& m_opener;
    QLabel* m_name;
    QProgressBar* m_share;
};

}  // namespace app
