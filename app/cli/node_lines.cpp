#include "app/cli/node_lines.h"

#include <fmt/format.h>

#include "app/cli/commands/foreign_program.h"
#include "lessons/pages/page_parts.h"
#include "pipeline/compare/own/own_blocks.h"
#include "pipeline/defects/own_words.h"
#include "pipeline/export/json/json_value.h"

namespace app {

namespace {

namespace foreign = pipeline::foreign;
using pipeline::Json;

// Reads the lines and runs them. The last line of output is the block of results, or one that begins with "!".
constexpr std::string_view kRun = R"(
const read = readLines(asked.text, asked.name, exports.parse), refuse = text => console.log('! ' + text);
if (read.errors.length) refuse(`line ${read.errors[0].line}, column ${read.errors[0].column}: ${read.errors[0].text}`);
else try {
  const out = new Function(asked.runs + '\n$end = performance.now() + kMostTime;\nreturn numbers => $run(' + read.plain + ', ' + JSON.stringify(asked.shape) + ', ' + asked.calls + ', numbers, () => {});')()(Float64Array.from(numbers));
  console.log(`${asked.name} ${asked.calls} ${out.length / asked.calls}\n${out.join(' ')}`);
} catch (error) { refuse(String(error && error.message || error)); }
)";

pipeline::Error refused(const std::string& why) { return {{}, "these lines cannot run: " + why, {}}; }

}  // namespace

lessons::LinesRunner nodeLines(const std::stop_token& stop) {
    const auto parts = lessons::writerParts();
    const auto found = runProgram("command -v node", {}, {}, stop);
    if (!parts || !found || !found->failure.empty()) return {};
    return [parts = *parts, stop](
               const pipeline::OwnContract& contract, const std::string& text,
               const std::vector<pipeline::OwnElement>& calls) -> pipeline::Result<pipeline::OwnResults> {
        std::string numbers;
        for (const pipeline::OwnElement& call : calls)
            for (const double x : call.in) numbers += foreign::numberText(x) + ',';
        const Json asked{{"text", text},
                         {"name", contract.name},
                         {"shape", shapeText(contract)},
                         {"calls", calls.size()},
                         {"runs", parts.lines}};
        const std::string script =
            fmt::format("{}\nconst asked = {}, numbers = [{}];\n{}", parts.reader, asked.dump(), numbers, kRun);
        auto run = runProgram("exec node --max-old-space-size=256 -", script, {}, stop);
        if (!run) return run.errors();
        if (!run->failure.empty()) return refused(run->failure);
        if (run->output.starts_with("! ")) return refused(run->output.substr(2, run->output.find('\n') - 2));
        return foreign::readResults(contract, calls.size(), run->output);
    };
}

}  // namespace app
