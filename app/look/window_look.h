#pragma once
#include "app/look/number_format.h"
#include "app/look/theme.h"

namespace app {

// Theme, text size and number format at one moment, as values for work on another thread.
struct WindowLook {
    Theme::Look theme = Theme::current().look();
    NumberFormat numbers = NumberStyle::current().format();
    bool operator==(const WindowLook&) const = default;
};

// While this exists, its thread uses that look, whatever the window has meanwhile.
class WornLook {
public:
    explicit WornLook(const WindowLook& look) {
        Theme::s_worn = &look.theme;
        NumberStyle::s_worn = &look.numbers;
    }
    ~WornLook() {
        Theme::s_worn = nullptr;
        NumberStyle::s_worn = nullptr;
    }
    WornLook(const WornLook&) = delete;
    WornLook& operator=(const WornLook&) = delete;
};

}  // namespace app
