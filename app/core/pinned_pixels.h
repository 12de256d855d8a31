#pragma once
#include <QObject>
#include <array>
#include <map>
#include <optional>

#include <glm/glm.hpp>

#include "app/core/document.h"

namespace app {

// Up to nine pixels of the picture that stay marked, by their numbers 1 to 9, in every buffer view.
// Forgotten with the scene; one that a smaller picture has no longer counts as not there.
class PinnedPixels : public QObject {
    Q_OBJECT
public:
    static constexpr int kMost = 9;

    // The document's own, made when first asked for.
    static PinnedPixels& of(Document& document);
    static const PinnedPixels* find(const Document& document);  // null where nobody has asked yet

    std::optional<glm::ivec2> pin(int number) const;  // 1 to 9
    // Takes the least free number, or lets go of a pixel that has one. false: all nine are taken.
    bool toggle(glm::ivec2 pixel);
    // All of them by their numbers, and again.
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
