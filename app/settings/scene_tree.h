#pragma once
#include <QListWidget>

#include "app/document/document.h"
#include "app/document/scene_outline.h"

namespace app {

// The scene's parts: objects with their materials, lights, camera. Choosing one shows its settings. An object or a light is
// also selected in all views.
class SceneTree : public QListWidget {
    Q_OBJECT
public:
    explicit SceneTree(Document& document, QWidget* parent = nullptr);

    QSize sizeHint() const override;

signals:
    void selected(const SceneItem& item);

private:
    void choose(int row);
    void rebuild();
    void followSelection();

    Document& m_document;
    std::vector<OutlineRow> m_rows;
};

}  // namespace app
