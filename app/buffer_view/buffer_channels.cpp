#include "app/buffer_view/buffer_channels.h"

#include <QKeyEvent>

#include "app/buffer_view/buffer_header.h"
#include "app/buffer_view/buffer_view.h"
#include "app/look/luminance.h"

namespace app {

using lessons::ShownChannel;

ChannelChoice::ChannelChoice(BufferView& view) : BufferFeature(view) {
    connect(&view.header(), &BufferHeader::channelChosen, this, &ChannelChoice::set);
    connect(&view.document(), &Document::sceneOpened, this, [this] { m_kept.clear(); });
}

ShownChannel ChannelChoice::channel() const {
    const auto found = m_kept.find(view().buffer().text());
    return found == m_kept.end() ? ShownChannel::All : found->second;
}

void ChannelChoice::set(ShownChannel channel) {
    const pipeline::BufferInfo& info = bufferInfo(view().buffer().id);
    if (info.channels == 1 || (channel == ShownChannel::Luminance && !hasLuminance(info))) return;
    m_kept[view().buffer().text()] = channel;
    emit changed();
    view().header().show(view().buffer(), channel);
    view().refresh();
}

bool ChannelChoice::press(const QKeyEvent& key) {
    switch (key.key()) {
        case Qt::Key_R: return set(ShownChannel::First), true;
        case Qt::Key_G: return set(ShownChannel::Second), true;
        case Qt::Key_B: return set(ShownChannel::Third), true;
        case Qt::Key_C: return set(ShownChannel::All), true;
        case Qt::Key_L:
            if (key.modifiers() & Qt::ShiftModifier) return false;
            return set(ShownChannel::Luminance), true;
        default: return false;
    }
}

void ChannelChoice::addTo(ShowRequest& request) { request.channel = channel(); }
void ChannelChoice::write(lessons::BufferShown& state) const { state.channel = channel(); }

pipeline::Errors ChannelChoice::read(const lessons::BufferShown& state) {
    set(state.channel);
    return {};
}

}  // namespace app
