#include "lessons/questions/question_reader.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "lessons/questions/misconceptions.h"
#include "lessons/questions/write_reader.h"
#include "pipeline/core/index_words.h"
#include "pipeline/core/text.h"
#include "pipeline/scene/settings_table.h"

namespace lessons {

namespace {

using pipeline::inQuotes;

constexpr std::size_t kMostOptions = 9, kMostHints = 9;  // one digit each
constexpr double kMostPoints = 10;

// Turns the entries of one question into it.
class QuestionReader {
public:
    QuestionReader(std::span<const Entry> entries, const pipeline::Scene& scene, const SceneSource& sceneNamed,
                   Names& names, Complaints& complaints)
        : m_entries(entries), m_scene(scene), m_sceneNamed(sceneNamed), m_names(names), m_complaints(complaints) {}

    std::optional<Question> read() {
        Question question;
        question.where = m_entries.front().where;
        const Entry *plain = find("question"), *asked = plain ? plain : find("prediction");
        if (!asked || (plain && find("prediction")))
            return m_complaints.add(question.where, asked ? "found two questions" : "no \"question\" here",
                                    "both a question and its answer"),
                   std::nullopt;
        question.isPrediction = !plain;
        question.text = prose(asked->value);
        for (const Entry& entry : m_entries)
            if (entry.key == "hint") question.hints.push_back(prose(entry.value));
        if (question.hints.size() > kMostHints)
            m_complaints.add(question.where, fmt::format("found {} hints", question.hints.size()), "at most 9");
        if (!readKind(question)) return {};
        // What is said after an answer may speak of it.
        question.works = textOf("works");
        question.right = textOf("right");
        question.wrong = textOf("wrong");
        question.paper = textOf("paper");
        if (const Entry* entry = find("points")) question.points = number(entry->line(), 0.5, kMostPoints).value_or(1);
        refuseOthers(question);
        return question;
    }

private:
    const Entry* find(std::string_view key) const { return lessons::find(m_entries, key); }
    Scope scope(bool mayPick = false) const { return {m_scene, &m_names, mayPick}; }
    Prose prose(std::span<const Line> lines) { return m_complaints.valueOf(parseProse(lines, scope())); }
    Prose textOf(std::string_view key) {
        const Entry* entry = find(key);
        return entry ? prose(entry->value) : Prose();
    }
    std::optional<double> number(const Line& line, double least, double most) {
        const auto value = numberIn(line.text);
        if (value && *value >= least && *value <= most) return value;
        m_complaints.add(line.where, "found " + inQuotes(line.text),
                         std::isfinite(most) ? fmt::format("a number from {} to {}", least, most)
                                             : fmt::format("a number from {} on", least));
        return {};
    }
    // An expression of this type at the line.
    Expression expression(const Line& line, Type type, bool mayPick = false) {
        auto read = parseExpression(line.text, line.where, scope(mayPick));
        if (!read) {
            m_complaints.add({}, read.errors());
            return {};
        }
        if (read->root.type != type)
            m_complaints.add(line.where, "found " + inQuotes(line.text),
                             type == Type::Number  ? "one number"
                             : type == Type::Truth ? "a condition, such as verdict(3) = kept"
                                                   : "a place: [x, y]");
        return std::move(read).value();
    }
    void checkId(std::string_view id, const pipeline::SourceLocation& where) {
        if (id.empty() || findMisconception(id)) return;
        std::vector<std::string> known;
        for (const Misconception& row : misconceptions().rows) known.push_back(row.id);
        m_complaints.addUnknown(where, "row in lessons/misconceptions.md for the mistake", id, known);
    }

    bool readKind(Question& question) {
        if (find("choice")) {
            question.kind = ChoiceQuestion{options("choice")};
        } else if (find("several")) {
            SeveralQuestion several{options("several"), {}};
            for (const Entry& entry : m_entries)
                if (entry.key == "mistake") {
                    if (entry.line().text != "opposite")
                        m_complaints.add(entry.line().where, "found " + inQuotes(entry.line().text), "\"opposite\"");
                    several.opposite = mistake(entry, {});
                }
            question.kind = std::move(several);
        } else if (const Entry* entry = find("click")) {
            return readClick(*entry, question);
        } else if (const Entry* until = find("until")) {
            return readUntil(*until, question);
        } else if (find("order")) {
            readOrder(question);
        } else if (const Entry* write = find("write")) {
            auto read = writeFrom(m_entries, *write, m_sceneNamed, scope(), m_complaints);
            if (!read) return false;
            question.kind = std::move(*read);
        } else if (const Entry* differs = find("differs")) {
            readStages(*differs, question);
        } else if (const Entry* answer = find("answer")) {
            readNumber(*answer, question);
        } else {
            m_complaints.add(question.where, "no \"answer\" here", "both a question and its answer");
            return false;
        }
        return true;
    }

    void readNumber(const Entry& answer, Question& question) {
        NumberQuestion number;
        number.answer = expression(answer.line(), Type::Number);
        if (const Entry* entry = find("tolerance")) {
            Line line = entry->line();
            number.relative = line.text.ends_with('%');
            if (number.relative) line.text.remove_suffix(1);
            number.tolerance = this->number(line, 0, number.relative ? 50 : INFINITY).value_or(0);
            if (number.relative) number.tolerance /= 100;
        }
        if (const Entry* entry = find("unit")) number.unit = entry->line().text;
        for (const Entry& entry : m_entries)
            if (entry.key == "mistake") number.mistakes.push_back(mistake(entry, Type::Number));
        m_names.insert_or_assign("answer", number.answer);
        question.kind = std::move(number);
    }

    Mistake mistake(const Entry& entry, std::optional<Type> type, bool mayPick = false) {
        if (entry.id.empty()) m_complaints.add(entry.where, "found a mistake without an id", "\"mistake ID: …\"");
        checkId(entry.id, entry.where);
        Mistake mistake{std::string(entry.id), {}, {}, entry.where};
        if (type) mistake.value = expression(entry.line(), *type, mayPick);
        const std::span<const Line> said = std::span(entry.value).subspan(1);
        if (said.empty())
            m_complaints.add(entry.where, "found a mistake without its sentence", "what is said, on the next line");
        else
            mistake.said = prose(said);
        return mistake;
    }

    std::vector<Option> options(std::string_view key) {
        std::vector<Option> all;
        for (const Entry& entry : m_entries)
            if (entry.key == key) all.push_back(option(entry));
        if (all.size() < 2 || all.size() > kMostOptions)
            m_complaints.add(find(key)->where, "found " + pipeline::plural(std::int64_t(all.size()), "option"),
                             "2 to 9 lines with " + inQuotes(key));
        return all;
    }
    // TEXT | if CONDITION | polygon 3 | said
    Option option(const Entry& entry) {
        checkId(entry.id, entry.where);
        Option option{{}, {}, {}, std::string(entry.id), {}, entry.where};
        std::vector<Line> parts = separated(entry.line(), " | ");
        option.text = prose(std::span(parts).first(1));
        std::vector<Line> said;
        bool hasCondition = false;
        for (const Line& part : std::span(parts).subspan(1)) {
            if (part.text.starts_with("if ") && !hasCondition) {
                hasCondition = true;
                option.holds = expression({part.text.substr(3), advanced(part.where, "if ")}, Type::Truth);
            } else if (const auto thing = thingIn(part); thing && !option.thing) {
                option.thing = thing;
            } else {
                said.push_back(part);
            }
        }
        said.insert(said.end(), entry.value.begin() + 1, entry.value.end());
        if (!said.empty()) option.said = prose(said);
        if (!hasCondition)
            m_complaints.add(entry.where, "found an option without its condition",
                             "TEXT | if CONDITION | what is said");
        return option;
    }
    // "polygon 3", or nothing.
    std::optional<Thing> thingIn(const Line& part) {
        const auto split = splitAt(part, " ");
        const auto kind = split ? thingNamed(split->first.text) : std::nullopt;
        if (!kind || *kind == ThingKind::Pixel) return {};
        const std::string_view digits = split->second.text;
        std::size_t index = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
        if (error != std::errc() || end != digits.data() + digits.size()) return {};
        if (const std::size_t count = countOf(*kind, m_scene); index >= count)
            m_complaints.add(split->second.where, fmt::format("found {} {}", name(*kind), index),
                             count == 0 ? "one that the scene has" : pipeline::indexWords(count, "one from "));
        return Thing{*kind, index};
    }

    bool readClick(const Entry& entry, Question& question) {
        ClickQuestion click;
        const auto kind = thingNamed(entry.line().text);
        const Entry *answer = find("answer"), *near = find("near");
        if (!kind)
            m_complaints.add(entry.line().where, "found " + inQuotes(entry.line().text),
                             "pixel, polygon, vertex, object or light");
        if (!answer == !near) {
            m_complaints.add(entry.where, answer ? "found both \"answer\" and \"near\"" : "no \"answer\" here",
                             "\"answer: CONDITION\" over what was clicked, or \"near: PLACE within N px\"");
            return false;
        }
        click.kind = kind.value_or(ThingKind::Pixel);
        if (answer) click.holds = expression(answer->line(), Type::Truth, true);
        if (near) readNear(near->line(), click);
        for (const Entry& one : m_entries)
            if (one.key == "mistake") click.mistakes.push_back(mistake(one, Type::Truth, true));
        question.kind = std::move(click);
        return true;
    }
    // PLACE within 6 px
    void readNear(const Line& line, ClickQuestion& click) {
        const auto parts = splitAt(line, " within ");
        if (!parts || !parts->second.text.ends_with("px") || click.kind != ThingKind::Pixel)
            return m_complaints.add(line.where, "found " + inQuotes(line.text),
                                    "for \"click: pixel\", a place and a distance: \"[268, 281] within 6 px\"");
        Line distance = parts->second;
        distance.text.remove_suffix(2);
        click.within = number(trimmed(distance), 0, 1e6).value_or(0);
        click.near = expression(parts->first, Type::Vector);
        if (click.near->root.size != 2) m_complaints.add(line.where, "found no place", "two numbers: [x, y]");
        const std::string place = fmt::format("({})", parts->first.text);
        const std::string condition =
            fmt::format("length([pick.x, pick.y] - {}) <= {}", place, pipeline::shortestText(click.within));
        if (auto holds = parseExpression(condition, line.where, scope(true))) click.holds = std::move(holds).value();
    }

    bool readUntil(const Entry& entry, Question& question) {
        UntilQuestion until;
        until.holds = expression(entry.line(), Type::Truth);
        const Entry *free = find("free"), *answer = find("answer");
        if (!free || !answer) {
            m_complaints.add(entry.where, std::string("no \"") + (free ? "answer" : "free") + "\" here",
                             "\"free: KEY, …\" and \"answer: KEY = VALUE, …\"");
            return false;
        }
        for (const Line& key : separated(free->line())) {
            const auto setting = pipeline::findSetting(m_scene, key.text);
            if (!setting) m_complaints.add(key.where, setting.errors());
            until.free.emplace_back(key.text);
        }
        for (const Line& part : separated(answer->line(), "; ")) setValue(part, until);
        for (const Entry& one : m_entries)
            if (one.key == "mistake") until.mistakes.push_back(mistake(one, Type::Truth));
        question.kind = std::move(until);
        return true;
    }
    // KEY = EXPRESSION, or KEY = WORD where the setting is a choice
    void setValue(const Line& part, UntilQuestion& until) {
        const auto sides = splitAt(part, "=");
        if (!sides) return m_complaints.add(part.where, "found " + inQuotes(part.text), "KEY = VALUE");
        UntilQuestion::Setting value{std::string(sides->first.text), {}, {}};
        if (std::ranges::find(until.free, value.key) == until.free.end())
            return m_complaints.addUnknown(sides->first.where, "free setting", value.key, until.free);
        const auto setting = pipeline::findSetting(m_scene, value.key);
        if (!setting) return;  // said of "free"
        if (setting->setting->choices.empty())
            value.number = expression(sides->second, Type::Number);
        else if (const auto choices = setting->setting->choices;
                 std::ranges::find(choices, sides->second.text) == choices.end())
            m_complaints.addUnknown(sides->second.where, "choice", sides->second.text,
                                    {choices.begin(), choices.end()});
        else
            value.word = sides->second.text;
        until.answer.push_back(std::move(value));
    }

    // TEXT | by EXPRESSION, or TEXT | stage NAME
    void readOrder(Question& question) {
        OrderQuestion order;
        for (const Entry& entry : m_entries)
            if (entry.key == "order") order.items.push_back(orderItem(entry));
        if (order.items.size() < 2 || order.items.size() > kMostOptions)
            m_complaints.add(find("order")->where,
                             "found " + pipeline::plural(std::int64_t(order.items.size()), "item"),
                             "2 to 9 lines with \"order\"");
        if (const Entry* entry = find("ends")) {
            if (const auto ends = splitAt(entry->line(), " | "))
                order.first = ends->first.text, order.last = ends->second.text;
            else
                m_complaints.add(entry->line().where, "found " + inQuotes(entry->line().text), "nearest | farthest");
        }
        for (const Entry& entry : m_entries)
            if (entry.key == "mistake")
                order.mistakes.push_back({mistake(entry, {}), lettersIn(entry, order.items.size())});
        question.kind = std::move(order);
    }
    OrderItem orderItem(const Entry& entry) {
        OrderItem item{{}, {}, {}, entry.where};
        const std::vector<Line> parts = separated(entry.line(), " | ");
        item.text = prose(std::span(parts).first(1));
        const Line key = parts.size() == 2 ? parts[1] : Line{"", entry.where};
        if (key.text.starts_with("by ")) {
            item.key = expression({key.text.substr(3), advanced(key.where, "by ")}, Type::Number);
        } else if (key.text.starts_with("stage ")) {
            item.stage = pipeline::findStage(key.text.substr(6));
            if (!item.stage) refuseStage({key.text.substr(6), key.where});
            item.key.root.number = double(index(item.stage.value_or(pipeline::StageId{})));
        } else {
            m_complaints.add(key.where, "found an item without its place",
                             "TEXT | by EXPRESSION, or TEXT | stage NAME");
        }
        return item;
    }
    // "C, A, B"; nothing for "opposite".
    std::vector<std::size_t> lettersIn(const Entry& entry, std::size_t count) {
        std::vector<std::size_t> order;
        if (entry.line().text == "opposite") return order;
        for (const Line& part : separated(entry.line()))
            if (part.text.size() == 1) order.push_back(std::size_t(part.text[0] - 'A'));
        if (!isOrderOf(order, count))
            m_complaints.add(entry.line().where, "found " + inQuotes(entry.line().text),
                             "\"opposite\", or each item's letter once: C, A, B");
        return order;
    }
    void refuseStage(const Line& word) {
        std::vector<std::string> names;
        for (const pipeline::StageId stage : pipeline::kStages) names.emplace_back(stageInfo(stage).name);
        m_complaints.addUnknown(word.where, "stage", word.text, names);
    }

    // The six stages as options: the first one that differs with these changes is right.
    void readStages(const Entry& differs, Question& question) {
        constexpr std::string_view kCall = "first_difference(";
        pipeline::SourceLocation where = differs.line().where;
        where.column -= int(kCall.size());  // of what stands before the changes
        ChoiceQuestion choice{{}, true};
        for (const pipeline::StageId stage : pipeline::kStages) {
            Option option{{}, {}, {}, {}, {}, differs.where};
            option.text = prose(std::array{Line{stageInfo(stage).label, differs.line().where}});
            const std::string holds = fmt::format("{}{}) = {}", kCall, differs.line().text, stageInfo(stage).name);
            auto read = parseExpression(holds, where, scope());
            if (!read) return m_complaints.add(where, read.errors());
            option.holds = std::move(read).value();
            choice.options.push_back(std::move(option));
        }
        for (const Entry& entry : m_entries) {
            if (entry.key != "mistake") continue;
            const Mistake known = mistake(entry, {});
            if (const auto stage = pipeline::findStage(entry.line().text))
                choice.options[index(*stage)].mistake = known.id, choice.options[index(*stage)].said = known.said;
            else
                refuseStage(entry.line());
        }
        question.kind = std::move(choice);
    }

    // Keys that belong to another kind of question.
    void refuseOthers(const Question& question) {
        const std::string_view kind = kindName(question);
        const auto refuse = [&](std::string_view key, std::initializer_list<std::string_view> kinds) {
            if (const Entry* entry = find(key); entry && std::ranges::find(kinds, kind) == kinds.end())
                m_complaints.add(entry->where, fmt::format("found \"{}\" in a question of kind {}", key, kind),
                                 fmt::format("it in one of kind {}", fmt::join(kinds, ", ")));
        };
        if (const Entry* entry = find("answer"); entry && kind != "write" && entry->value.size() > 1)
            m_complaints.add(entry->value[1].where, "found " + inQuotes(entry->value[1].text),
                             "a key such as \"hint:\"");
        refuse("answer", {"number", "click", "until", "write"});
        refuse("tolerance", {"number", "write"});
        for (const std::string_view of : {"start", "trial", "lines"}) refuse(of, {"write"});
        refuse("unit", {"number"});
        refuse("near", {"click"});
        refuse("free", {"until"});
        refuse("ends", {"order"});
        if (!find("differs")) refuse("mistake", {"number", "click", "until", "several", "order", "write"});
        for (const std::string_view other : {"choice", "several", "click", "until", "order", "write"})
            refuse(other, {other});
    }

    std::span<const Entry> m_entries;
    const pipeline::Scene& m_scene;
    const SceneSource& m_sceneNamed;
    Names& m_names;
    Complaints& m_complaints;
};

}  // namespace

std::optional<Question> questionFrom(std::span<const Entry> entries, const pipeline::Scene& scene,
                                     const SceneSource& sceneNamed, Names& names, Complaints& complaints) {
    return QuestionReader(entries, scene, sceneNamed, names, complaints).read();
}

}  // namespace lessons
