#pragma once
#include <QObject>
#include <QVariantAnimation>
#include <memory>
#include <optional>

#include "app/drawing3d/space_content.h"

namespace app {

class SceneView;

// The content of a 3D view and the space that shows it. From one space to another the polygons move in 400 ms, or at once
// without motion, and to and from the hemisphere at the point.
class ShownSpace : public QObject {
    Q_OBJECT
public:
    explicit ShownSpace(SceneView& view);
    ~ShownSpace() override;

    // content: in world space; null shows the sentence of setEmptyText. The camera stays, unless `newScene`. moved: inSpace
    // of the content for the space on show, where a caller has computed it in the background; null: computed here.
    void setContent(std::shared_ptr<const ViewContent> content, bool newScene,
                    std::shared_ptr<const ViewContent> moved = nullptr);
    const std::shared_ptr<const ViewContent>& content() const { return m_content; }
    // In the space on show; null if no point is picked, or a light has no shadow buffer.
    const std::shared_ptr<const ViewContent>& shown() const { return isWorld() ? m_content : m_moved; }

    // `moved`: as of setContent, of the space that it goes to.
    void set(SpaceId space, std::shared_ptr<const ViewContent> moved = nullptr);
    SpaceId id() const { return m_space; }
    bool isWorld() const { return m_space.space == ViewSpace::World; }
    bool isPoint() const { return m_space.space == ViewSpace::Point; }
    bool isMoving() const { return m_morph.has_value(); }  // from one space to another
    void endMove();

private:
    void show();

    SceneView& m_view;
    SpaceId m_space;
    std::shared_ptr<const ViewContent> m_content;  // of the world
    std::shared_ptr<const ViewContent> m_moved;    // in the space on show, unless that is the world
    std::optional<SpaceMorph> m_morph;
    QVariantAnimation m_move;  // along m_morph
};

}  // namespace app
