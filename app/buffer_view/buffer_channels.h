#pragma once
#include <map>
#include <string>

#include "app/buffer_view/buffer_feature.h"

namespace app {

// Which channel of a buffer is on show: all of them, one, or their luminance. Kept for each buffer.
class ChannelChoice : public BufferFeature {
    Q_OBJECT
public:
    explicit ChannelChoice(BufferView& view);

    lessons::ShownChannel channel() const;
    void set(lessons::ShownChannel channel);  // without effect if the buffer has no such channel

    bool press(const QKeyEvent& key) override;
    void addTo(ShowRequest& request) override;
    void write(lessons::BufferShown& state) const override;
    pipeline::Errors read(const lessons::BufferShown& state) override;

signals:
    void changed();  // before the view shows it

private:
    std::map<std::string, lessons::ShownChannel> m_kept;  // by the buffer's name
};

}  // namespace app
