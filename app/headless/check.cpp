#include "app/headless/check.h"

#include <algorithm>
#include <chrono>

#include "pipeline/check/check_json.h"
#include "pipeline/core/text.h"

namespace app {

namespace {

using pipeline::check::Case;
using pipeline::check::CaseResult;
using pipeline::check::Group;

// Columns that a text takes on a terminal: UTF-8 characters, none of ours is wider than one.
std::size_t columns(std::string_view text) {
    return std::size_t(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}
std::string padded(std::string_view text, std::size_t width) {
    return std::string(text) + std::string(width - std::min(width, columns(text)), ' ');
}

void printRows(const std::vector<std::vector<std::string>>& rows, const CommandHost& host) {
    std::vector<std::size_t> widths(rows[0].size(), 0);
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], columns(row[i]));
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) line += padded(row[i], widths[i] + 2);
        host.say("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
    }
}

std::string nearestCase(const std::string& id) {
    std::vector<std::string> ids;
    for (const Case& c : pipeline::check::caseTable()) ids.emplace_back(c.id);
    return pipeline::nearest(id, ids);
}

// False after the reason was told.
bool readFilter(const CheckOptions& options, pipeline::check::Filter& filter, const CommandHost& host) {
    for (const std::string& id : options.cases) {
        if (!pipeline::check::findCase(id)) {
            host.tell("there is no case {}; the nearest is {}\n", pipeline::inQuotes(id), nearestCase(id));
            return false;
        }
        filter.ids.push_back(id);
    }
    std::vector<std::string> names;
    for (std::size_t g = 0; g < pipeline::check::kGroupCount; ++g) names.emplace_back(name(Group(g)));
    for (const std::string& text : options.groups) {
        const auto group = std::ranges::find(names, text);
        if (group == names.end()) {
            host.tell("there is no group {}; the nearest is {}\n", pipeline::inQuotes(text),
                      pipeline::nearest(text, names));
            return false;
        }
        filter.groups.push_back(Group(group - names.begin()));
    }
    return true;
}

void printList(const pipeline::check::Filter& filter, const CommandHost& host) {
    std::vector<std::vector<std::string>> rows{{"case", "group", "title", "input"}};
    for (const Case& c : pipeline::check::caseTable())
        if (filter.admits(c))
            rows.push_back({std::string(c.id), std::string(name(c.group)), std::string(c.title), std::string(c.input)});
    printRows(rows, host);
}

void printResults(std::vector<CaseResult> results, double seconds, const CommandHost& host) {
    std::ranges::stable_sort(results, {}, &CaseResult::holds);
    std::vector<std::vector<std::string>> rows{{"case", "title", "naive", "ours", "bound", "ends in", "verdict"}};
    for (const CaseResult& r : results)
        rows.push_back({std::string(r.what->id), std::string(r.what->title), r.naiveText(), r.oursText(), r.boundText(),
                        std::string(name(r.what->outcome)), r.holds ? "holds" : "breaks: " + r.reason});
    printRows(rows, host);
    host.say("\n{} of {} hold, in {:.2f} s\n", std::ranges::count(results, true, &CaseResult::holds), results.size(),
             seconds);
}

}  // namespace

int check(const CheckOptions& options, const CommandHost& host) {
    pipeline::check::Filter filter;
    if (!readFilter(options, filter, host)) return kWrongUsage;
    if (options.list && !options.json) {
        printList(filter, host);
        return kDone;
    }
    if (options.list) {
        pipeline::Json cases = pipeline::Json::array();
        for (const Case& c : pipeline::check::caseTable())
            if (filter.admits(c)) cases.push_back(toJson(c));
        host.say("{}\n", cases.dump(2));
        return kDone;
    }
    const auto start = std::chrono::steady_clock::now();
    std::vector<CaseResult> results = runChecks(filter, options.threads, host.stop);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (host.stop.stop_requested()) return host.cancelled();
    const auto holding = std::size_t(std::ranges::count(results, true, &CaseResult::holds));
    if (options.json)
        host.say("{}\n", toJson(results, seconds).dump(2));
    else
        printResults(results, seconds, host);
    return holding == results.size() ? kDone : kAnswerIsNo;
}

}  // namespace app
