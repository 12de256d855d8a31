#pragma once
#include <QMargins>
#include <QWidget>
#include <functional>

#include "app/core/theme.h"

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

// Of all that stands in a widget. Where that gets another parent, Qt's style sheets give its labels and buttons back the
// fonts that they had when they were first styled.
inline void followThemeAgain(const QWidget& root) {
    for (const ThemeFollower* follower : root.findChildren<ThemeFollower*>()) follower->applyAgain();
}

}  // namespace app
