#pragma once
#include <QAccessible>
#include <QWidget>

namespace app {

// What a widget that paints itself is to a screen reader, which would take it for an empty frame. Before it has a name:
// what is asked about a widget once is kept.
void speakAs(QWidget& widget, QAccessible::Role role);

// A widget that moves one number between two ends: a slider to a screen reader, with its number.
class SpokenSlider {
public:
    struct Scale {
        double value, low, high, step;
    };
    virtual ~SpokenSlider() = default;
    virtual Scale spoken() const = 0;
    virtual void slideTo(double value) = 0;  // as if the user had

protected:
    static void speak(QWidget& slider);     // once, when it is made
    static void sayValue(QWidget& slider);  // after each change
};

}  // namespace app
