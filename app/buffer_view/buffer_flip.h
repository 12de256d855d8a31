#pragma once
#include "app/buffer_view/buffer_feature.h"

class QAction;

namespace app {

// Which way up the picture is.
class FlipToggle : public BufferFeature {
public:
    explicit FlipToggle(BufferView& view);

    void set(bool flipped);  // row 0 at the bottom

    bool press(const QKeyEvent& key) override;
    void write(lessons::BufferShown& state) const override;
    pipeline::Errors read(const lessons::BufferShown& state) override;

private:
    QAction* m_action;
};

}  // namespace app
