#pragma once
#include <set>
#include <string>

#include "app/buffer_view/buffer_feature.h"
#include "app/buffer_view/buffer_page.h"

namespace app {

class BufferCompare;

// Finds the buffer that a view names: the frame's own or a derived one, else the reason why there is none. While terms
// are mixed, their picture takes the place of the frame buffer.
class BufferSource : public BufferFeature {
public:
    BufferSource(BufferView& view, const BufferCompare& compare);

    // Whether a question hides the buffer, or the buffer that it is compared with, until it is answered.
    bool isHidden() const;
    std::optional<pipeline::AnyBuffer> find(const pipeline::Frame& frame) const;
    std::optional<Absence> whyNot(const pipeline::Frame& frame) const;  // nothing: the buffer is on its way
    void takeOffer();                                                   // that whyNot() has made

    pipeline::BufferSet want() override;
    void addTo(ShowRequest& request) override;
    QString notice() const override;

private:
    bool isDerived() const;
    bool isForced() const;  // computed although the scene has no use for it
    bool isMixed() const;
    Absence whyNotDerived() const;

    const BufferCompare& m_compare;
    std::set<std::string> m_forced;  // names
};

}  // namespace app
