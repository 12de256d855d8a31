#pragma once
#include <QLabel>
#include <QMargins>
#include <QWidget>
#include <functional>

#include "app/look/theme.h"

namespace app {

// What followTheme leaves with its owner.
class ThemeFollower : public QObject {
    Q_OBJECT
public:
    ThemeFollower(QObject* owner, std::function<void()> apply) : QObject(owner), m_apply(std::move(apply)) {
        m_apply();
        connect(&Theme::current(), &Theme::changed, this, [this] { m_apply(); });
    }
    void applyAgain() const { m_apply(); }

private:
    std::function<void()> m_apply;
};

// Runs `apply` now and whenever the theme or the font scale changes, as long as `owner` lives:
// for what a style sheet cannot set, fonts and lengths first of all.
template <class Apply>
void followTheme(QObject* owner, Apply apply) {
    new ThemeFollower(owner, std::move(apply));
}

// Gives a layout its margins, and the distance between its parts, in pixels at scale 1; they follow the scale. Without a
// distance it keeps the style's.
template <class Layout>
Layout* spaced(Layout* layout, QMargins margins, int between = -1) {
    followTheme(layout, [layout, margins, between] {
        const Theme& theme = Theme::current();
        layout->setContentsMargins(theme.px(margins.left()), theme.px(margins.top()), theme.px(margins.right()),
                                   theme.px(margins.bottom()));
        if (between >= 0) layout->setSpacing(theme.px(between));
    });
    return layout;
}

// How a label looks. Its font is at scale 1 and follows the scale.
struct LabelStyle {
    const char* name = "";  // the object's
    int tone = 1;           // of the text: 1 strong, 3 faint
    bool isMono = false;
    double size = 0;  // 0: the font of the style sheet
    int weight = 400;
    bool wraps = false;
};
inline QLabel* styled(QLabel* label, const LabelStyle& style) {
    label->setObjectName(style.name);
    if (style.tone != 1) label->setProperty("tone", style.tone);
    label->setWordWrap(style.wraps);
    if (style.size > 0)
        followTheme(label, [label, style] {
            const Theme& theme = Theme::current();
            label->setFont(style.isMono ? theme.mono(style.size) : theme.text(style.size, style.weight));
        });
    return label;
}

// Of all that stands in a widget. Where that gets another parent, Qt's style sheets give its labels and buttons back the
// fonts that they had when they were first styled.
inline void followThemeAgain(const QWidget& root) {
    for (const ThemeFollower* follower : root.findChildren<ThemeFollower*>()) follower->applyAgain();
}

}  // namespace app
