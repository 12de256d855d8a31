#pragma once
#include <QDialog>
#include <memory>

#include "pipeline/defects/defect.h"
#include "pipeline/scene/scene.h"

class QComboBox;
class QLabel;

namespace app {

// A teacher's own picture for the game: the scene, built in or the one that is open, and the error planted in it.
class BugOwnDialog : public QDialog {
    Q_OBJECT
public:
    // open: the window's scene, the first of the list; null: none is open.
    BugOwnDialog(std::shared_ptr<const pipeline::Scene> open, QWidget* parent);

signals:
    void chosen(const std::shared_ptr<const pipeline::Scene>& scene, pipeline::Defect defect);

private:
    void choose();

    std::shared_ptr<const pipeline::Scene> m_open;
    QComboBox *m_scenes, *m_defects;
    QLabel* m_words;
};

}  // namespace app
