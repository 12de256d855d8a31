#pragma once
#include "app/buffer_view/buffer_feature.h"
#include "app/frames/region_statistics.h"

namespace app {

class RegionPanel;

// A rectangle of the picture, and the statistics of its values in a corner.
class RegionMark : public BufferFeature {
public:
    explicit RegionMark(BufferView& view);

    void set(const std::optional<Region>& region);
    void measure();  // between the first two pins, else of what is visible

    bool press(const QKeyEvent& key) override;
    void show() override;
    void place(CanvasRoom& room) override;
    void write(lessons::BufferShown& state) const override;
    pipeline::Errors read(const lessons::BufferShown& state) override;

private:
    RegionPanel* m_panel;
    std::optional<Region> m_region;
};

}  // namespace app
