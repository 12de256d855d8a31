#include "app/buffer_view/buffer_condition.h"

#include <QKeyEvent>
#include <QMenu>

#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_overlays.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/canvas/condition_bar.h"
#include "app/look/theme.h"

namespace app {

using pipeline::BufferId;
using pipeline::BufferName;

bool isOfText(const BufferName& name) { return name.id == BufferId::Condition || name.id == BufferId::Expression; }

ConditionVeil::ConditionVeil(BufferView& view) : BufferFeature(view), m_bar(new ConditionBar(view.document(), &view)) {
    connect(&view.header(), &BufferHeader::overlayMenuOpens, this, [this](QMenu* menu) {  // after the overlays
        menu->addSeparator();
        QAction* action = menu->addAction(tr("Condition…"), m_bar, &ConditionBar::open);
        action->setToolTip(tr("Veil the pixels for which a condition does not hold (/)"));
    });
    connect(m_bar, &ConditionBar::changed, &view, &BufferView::refresh);
    connect(m_bar, &ConditionBar::left, view.canvas(), qOverload<>(&QWidget::setFocus));
    connect(&Theme::current(), &Theme::changed, &view, &BufferView::refresh);  // its ground is the veil's
    connect(&view, &BufferView::bufferChanged, this, [this](const BufferName& name) {
        if (isOfText(name) && m_bar->isHidden()) m_bar->reveal();
    });
}

bool ConditionVeil::press(const QKeyEvent& key) {
    if (key.key() != Qt::Key_Slash) return false;
    m_bar->open();
    return true;
}

void ConditionVeil::addTo(ShowRequest& request) {
    if (takesOverlays(*request.buffer.info) && view().buffer().id != BufferId::Condition) request.veil = m_bar->mask();
}

void ConditionVeil::write(lessons::BufferShown& state) const {
    if (!m_bar->isHidden()) state.overlays.push_back(BufferName{BufferId::Condition}.text());
}

pipeline::Errors ConditionVeil::read(const lessons::BufferShown& state) {
    bool asks = isOfText(view().buffer());
    for (const std::string& key : state.overlays) {
        const auto derived = pipeline::findDerived(key);
        asks = asks || (derived && derived->id == BufferId::Condition);
    }
    asks ? m_bar->reveal() : m_bar->close();
    return {};
}

}  // namespace app
