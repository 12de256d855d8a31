#pragma once
#include <QBoxLayout>

#include "app/start/start_button.h"

namespace app {

// A line at the left of the start page: a tool with its icon, or a recent file with its time and the place in it.
class StartLine : public StartButton {
    Q_OBJECT
public:
    StartLine(const QString& title, const QString& tip, QWidget* parent);

    void setIcon(const QString& name) { m_icon = name; }  // of resources/icons
    void setPlace(const QString& when, const QString& where) { m_when = when, m_where = where; }
    void setTimed(bool isTimed) { m_isTimed = isTimed, update(); }
    QSize sizeHint() const override;

protected:
    void paintInside(QPainter& painter, const QRectF& box) const override;

private:
    QString m_icon, m_when, m_where;
    bool m_isTimed = true;
};

}  // namespace app
