#pragma once
#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include <glm/glm.hpp>

#include "app/frames/pinned_pixels.h"
#include "app/frames/scene_step.h"
#include "lessons/state/selection.h"
#include "pipeline/scene/scene.h"

namespace app {

// Where the user points: the hovered and the picked pixel, the pins, the selected element, the channel and the symbol
// of the equation. Pixels and elements are those of the scene that it was given last.
class Pointing : public QObject {
    Q_OBJECT
public:
    explicit Pointing(QObject* parent = nullptr);

    void setScene(ScenePtr scene);  // a new state of the same scene; the picture may have become smaller
    // Another scene: forgets pixels, pins and selection. tellReset() emits the signals.
    void reset(ScenePtr scene);
    void tellReset();

    std::optional<glm::ivec2> pixel() const { return m_pixel; }
    void pick(std::optional<glm::ivec2> pixel);  // clamped to the picture; clears the selection
    PinnedPixels& pins() { return m_pins; }
    const PinnedPixels& pins() const { return m_pins; }
    std::optional<glm::ivec2> hovered() const { return m_hovered; }
    void hover(std::optional<glm::ivec2> pixel);
    // The selection apart from the pixel.
    const std::optional<lessons::Selection>& selection() const { return m_selection; }
    void select(std::optional<lessons::Selection> selection);  // nothing if the scene has no such element
    int channel() const { return m_channel; }                  // 0 r, 1 g, 2 b: for the equation
    void setChannel(int channel);
    // The buffer or setting of the equation's symbol under the cursor; empty if there is none.
    const QString& symbol() const { return m_symbol; }
    void setSymbol(const QString& refers);

signals:
    void pixelChanged();
    void hoverChanged();
    void selectionChanged();
    void channelChanged();
    void symbolChanged();

private:
    ScenePtr m_scene;
    std::optional<glm::ivec2> m_pixel, m_hovered;
    PinnedPixels m_pins;
    std::optional<lessons::Selection> m_selection;
    int m_channel = 2;
    QString m_symbol;
};

}  // namespace app
