#include "lessons/questions/write_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "lessons/lesson_text.h"
#include "pipeline/inspect/own_calls.h"

namespace lessons {

namespace {

using pipeline::Errors;
using pipeline::OwnElement;

std::vector<OwnElement> callsIn(const WriteQuestion& write, const pipeline::Scene& scene, const pipeline::Stop& stop) {
    return ownFrame(pipeline::ownScene(scene), write.contract.id, std::make_shared<const pipeline::OwnRecord>(), stop)
        .unknown;
}

// The page's scene and the trials, with their names.
std::vector<std::pair<std::string, const pipeline::Scene*>> scenesOf(const WriteQuestion& write,
                                                                     const pipeline::Scene& scene) {
    std::vector<std::pair<std::string, const pipeline::Scene*>> all{{"", &scene}};
    for (const WriteQuestion::Trial& trial : write.trials) all.emplace_back(trial.name, &trial.scene);
    return all;
}

// What a wrong answer of the contract gives.
pipeline::OwnResults resultsOf(const pipeline::OwnContract& contract, const pipeline::OwnMistake& mistake,
                               const std::vector<OwnElement>& calls) {
    pipeline::OwnResults results;
    for (const OwnElement& call : calls) results.push_back(valueOf(contract, mistake.formula, call.in));
    return results;
}

// The last line of a function before its end.
std::string lastLine(const std::string& function, const std::string& file) {
    std::string last;
    for (const Line& line : linesOf(function, file))
        if (const Line bare = trimmed(line); bare.text != "}" && !bare.text.empty()) last = bare.text;
    return last;
}

}  // namespace

pipeline::Result<Written> judgedIn(const WriteQuestion& write, const pipeline::Scene& scene, const std::string& text,
                                   const LinesRunner& run, const pipeline::Stop& stop) {
    Written judged{text, {}, {}};
    for (const auto& [name, of] : scenesOf(write, scene)) {
        const std::vector<OwnElement> calls = callsIn(write, *of, stop);
        if (stop.stop_requested()) return pipeline::Error{{}, "stopped", {}};
        const auto results = run(write.contract, text, calls);
        if (!results) return results.errors();
        judged.verdict = judgeOwn(write.contract, calls, *results);
        if (judged.verdict.isRight()) continue;
        judged.trial = name;
        break;
    }
    return judged;
}

Errors writeErrorsOf(const Question& question, const WriteQuestion& write, const pipeline::Scene& scene,
                     const LinesRunner& run, const pipeline::Stop& stop) {
    Errors errors;
    const auto add = [&](std::string found, std::string expected = {}) {
        errors.push_back({question.where, std::move(found), std::move(expected)});
    };
    const pipeline::OwnContract& contract = write.contract;
    std::vector<bool> isShown(contract.mistakes.size()), isTold(contract.mistakes.size());
    for (const auto& [name, of] : scenesOf(write, scene)) {
        const std::vector<OwnElement> calls = callsIn(write, *of, stop);
        if (calls.empty())
            add(fmt::format("{} is never called {}", contract.name, name.empty() ? "on this page" : "in " + name),
                fmt::format("a scene that calls it: it is called {}", contract.asked));
        for (std::size_t i = 0; i < contract.mistakes.size(); ++i) {
            const auto verdict = judgeOwn(contract, calls, resultsOf(contract, contract.mistakes[i], calls));
            isShown[i] = isShown[i] || !verdict.isRight();
            isTold[i] = isTold[i] || (verdict.names.size() == 1 && verdict.names[0] == &contract.mistakes[i]);
        }
    }
    for (std::size_t i = 0; i < contract.mistakes.size(); ++i)
        if (!isTold[i])
            add(fmt::format("no scene {} the mistake {}{}", isShown[i] ? "tells" : "shows", contract.mistakes[i].id,
                            isShown[i] ? " from another one" : ""),
                "a trial that does");
    const std::string last = lastLine(write.answer, question.where.file);
    for (const Prose& hint : question.hints)
        for (const std::string& piece : hint.pieces)
            if (piece.find(last) != piece.npos) add("a hint has the last line of the answer", "less");
    if (!run || !errors.empty()) return errors;
    const auto answer = judgedIn(write, scene, write.answer, run, stop);
    if (!answer)
        errors.insert(errors.end(), answer.errors().begin(), answer.errors().end());
    else if (!answer->verdict.isRight())
        add(fmt::format("the answer is wrong in {} of {} calls {}", answer->verdict.wrong, answer->verdict.all,
                        answer->trial.empty() ? "on this page" : "in " + answer->trial));
    // A start that cannot run is as good as a wrong one.
    if (const auto start = judgedIn(write, scene, write.start, run, stop); start && start->verdict.isRight())
        add("the start is right already", "a function that is to be completed");
    return errors;
}

}  // namespace lessons
