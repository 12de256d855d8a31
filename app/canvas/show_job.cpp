#include "app/canvas/show_job.h"

#include "app/canvas/condition_bar.h"
#include "app/canvas/shadow_overlay.h"
#include "app/canvas/violators.h"
#include "app/frames/buffer_place.h"
#include "app/frames/large_frame.h"
#include "app/look/luminance.h"
#include "pipeline/inspect/compare.h"

namespace app {

using pipeline::AnyBuffer;

namespace {

bool isLittle(const AnyBuffer& buffer, const pipeline::Frame& frame) {
    return buffer.count() <= kManyNumbers && !isLarge(frame);
}
bool isLittle(const ShowRequest& request) {
    if (request.overlays[index(OverlayId::Violators)]) return false;  // contracts ask more of an element than a picture
    const auto& other = request.other;
    return isLittle(request.buffer, *request.frame) && (!other || isLittle(other->buffer, *other->frame));
}

bool isSame(const AnyBuffer& a, const AnyBuffer& b) { return a.name == b.name && placeOf(a) == placeOf(b); }
bool isSame(const OtherRequest& a, const OtherRequest& b) {
    return a.source == b.source && a.frame == b.frame && isSame(a.buffer, b.buffer);
}
template <class T>
bool isSame(const std::optional<T>& a, const std::optional<T>& b) {
    return a && b ? isSame(*a, *b) : a.has_value() == b.has_value();
}

// Beside A.
ShownOther showOther(const ShowRequest& request, const ShownBuffer& a, const std::stop_token& stop) {
    const OtherRequest& b = *request.other;
    const bool isLuminance = a.source.info != a.buffer.info && hasLuminance(*b.buffer.info);
    ShownOther other{isLuminance ? luminanceOf(b.buffer) : b.buffer, {}, {}, {}, {}};
    other.whyNotComparable = whyNotComparable(a.buffer, other.buffer);
    const bool isComparable = other.whyNotComparable.empty();
    const lessons::ShownChannel channel = a.look.channel,
                                channelB = isComparable ? channel : lessons::ShownChannel::All;
    const auto drawnOf = [](const pipeline::Frame& frame, const AnyBuffer& buffer, lessons::ShownChannel shown) {
        return drawnElements(buffer, polygonsUnder(frame, *buffer.info), shown);
    };
    other.drawnA = drawnOf(*request.frame, a.buffer, channel);
    other.drawnB = drawnOf(*b.frame, other.buffer, channelB);
    const bool sameColors =
        isComparable && shownPalette(*a.buffer.info, channel) == shownPalette(*other.buffer.info, channel);
    if (isComparable || b.source.kind == OtherSource::Kind::PreviousStage)
        other.shown = showBuffer(*b.frame, other.buffer, other.drawnB, channelB,
                                 sameColors ? std::optional(a.look.range) : std::nullopt, stop);
    if (other.shown && request.mine && b.source.kind == OtherSource::Kind::Mine) {
        if (request.overlays[index(OverlayId::Classes)]) addClasses(*request.mine, *other.shown);
        if (request.overlays[index(OverlayId::Violators)])
            violators(theirInput(request.mine->conventions, *request.mine->reference), b.buffer.name,
                      other.shown->content, stop);
    }
    if (other.drawnA.empty() != other.drawnB.empty())  // one has a background, the other has none
        other.drawnA = other.drawnB = other.drawnA.empty() ? other.drawnB : other.drawnA;
    return other;
}

}  // namespace

// Of a difference, what is drawn comes with its numbers.
bool operator==(const ShowRequest& a, const ShowRequest& b) {
    return a.frame == b.frame && isSame(a.buffer, b.buffer) && isSame(a.mix, b.mix) && a.channel == b.channel &&
           a.range == b.range && a.overlays == b.overlays && a.hatches == b.hatches && a.shadows == b.shadows &&
           a.veil == b.veil && a.mine == b.mine && a.counts == b.counts && isSame(a.other, b.other) && a.look == b.look;
}

ShownBuffer show(const ShowRequest& request, const std::stop_token& stop) {
    const pipeline::Frame& frame = *request.frame;
    const auto drawn = request.drawn
                           ? *request.drawn
                           : drawnElements(request.buffer, polygonsUnder(frame, *request.buffer.info), request.channel);
    ShownBuffer shown = showBuffer(frame, request.buffer, drawn, request.channel, request.range, stop, request.counts);
    if (stop.stop_requested()) return shown;
    if (request.mix) {
        const QString notice = shown.notice;
        shown = showBuffer(frame, *request.mix, {}, request.channel, shown.look.range, stop);
        shown.notice = notice;
    }
    CanvasContent& content = shown.content;
    if (request.hatches) content.overlays.push_back(verdictPicture(*request.hatches, 0));
    addOverlays(frame, request.overlays, shown, stop);
    if (request.mine && request.overlays[index(OverlayId::Classes)]) addClasses(*request.mine, shown);
    if (request.shadows) {
        const QImage image = verdictPicture(*request.shadows, kVerdictAlpha);
        if (image.size() == content.size) content.overlays.push_back(image);
    }
    if (request.veil && QSize(request.veil->size.x, request.veil->size.y) == content.size)
        content.overlays.push_back(veilOf(*request.veil));
    return shown;
}

ShowJob::ShowJob(QObject* parent) : QObject(parent) {
    connect(&m_job, &BackgroundJob::busyChanged, this, &ShowJob::busyChanged);
}

std::shared_ptr<const ShowAnswer> ShowJob::answer(const ShowRequest& request) {
    if (m_asked && *m_asked == request) return m_answer;
    m_asked = request;
    const auto make = [request](const std::stop_token& stop) {
        ShowAnswer made{request, show(request, stop), {}};
        if (request.other && !stop.stop_requested()) made.other = showOther(request, made.shown, stop);
        return std::make_shared<const ShowAnswer>(std::move(made));
    };
    if (isLittle(request)) {
        m_job.forget();
        return m_answer = make({});
    }
    // While a slider moves what is under way may finish: it is better than none until the hand rests.
    m_job.ask([make](const BackgroundJob::Control& control) { return make(control.stop); },
              [this](const std::shared_ptr<const ShowAnswer>& made) {
                  m_answer = made;
                  emit ready();
              },
              BackgroundJob::Running::Finish);
    return m_answer;
}

void ShowJob::forget() {
    m_job.forget();
    m_asked.reset();
    m_answer.reset();
}

}  // namespace app
