#include "app/buffer_view/buffer_source.h"

#include <algorithm>

#include "app/buffer_view/buffer_condition.h"
#include "app/buffer_view/buffer_view.h"
#include "app/compare/buffer_compare.h"
#include "app/frames/derived_buffers.h"
#include "app/frames/mix_model.h"
#include "app/look/hidden_in_window.h"
#include "app/look/text.h"
#include "pipeline/plan/needs.h"

namespace app {

using pipeline::Action;
using pipeline::BufferId;
using pipeline::BufferName;
using Offer = Absence::Offer;

namespace {

constexpr BufferName kMixedPicture{BufferId::Mix};

}  // namespace

BufferSource::BufferSource(BufferView& view, const BufferCompare& compare) : BufferFeature(view), m_compare(compare) {
    Document& document = view.document();
    connect(&document.derived(), &DerivedBuffers::changed, this, [this](const BufferName& name) {
        BufferView& of = this->view();
        if (name == of.buffer() || (name == kMixedPicture && of.buffer().id == BufferId::Color)) of.refresh();
    });
    connect(&document.mixer(), &MixModel::changed, this, [this] {
        want();
        if (this->view().buffer().id == BufferId::Color) this->view().refresh();
    });
    connect(&document, &Document::hiddenChanged, &view, &BufferView::refresh);
    connect(&document, &Document::sceneOpened, this, [this] { m_forced.clear(); });
}

bool BufferSource::isDerived() const { return pipeline::isDerived(view().buffer().id); }
bool BufferSource::isForced() const { return m_forced.contains(view().buffer().text()); }

bool BufferSource::isMixed() const {
    const MixModel& mixer = view().document().mixer();
    return view().buffer().id == BufferId::Color && !mixer.isPlain() && !mixer.isShownAlone();
}

bool BufferSource::isHidden() const {
    const lessons::Hidden& hidden = view().document().hidden();
    const auto compared = m_compare.isOn() && !hidden.buffers.empty() ? m_compare.state() : std::nullopt;
    return hidden.hides(view().buffer()) ||
           (compared && std::ranges::any_of(hidden.buffers, [&](const BufferName& name) {
                return compared->with == "buffer " + name.text();
            }));
}

// A buffer that the scene has no use for is computed only when the user insists.
pipeline::BufferSet BufferSource::want() {
    Document& document = view().document();
    const BufferName& name = view().buffer();
    std::vector<BufferName> derived;
    if (!isHiddenInWindow(view()) && isDerived()) derived.push_back(name);
    if (!isHiddenInWindow(view()) && isMixed()) derived.push_back(kMixedPicture);
    document.derived().want(this, std::move(derived));
    document.mixer().setShownAlone(this, !isHiddenInWindow(view()) && name == kMixedPicture);
    const bool isUseful = !isDerived() && document.hasScene() && whyUseless(document.scene(), name.id).empty();
    return isUseful || isForced() ? pipeline::setOf({name.id}) : pipeline::BufferSet();
}

std::optional<pipeline::AnyBuffer> BufferSource::find(const pipeline::Frame& frame) const {
    if (!isDerived()) return frame.buffer(view().buffer());
    const lessons::DerivedBuffer* made = view().document().derived().made(view().buffer());
    return made ? std::optional(made->buffer) : std::nullopt;
}

std::optional<Absence> BufferSource::whyNot(const pipeline::Frame& frame) const {
    if (isDerived()) return whyNotDerived();
    const BufferName& name = view().buffer();
    const QString why = toQString(frame.whyAbsent(name));
    const pipeline::StageId stage = bufferInfo(name.id).stage;
    const auto& whole = view().document().frames().whole();
    const bool comesLater = frame.until() < stage && whole && whole->plan()[index(stage)].action != Action::LeaveOut;
    if (name.light >= int(frame.scene().lights.size()) || comesLater) return Absence{why};
    const bool comes = isForced() || whyUseless(frame.scene(), name.id).empty();
    if (comes) return {};
    return Absence{tr("This buffer was left out:\n%1").arg(why), Offer::ComputeAnyway};
}

Absence BufferSource::whyNotDerived() const {
    const BufferName& name = view().buffer();
    const DerivedBuffers& derived = view().document().derived();
    const DerivedJob* job = derived.find(name);
    const bool canCancel = name.id == BufferId::ShadowVerdict && job && job->busy();
    const bool canCompute = job && job->wasCancelled();
    const bool isTextMissing = isOfText(name) && derived.text().trimmed().isEmpty();
    return {isTextMissing ? tr("Type a condition or an expression below.") : derived.whyNot(name),
            canCancel    ? Offer::Cancel
            : canCompute ? Offer::Compute
                         : Offer::Nothing};
}

void BufferSource::takeOffer() {
    if (!isDerived()) {
        m_forced.insert(view().buffer().text());
        return view().want();
    }
    DerivedJob* job = view().document().derived().find(view().buffer());
    if (!job) return;
    job->wasCancelled() ? job->retry() : job->cancel();
}

void BufferSource::addTo(ShowRequest& request) {
    const DerivedBuffers& derived = view().document().derived();
    if (isDerived())
        if (const lessons::DerivedBuffer* made = derived.made(view().buffer())) request.hatches = made->verdicts;
    if (!isMixed()) return;
    const lessons::DerivedBuffer* mix = derived.made(kMixedPicture);
    if (mix && mix->buffer.shape == request.buffer.shape) request.mix = mix->buffer;
}

QString BufferSource::notice() const {
    const bool isOfMix = isMixed() || view().buffer() == kMixedPicture;
    return isOfMix ? view().document().mixer().sentence().toHtmlEscaped() : QString();
}

}  // namespace app
