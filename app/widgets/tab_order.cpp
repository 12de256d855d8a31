#include "app/widgets/tab_order.h"

#include <algorithm>

#include <QScrollArea>

namespace app {
namespace {

struct Placed {
    QRect rect;
    QWidget* widget;
};
using Places = QList<Placed>;

// What a line across the axis can part, in order.
QList<Places> parted(Places places, Qt::Orientation axis) {
    const auto first = [axis](const QRect& r) { return axis == Qt::Vertical ? r.top() : r.left(); };
    const auto last = [axis](const QRect& r) { return axis == Qt::Vertical ? r.bottom() : r.right(); };
    std::stable_sort(places.begin(), places.end(),
                     [&](const Placed& a, const Placed& b) { return first(a.rect) < first(b.rect); });
    QList<Places> parts;
    int end = 0;
    for (const Placed& place : places) {
        if (parts.isEmpty() || first(place.rect) > end) parts.append(Places());
        end = parts.back().isEmpty() ? last(place.rect) : std::max(end, last(place.rect));
        parts.back().append(place);
    }
    return parts;
}

void read(const QWidget& parent, QList<QWidget*>& order);

void read(const Places& places, QList<QWidget*>& order) {
    for (const Qt::Orientation axis : {Qt::Vertical, Qt::Horizontal}) {
        const QList<Places> parts = parted(places, axis);
        if (parts.size() < 2) continue;
        for (const Places& part : parts) read(part, order);
        return;
    }
    for (const Placed& place : places) {  // one alone, or such as overlap
        // A part of another control, as a spin box's field, sends the focus there.
        if (place.widget->focusPolicy() & Qt::TabFocus && !place.widget->focusProxy()) order += place.widget;
        read(*place.widget, order);
    }
}

void read(const QWidget& parent, QList<QWidget*>& order) {
    Places places;
    for (QObject* child : parent.children()) {
        auto* widget = qobject_cast<QWidget*>(child);
        if (!widget || widget->isWindow() || !widget->isVisible() || !widget->isEnabled()) continue;
        // Qt puts a dock behind another's tab outside of the window instead of hiding it.
        if (parent.isWindow() && !parent.rect().intersects(widget->geometry())) continue;
        places += {widget->geometry(), widget};
    }
    if (!places.isEmpty()) read(places, order);
}

}  // namespace

QList<QWidget*> tabOrder(const QWidget& window) {
    QList<QWidget*> order;
    read(window, order);
    return order;
}

QWidget* nextInTabOrder(const QWidget& window, QWidget* now, bool forward) {
    const QList<QWidget*> order = tabOrder(window);
    const qsizetype at = order.indexOf(now);
    if (at < 0) return nullptr;
    return order[(at + (forward ? 1 : order.size() - 1)) % order.size()];
}

bool focusNext(const QWidget& window, bool forward) {
    QWidget* now = window.window()->focusWidget();
    QWidget* next = now ? nextInTabOrder(window, now, forward) : nullptr;
    if (!next) return false;
    next->setFocus(forward ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    for (QWidget* above = next->parentWidget(); above; above = above->parentWidget())
        if (auto* scroll = qobject_cast<QScrollArea*>(above)) scroll->ensureWidgetVisible(next);
    return true;
}

}  // namespace app
