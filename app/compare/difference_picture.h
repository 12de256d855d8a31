#pragma once
#include <QObject>
#include <optional>

#include "app/canvas/show_job.h"
#include "app/frames/difference_job.h"

namespace app {

// "12 of 2 686 pixels differ, most by 0.5 at 268, 281".
QString findingText(const pipeline::BufferDifference& found);

// The difference of A and B: its numbers, and its picture.
class DifferencePicture : public QObject {
    Q_OBJECT
public:
    explicit DifferencePicture(QObject* parent);

    pipeline::DifferenceMetric metric() const { return m_metric; }
    void setMetric(pipeline::DifferenceMetric metric);
    std::optional<pipeline::PaletteRange>& range() { return m_range; }  // the user's
    const std::optional<pipeline::PaletteRange>& range() const { return m_range; }
    // Of which A it is from now on; nothing is found yet.
    void begin(const pipeline::AnyBuffer& a, lessons::ShownChannel channel);
    void find(const ShownOther& b);  // nothing where the two cannot be compared
    bool hasB() const { return m_b.has_value(); }
    void forgetOtherThan(const pipeline::BufferName& a);  // a difference of what was on show before
    const std::optional<pipeline::BufferDifference>& found() const { return m_found; }
    // Null until the first has come.
    std::shared_ptr<const ShowAnswer> picture(const pipeline::FramePtr& frame);
    void forgetPicture();
    // The text after A's value at a pixel: B's value; empty without B. isShown: the difference is on show.
    QString readout(QPoint pixel, bool isShown) const;
    QString formula() const;  // "error = A − B"
    DifferenceJob& job() { return m_job; }
    const DifferenceJob& job() const { return m_job; }
    ShowJob& showing() { return m_showing; }
    const ShowJob& showing() const { return m_showing; }

private:
    DifferenceJob m_job;
    ShowJob m_showing;
    pipeline::DifferenceMetric m_metric = pipeline::DifferenceMetric::Error;
    std::optional<pipeline::PaletteRange> m_range;
    std::optional<pipeline::AnyBuffer> m_a, m_b;
    lessons::ShownChannel m_channel = lessons::ShownChannel::All;
    std::optional<pipeline::BufferDifference> m_found;
    pipeline::FramePtr m_frame;  // that the picture is of, which may lag behind
};

}  // namespace app
