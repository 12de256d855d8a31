#include "app/frames/pinned_pixels.h"

#include <algorithm>

namespace app {

PinnedPixels::PinnedPixels(QObject* parent) : QObject(parent) {}

void PinnedPixels::setPictureSize(glm::ivec2 size) {
    m_size = size;
    emit changed();
}

std::optional<glm::ivec2> PinnedPixels::pin(int number) const {
    if (number < 1 || number > kMost) return {};
    const auto& pin = m_pins[std::size_t(number - 1)];
    return pin && pin->x < m_size.x && pin->y < m_size.y ? pin : std::nullopt;
}

bool PinnedPixels::toggle(glm::ivec2 pixel) {
    auto place = std::ranges::find(m_pins, std::optional(pixel));
    const bool isNew = place == m_pins.end();
    if (isNew) place = std::ranges::find_if(m_pins, [](const auto& pin) { return !pin; });
    if (place == m_pins.end()) return false;
    *place = isNew ? std::optional(pixel) : std::nullopt;
    emit changed();
    return true;
}

std::map<int, std::array<int, 2>> PinnedPixels::all() const {
    std::map<int, std::array<int, 2>> pins;
    for (int number = 1; number <= kMost; ++number)
        if (const auto pixel = pin(number)) pins[number] = {pixel->x, pixel->y};
    return pins;
}

void PinnedPixels::set(const std::map<int, std::array<int, 2>>& pins) {
    m_pins = {};
    for (const auto& [number, xy] : pins)
        if (number >= 1 && number <= kMost) m_pins[std::size_t(number - 1)] = glm::ivec2(xy[0], xy[1]);
    emit changed();
}

void PinnedPixels::clear() {
    m_pins = {};
    emit changed();
}

bool PinnedPixels::any() const {
    for (int number = 1; number <= kMost; ++number)
        if (pin(number)) return true;
    return false;
}

}  // namespace app
