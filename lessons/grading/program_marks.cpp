#include "lessons/grading/program_marks.h"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/grading/class_page.h"
#include "pipeline/compare/report/compare_html.h"
#include "pipeline/core/printable.h"
#include "pipeline/core/text.h"
#include "pipeline/export/html/html_text.h"

namespace lessons {

namespace foreign = pipeline::foreign;
using pipeline::Error;
using pipeline::Errors;

namespace {

// Of one scene; the same for a function and for a stage.
struct Judged {
    std::vector<TaskMarks::Mark> marks;
    bool agrees = false;
    std::string headline, html;
    std::vector<std::string> hints;
    std::optional<NamedError> error;
};

std::optional<NamedError> errorOf(const foreign::OwnReport& report) {
    if (report.verdict.names.empty()) return {};
    NamedError out{{}, {}, std::string(report.contract().lesson), std::string(report.contract().heading)};
    for (const pipeline::OwnMistake* const name : report.verdict.names) {
        out.id += fmt::format("{}{}", out.id.empty() ? "" : "|", name->id);
        out.name += fmt::format("{}{}", out.name.empty() ? "" : " or ", name->name);
    }
    return out;
}

class ProgramMarker {
public:
    ProgramMarker(const Course& course, const Course::Task& task, const pipeline::Stop& stop)
        : m_course(course), m_task(task), m_program(*task.program), m_stop(stop) {}

    MarkedProgram mark(const HandInFiles::OfTask& files, const OpensHandIn& open) {
        m_out.marks.task = m_task.name;
        addProblems(files.problems, m_out.marks.problems);
        if (const auto run = begin(files, open))
            for (const Course::Trial& trial : m_program.trials) markIn(trial, *run);
        else
            for (const Course::Trial& trial : m_program.trials) addNothing(trial, "not run");
        m_out.marks.headline = headlineOfAll();
        return std::move(m_out);
    }

private:
    // Nothing after the reason is among the problems.
    std::optional<RunsCommand> begin(const HandInFiles::OfTask& files, const OpensHandIn& open) {
        if (files.bytes.empty()) return {};
        auto run = open(files);
        if (!run) return problem("", run.errors()), std::nullopt;
        if (m_program.build.empty()) return std::move(run).value();
        const auto built = (*run)(m_program.build, "");
        if (!built) return problem("build", built.errors()), std::nullopt;
        m_messages = built->messages;
        if (!built->failure.empty()) return problem("build", Error{{}, built->failure, {}}), std::nullopt;
        return std::move(run).value();
    }

    void markIn(const Course::Trial& trial, const RunsCommand& run) {
        if (m_isEnded) return addNothing(trial, "not run after it was ended in another scene");
        const foreign::Program program = [&](const std::string& input) {
            auto output = run(m_program.run, input);
            if (output) m_messages = output->messages, m_isEnded = output->isEnded;
            return output;
        };
        m_messages.clear();
        auto judged = trial.function ? judgeFunction(trial, program) : judgeStage(trial, program);
        if (m_stop.stop_requested()) return;
        if (!judged) {
            addNothing(trial, "could not be judged");
            problem(shownName(trial),
                    trial.isHidden ? Errors{{{}, "the results could not be judged", {}}} : judged.errors());
            if (!trial.isHidden) addPage(trial, pageOfProblems());
            return;
        }
        m_out.marks.isCompared = true;
        ++m_judged, m_right += judged->agrees;
        std::ranges::move(judged->marks, std::back_inserter(m_out.marks.marks));
        if (!trial.isHidden) addPage(trial, std::move(judged->html));
        if (judged->agrees) return;
        m_out.marks.firstWrong = stageInfo(m_program.stage).label;
        if (m_first.empty()) m_first = judged->headline;
        if (m_out.marks.hints.empty() && !trial.isHidden) m_out.marks.hints = judged->hints;
        // The scene in which the fewest mistakes explain the results tells most.
        const auto names = [](const std::optional<NamedError>& error) { return std::ranges::count(error->id, '|'); };
        if (judged->error && (!m_out.marks.error || names(judged->error) < names(m_out.marks.error)))
            m_out.marks.error = judged->error;
    }

    pipeline::Result<Judged> judgeFunction(const Course::Trial& trial, const foreign::Program& program) {
        auto found = trial.function->judge(program, !trial.isHidden, m_stop);
        if (!found) return found.errors();
        foreign::OwnReport report = std::move(found).value();
        report.scene = trial.name, report.command = m_program.run, report.hints = m_course.hints;
        if (trial.isHidden) report.messages.clear();
        const Course::Check& check = m_task.checks[0];
        const double share = check.points / double(m_program.trials.size());
        const bool agrees = report.verdict.isRight(), isNamed = !report.verdict.names.empty();
        std::vector<std::string> lines = ownText(report);
        lines.erase(lines.begin());
        return Judged{{{shownName(trial),
                        agrees    ? "agrees"
                        : isNamed ? "differs; one known error explains the results"
                                  : "differs",
                        agrees    ? share
                        : isNamed ? share / 2
                                  : 0,
                        share}},
                      agrees,
                      headline(report),
                      trial.isHidden ? "" : ownHtml(report),
                      std::move(lines),
                      errorOf(report)};
    }

    pipeline::Result<Judged> judgeStage(const Course::Trial& trial, const foreign::Program& program) {
        foreign::CompareOptions options;
        options.hints = m_course.hints, options.stop = m_stop;
        const auto report = trial.stage->judge(program, m_program.run, options);
        if (!report) return report.errors();
        Judged judged{{},
                      report->agrees(),
                      headline(*report),
                      trial.isHidden ? "" : reportHtml(*report, m_program.run),
                      hints(*report),
                      lessons::errorOf(*report)};
        for (Course::Check check : m_task.checks) {
            check.points /= double(m_program.trials.size());
            judged.marks.push_back(markOf(*report, check));
            judged.marks.back().name = fmt::format("{}: {}", shownName(trial), check.name);
        }
        return judged;
    }

    std::string shownName(const Course::Trial& trial) const {
        if (!trial.isHidden) return trial.name;
        const auto first = std::ranges::find(m_program.trials, true, &Course::Trial::isHidden);
        return fmt::format("hidden {}", &trial - &*first + 1);
    }

    void addNothing(const Course::Trial& trial, const std::string& words) {
        for (const Course::Check& check : m_task.checks)
            m_out.marks.marks.push_back(
                {m_program.function ? shownName(trial) : fmt::format("{}: {}", shownName(trial), check.name), words, 0,
                 check.points / double(m_program.trials.size())});
    }

    // With the end of what the program wrote to standard error, but of hidden scenes, whose numbers it may hold.
    void problem(const std::string& where, const Errors& errors) {
        for (const Error& error : errors) {
            std::string words = (where.empty() ? "" : where + ": ") + format(error);
            if (!m_messages.empty() && !where.starts_with("hidden")) words += " It says: " + m_messages;
            std::ranges::replace(words, '\n', ' ');
            m_out.marks.problems.push_back(pipeline::escaped(words));
        }
    }
    void problem(const std::string& where, const Error& error) { problem(where, Errors{error}); }

    void addPage(const Course::Trial& trial, std::string html) {
        m_out.marks.pages.push_back(fmt::format("{}.{}", m_task.name, trial.name));
        m_out.pages.emplace_back(m_out.marks.pages.back(), std::move(html));
    }
    std::string pageOfProblems() const {
        return classPage(m_task.name, "The results could not be judged.",
                         pipeline::element("p", m_out.marks.problems.back()) + '\n');
    }

    std::string headlineOfAll() const {
        const std::size_t all = m_program.trials.size();
        if (m_judged == 0) return "The program could not be judged.";
        if (m_right == all) return fmt::format("Right in {}.", pipeline::plural(std::int64_t(all), "scene"));
        return fmt::format("Right in {} of {}. {}", m_right, pipeline::plural(std::int64_t(all), "scene"), m_first);
    }

    const Course& m_course;
    const Course::Task& m_task;
    const Course::Program& m_program;
    const pipeline::Stop& m_stop;
    MarkedProgram m_out;
    std::string m_messages, m_first;  // standard error of the last run; headline of the first scene that differs
    std::size_t m_judged = 0, m_right = 0;
    bool m_isEnded = false;
};

}  // namespace

MarkedProgram markProgram(const Course& course, const Course::Task& task, const HandInFiles::OfTask& files,
                          const OpensHandIn& open, const pipeline::Stop& stop) {
    return ProgramMarker(course, task, stop).mark(files, open);
}

}  // namespace lessons
