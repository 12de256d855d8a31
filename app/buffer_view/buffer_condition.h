#pragma once
#include "app/buffer_view/buffer_feature.h"

namespace app {

class ConditionBar;

// The document's condition: its bar below the picture, and a veil over the pixels for which it does not hold.
class ConditionVeil : public BufferFeature {
public:
    explicit ConditionVeil(BufferView& view);

    ConditionBar& bar() { return *m_bar; }

    bool press(const QKeyEvent& key) override;
    void addTo(ShowRequest& request) override;
    void write(lessons::BufferShown& state) const override;
    pipeline::Errors read(const lessons::BufferShown& state) override;

private:
    ConditionBar* m_bar;
};

// Whether a derived buffer is computed from the text of the condition's bar.
bool isOfText(const pipeline::BufferName& name);

}  // namespace app
