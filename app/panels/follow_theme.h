#pragma once
#include "app/core/theme.h"

namespace app {

// Runs `apply` now and whenever the theme or the font scale changes, as long as `owner` lives:
// for what a style sheet cannot set, fonts and lengths first of all.
template <class Apply>
void followTheme(QObject* owner, Apply apply) {
    apply();
    QObject::connect(&Theme::current(), &Theme::changed, owner, apply);
}

}  // namespace app
