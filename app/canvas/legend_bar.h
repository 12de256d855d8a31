#pragma once
#include <QWidget>

#include "app/canvas/shown_buffer.h"

namespace app {

// Names beside their colours, in as many rows as fit; the tooltip lists the others.
class LegendBar : public QWidget {
    Q_OBJECT
public:
    explicit LegendBar(QWidget* parent = nullptr);
    void setEntries(std::vector<LegendEntry> entries);
    QSize minimumSizeHint() const override;
    std::vector<QRect> places() const;  // of the entries that fit, in their order

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<LegendEntry> m_entries;
};

}  // namespace app
