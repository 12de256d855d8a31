#include "app/drawing3d/label_words.h"

#include <QFontMetricsF>
#include <algorithm>
#include <vector>

#include "app/look/text.h"

namespace app {

namespace {

using LabelKind = Label::Kind;

// Letters of one font, and how far they stand above the baseline.
struct Run {
    QString text;
    QFont font;
    double raised = 0;
};

constexpr QChar kSubscriptZero(0x2080), kSubscriptNine(0x2089);
bool isSubscript(QChar c) { return c >= kSubscriptZero && c <= kSubscriptNine; }
bool isOfVector(QChar c) { return QStringLiteral("NLVRH").contains(c); }

class Setter {
public:
    explicit Setter(QFont font) : m_font(std::move(font)) {}

    std::vector<Run> set(const QString& text) {
        for (m_at = 0; m_at < text.size();) {
            if (isSubscript(text[m_at]))
                small(digits(text), -0.22);
            else if (text[m_at] == '^' && m_at + 1 < text.size() && text[m_at + 1].isDigit())
                ++m_at, small(takeWhile(text, [](QChar c) { return c.isDigit() || c == '.'; }), 0.4);
            else if (text[m_at].isLetter())
                word(takeWhile(text, [](QChar c) { return c.isLetter() && !isSubscript(c); }));
            else
                add(takeWhile(text, [](QChar c) { return !c.isLetter() && c != '^' && !isSubscript(c); }), false,
                    false);
        }
        return std::move(m_runs);
    }

private:
    template <class Is>
    QString takeWhile(const QString& text, Is is) {
        const auto first = m_at;
        do ++m_at;
        while (m_at < text.size() && is(text[m_at]));
        return text.mid(first, m_at - first);
    }
    QString digits(const QString& text) {
        QString digits = takeWhile(text, isSubscript);
        for (QChar& c : digits) c = QChar('0' + (c.unicode() - kSubscriptZero.unicode()));
        return digits;
    }
    // "NL" are two vectors, "near" is a word.
    void word(const QString& letters) {
        const bool areVectors = std::ranges::all_of(letters, isOfVector);
        add(letters, areVectors || letters.size() == 1, areVectors);
    }
    void small(QString digits, double raised) {
        const double height = m_font.pixelSize();
        QFont font = m_font;
        font.setPixelSize(std::max(1, int(std::lround(0.7 * height))));
        font.setItalic(false);
        m_runs.push_back({std::move(digits), font, raised * height});
    }
    void add(QString text, bool italic, bool bold) {
        QFont font = m_font;
        font.setItalic(italic), font.setBold(bold);
        m_runs.push_back({std::move(text), font});
    }

    QFont m_font;
    qsizetype m_at = 0;
    std::vector<Run> m_runs;
};

std::vector<Run> runsOf(const Label& label) {
    const QString text = toQString(label.text);
    if (label.kind == LabelKind::Caption) return {{text, fontOf(label.kind)}};
    return Setter(fontOf(label.kind)).set(text);
}

}  // namespace

QFont fontOf(Label::Kind kind) {
    const Theme& theme = Theme::current();
    switch (kind) {
        case LabelKind::Letter: return theme.formula(21);
        case LabelKind::Axis: return theme.formula(16);
        case LabelKind::Note:
        case LabelKind::Angle:
        case LabelKind::Plane: return theme.formula(15);
        case LabelKind::Caption: break;
    }
    return theme.text(12);
}

QPainterPath pathOf(const Label& label) {
    QPainterPath path;
    double x = 0;
    for (const Run& run : runsOf(label)) {
        path.addText(x, -run.raised, run.font, run.text);
        x += QFontMetricsF(run.font).horizontalAdvance(run.text);
    }
    return path;
}

QSizeF sizeOf(const Label& label) {
    if (label.kind == LabelKind::Letter || label.kind == LabelKind::Axis) return pathOf(label).boundingRect().size();
    double width = 0;
    for (const Run& run : runsOf(label)) width += QFontMetricsF(run.font).horizontalAdvance(run.text);
    return {width, QFontMetricsF(fontOf(label.kind)).height()};
}

}  // namespace app
