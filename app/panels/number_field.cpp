#include "app/panels/number_field.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>

#include "app/core/text.h"
#include "app/panels/follow_theme.h"

namespace app {

NumberField::NumberField(pipeline::SettingRef setting, QWidget* parent) : QLineEdit(parent), m_setting(setting) {
    setAlignment(Qt::AlignRight);
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

void NumberField::keyPressEvent(QKeyEvent* event) {
    const bool up = event->key() == Qt::Key_Up, down = event->key() == Qt::Key_Down;
    if (event->key() == Qt::Key_Escape && isModified()) {
        setModified(false);
        setText(toQString(formatSetting(m_setting, m_value)));
        showWrong({});
        selectAll();
    } else if (up || down) {
        const QString shown = text();
        const qsizetype point = shown.indexOf('.');
        const int decimals = point < 0 || shown.contains('e') ? 0 : int(shown.size() - point - 1);
        const double tens = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
        const double unit = std::pow(10.0, decimals);
        const double value = std::round(m_value * unit + (up ? tens : -tens)) / unit;
        emit entered(std::clamp(value, m_setting.setting->min, m_setting.setting->max));
        selectAll();
    } else {
        QLineEdit::keyPressEvent(event);
    }
}

void NumberField::focusOutEvent(QFocusEvent* event) {
    take();
    QLineEdit::focusOutEvent(event);
}

}  // namespace app
