#include "app/export/film_job.h"

#include "app/document/export_plan.h"
#include "app/jobs/memory_notice.h"
#include "app/look/text.h"
#include "pipeline/run/runner.h"

namespace app {
namespace {

using pipeline::Errors;
using pipeline::FilmSummary;
using pipeline::Result;

Result<FilmSummary> write(std::shared_ptr<const pipeline::Scene> scene, const FilmOrder& order,
                          const std::stop_token& stop, const pipeline::FilmProgress& progress) {
    const pipeline::FrameRequest wanted{.wanted = pipeline::setOf({order.buffer.id}), .stop = stop};
    const pipeline::FramePtr frame = runFrame(std::move(scene), wanted, nullptr);
    if (!frame) return FilmSummary{.cancelled = true};
    if (!frame->buffer(order.buffer))
        return pipeline::Error{
            {}, "no " + order.buffer.text() + ". " + std::string(frame->whyAbsent(order.buffer)), {}};
    const pipeline::Steps steps(frame);
    const pipeline::FilmRequest request{order.buffer,
                                        order.level,
                                        steps.momentOf(order.from),
                                        steps.momentOf(order.to),
                                        std::size_t(order.pictures),
                                        order.milliseconds,
                                        order.captions,
                                        order.algorithm};
    if (request.to < request.from)
        return pipeline::Error{{}, "the film ends before it begins", "a later place for its end"};
    return writeFilm(steps, request, order.target, progress);
}

}  // namespace

FilmOrder filmOf(const pipeline::BufferName& buffer) {
    FilmOrder order;
    order.buffer = buffer;
    order.from.stage = order.to.stage = bufferInfo(buffer.id).stage;
    order.from.what = pipeline::Place::What::Start;
    return order;
}

QString filmCommand(const pipeline::Scene& scene, const QStringList& changes, const FilmOrder& order) {
    const FilmOrder usual = filmOf(order.buffer);
    QStringList words{"shadescope", "film", sceneWord(scene)};
    words << "--buffer" << toQString(order.buffer.text()) << "--by" << toQString(name(order.level));
    if (order.from != usual.from) words << "--from" << shellWord(toQString(text(order.from)));
    if (order.to != usual.to) words << "--to" << shellWord(toQString(text(order.to)));
    words << "--pictures" << QString::number(order.pictures);
    if (pipeline::isGif(order.target)) words << "--milliseconds" << QString::number(order.milliseconds);
    if (order.algorithm) words << "--algorithm";
    if (!order.captions) words << "--no-captions";
    words << changes;
    return words.join(' ') + " -o " + shellWord(toQString(order.target.string()));
}

FilmJob::FilmJob(std::shared_ptr<const pipeline::Scene> scene, FilmOrder order, QObject* parent) : ThreadJob(parent) {
    start([this, scene = std::move(scene), order = std::move(order)](const std::stop_token& stop, const auto& later) {
        const auto progress = [&](std::size_t done, std::size_t all) {
            later([this, share = double(done) / double(all)] { emit progressed(share); });
            return !stop.stop_requested();
        };
        const auto result = withinMemory([&] { return write(scene, order, stop, progress); });
        later([this, result] {
            if (result) {
                emit finished(*result);
            } else {
                emit failed(result.errors());
            }
        });
    });
}

}  // namespace app
