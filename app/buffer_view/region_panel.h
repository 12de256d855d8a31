#pragma once
#include <QFrame>
#include <optional>

#include "app/frames/region_statistics.h"
#include "app/jobs/background_job.h"
#include "app/look/number_format.h"

class QLabel;

namespace app {

// The statistics of a region, over a corner of a buffer view.
class RegionPanel : public QFrame {
    Q_OBJECT
public:
    explicit RegionPanel(QWidget* parent);

    // Nothing hides it. The statistics of a large region come a little later, and a bar says so.
    void show(const pipeline::AnyBuffer& buffer, const std::optional<Region>& region, lessons::ShownChannel channel);
    const QString& text() const { return m_text; }  // as it is copied

signals:
    void closed();
    void resized();

private:
    struct Question {
        pipeline::AnyBuffer buffer;
        Region region;
        lessons::ShownChannel channel = lessons::ShownChannel::All;
        NumberFormat numbers;
    };
    void take(const QString& text);

    QLabel* m_table;
    QString m_text;
    std::optional<Question> m_asked;
    BackgroundJob m_job;
};

}  // namespace app
