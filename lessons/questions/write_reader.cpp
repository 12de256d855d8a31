#include "lessons/questions/write_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/core/text.h"
#include "pipeline/plan/memory_limit.h"
#include "pipeline/scene/settings_table.h"

namespace lessons {

namespace {

using pipeline::inQuotes;

constexpr std::size_t kMostTrials = 4;
constexpr double kMostLines = 40;  // on paper

// The lines below an entry, indented as there, between the head and the end of the function.
std::string functionOf(const pipeline::OwnContract& contract, const Entry* body) {
    const auto lines = body ? std::span(body->value).subspan(1) : std::span<const Line>();
    int margin = lines.empty() ? 0 : lines[0].where.column;  // the column at which the leftmost begins
    for (const Line& line : lines) margin = std::min(margin, line.where.column);
    std::string text = fmt::format("function {} {{\n", signatureOf(contract));
    for (const Line& line : lines)
        text += fmt::format("  {}{}\n", std::string(std::size_t(line.where.column - margin), ' '), line.text);
    return text + (lines.empty() ? "  \n}" : "}");
}

class WriteReader {
public:
    WriteReader(const SceneSource& sceneNamed, const Scope& scope, Complaints& complaints)
        : m_sceneNamed(sceneNamed), m_scope(scope), m_complaints(complaints) {}

    std::optional<WriteQuestion> read(std::span<const Entry> entries, const Entry& named) {
        const auto function = pipeline::findOwn(named.line().text);
        if (!function) {
            std::vector<std::string> known;
            for (std::size_t i = 0; i < pipeline::kOwnCount; ++i)
                known.emplace_back(ownContract(pipeline::OwnFunction(i)).name);
            m_complaints.addUnknown(named.line().where, "function", named.line().text, known);
            return {};
        }
        const Entry* answer = find(entries, "answer");
        if (!answer || answer->value.size() < 2) {
            m_complaints.add(named.where, "no lines of \"answer\" here", "the body of the function, below \"answer:\"");
            return {};
        }
        WriteQuestion write{ownContract(*function), {}, {}, {}, {}, answer->value.size() + 1};
        write.start = functionOf(write.contract, find(entries, "start"));
        write.answer = functionOf(write.contract, answer);
        for (const Entry& entry : entries) {
            if (entry.key == "mistake") write.mistakes.push_back(mistake(entry, write.contract));
            if (entry.key == "trial") trial(entry.line(), write);
            if (entry.key == "tolerance") write.contract.tolerance = number(entry.line(), 0, INFINITY);
            if (entry.key == "lines") write.lines = std::size_t(number(entry.line(), 1, kMostLines));
        }
        return write;
    }

private:
    double number(const Line& line, double least, double most) {
        const auto value = numberIn(line.text);
        if (value && *value >= least && *value <= most) return *value;
        m_complaints.add(line.where, "found " + inQuotes(line.text), fmt::format("a number from {} on", least));
        return least;
    }
    // A wrong answer that the contract knows, and what is said of it.
    Mistake mistake(const Entry& entry, const pipeline::OwnContract& contract) {
        std::vector<std::string> known;
        for (const pipeline::OwnMistake& one : contract.mistakes) known.emplace_back(one.id);
        if (std::ranges::find(known, entry.id) == known.end())
            m_complaints.addUnknown(entry.where, fmt::format("mistake of {}", contract.name), entry.id, known);
        const auto said = std::span(entry.value).subspan(1);
        if (said.empty())
            m_complaints.add(entry.where, "found a mistake without its sentence", "what is said, on the next line");
        return {std::string(entry.id), {}, m_complaints.valueOf(parseProse(said, m_scope)), entry.where};
    }
    // SCENE; KEY = VALUE; …
    void trial(const Line& line, WriteQuestion& write) {
        const std::vector<Line> parts = separated(line, ";");
        auto scene = m_sceneNamed(parts[0].text);
        for (const Line& set : std::span(parts).subspan(1))
            if (scene) scene = pipeline::withSetting(*scene, set.text);
        if (!scene) return m_complaints.add(line.where, scene.errors());
        m_complaints.add(line.where, pipeline::checkSceneAndMemory(*scene));
        if (write.trials.size() == kMostTrials) return m_complaints.add(line.where, "found more trials", "at most 4");
        write.trials.push_back({std::string(line.text), std::move(scene).value()});
    }

    const SceneSource& m_sceneNamed;
    const Scope m_scope;
    Complaints& m_complaints;
};

}  // namespace

std::optional<WriteQuestion> writeFrom(std::span<const Entry> entries, const Entry& write,
                                       const SceneSource& sceneNamed, const Scope& scope, Complaints& complaints) {
    return WriteReader(sceneNamed, scope, complaints).read(entries, write);
}

}  // namespace lessons
