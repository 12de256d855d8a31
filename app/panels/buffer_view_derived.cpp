// Derived buffers in a BufferView.
#include <QLabel>

#include "app/core/derived_buffers.h"
#include "app/core/mix_model.h"
#include "app/core/put_away.h"
#include "app/panels/buffer_view.h"
#include "app/panels/condition_bar.h"
#include "app/panels/shadow_overlay.h"

namespace app {

using pipeline::BufferId;
using pipeline::BufferName;

namespace {

constexpr BufferName kMix{BufferId::Mix};

bool hasText(const BufferName& name) { return name.id == BufferId::Condition || name.id == BufferId::Expression; }

}  // namespace

void BufferView::observeDerived() {
    connect(&m_document.derived(), &DerivedBuffers::changed, this, [this](const BufferName& name) {
        if (name == m_name || (name == kMix && m_name.id == BufferId::Color)) refresh();
    });
    connect(&m_document.mixer(), &MixModel::changed, this, [this] {
        wantDerived();
        if (m_name.id == BufferId::Color) refresh();
    });
    // What a condition is of stands below its picture.
    connect(this, &BufferView::bufferChanged, this, [this](const BufferName& name) {
        if (hasText(name) && m_condition->isHidden()) m_condition->reveal();
    });
}

void BufferView::wantDerived() {
    std::vector<BufferName> wanted;
    if (!isPutAway(*this) && pipeline::isDerived(m_name.id)) wanted.push_back(m_name);
    if (!isPutAway(*this) && m_name.id == BufferId::Color && !m_document.mixer().isPlain()) wanted.push_back(kMix);
    m_document.derived().want(this, std::move(wanted));
}

void BufferView::takeOffer() {
    if (!pipeline::isDerived(m_name.id)) {
        kept().forced = true;
        return want();
    }
    DerivedJob* job = m_document.derived().find(m_name);
    if (!job) return;
    job->wasCancelled() ? job->retry() : job->cancel();
}

std::optional<ShownBuffer> BufferView::showDerived(const pipeline::Frame& frame) {
    const DerivedBuffers& derived = m_document.derived();
    const DerivedBuffer* made = derived.made(m_name);
    const DerivedJob* job = derived.find(m_name);
    if (!made) {
        const bool canCancel = m_name.id == BufferId::ShadowVerdict && job && job->busy();
        const bool canCompute = job && job->wasCancelled();
        const bool isTextMissing = hasText(m_name) && derived.text().trimmed().isEmpty();
        showMessage(isTextMissing ? tr("Type a condition or an expression below.") : derived.whyNot(m_name),
                    canCancel    ? Offer::Cancel
                    : canCompute ? Offer::Compute
                                 : Offer::Nothing);
        return {};
    }
    const auto polygons = frame.buffer({BufferId::PolygonId});
    ShownBuffer shown = showBuffer(frame, made->buffer, drawnElements(made->buffer, polygons, kept().channel),
                                   kept().channel, kept().range);
    if (made->verdicts) shown.content.overlays.push_back(verdictPicture(*made->verdicts, 0));
    if (m_name == kMix) shown.notice = m_document.mixer().sentence();
    return shown;
}

// The picture that the terms make as they are mixed stands where the frame buffer would.
void BufferView::showMix(const pipeline::Frame& frame, ShownBuffer& shown) const {
    const MixModel& mixer = m_document.mixer();
    if (m_name.id != BufferId::Color || mixer.isPlain()) return;
    const DerivedBuffer* mixed = m_document.derived().made(kMix);
    if (mixed && mixed->buffer.shape == shown.buffer.shape) {
        const QString notice = shown.notice;
        shown = showBuffer(frame, mixed->buffer, {}, channel(), shown.look.range);
        shown.notice = notice;
    }
    shown.notice = mixer.sentence() + (shown.notice.isEmpty() ? QString() : "<br>" + shown.notice);
}

}  // namespace app
