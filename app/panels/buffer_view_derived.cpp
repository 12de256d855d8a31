// Derived buffers in a BufferView.
#include <QLabel>
#include <algorithm>

#include "app/core/derived_buffers.h"
#include "app/core/mix_model.h"
#include "app/core/put_away.h"
#include "app/core/text.h"
#include "app/panels/buffer_canvas.h"
#include "app/panels/buffer_compare.h"
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
    connect(&m_document, &Document::hiddenChanged, this, &BufferView::refresh);
    // What a condition is of stands below its picture.
    connect(this, &BufferView::bufferChanged, this, [this](const BufferName& name) {
        if (hasText(name) && m_condition->isHidden()) m_condition->reveal();
    });
}

void BufferView::wantDerived() {
    std::vector<BufferName> wanted;
    if (!isPutAway(*this) && pipeline::isDerived(m_name.id)) wanted.push_back(m_name);
    if (!isPutAway(*this) && isMixed()) wanted.push_back(kMix);
    m_document.derived().want(this, std::move(wanted));
    m_document.mixer().setShownAlone(this, !isPutAway(*this) && m_name == kMix);
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

std::optional<ShowRequest> BufferView::request(const pipeline::FramePtr& frame) {
    if (isHiddenNow()) {
        tellHidden();
        return {};
    }
    const bool isOwn = !pipeline::isDerived(m_name.id);
    const lessons::DerivedBuffer* derived = isOwn ? nullptr : m_document.derived().made(m_name);
    auto buffer = isOwn ? frame->buffer(m_name) : derived ? std::optional(derived->buffer) : std::nullopt;
    if (!buffer) {
        isOwn ? tellAbsent(*frame) : tellWhyNotDerived();
        return {};
    }
    ShowRequest request{.frame = frame, .buffer = *std::move(buffer)};
    request.channel = kept().channel;
    request.range = kept().range;
    request.overlays = overlaysNow();
    if (derived) request.hatches = derived->verdicts;
    if (isMixed()) {  // the picture that the terms make as they are mixed stands where the frame buffer would
        const lessons::DerivedBuffer* mix = m_document.derived().made(kMix);
        if (mix && mix->buffer.shape == request.buffer.shape) request.mix = mix->buffer;
    }
    layOver(request);
    m_compare->addOther(request);
    return request;
}

// Also what has a hidden buffer on the other side of its comparison.
bool BufferView::isHiddenNow() const {
    const lessons::Hidden& hidden = m_document.hidden();
    const auto compared = m_compare->isOn() && !hidden.buffers.empty() ? m_compare->state() : std::nullopt;
    return hidden.hides(m_name) || (compared && std::ranges::any_of(hidden.buffers, [&](const BufferName& name) {
                                        return compared->with == "buffer " + name.text();
                                    }));
}

void BufferView::tellHidden() {
    m_frame.reset();
    m_canvas->setContent({});
    m_canvas->setAccessibleDescription({});
    showMessage(tr("%1\nafter your answer").arg(toQString(m_name.text())), Offer::Nothing);
}

// Without those that are drawn from what is hidden.
OverlaySet BufferView::overlaysNow() const {
    OverlaySet shown = m_overlays;
    for (std::size_t i = 0; i < shown.size(); ++i)
        for (const BufferName& hidden : m_document.hidden().buffers)
            if (shown[i] && buffersOf(OverlaySet().set(i), m_name.id)[index(hidden.id)]) shown.reset(i);
    return shown;
}

void BufferView::tellAbsent(const pipeline::Frame& frame) {
    const QString why = toQString(frame.whyAbsent(m_name));
    if (m_name.light >= int(frame.scene().lights.size()) || frame.until() < bufferInfo(m_name.id).stage)
        return showMessage(why, Offer::Nothing);
    const bool comes = kept().forced || whyUseless(frame.scene(), m_name.id).empty();
    if (!comes) showMessage(tr("This buffer was left out:\n%1").arg(why), Offer::Compute);
}

bool BufferView::isMixed() const {
    const MixModel& mixer = m_document.mixer();
    return m_name.id == BufferId::Color && !mixer.isPlain() && !mixer.isShownAlone();
}

QString BufferView::withNotices(const QString& notice) const {
    QStringList lines;
    if (whyNoOverlays(bufferInfo(m_name.id)).isEmpty()) lines << m_shadows->notice();
    if (isMixed() || m_name == kMix) lines << m_document.mixer().sentence().toHtmlEscaped();
    lines << notice;
    lines.removeAll(QString());
    return lines.join("<br>");
}

void BufferView::tellWhyNotDerived() {
    const DerivedBuffers& derived = m_document.derived();
    const DerivedJob* job = derived.find(m_name);
    const bool canCancel = m_name.id == BufferId::ShadowVerdict && job && job->busy();
    const bool canCompute = job && job->wasCancelled();
    const bool isTextMissing = hasText(m_name) && derived.text().trimmed().isEmpty();
    showMessage(isTextMissing ? tr("Type a condition or an expression below.") : derived.whyNot(m_name),
                canCancel    ? Offer::Cancel
                : canCompute ? Offer::Compute
                             : Offer::Nothing);
}

}  // namespace app
