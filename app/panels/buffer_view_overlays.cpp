// What a BufferView lays over its picture.
#include <QLabel>

#include "app/core/renderer_check.h"
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
        fillOverlayMenu(*menu, m_overlays, bufferInfo(m_name.id), m_canvas->isFlipped(),
                        [this](OverlayId id, bool on) { setOverlay(id, on); });
        m_shadows->fillMenu(*menu, whyNoOverlays(bufferInfo(m_name.id)));
        menu->addSeparator();
        QAction* condition = menu->addAction(tr("Condition…"), m_condition, &ConditionBar::open);
        condition->setToolTip(tr("Veils the pixels for which a condition does not hold (/)"));
    });
    connect(m_condition, &ConditionBar::changed, this, &BufferView::refresh);
    connect(&m_document.renderer(), &RendererCheck::compared, this, [this] {
        if (m_overlays[index(OverlayId::Classes)]) refresh();
    });
    connect(&Theme::current(), &Theme::changed, this, &BufferView::refresh);  // its ground is the veil's
    connect(m_condition, &ConditionBar::left, m_canvas, qOverload<>(&QWidget::setFocus));
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

void BufferView::layOver(ShowRequest& request) const {
    if (!whyNoOverlays(*request.buffer.info).isEmpty()) return;
    if (m_overlays[index(OverlayId::Classes)] || m_compare->isMine()) request.mine = m_document.renderer().report();
    if (m_shadows->light()) request.shadows = m_shadows->verdicts();
    if (m_name.id != pipeline::BufferId::Condition) request.veil = m_condition->mask();
}

void BufferView::showEdgeFunctions() {
    const std::optional<glm::ivec2> pixel = m_document.pixel();
    const bool shows = m_overlays[index(OverlayId::EdgeFunctions)] && m_frame && pixel &&
                       whyNoOverlays(bufferInfo(m_name.id)).isEmpty();
    m_canvas->setEdgeView(shows ? edgeViewAt(*m_frame, *pixel) : std::nullopt);
}

}  // namespace app
