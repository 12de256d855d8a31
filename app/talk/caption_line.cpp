#include "app/talk/caption_line.h"

#include <QPainter>
#include <algorithm>

#include "app/look/text.h"
#include "app/look/theme.h"
#include "lessons/pages/talk_words.h"

namespace app {
namespace {

constexpr double kLetters = 14.1, kLargest = 19.5;  // 26 and 36 px in 1080 lines

// Broken between words; the second line is cut where both are too short.
QStringList twoLines(const QString& text, const QFontMetrics& metrics, int room) {
    if (metrics.horizontalAdvance(text) <= room) return {text};
    qsizetype end = 0;
    for (qsizetype next = text.indexOf(' '); next > 0; next = text.indexOf(' ', next + 1)) {
        if (metrics.horizontalAdvance(text.left(next)) > room) break;
        end = next;
    }
    if (end == 0) return {metrics.elidedText(text, Qt::ElideRight, room)};
    return {text.left(end), metrics.elidedText(text.mid(end + 1), Qt::ElideRight, room)};
}

// One line with the lectures' symbols as they are set. That takes no more room than the text as it is written.
void paintSet(QPainter& painter, const QRect& box, const QString& line, const QFont& font) {
    const QFontMetrics metrics(font);
    QFont small = font;
    small.setPixelSize(std::max(1, int(0.62 * metrics.height())));
    int x = box.left();
    const int baseline = box.top() + (box.height() - metrics.height()) / 2 + metrics.ascent();
    using Script = lessons::SetPiece::Script;
    for (const lessons::SetPiece& piece : lessons::setPieces(line.toStdString())) {
        const bool isPlain = piece.script == Script::None;
        painter.setFont(isPlain ? font : small);
        const int down = isPlain                         ? 0
                         : piece.script == Script::Below ? metrics.descent() * 2 / 3
                                                         : -metrics.ascent() / 2;
        const QString text = toQString(piece.text);
        painter.drawText(x, baseline + down, text);
        x += painter.fontMetrics().horizontalAdvance(text);
    }
}

}  // namespace

QSize CaptionLine::sizeHint() const { return {200, Theme::current().px(38)}; }

void CaptionLine::setText(const QString& stage, const QString& sentence) {
    m_stage = stage, m_sentence = sentence;
    setAccessibleName(stage.isEmpty() ? sentence : stage + ". " + sentence);
    update();
}

void CaptionLine::setCues(int count, int current) {
    m_count = count, m_current = current;
    update();
}

void CaptionLine::setKey(const QString& key) {
    m_key = key;
    update();
}

// In letters as large as there is room for; what does not fit in the smallest ones has two lines.
void CaptionLine::paintSentence(QPainter& painter, int room) const {
    const Theme& theme = Theme::current();
    double letters = kLargest;
    int left = 0;
    for (;; letters = std::max(letters - 0.5, kLetters)) {
        left = m_stage.isEmpty() ? 0 : QFontMetrics(theme.text(letters, 600)).horizontalAdvance(m_stage) + theme.px(12);
        if (letters == kLetters || left + QFontMetrics(theme.text(letters)).horizontalAdvance(m_sentence) <= room)
            break;
    }
    painter.setFont(theme.text(letters, 600));
    painter.setPen(theme.colors().accent);
    painter.drawText(rect(), Qt::AlignVCenter | Qt::AlignLeft, m_stage);
    const QFont font = theme.text(letters);
    const QFontMetrics metrics(font);
    painter.setPen(theme.colors().text);
    const QRect box(left, 0, room - left, height());
    const QStringList lines = twoLines(m_sentence, metrics, box.width());
    for (int i = 0; i < lines.size(); ++i) {
        const int top = int((height() - lines.size() * metrics.height()) / 2) + i * metrics.height();
        paintSet(painter, QRect(box.left(), top, box.width(), metrics.height()), lines[i], font);
    }
}

void CaptionLine::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::current();
    const ThemeColors& colors = theme.colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    // As many dots as fit into a third of the line. They end at the margin.
    const double dot = theme.px(6), gap = theme.px(5), pill = 2.4 * dot;
    const int shown = std::min(m_count, int(width() / 3 / (dot + gap)));
    const int first = std::clamp(m_current - shown / 2, 0, std::max(0, m_count - shown));
    const bool hasCurrent = m_current >= first && m_current < first + shown;
    double right = width() - 1;  // for the outline of the last one
    if (shown > 0) right -= shown * (dot + gap) - gap + (hasCurrent ? pill - dot : 0);
    double x = right;
    for (int i = first; i < first + shown; ++i) {
        const bool now = i == m_current;
        const QRectF box(x, (height() - dot) / 2, now ? pill : dot, dot);
        painter.setPen(i > m_current ? QPen(colors.text3, 1.5) : QPen(Qt::NoPen));
        painter.setBrush(i > m_current ? QBrush(Qt::NoBrush) : QBrush(now ? colors.accent : colors.text3));
        painter.drawRoundedRect(box, dot / 2, dot / 2);
        x += box.width() + gap;
    }
    if (shown > 0) right -= theme.px(12);
    // The key's place stays empty without it: the sentence does not move.
    const QFont keyFont = theme.text(12, 500);
    const auto widthOf = [&](const QString& key) {
        return QFontMetrics(keyFont).horizontalAdvance(key) + theme.px(12);
    };
    if (!m_key.isEmpty()) {
        const QRectF box(right - widthOf(m_key), 1, widthOf(m_key) - 1, height() - 2);
        painter.setPen(colors.outline);
        painter.setBrush(colors.raised);
        painter.drawRoundedRect(box, theme.px(4), theme.px(4));
        painter.setFont(keyFont);
        painter.setPen(colors.text);
        painter.drawText(box, Qt::AlignCenter, m_key);
    }
    right -= std::max(widthOf("Shift+F10"), widthOf(m_key));
    paintSentence(painter, int(right) - theme.px(12));
}

}  // namespace app
