#pragma once
#include "app/panels/buffer_feature.h"

class QLabel;

namespace app {

// A picture of a moment ago may stay while a slider moves, but not under the words of another cue, nor in place of B: it is
// dimmed, and says that its own is being computed.
class LateVeil : public BufferFeature {
public:
    explicit LateVeil(BufferView& view);

    void show() override;
    void place(CanvasRoom& room) override;
    pipeline::Errors read(const lessons::BufferShown& state) override;

private:
    bool isThere() const;
    QString words() const;  // empty: the picture is what was asked for

    QLabel* m_veil;
    bool m_isAsked = false;  // by a cue, a page or a session, and not there yet
};

}  // namespace app
