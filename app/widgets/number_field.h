#pragma once
#include <QLineEdit>
#include <optional>

#include "pipeline/scene/settings_table.h"

namespace app {

// A field for the value of a number setting. Enter or leaving it takes the text; what cannot be
// read is marked, with the reason as tooltip, and Esc brings the old value back. Up and Down
// change the last shown digit by one, with Shift by ten. Dragged sideways before it has the focus the value follows, 200
// pixels for what its slider goes through; with Shift ten times as fast, with Alt a tenth.
class NumberField : public QLineEdit {
    Q_OBJECT
public:
    explicit NumberField(pipeline::SettingRef setting, QWidget* parent = nullptr);

    void setValue(double value);  // says nothing; leaves alone what is being typed

signals:
    void entered(double value);
    void dragged(double value);  // while it is; entered() then ends the drag

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    void take();
    double rounded(double value, bool fine) const;
    void showWrong(const QString& why);

    pipeline::SettingRef m_setting;
    double m_value = 0;
    std::optional<QPointF> m_pressed;  // where a drag may begin, or goes on from
    std::optional<double> m_dragged;   // unrounded, so that slow drags add up
    bool m_drags = false;
};

}  // namespace app
