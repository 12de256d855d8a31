#pragma once
#include "app/buffer_view/buffer_feature.h"

namespace app {

class Loupe;

// Shows or hides the loupe.
class LoupeToggle : public BufferFeature {
public:
    explicit LoupeToggle(BufferView& view);

    void set(bool shown);

    bool press(const QKeyEvent& key) override;
    void place(CanvasRoom& room) override;

private:
    bool isShown() const;

    Loupe* m_loupe;
};

}  // namespace app
