#pragma once
#include <QPointer>
#include <QScrollArea>
#include <QScrollBar>

namespace app {

// Keeps a part of a scrolled page in sight while the page is laid out anew around it, until the user scrolls.
class KeptInSight : public QObject {
public:
    explicit KeptInSight(QScrollArea& area) : QObject(&area), m_area(area) {
        const QScrollBar* bar = area.verticalScrollBar();
        connect(bar, &QScrollBar::rangeChanged, this, &KeptInSight::show, Qt::QueuedConnection);
        connect(bar, &QScrollBar::actionTriggered, this, [this] { m_part = nullptr; });
    }
    // null: stops.
    void keep(QWidget* part) {
        m_part = part;
        QMetaObject::invokeMethod(
            this, [this] { show(); }, Qt::QueuedConnection);  // once it has its place
    }

private:
    void show() {
        if (!m_part || !m_part->isVisible()) return;
        if (m_part->height() < m_area.viewport()->height()) return m_area.ensureWidgetVisible(m_part);
        m_area.verticalScrollBar()->setValue(m_part->mapTo(m_area.widget(), QPoint()).y());  // read from its top on
    }

    QScrollArea& m_area;
    QPointer<QWidget> m_part;
};

}  // namespace app
