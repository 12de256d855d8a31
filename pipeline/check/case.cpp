#include "pipeline/check/case.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "pipeline/core/number.h"
#include "pipeline/core/text.h"
#include "pipeline/run/parallel.h"
#include "pipeline/scene/settings_table.h"

namespace pipeline::check {
namespace {

std::vector<Case> allCases() {
    std::vector<Case> all;
    for (const auto cases :
         {geometryCases(), polygonCases(), readerCases(), cameraCases(), coverageCases(), clipCases(), depthCases(),
          normalCases(), lightCases(), highlightCases(), biasCases(), shadowCases(), limitCases()})
        all.insert(all.end(), cases.begin(), cases.end());
    return all;
}

// Thrown out of a case that is asked to stop, so that no case has to hand it on.
#ifdef __cpp_lib_jthread
struct Stopped {};
void giveUp() { throw Stopped{}; }
template <class Run>
void untilStopped(Run run) try {
    run();
} catch (const Stopped&) {
}
#else  // nobody asks, and nothing catches
void giveUp() {}
template <class Run>
void untilStopped(Run run) {
    run();
}
#endif
thread_local Stop currentStop;  // of the case that this thread runs; a trial knows of none

char upper(char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; }
bool sameId(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, [](char x, char y) { return upper(x) == upper(y); });
}

// +infinity stands for "nothing was drawn here" in these, and only in these.
bool mayBeInfinite(BufferId id) {
    return id == BufferId::Depth || id == BufferId::ZView || id == BufferId::ShadowBuffer;
}

}  // namespace

std::string_view name(Group group) {
    static constexpr std::string_view kNames[kGroupCount]{"geometry", "camera", "raster", "depth",
                                                          "shading",  "shadow", "limits"};
    return kNames[std::size_t(group)];
}

std::string_view title(Group group) {
    static constexpr std::string_view kTitles[kGroupCount]{"Geometry", "Camera", "Raster",          "Depth",
                                                           "Shading",  "Shadow", "Order and limits"};
    return kTitles[std::size_t(group)];
}

std::string_view name(Outcome outcome) {
    static constexpr std::string_view kNames[]{"value", "empty", "error"};
    return kNames[std::size_t(outcome)];
}

void Trial::demand(bool truth, std::string_view otherwise) {
    if (!truth && m_broken.empty()) m_broken = otherwise;
}

FramePtr Trial::frame(const Scene& scene, BufferSet wanted, StageId until) {
    const Errors errors = checkScene(scene);
    demand(errors.empty(), fmt::format("the scene is refused: {}", errors.empty() ? "" : format(errors[0])));
    FrameRequest request;
    request.wanted = wanted, request.until = until, request.threads = m_threads;
    request.stop = currentStop;
    FramePtr frame = runFrame(std::make_shared<const Scene>(scene), request, nullptr);
    if (!frame) giveUp();
    for (const AnyBuffer& buffer : frame->buffers()) {
        const BufferStatistics s = statistics(buffer);
        demand(s.nan == 0, fmt::format("{} holds {} NaN", buffer.name.text(), s.nan));
        demand(s.infinite == 0 || mayBeInfinite(buffer.name.id),
               fmt::format("{} holds {} infinities", buffer.name.text(), s.infinite));
    }
    return frame;
}

std::span<const Case> caseTable() {
    static const std::vector<Case> table = allCases();
    return table;
}

const Case* findCase(std::string_view id) {
    const auto table = caseTable();
    const auto found = std::ranges::find_if(table, [&](const Case& c) { return sameId(c.id, id); });
    return found == table.end() ? nullptr : &*found;
}

std::string measured(double value, std::string_view unit) {
    if (std::isnan(value)) return "NaN";
    if (std::isinf(value)) return "infinite";
    // Whole numbers are counts and stay; of others two digits say enough.
    const bool count = value == std::floor(value) && std::abs(value) < 1e7;
    const double shown = count ? value : readNumber(fmt::format("{:.1e}", value)).value_or(value);
    const bool joined = unit.empty() || unit == "°";
    return fmt::format("{}{}{}", shortestText(shown), joined ? "" : " ", unit);
}

std::string CaseResult::naiveText() const {
    return finding.naiveText.empty() ? measured(finding.naive, what->unit) : finding.naiveText;
}
std::string CaseResult::oursText() const {
    return finding.oursText.empty() ? measured(finding.ours, what->unit) : finding.oursText;
}
std::string CaseResult::boundText() const { return measured(what->bound, what->unit); }

bool Filter::admits(const Case& which) const {
    if (ids.empty() && groups.empty()) return true;
    return std::ranges::any_of(ids, [&](const std::string& id) { return sameId(id, which.id); }) ||
           std::ranges::find(groups, which.group) != groups.end();
}

std::optional<Scene> withNaiveForm(const Case& which, Scene scene) {
    if (which.naiveWith.empty()) return {};
    std::istringstream parts{std::string(which.naiveWith)};
    for (std::string part; parts >> part;) {
        const std::string_view text = part;
        const std::size_t equals = text.find('=');
        const auto setting = findSetting(scene, text.substr(0, equals));
        const auto value = setting ? parseSetting(*setting, text.substr(equals + 1)) : setting.errors();
        if (!value) return {};
        setting->set(scene, *value);
    }
    return scene;
}

CaseResult runCase(const Case& which, int threads) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    Trial trial(threads);
    CaseResult result{&which, which.run(trial), false, {}, 0};
    result.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    const bool within = result.finding.ours <= which.bound;  // false for NaN
    result.reason = trial.broken();
    if (result.reason.empty() && !within)
        result.reason = fmt::format("{} is {}, more than {}", which.measure, measured(result.finding.ours, which.unit),
                                    result.boundText());
    result.holds = result.reason.empty();
    return result;
}

std::vector<CaseResult> runChecks(const Filter& filter, int threads, Stop stop,
                                  const std::function<void(const CaseResult&)>& each) {
    std::vector<CaseResult> results;
    for (const Case& which : caseTable())
        if (filter.admits(which)) results.push_back({&which, {}, false, {}, 0});
    Threads pool(threads, stop);
    // A lone case gets the threads for its frames.
    const int threadsEach = results.size() == 1 ? threads : 1;
    std::vector<std::uint8_t> done(results.size(), 0);
    pool.forRange(results.size(), 1, [&](std::size_t begin, std::size_t end) {
        currentStop = stop;
        untilStopped([&] {
            for (std::size_t i = begin; i < end; ++i) {
                results[i] = runCase(*results[i].what, threadsEach);
                done[i] = 1;
                if (each) each(results[i]);
            }
        });
        currentStop = Stop();
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < results.size(); ++i)
        if (done[i]) results[kept++] = results[i];
    results.resize(kept);
    return results;
}

}  // namespace pipeline::check
