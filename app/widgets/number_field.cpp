#include "app/widgets/number_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>

#include "app/look/text.h"
#include "app/widgets/follow_theme.h"

namespace app {

NumberField::NumberField(pipeline::SettingRef setting, QWidget* parent) : QLineEdit(parent), m_setting(setting) {
    setAlignment(Qt::AlignRight);
    setFocusPolicy(Qt::TabFocus);  // a click that is no drag gives it too
    followTheme(this, [this] {
        setFont(Theme::current().mono());
        setFixedWidth(Theme::current().px(62));
    });
    connect(this, &QLineEdit::returnPressed, this, [this] {
        take();
        selectAll();
    });
}

void NumberField::setValue(double value) {
    const bool isNew = value != m_value || text().isEmpty();
    m_value = value;
    if (isModified() && hasFocus() && !isNew) return;
    setText(toQString(formatSetting(m_setting, value)));
    showWrong({});
}

void NumberField::take() {
    if (!isModified()) return;
    const auto value = parseSetting(m_setting, text().toStdString());
    if (!value) {
        const auto& error = value.errors().front();
        return showWrong(toQString(error.found + ", expected " + error.expected));
    }
    showWrong({});
    setModified(false);
    emit entered(*value);
}

void NumberField::showWrong(const QString& why) {
    setToolTip(why);
    const QString color = Theme::current().colors().failed.name();
    const QString sheet = why.isEmpty() ? QString() : QStringLiteral("QLineEdit { border: 2px solid %1; }").arg(color);
    // A style sheet is read anew even where it is the same; every field is told every value of a drag.
    if (sheet != styleSheet()) setStyleSheet(sheet);
}

// What has been taken is a step of the scene's undo, and none of the text's.
bool NumberField::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && !isModified()) {
        const auto* key = static_cast<const QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return false;
        }
    }
    return QLineEdit::event(event);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    const bool up = event->key() == Qt::Key_Up, down = event->key() == Qt::Key_Down;
    if (event->key() == Qt::Key_Escape && isModified()) {
        setModified(false);
        setText(toQString(formatSetting(m_setting, m_value)));
        showWrong({});
        selectAll();
    } else if (up || down) {
        const QString shown = text();
        const qsizetype point = shown.indexOf('.'), power = shown.indexOf('e');
        const qsizetype end = power < 0 ? shown.size() : power;
        const int places = point < 0 ? 0 : int(end - point - 1),
                  exponent = shown.mid(end + 1).toInt();  // 0 without one
        const double tens = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
        const double unit = std::pow(10.0, places - exponent);
        const double value = std::round(m_value * unit + (up ? tens : -tens)) / unit;
        emit entered(std::clamp(value, m_setting.setting->min, m_setting.setting->max));
        selectAll();
    } else {
        QLineEdit::keyPressEvent(event);
    }
}

// A field that has the focus is written in.
void NumberField::mousePressEvent(QMouseEvent* event) {
    m_drags = false;
    if (event->button() != Qt::LeftButton || hasFocus()) return QLineEdit::mousePressEvent(event);
    m_pressed = event->position();
}

void NumberField::mouseMoveEvent(QMouseEvent* event) {
    if (!m_pressed) return QLineEdit::mouseMoveEvent(event);
    const double by = event->position().x() - m_pressed->x();
    if (!m_drags && std::abs(by) < QApplication::startDragDistance()) return;
    m_drags = true;
    m_pressed = event->position();
    const pipeline::Setting& setting = *m_setting.setting;
    constexpr double kPixels = 200;
    const bool fast = event->modifiers() & Qt::ShiftModifier, slow = event->modifiers() & Qt::AltModifier;
    const double change = by * (setting.high - setting.low) / kPixels * (fast ? 10 : slow ? 0.1 : 1);
    m_dragged = std::clamp(m_dragged.value_or(m_value) + change, setting.min, setting.max);
    emit dragged(rounded(*m_dragged, slow));
}

void NumberField::mouseReleaseEvent(QMouseEvent* event) {
    if (!m_pressed) return QLineEdit::mouseReleaseEvent(event);
    m_pressed.reset();
    m_dragged.reset();
    if (std::exchange(m_drags, false)) return emit entered(m_value);
    setFocus(Qt::MouseFocusReason);
    selectAll();
}

// As a person would write it: three digits of the range, with Alt one more.
double NumberField::rounded(double value, bool fine) const {
    const pipeline::Setting& setting = *m_setting.setting;
    const double digits = std::floor(std::log10(setting.high - setting.low)) - (fine ? 3 : 2);
    const double grid = setting.kind == pipeline::SettingKind::Integer ? 1 : std::pow(10.0, -digits);
    return std::round(value * grid) / grid;
}

void NumberField::focusOutEvent(QFocusEvent* event) {
    take();
    QLineEdit::focusOutEvent(event);
}

}  // namespace app
