#include "app/headless/pixel_text.h"

#include <fmt/format.h>

#include <charconv>

#include "pipeline/core/text.h"

namespace app {

std::optional<glm::ivec2> parsePair(std::string_view text, char separator) {
    const auto at = text.find(separator);
    if (at == text.npos) return std::nullopt;
    glm::ivec2 pair;
    const auto whole = [](std::string_view digits, int& value) {
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        return error == std::errc() && end == digits.data() + digits.size();
    };
    if (!whole(text.substr(0, at), pair.x) || !whole(text.substr(at + 1), pair.y)) return std::nullopt;
    return pair;
}

pipeline::Result<glm::ivec2> pixelIn(const pipeline::Scene& scene, const std::string& text) {
    const auto pixel = parsePair(text, ',');
    const int width = scene.settings.width, height = scene.settings.height;
    if (pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x < width && pixel->y < height) return *pixel;
    return pipeline::Error{{},
                           "--pixel is " + pipeline::inQuotes(text),
                           fmt::format("X,Y with X from 0 to {} and Y from 0 to {}", width - 1, height - 1)};
}

}  // namespace app
