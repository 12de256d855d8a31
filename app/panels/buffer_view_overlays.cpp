// What a BufferView lays over its picture.
#include <QLabel>

#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_compare.h"
#include "app/panels/buffer_header.h"
#include "app/panels/buffer_view.h"
#include "app/panels/condition_bar.h"
#include "app/panels/loupe.h"
#include "app/panels/shadow_overlay.h"

namespace app {

namespace {

constexpr OverlaySet kAlwaysOn = OverlaySet(1ull << index(OverlayId::Strange));

}  // namespace

void BufferView::observeOverlays() {
    m_overlays = kAlwaysOn;
    m_shadows = new ShadowOverlay(m_document, this);
    connect(m_shadows, &ShadowOverlay::changed, this, [this] {
        setShowLoupe(m_loupe->isVisibleTo(m_canvas));  // the button of the overlays
        refresh();
    });
    connect(m_notice, &QLabel::linkActivated, m_shadows, &ShadowOverlay::cancel);
    connect(m_header, &BufferHeader::overlayMenuOpens, this, [this](QMenu* menu) {
        fillOverlayMenu(*menu, m_overlays, bufferInfo(m_name.id),
                        [this](OverlayId id, bool on) { setOverlay(id, on); });
        m_shadows->fillMenu(*menu, whyNoOverlays(bufferInfo(m_name.id)));
        menu->addSeparator();
        QAction* condition = menu->addAction(tr("Condition…"), m_condition, &ConditionBar::open);
        condition->setToolTip(tr("Veils the pixels for which a condition does not hold (/)"));
    });
    connect(m_condition, &ConditionBar::changed, this, &BufferView::refresh);
}

void BufferView::setOverlay(OverlayId overlay, bool shown) {
    m_overlays[index(overlay)] = shown;
    m_canvas->setShowEdges(m_overlays[index(OverlayId::Edges)]);
    setShowLoupe(m_loupe->isVisibleTo(m_canvas));
    want();
    refresh();
}

void BufferView::setShowLoupe(bool show) {
    m_loupe->setVisible(show);
    m_header->setToggles((m_overlays & ~kAlwaysOn).any() || m_shadows->light(), show);
    placeOverlays();
}

void BufferView::layOver(const pipeline::Frame& frame, ShownBuffer& shown) const {
    addOverlays(frame, m_overlays, shown);
    if (m_shadows->light() && whyNoOverlays(*shown.buffer.info).isEmpty()) {
        const QImage image = m_shadows->image();
        if (image.size() == shown.content.size) shown.content.overlays.push_back(image);
        const QString notice = m_shadows->notice();
        if (!notice.isEmpty()) shown.notice = shown.notice.isEmpty() ? notice : notice + "<br>" + shown.notice;
    }
    const lessons::ConditionMask* mask = m_condition->mask();
    const bool fits =
        mask && m_name.id != pipeline::BufferId::Condition && QSize(mask->size.x, mask->size.y) == shown.content.size;
    if (fits && whyNoOverlays(*shown.buffer.info).isEmpty()) shown.content.overlays.push_back(veilOf(*mask));
}

void BufferView::showEdgeFunctions() {
    const pipeline::FramePtr& frame = m_document.frame();
    const std::optional<glm::ivec2> pixel = m_document.pixel();
    const bool shows =
        m_overlays[index(OverlayId::EdgeFunctions)] && frame && pixel && whyNoOverlays(bufferInfo(m_name.id)).isEmpty();
    m_canvas->setEdgeView(shows ? edgeViewAt(*frame, *pixel) : std::nullopt);
}

}  // namespace app
