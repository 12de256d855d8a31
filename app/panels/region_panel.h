#pragma once
#include <QFrame>
#include <optional>

#include "app/core/region_statistics.h"

class QLabel;

namespace app {

// The statistics of a region, over a corner of a buffer view.
class RegionPanel : public QFrame {
    Q_OBJECT
public:
    explicit RegionPanel(QWidget* parent);

    // Nothing hides it.
    void show(const pipeline::AnyBuffer& buffer, const std::optional<Region>& region, ShownChannel channel);
    const QString& text() const { return m_text; }  // as it is copied

signals:
    void closed();

private:
    QLabel* m_table;
    QString m_text;
};

}  // namespace app
