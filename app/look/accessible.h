#pragma once
#include <QAccessible>
#include <QWidget>

class QComboBox;

namespace app {

// Tells a screen reader the role of a widget that paints itself; otherwise it would be an empty frame. Call it before
// the widget has a name, because answers about a widget are cached.
void setAccessibleRole(QWidget& widget, QAccessible::Role role);

// The name of a list without a label beside it. If names come only from labels, as in Qt on Linux, a screen reader
// would call it by its value.
void nameComboBox(QComboBox& box, const QString& name);

// A widget that moves one number between two ends: for a screen reader a slider with its number.
class AccessibleSlider {
public:
    struct Scale {
        double value, low, high, step;
    };
    virtual ~AccessibleSlider() = default;
    virtual Scale spoken() const = 0;
    virtual void slideTo(double value) = 0;  // as if the user had done it

protected:
    static void speak(QWidget& slider);     // once, on creation
    static void sayValue(QWidget& slider);  // after each change
};

}  // namespace app
