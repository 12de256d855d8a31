#include "app/commands/pixel_field.h"

#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QVBoxLayout>

#include "app/widgets/follow_theme.h"

namespace app {

std::optional<glm::ivec2> parsePixel(const QString& text, glm::ivec2 size) {
    static const QRegularExpression form("^\\s*(\\d{1,9})\\s*[,;\\s]\\s*(\\d{1,9})\\s*$");
    const auto match = form.match(text);
    if (!match.hasMatch()) return std::nullopt;
    const glm::ivec2 pixel(match.captured(1).toInt(), match.captured(2).toInt());
    if (pixel.x >= size.x || pixel.y >= size.y) return std::nullopt;
    return pixel;
}

PixelField::PixelField(QWidget* window)
    : Popover(window),
      m_field(new QLineEdit(this)),
      m_hint(styled(new QLabel(this), {.tone = 2, .size = 12, .wraps = true})) {
    setObjectName("pixelField");
    m_field->setObjectName("pixelText");
    m_field->setAccessibleName(tr("Go to pixel"));
    auto* column = spaced(new QVBoxLayout(this), {16, 12, 16, 12});
    auto* title = new QLabel(tr("Go to pixel"), this);
    column->addWidget(title);
    column->addWidget(m_field);
    column->addWidget(m_hint);
    followTheme(this, [this, title] {
        const Theme& theme = Theme::current();
        title->setFont(theme.text(14, 600));
        m_field->setFont(theme.mono(15));
        setFixedWidth(theme.px(320));
    });
    connect(m_field, &QLineEdit::returnPressed, this, [this] {
        if (const auto pixel = parsePixel(m_field->text(), m_size)) {
            close();
            emit entered(*pixel);
        } else {
            m_hint->setText(tr("There is no such pixel: %1.").arg(range()));
            adjustSize();
        }
    });
}

void PixelField::open(glm::ivec2 size, std::optional<glm::ivec2> now) {
    m_size = size;
    m_field->setText(now ? QStringLiteral("%1, %2").arg(now->x).arg(now->y) : QString());
    m_field->selectAll();
    m_hint->setText(tr("%1; Enter goes there.").arg(range()));
    Popover::open(m_field);
}

QString PixelField::range() const { return tr("x, y from 0, 0 to %1, %2").arg(m_size.x - 1).arg(m_size.y - 1); }

}  // namespace app
