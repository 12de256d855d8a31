#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>

#include "app/cli/commands.h"
#include "app/cli/frame_argument.h"
#include "app/cli/interrupt.h"
#include "app/cli/message.h"
#include "pipeline/check/check_json.h"
#include "pipeline/core/text.h"

namespace app {

namespace {

using pipeline::check::Case;
using pipeline::check::CaseResult;
using pipeline::check::Group;

struct CheckOptions {
    std::vector<std::string> cases, groups;
    int threads = 0;
    bool json = false, list = false;
};

// Columns that a text takes on a terminal: UTF-8 characters, none of ours is wider than one.
std::size_t columns(std::string_view text) {
    return std::size_t(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}
std::string padded(std::string_view text, std::size_t width) {
    return std::string(text) + std::string(width - std::min(width, columns(text)), ' ');
}

void printRows(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths(rows[0].size(), 0);
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], columns(row[i]));
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) line += padded(row[i], widths[i] + 2);
        say("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
    }
}

std::string nearestCase(const std::string& id) {
    std::vector<std::string> ids;
    for (const Case& c : pipeline::check::caseTable()) ids.emplace_back(c.id);
    return pipeline::nearest(id, ids);
}

// False after the reason went to standard error.
bool readFilter(const CheckOptions& options, pipeline::check::Filter& filter) {
    for (const std::string& id : options.cases) {
        if (!pipeline::check::findCase(id)) {
            tell("there is no case {}; the nearest is {}\n", pipeline::inQuotes(id), nearestCase(id));
            return false;
        }
        filter.ids.push_back(id);
    }
    std::vector<std::string> names;
    for (std::size_t g = 0; g < pipeline::check::kGroupCount; ++g) names.emplace_back(name(Group(g)));
    for (const std::string& text : options.groups) {
        const auto group = std::ranges::find(names, text);
        if (group == names.end()) {
            tell("there is no group {}; the nearest is {}\n", pipeline::inQuotes(text), pipeline::nearest(text, names));
            return false;
        }
        filter.groups.push_back(Group(group - names.begin()));
    }
    return true;
}

void printList(const pipeline::check::Filter& filter) {
    std::vector<std::vector<std::string>> rows{{"case", "group", "title", "input"}};
    for (const Case& c : pipeline::check::caseTable())
        if (filter.admits(c))
            rows.push_back({std::string(c.id), std::string(name(c.group)), std::string(c.title), std::string(c.input)});
    printRows(rows);
}

void print(const pipeline::Json& json) { say("{}\n", json.dump(2)); }

void printResults(std::vector<CaseResult> results, double seconds) {
    std::ranges::stable_sort(results, {}, &CaseResult::holds);
    std::vector<std::vector<std::string>> rows{{"case", "title", "naive", "ours", "bound", "ends in", "verdict"}};
    for (const CaseResult& r : results)
        rows.push_back({std::string(r.what->id), std::string(r.what->title), r.naiveText(), r.oursText(), r.boundText(),
                        std::string(name(r.what->outcome)), r.holds ? "holds" : "breaks: " + r.reason});
    printRows(rows);
    say("\n{} of {} hold, in {:.2f} s\n", std::ranges::count(results, true, &CaseResult::holds), results.size(),
        seconds);
}

int runCheck(const CheckOptions& options) {
    pipeline::check::Filter filter;
    if (!readFilter(options, filter)) return kWrongUsage;
    if (options.list) {
        if (!options.json) {
            printList(filter);
            return kDone;
        }
        pipeline::Json cases = pipeline::Json::array();
        for (const Case& c : pipeline::check::caseTable())
            if (filter.admits(c)) cases.push_back(toJson(c));
        print(cases);
        return kDone;
    }
    const Interrupt interrupt;
    const auto start = std::chrono::steady_clock::now();
    std::vector<CaseResult> results = runChecks(filter, options.threads, interrupt.token());
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (interrupt.asked()) {
        tell("Cancelled.\n");
        return kInterrupted;
    }
    const auto holding = std::size_t(std::ranges::count(results, true, &CaseResult::holds));
    if (options.json) {
        print(toJson(results, seconds));
    } else {
        printResults(results, seconds);
    }
    return holding == results.size() ? kDone : kAnswerIsNo;
}

}  // namespace

void declareCheck(CLI::App& program, const CliHost&, int& status) {
    const auto options = std::make_shared<CheckOptions>();
    CLI::App* command = program.add_subcommand(
        "check", "Run the stiff and extreme cases: what a naive formula gives, what this program gives, and the bound");
    command->add_option("--case", options->cases, "This case alone; can be given more than once")->type_name("ID");
    command
        ->add_option("--group", options->groups,
                     "The cases of a group: geometry, camera, raster, depth, shading, shadow or limits")
        ->type_name("GROUP");
    command->add_flag("--list", options->list, "List the cases and run none");
    command->add_flag("--json", options->json, "Print JSON");
    declareThreads(*command, options->threads);
    command->callback([options, &status] { status = runCheck(*options); });
}

}  // namespace app
