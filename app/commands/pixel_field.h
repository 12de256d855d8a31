#pragma once
#include <optional>

#include <glm/glm.hpp>

#include "app/widgets/popover.h"

class QLabel;
class QLineEdit;

namespace app {

// "268, 281" as a pixel: two whole numbers parted by a comma or white space, inside the picture.
std::optional<glm::ivec2> parsePixel(const QString& text, glm::ivec2 size);

// Asks for a pixel by its numbers.
class PixelField : public Popover {
    Q_OBJECT
public:
    explicit PixelField(QWidget* window);

    void open(glm::ivec2 size, std::optional<glm::ivec2> now);

signals:
    void entered(glm::ivec2 pixel);

private:
    QString range() const;

    glm::ivec2 m_size{0};
    QLineEdit* m_field;
    QLabel* m_hint;
};

}  // namespace app
