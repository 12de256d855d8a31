#pragma once
#include <QSize>
#include <algorithm>

#include "app/look/theme.h"

namespace app {

// How the start page shares its room. Lengths in pixels.
struct StartFit {
    bool isWide;        // both lectures beside each other
    int left, lessons;  // the widths of the left column, and of the lessons beside the scenes
    int pictures;       // the height of a lecture's first pictures; 0: they are left out
    int side, gap;      // beside the right half; between its parts
};

inline StartFit fitStart(const QSize& page) {
    const Theme& theme = Theme::current();
    const double width = page.width() / theme.scale(),
                 height = page.height() / theme.scale();  // in the theme's lengths
    const bool isWide = width >= 1600;
    const auto along = [](double from, double low, double at, double to, double high) {
        return low + (high - low) * std::clamp((at - from) / (to - from), 0.0, 1.0);
    };
    return {.isWide = isWide,
            .left = isWide ? theme.px(312) : theme.px(along(900, 200, width, 1366, 240)),
            .lessons = theme.px(along(900, 230, width, 1366, 290)),
            // Below this height the first rows of scenes would not be in sight.
            .pictures = height < 540 ? 0 : theme.px(along(540, 80, height, 736, 116)),
            .side = theme.px(isWide ? 28 : along(900, 12, width, 1366, 16)),
            .gap = theme.px(isWide ? 12 : along(900, 6, width, 1366, 8))};
}

}  // namespace app
