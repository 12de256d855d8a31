#pragma once
#include <QObject>
#include <array>
#include <map>
#include <optional>

#include <glm/glm.hpp>

namespace app {

// Up to nine pixels that stay marked in every buffer view, with numbers 1 to 9. A pin outside a smaller picture counts
// as absent.
class PinnedPixels : public QObject {
    Q_OBJECT
public:
    static constexpr int kMost = 9;

    explicit PinnedPixels(QObject* parent = nullptr);

    void setPictureSize(glm::ivec2 size);             // in pixels
    std::optional<glm::ivec2> pin(int number) const;  // 1 to 9
    // Gives the pixel the smallest free number, or removes its pin. false: all nine are in use.
    bool toggle(glm::ivec2 pixel);
    // All pins by their numbers; and their restoration.
    std::map<int, std::array<int, 2>> all() const;
    void set(const std::map<int, std::array<int, 2>>& pins);
    void clear();
    bool any() const;

signals:
    void changed();

private:
    glm::ivec2 m_size{0};
    std::array<std::optional<glm::ivec2>, kMost> m_pins;
};

}  // namespace app
