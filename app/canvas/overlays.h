#pragma once
#include <QMenu>
#include <bitset>
#include <span>

#include "app/canvas/shown_buffer.h"
#include "lessons/state/shown_words.h"

namespace app {

// What can be laid over the picture of a buffer, several at once.
enum class OverlayId : unsigned char {
    Edges,
    EdgeFunctions,
    Verdict,
    Fragments,
    PolygonSize,
    DepthTest,
    Strange,
    Violators,
    Classes
};
inline constexpr std::size_t kOverlayCount = 9;
using OverlaySet = std::bitset<kOverlayCount>;
constexpr std::size_t index(OverlayId id) { return static_cast<std::size_t>(id); }
static_assert(lessons::kOverlayNames.size() == kOverlayCount);
constexpr std::string_view keyOf(OverlayId id) { return lessons::kOverlayNames[index(id)]; }  // in files

struct OverlayInfo {
    OverlayId id;
    const char* name;
    const char* tip;
    pipeline::BufferSet needs;
};
std::span<const OverlayInfo, kOverlayCount> overlayTable();

// The buffers that the overlays read over the buffer on show.
pipeline::BufferSet buffersOf(OverlaySet overlays, pipeline::BufferId shown);
// Why a buffer's view cannot have overlays; empty where it can.
QString whyNoOverlays(const pipeline::BufferInfo& info);
// Likewise of one of them, in a picture with row 0 on top or, where it is flipped, at the foot.
QString whyNoOverlay(OverlayId overlay, const pipeline::BufferInfo& info, bool isFlipped);

// Draws the overlays over a buffer of the frame, except those whose buffers the frame does not hold yet. The notice
// explains the colours. Incomplete if stopped.
void addOverlays(const pipeline::Frame& frame, OverlaySet overlays, ShownBuffer& shown,
                 const std::stop_token& stop = {});

// Check marks for all of them; change(id, on) is called for what the user picks.
template <class Change>
void fillOverlayMenu(QMenu& menu, OverlaySet on, const pipeline::BufferInfo& info, bool isFlipped, Change change) {
    menu.clear();
    menu.setToolTipsVisible(true);
    for (const OverlayInfo& overlay : overlayTable()) {
        QAction* action = menu.addAction(QMenu::tr(overlay.name));
        action->setCheckable(true);
        action->setChecked(on[index(overlay.id)]);
        const QString why = whyNoOverlay(overlay.id, info, isFlipped);
        action->setEnabled(why.isEmpty());
        action->setToolTip(why.isEmpty() ? QMenu::tr(overlay.tip) : why);
        QObject::connect(action, &QAction::toggled, &menu, [change, id = overlay.id](bool isOn) { change(id, isOn); });
    }
}

}  // namespace app
