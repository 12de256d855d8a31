#include "app/buffer_view/buffer_counts.h"

#include "app/buffer_view/buffer_view.h"

namespace app {

PictureCounts::PictureCounts(BufferView& view) : BufferFeature(view) {
    constexpr int kMostMilliseconds = 150;
    m_young.setSingleShot(true);
    m_young.setInterval(kMostMilliseconds);
    connect(&m_young, &QTimer::timeout, this, [this] {
        if (m_isOld) this->view().refresh();
    });
}

void PictureCounts::addTo(ShowRequest& request) {
    m_isOld = m_young.isActive() && view().document().frames().isMoving() && m_kept &&
              m_kept->buffer == request.buffer.name && m_kept->channel == request.channel && !request.mix;
    if (m_isOld)
        request.counts = m_kept->counts;
    else
        m_young.start();
}

void PictureCounts::show() {
    const ShownBuffer& shown = *view().shown();
    m_kept = Kept{shown.source.name, shown.look.channel, shown.counts};
}

}  // namespace app
