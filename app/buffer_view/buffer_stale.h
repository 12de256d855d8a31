#pragma once
#include "app/buffer_view/buffer_feature.h"

class QLabel;

namespace app {

// Dims the previous picture and says that the next one is being computed, if the previous one would mislead: under the
// words of another cue, or in place of B. While a slider moves it stays as it is.
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
