#include "app/buffer_view/buffer_overlays.h"

#include <algorithm>

#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/canvas/shadow_overlay.h"
#include "app/document/renderer_check.h"
#include "app/look/theme.h"

namespace app {

using pipeline::BufferId;

namespace {

constexpr OverlaySet kAlwaysOn = OverlaySet(1ull << index(OverlayId::Strange));

}  // namespace

bool takesOverlays(const pipeline::BufferInfo& info) { return whyNoOverlays(info).isEmpty(); }

OverlayChoice::OverlayChoice(BufferView& view)
    : BufferFeature(view), m_on(kAlwaysOn), m_shadows(new ShadowOverlay(view.document(), this)) {
    connect(m_shadows, &ShadowOverlay::changed, this, [this] {
        showChoice();
        this->view().refresh();
    });
    connect(&view.header(), &BufferHeader::overlayMenuOpens, this, [this](QMenu* menu) { fillMenu(*menu); });
    connect(&view.document().renderer(), &RendererCheck::compared, this, [this] {
        if (isOn(OverlayId::Classes)) this->view().refresh();
    });
    connect(&view.document().pointing(), &Pointing::pixelChanged, this, &OverlayChoice::showEdgeFunctions);
}

void OverlayChoice::set(OverlayId overlay, bool shown) {
    m_on[index(overlay)] = shown;
    showChoice();
    view().want();
    view().refresh();
}

void OverlayChoice::fillMenu(QMenu& menu) {
    const pipeline::BufferInfo& info = bufferInfo(view().buffer().id);
    fillOverlayMenu(menu, m_on, info, view().canvas()->placing().isFlipped(),
                    [this](OverlayId id, bool on) { set(id, on); });
    m_shadows->fillMenu(menu, whyNoOverlays(info));
}

void OverlayChoice::showChoice() {
    view().canvas()->setShowEdges(isOn(OverlayId::Edges));
    view().header().setOverlays((m_on & ~kAlwaysOn).any() || m_shadows->light());
}

void OverlayChoice::showEdgeFunctions() {
    const std::optional<glm::ivec2> pixel = view().document().pointing().pixel();
    const bool shows =
        isOn(OverlayId::EdgeFunctions) && view().frame() && pixel && takesOverlays(bufferInfo(view().buffer().id));
    view().canvas()->setEdgeView(shows ? edgeViewAt(*view().frame(), *pixel) : std::nullopt);
}

OverlaySet OverlayChoice::told() const {
    OverlaySet told = m_on;
    for (std::size_t i = 0; i < told.size(); ++i)
        for (const pipeline::BufferName& hidden : view().document().hidden().buffers)
            if (told[i] && buffersOf(OverlaySet().set(i), view().buffer().id)[index(hidden.id)]) told.reset(i);
    return told;
}

pipeline::BufferSet OverlayChoice::want() {
    const BufferId shown = view().buffer().id;
    return takesOverlays(bufferInfo(shown)) ? buffersOf(m_on, shown) : pipeline::BufferSet();
}

void OverlayChoice::addTo(ShowRequest& request) {
    request.overlays = told();
    if (!takesOverlays(*request.buffer.info)) return;
    if (isOn(OverlayId::Classes)) request.mine = view().document().renderer().report();
    if (m_shadows->light()) request.shadows = m_shadows->verdicts();
}

void OverlayChoice::show() { showEdgeFunctions(); }

QString OverlayChoice::notice() const {
    return takesOverlays(bufferInfo(view().buffer().id)) ? m_shadows->notice() : QString();
}

void OverlayChoice::write(lessons::BufferShown& state) const {
    state.overlays.clear();  // also the overlays that are on if a state names none
    for (const OverlayInfo& overlay : overlayTable())
        if (isOn(overlay.id)) state.overlays.emplace_back(keyOf(overlay.id));
    if (const auto light = m_shadows->light())
        state.overlays.push_back(pipeline::BufferName{BufferId::ShadowVerdict, int(*light)}.text());
}

pipeline::Errors OverlayChoice::read(const lessons::BufferShown& state) {
    pipeline::Errors errors;
    m_on.reset();
    std::optional<std::size_t> verdictsOf;
    for (const std::string& key : state.overlays) {
        if (const auto derived = pipeline::findDerived(key)) {
            if (derived->id == BufferId::ShadowVerdict) verdictsOf = std::size_t(derived->light);
            continue;
        }
        const auto row = std::ranges::find(overlayTable(), key, [](const OverlayInfo& o) { return keyOf(o.id); });
        if (row != overlayTable().end())
            m_on.set(index(row->id));
        else
            errors.push_back({{}, "there is no overlay \"" + key + '"'});
    }
    m_shadows->setLight(verdictsOf);
    return errors;
}

}  // namespace app
