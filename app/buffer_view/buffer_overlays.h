#pragma once
#include "app/buffer_view/buffer_feature.h"

namespace app {

class ShadowOverlay;

// Edges, verdicts, depth tests, shadows and more, laid over the picture. The choice is the view's, not the buffer's.
class OverlayChoice : public BufferFeature {
public:
    explicit OverlayChoice(BufferView& view);

    bool isOn(OverlayId overlay) const { return m_on[index(overlay)]; }
    void set(OverlayId overlay, bool shown);
    ShadowOverlay& shadows() { return *m_shadows; }

    pipeline::BufferSet want() override;
    void addTo(ShowRequest& request) override;
    void show() override;
    QString notice() const override;
    void write(lessons::BufferShown& state) const override;
    pipeline::Errors read(const lessons::BufferShown& state) override;

private:
    void fillMenu(QMenu& menu);
    void showChoice();  // in the header and the canvas
    void showEdgeFunctions();
    OverlaySet told() const;  // without the overlays that show what a question hides

    OverlaySet m_on;
    ShadowOverlay* m_shadows;
};

// Whether a picture of this buffer can have overlays.
bool takesOverlays(const pipeline::BufferInfo& info);

}  // namespace app
