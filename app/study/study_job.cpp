#include "app/study/study_job.h"

#include <chrono>
#include <functional>

#include "app/jobs/memory_notice.h"
#include "app/look/text.h"
#include "pipeline/study/machine.h"

namespace app {
namespace {

using pipeline::StudyPoint;
using pipeline::StudyReport;
using pipeline::StudyRequest;

// Frames of the first, short measurement: enough to see where the points will stand.
constexpr int kFirstLook = 3;

// What the thread does, and whom it tells.
struct Work {
    StudyRequest request;
    std::function<void(double share, std::string what, double secondsLeft)> progress;
    std::function<void(const StudyReport&)> report;

    using Clock = std::chrono::steady_clock;
    static double secondsSince(Clock::time_point start) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    }

    // A frame in 128 bits and the rays take far longer than a frame: of all the work the errors are put at one half. Each
    // point comes with a first look at its time, so that the plot fills as they arrive.
    bool findErrors(StudyReport& study, const std::stop_token& stop) const {
        pipeline::ErrorFinder finder(request);
        StudyRequest quick = request;
        quick.warmups = 1;
        quick.repeats = kFirstLook;
        StudyReport soFar = study;
        soFar.points.clear();
        soFar.warmups = quick.warmups;
        soFar.repeats = quick.repeats;
        soFar.processes = 1;
        const auto start = Clock::now();
        for (std::size_t i = 0; i < study.points.size(); ++i) {
            const double done = double(i) / double(study.points.size());
            std::string what = "errors of";
            for (const std::string& value : study.points[i].values) what += ' ' + value;
            progress(0.55 * done, what, i == 0 ? -1 : secondsSince(start) * (1 - done) / done);
            if (study.points[i].failure.empty() && !finder.find(study.points[i], study, stop)) return false;
            if (request.repeats <= kFirstLook) continue;
            std::vector<StudyPoint> one{study.points[i]};
            if (!measureTimes(
                    quick, one, [](int, int) {}, stop))
                return false;
            soFar.points.push_back(std::move(one.front()));
            report(soFar);
        }
        return true;
    }

    // from, to: the part of all the work that it is.
    bool takeTimes(const StudyRequest& how, StudyReport& study, double from, double to,
                   const std::stop_token& stop) const {
        const auto start = Clock::now();
        const auto tell = [&](int done, int all) {
            const double share = double(done) / all;
            progress(from + (to - from) * share, "times, round " + std::to_string(done) + " of " + std::to_string(all),
                     done == 0 ? -1 : secondsSince(start) * (1 - share) / share);
        };
        if (!measureTimes(how, study.points, tell, stop)) return false;
        study.processes = 1;
        return true;
    }

    // False when it was stopped.
    bool operator()(const std::stop_token& stop) const {
        StudyReport study = beginStudy(request);
        study.load = {pipeline::loadAverage()};
        if (!findErrors(study, stop)) return false;
        // Of a cancelled measurement the first look stays.
        if (!takeTimes(request, study, 0.55, 1, stop)) return false;
        report(study);
        return true;
    }
};

}  // namespace

StudyJob::StudyJob(StudyRequest request, QObject* parent) : ThreadJob(parent) {
    start([this, request = std::move(request)](const std::stop_token& stop, const auto& later) {
        const auto progress = [&](double share, const std::string& what, double secondsLeft) {
            later([this, share, what = toQString(what), secondsLeft] { emit progressed(share, what, secondsLeft); });
        };
        const auto report = [&](const StudyReport& study) { later([this, study] { emit reported(study); }); };
        try {
            const bool done = Work{request, progress, report}(stop);
            later([this, done] { emit finished(!done); });
        } catch (const std::bad_alloc&) {
            later([this] {
                emit MemoryNotice::instance().gaveUp();
                emit finished(true);
            });
        }
    });
}

}  // namespace app
