#include "pipeline/compare/trial.h"

#include <fmt/format.h>

#include "pipeline/compare/own/own_blocks.h"
#include "pipeline/compare/reference.h"

namespace pipeline::foreign {

namespace {

Error stopped() { return {{}, "stopped", {}}; }

// The results for some calls; what the run says goes into the report.
Result<OwnResults> ask(const Program& program, const std::vector<OwnElement>& calls, OwnReport& report) {
    auto run = program(callsText(report.contract(), calls));
    if (!run) return run.errors();
    report.messages = run->messages, report.seconds += run->seconds;
    if (!run->failure.empty()) return Error{{}, run->failure, {}};
    return readResults(report.contract(), calls.size(), run->output);
}

void add(const std::vector<OwnElement>& calls, const OwnResults& results, OwnRecord& record) {
    for (std::size_t i = 0; i < calls.size(); ++i) record.add(calls[i], results[i]);
}

}  // namespace

FunctionTrial::FunctionTrial(Scene scene, OwnFunction function, const Stop& stop)
    : m_scene(std::move(scene)),
      m_function(function),
      m_right(ownFrame(m_scene, function, std::make_shared<const OwnRecord>(), stop)) {}

std::optional<Error> FunctionTrial::whyNot() const {
    if (!m_right.unknown.empty()) return {};
    const OwnContract& contract = ownContract(m_function);
    return Error{{},
                 signatureOf(contract) + " is never called in this scene",
                 fmt::format("a scene that calls it: it is called {}", contract.asked)};
}

Result<OwnReport> FunctionTrial::judge(const Program& program, bool picture, const Stop& stop) const {
    if (const auto error = whyNot()) return *error;
    OwnReport report;
    report.function = m_function;
    report.elements = m_right.unknown, report.isCut = m_right.isCut, report.right = m_right.frame;
    auto results = ask(program, report.elements, report);
    if (stop.stop_requested()) return stopped();
    if (!results) return results.errors();
    report.mine = std::move(results).value();
    report.verdict = judgeOwn(report.contract(), report.elements, report.mine);
    if (!picture || !report.contract().picture) return report;

    const auto record = std::make_shared<OwnRecord>();
    add(report.elements, report.mine, *record);
    for (int runs = 1;; ++runs) {
        const OwnFrame yours = ownFrame(m_scene, m_function, record, stop);
        if (stop.stop_requested()) return stopped();
        report.yours = yours.frame, report.notAsked = yours.unknown.size();
        if (yours.unknown.empty() || runs == kOwnRuns || report.isCut) return report;
        const auto more = ask(program, yours.unknown, report);
        if (stop.stop_requested()) return stopped();
        if (!more) return more.errors();
        add(yours.unknown, *more, *record);
    }
}

StageTrial::StageTrial(Scene scene, const StageBlocks& blocks, const Stop& stop)
    : m_scene(std::move(scene)), m_blocks(blocks), m_frame(stageFrame(m_scene, blocks, stop)) {
    if (auto reference = makeReference(m_scene, {}, stop))
        m_reference = std::make_shared<const Reference>(std::move(*reference));
}

Result<Report> StageTrial::judge(const Program& program, const std::string& given,
                                 const CompareOptions& options) const {
    if (!m_frame || !m_reference) return stopped();
    const auto run = program(stageText(*m_frame, m_blocks));
    if (options.stop.stop_requested()) return stopped();
    if (!run) return run.errors();
    if (!run->failure.empty()) return Error{{}, run->failure, {}};
    auto in = readStage(*m_frame, m_blocks, run->output);
    if (!in) return in.errors();
    return compareRenderer(m_scene, m_reference, std::move(in).value(), given, options);
}

}  // namespace pipeline::foreign
