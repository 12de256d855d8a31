#include "app/frames/pointing.h"

namespace app {

namespace {

glm::ivec2 pictureSize(const pipeline::Scene& scene) { return {scene.settings.width, scene.settings.height}; }

}  // namespace

Pointing::Pointing(QObject* parent) : QObject(parent) {}

void Pointing::setScene(ScenePtr scene) {
    m_scene = std::move(scene);
    pick(m_pixel);
    select(m_selection);
    m_pins.setPictureSize(pictureSize(*m_scene));
}

void Pointing::reset(ScenePtr scene) {
    m_scene = std::move(scene);
    m_pixel.reset();
    m_hovered.reset();
    m_selection.reset();
}

void Pointing::tellReset() {
    m_pins.clear();
    m_pins.setPictureSize(pictureSize(*m_scene));
    emit pixelChanged();
    emit selectionChanged();
    emit hoverChanged();
}

void Pointing::pick(std::optional<glm::ivec2> pixel) {
    if (!m_scene) pixel.reset();
    if (pixel) *pixel = glm::clamp(*pixel, glm::ivec2(0), pictureSize(*m_scene) - 1);
    if (pixel == m_pixel) return;
    m_pixel = pixel;
    if (pixel) select(std::nullopt);
    emit pixelChanged();
}

void Pointing::select(std::optional<lessons::Selection> selection) {
    if (selection && !(m_scene && isIn(*m_scene, *selection))) selection.reset();
    if (selection == m_selection) return;
    m_selection = selection;
    emit selectionChanged();
}

void Pointing::hover(std::optional<glm::ivec2> pixel) {
    if (pixel == m_hovered) return;
    m_hovered = pixel;
    emit hoverChanged();
}

void Pointing::setChannel(int channel) {
    if (channel == m_channel) return;
    m_channel = channel;
    emit channelChanged();
}

void Pointing::setSymbol(const QString& refers) {
    if (refers == m_symbol) return;
    m_symbol = refers;
    emit symbolChanged();
}

}  // namespace app
