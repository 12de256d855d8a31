#pragma once
#include <QTimer>
#include <memory>

#include "app/buffer_view/buffer_feature.h"

namespace app {

// Counts over all pixels: the histogram, the distinct values. While a slider or a handle moves, counts up to 150 ms old
// are reused, so that pictures come faster. At rest they are those of the picture on show.
class PictureCounts : public BufferFeature {
public:
    explicit PictureCounts(BufferView& view);

    void addTo(ShowRequest& request) override;
    void show() override;

private:
    struct Kept {
        pipeline::BufferName buffer;
        lessons::ShownChannel channel = lessons::ShownChannel::All;
        std::shared_ptr<const ElementCounts> counts;
    };
    std::optional<Kept> m_kept;  // of the picture on show
    bool m_isOld = false;        // they are of a picture before it
    QTimer m_young;              // while it runs they are young enough
};

}  // namespace app
