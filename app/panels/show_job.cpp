#include "app/panels/show_job.h"

#include "app/core/buffer_place.h"
#include "app/core/large_frame.h"
#include "app/panels/condition_bar.h"
#include "app/panels/shadow_overlay.h"

namespace app {

using pipeline::AnyBuffer;

namespace {

bool isLittle(const ShowRequest& request) { return request.buffer.count() <= kManyNumbers && !isLarge(*request.frame); }

bool isSame(const AnyBuffer& a, const AnyBuffer& b) { return a.name == b.name && placeOf(a) == placeOf(b); }

}  // namespace

bool operator==(const ShowRequest& a, const ShowRequest& b) {
    const bool sameMix = a.mix && b.mix ? isSame(*a.mix, *b.mix) : a.mix.has_value() == b.mix.has_value();
    return a.frame == b.frame && isSame(a.buffer, b.buffer) && sameMix && a.channel == b.channel &&
           a.range == b.range && a.overlays == b.overlays && a.hatches == b.hatches && a.shadows == b.shadows &&
           a.veil == b.veil && a.numbers == b.numbers;
}

ShownBuffer show(const ShowRequest& request) {
    const pipeline::Frame& frame = *request.frame;
    const auto drawn = drawnElements(request.buffer, frame.buffer({pipeline::BufferId::PolygonId}), request.channel);
    ShownBuffer shown = showBuffer(frame, request.buffer, drawn, request.channel, request.range);
    if (request.mix) {
        const QString notice = shown.notice;
        shown = showBuffer(frame, *request.mix, {}, request.channel, shown.look.range);
        shown.notice = notice;
    }
    CanvasContent& content = shown.content;
    if (request.hatches) content.overlays.push_back(verdictPicture(*request.hatches, 0));
    addOverlays(frame, request.overlays, shown);
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
    const auto make = [request] { return std::make_shared<const ShowAnswer>(ShowAnswer{request, show(request)}); };
    if (isLittle(request)) {
        m_job.forget();
        return m_answer = make();
    }
    // While a slider moves what is under way may finish: it is better than none until the hand rests.
    m_job.ask([make](const BackgroundJob::Control&) { return make(); },
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
