#pragma once
#include <QAccessible>
#include <QWidget>

class QComboBox;

namespace app {

// What a widget that paints itself is to a screen reader, which would take it for an empty frame. Before it has a name:
// what is asked about a widget once is kept.
void speakAs(QWidget& widget, QAccessible::Role role);

// The name of a list to choose from that has no label of its own beside it. Where names come from labels alone, as in Qt
// on Linux, a reader would call it by its value.
void nameChoice(QComboBox& box, const QString& name);

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
