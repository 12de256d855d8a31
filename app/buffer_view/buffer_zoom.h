#pragma once
#include "app/buffer_view/buffer_feature.h"

namespace app {

// Which part of the picture is in view, and how large.
class PictureZoom : public BufferFeature {
public:
    explicit PictureZoom(BufferView& view);

    // Refreshes the view first. Nothing: what fits, of the next picture of the document's scene.
    void showPart(const std::optional<lessons::BufferShown::Zoom>& part);

    bool press(const QKeyEvent& key) override;
    void show() override;
    void write(lessons::BufferShown& state) const override;

private:
    bool m_fitsNext = false;
};

}  // namespace app
