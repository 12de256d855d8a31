#pragma once
#include <QLineEdit>

#include "pipeline/scene/settings_table.h"

namespace app {

// A field for the value of a number setting. Enter or leaving it takes the text; what cannot be
// read is marked, with the reason as tooltip, and Esc brings the old value back. Up and Down
// change the last shown digit by one, with Shift by ten.
class NumberField : public QLineEdit {
    Q_OBJECT
public:
    explicit NumberField(pipeline::SettingRef setting, QWidget* parent = nullptr);

    void setValue(double value);  // says nothing; leaves alone what is being typed

signals:
    void entered(double value);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void take();
    void showWrong(const QString& why);

    pipeline::SettingRef m_setting;
    double m_value = 0;
};

}  // namespace app
