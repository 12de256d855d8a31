#include "app/look/accessible.h"

#include <algorithm>

#include <QAccessibleWidget>
#include <QComboBox>
#include <QLabel>

namespace app {
namespace {

constexpr const char* kRole = "spokenRole";

class Painted : public QAccessibleWidget {
public:
    explicit Painted(QWidget* widget) : QAccessibleWidget(widget, QAccessible::Role(widget->property(kRole).toInt())) {}
};

class Slider : public QAccessibleWidget, public QAccessibleValueInterface {
public:
    Slider(QWidget* widget, AccessibleSlider& slider)
        : QAccessibleWidget(widget, QAccessible::Slider), m_slider(slider) {}

    void* interface_cast(QAccessible::InterfaceType type) override {
        if (type == QAccessible::ValueInterface) return static_cast<QAccessibleValueInterface*>(this);
        return QAccessibleWidget::interface_cast(type);
    }
    QString text(QAccessible::Text kind) const override {
        return kind == QAccessible::Value ? QString::number(m_slider.spoken().value) : QAccessibleWidget::text(kind);
    }
    QVariant currentValue() const override { return m_slider.spoken().value; }
    QVariant minimumValue() const override { return m_slider.spoken().low; }
    QVariant maximumValue() const override { return m_slider.spoken().high; }
    QVariant minimumStepSize() const override { return m_slider.spoken().step; }
    void setCurrentValue(const QVariant& value) override {
        const auto scale = m_slider.spoken();
        m_slider.slideTo(std::clamp(value.toDouble(), scale.low, scale.high));
    }

private:
    AccessibleSlider& m_slider;
};

QAccessibleInterface* make(const QString&, QObject* object) {
    auto* widget = qobject_cast<QWidget*>(object);
    if (!widget || !widget->property(kRole).isValid()) return nullptr;
    if (auto* slider = dynamic_cast<AccessibleSlider*>(widget)) return new Slider(widget, *slider);
    return new Painted(widget);
}

}  // namespace

void setAccessibleRole(QWidget& widget, QAccessible::Role role) {
    QAccessible::installFactory(make);  // Qt keeps each factory once
    widget.setProperty(kRole, role);
}

void nameComboBox(QComboBox& box, const QString& name) {
    box.setAccessibleName(name);
    auto* label = new QLabel(name, box.parentWidget());
    label->setBuddy(&box);
    label->hide();
    QObject::connect(&box, &QObject::destroyed, label, &QObject::deleteLater);
}

void AccessibleSlider::speak(QWidget& slider) { setAccessibleRole(slider, QAccessible::Slider); }

void AccessibleSlider::sayValue(QWidget& slider) {
    if (!QAccessible::isActive()) return;
    QAccessibleValueChangeEvent event(&slider, dynamic_cast<AccessibleSlider&>(slider).spoken().value);
    QAccessible::updateAccessibility(&event);
}

}  // namespace app
