#pragma once
#include <QObject>
#include <array>
#include <map>
#include <optional>

#include <glm/glm.hpp>

#include "app/core/document.h"

namespace app {

// Up to nine pixels that stay marked in every buffer view, with numbers 1 to 9. Forgotten with the scene. A pin outside
// a smaller picture counts as absent.
class PinnedPixels : public QObject {
    Q_OBJECT
public:
    static constexpr int kMost = 9;

    // The document's own, created on first use.
    static PinnedPixels& of(Document& document);
    static const PinnedPixels* find(const Document& document);  // null if it does not exist yet

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
    explicit PinnedPixels(Document& document);

    Document& m_document;
    std::array<std::optional<glm::ivec2>, kMost> m_pins;
};

}  // namespace app
