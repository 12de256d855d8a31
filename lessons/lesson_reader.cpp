#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <map>

#include "lessons/lesson.h"
#include "lessons/text_position.h"
#include "pipeline/core/printable.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/plan/memory_limit.h"
#include "pipeline/scene/key_places.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::Errors;
using pipeline::inQuotes;
using pipeline::Result;
using pipeline::SourceLocation;

constexpr std::array<std::string_view, 6> kHeaderKeys{"title", "lecture", "summary", "scene", "set", "let"};
constexpr std::array<std::string_view, 7> kPageKeys{"stage", "buffers", "pixel", "channel", "set", "let", "scene"};
constexpr std::array<std::string_view, 2> kRepeatedKeys{"set", "let"};
constexpr std::array<std::string_view, 6> kQuestionKeys{"question", "answer", "tolerance", "hint", "right", "wrong"};
using Keys = std::span<const std::string_view>;
constexpr std::size_t kMaxLessonBytes = std::size_t{1} << 20;

// "key: value" with the lines that carry it on.
struct Entry {
    std::string_view key;
    SourceLocation where;
    std::vector<Line> value;  // at least one
    const Line& line() const { return value.front(); }
};

Line trimmed(Line line) {
    const auto first = std::min(line.text.find_first_not_of(" \t"), line.text.size());
    const SourceLocation where = advanced(line.where, line.text.substr(0, first));
    const std::string_view text = line.text.substr(first);
    return {text.substr(0, text.find_last_not_of(" \t") + 1), where};
}
bool isBlank(const Line& line) { return trimmed(line).text.empty(); }
bool isHeading(const Line& line) { return line.text.starts_with("# "); }

// A line of the form "word: value", or nothing.
std::optional<Entry> entryIn(const Line& line) {
    const auto end = std::ranges::find_if(line.text, [](char c) { return c < 'a' || c > 'z'; });
    const std::size_t length = std::size_t(end - line.text.begin());
    if (length == 0 || length == line.text.size() || line.text[length] != ':') return {};
    const std::size_t value = length + 1;
    return Entry{line.text.substr(0, length),
                 line.where,
                 {trimmed({line.text.substr(value), advanced(line.where, line.text.substr(0, value))})}};
}

std::vector<Line> linesOf(std::string_view text, const std::string& file) {
    std::vector<Line> lines;
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        if (line.ends_with('\r')) line.remove_suffix(1);
        lines.push_back({line, {file, int(lines.size()) + 1, 1}});
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

// Turns the lines of one file into a lesson, collecting what is wrong on the way.
class Reader {
public:
    Reader(std::string_view text, const std::string& file, const SceneSource& sceneNamed)
        : m_lines(linesOf(text, file)), m_file(file), m_sceneNamed(sceneNamed) {}

    Result<Lesson> read() {
        Lesson lesson;
        header(lesson);
        if (m_at == m_lines.size()) {
            fail({m_file, int(m_lines.size()), 0}, "the file has no page", "a line \"# HEADING\"");
        }
        while (m_at < m_lines.size()) lesson.pages.push_back(page());
        if (m_errors.size() > pipeline::kMaxErrors) m_errors.resize(pipeline::kMaxErrors);
        if (!m_errors.empty()) return m_errors;
        return lesson;
    }

private:
    void fail(const SourceLocation& where, std::string found, std::string expected = {}) {
        m_errors.push_back({where, std::move(found), std::move(expected)});
    }
    // Errors of the pipeline know no place in this file; those of a scene file know their own.
    void fail(const SourceLocation& where, Errors errors) {
        for (Error& error : errors) {
            if (error.where.line == 0) error.where = where;
            m_errors.push_back(std::move(error));
        }
    }
    void failUnknown(const SourceLocation& where, std::string_view kind, std::string_view name,
                     std::vector<std::string> known) {
        fail(where, "no " + std::string(kind) + ' ' + inQuotes(name) + "; " + pipeline::insteadOf(name, known));
    }

    // The entries from here up to a line that is neither blank nor an entry, or begins one of
    // `others`. A line that looks like an entry has to be one.
    std::vector<Entry> entries(Keys keys, Keys others = {}) {
        std::vector<Entry> found;
        for (; m_at < m_lines.size() && !isHeading(m_lines[m_at]); ++m_at) {
            if (isBlank(m_lines[m_at])) continue;
            const auto entry = entryIn(m_lines[m_at]);
            if (!entry || std::ranges::find(others, entry->key) != others.end()) break;
            if (known(*entry, keys, found)) found.push_back(*entry);
        }
        return found;
    }
    bool known(const Entry& entry, Keys keys, const std::vector<Entry>& before) {
        if (std::ranges::find(keys, entry.key) == keys.end()) {
            failUnknown(entry.where, "key", entry.key, {keys.begin(), keys.end()});
            return false;
        }
        if (std::ranges::find(kRepeatedKeys, entry.key) == kRepeatedKeys.end() &&
            std::ranges::find(before, entry.key, &Entry::key) != before.end())
            fail(entry.where, "found " + inQuotes(entry.key) + " a second time", "it once");
        if (!entry.line().text.empty()) return true;
        fail(entry.line().where, "found nothing", "what " + inQuotes(entry.key) + " is");
        return false;
    }

    void header(Lesson& lesson) {
        m_header = entries(kHeaderKeys);
        for (; m_at < m_lines.size() && !isHeading(m_lines[m_at]); ++m_at)
            if (!isBlank(m_lines[m_at]))
                fail(m_lines[m_at].where, "found " + inQuotes(m_lines[m_at].text), "\"key: value\" or \"# HEADING\"");
        for (const auto& [key, text] :
             {std::pair{"title", &lesson.title}, {"lecture", &lesson.lecture}, {"summary", &lesson.summary}})
            if (const Entry* entry = find(m_header, key))
                *text = entry->line().text;
            else
                fail({m_file, 1, 1}, "no " + std::string(key) + " in the header", inQuotes(std::string(key) + ": …"));
    }

    static const Entry* find(const std::vector<Entry>& entries, std::string_view key) {
        const auto found = std::ranges::find(entries, key, &Entry::key);
        return found == entries.end() ? nullptr : &*found;
    }

    // The scene that `entries` or else the header names, with the settings of both.
    std::optional<pipeline::Scene> sceneOf(const std::vector<Entry>& entries, const SourceLocation& page) {
        const Entry* entry = find(entries, "scene");
        if (!entry) entry = find(m_header, "scene");
        if (!entry) {
            fail(page, "no scene for this page", "\"scene: …\" in the header");
            return {};
        }
        const std::string name(entry->line().text);
        auto known = m_scenes.find(name);
        if (known == m_scenes.end()) {  // pages of one scene share its meshes, and say once what is wrong with it
            auto scene = m_sceneNamed(name);
            if (!scene) fail(entry->line().where, scene.errors());
            known = m_scenes.emplace(name, scene ? std::optional(std::move(scene).value()) : std::nullopt).first;
        }
        std::optional<pipeline::Scene> scene = known->second;
        if (!scene) return {};
        const std::vector<Entry>* const lists[] = {&m_header, &entries};
        for (const std::vector<Entry>* list : lists)
            for (const Entry& set : *list) {
                if (set.key != "set") continue;
                auto changed = pipeline::withSetting(*scene, set.line().text);
                if (changed)
                    scene = std::move(changed).value();
                else if (list == &entries || !m_headerChecked)
                    fail(set.line().where, changed.errors());
            }
        m_headerChecked = true;
        fail(page, pipeline::checkSceneAndMemory(*scene));
        return scene;
    }

    Page page() {
        Page page;
        page.where = m_lines[m_at].where;
        page.heading = trimmed({m_lines[m_at].text.substr(2), {}}).text;
        ++m_at;
        const std::vector<Entry> settings = entries(kPageKeys, kQuestionKeys);
        const std::vector<Line> text = textLines();
        const std::vector<Entry> question = questionEntries();
        const auto scene = sceneOf(settings, page.where);
        if (!scene) return page;  // names can only be checked against a scene
        page.state.scene = *scene;
        for (const Entry& entry : settings) apply(entry, page.state);
        if (page.state.buffers.empty()) page.state.buffers.push_back({pipeline::BufferId::Color});
        if (text.empty()) fail(page.where, "this page has no text", "Markdown below its keys");
        const Names names = namesFrom(settings, *scene);
        page.text = prose(text, {*scene, &names});
        if (!question.empty()) page.question = questionFrom(question, *scene, names);
        return page;
    }

    // What the header and the page let names stand for; each may use those before it.
    Names namesFrom(const std::vector<Entry>& page, const pipeline::Scene& scene) {
        Names names;
        for (const std::vector<Entry>* list : {&std::as_const(m_header), &page})
            for (const Entry& entry : *list)
                if (entry.key == "let") let(entry.line(), scene, names);
        return names;
    }
    void let(const Line& line, const pipeline::Scene& scene, Names& names) {
        const std::size_t sign = line.text.find('=');
        if (sign == line.text.npos) return fail(line.where, "found " + inQuotes(line.text), "NAME = EXPRESSION");
        const std::string name(trimmed({line.text.substr(0, sign), {}}).text);
        if (const std::string why = whyNoName(name); !why.empty())
            return fail(line.where, "found the name " + inQuotes(name) + ": " + why);
        auto expression = parseExpression(line.text.substr(sign + 1),
                                          advanced(line.where, line.text.substr(0, sign + 1)), {scene, &names});
        if (!expression) return fail({}, expression.errors());
        if (!names.try_emplace(name, std::move(expression).value()).second)
            fail(line.where, "found the name " + inQuotes(name) + " a second time", "another name");
    }

    // The Markdown of a page, without blank lines around it.
    std::vector<Line> textLines() {
        std::vector<Line> lines;
        bool fenced = false;
        for (; m_at < m_lines.size(); ++m_at) {
            const Line& line = m_lines[m_at];
            if (line.text.starts_with("```")) fenced = !fenced;
            const auto entry = fenced ? std::nullopt : entryIn(line);
            if (entry && std::ranges::find(kQuestionKeys, entry->key) != kQuestionKeys.end()) break;
            if (!fenced && isHeading(line)) break;
            if (!lines.empty() || !isBlank(line)) lines.push_back(line);
        }
        while (!lines.empty() && isBlank(lines.back())) lines.pop_back();
        return lines;
    }

    std::vector<Entry> questionEntries() {
        std::vector<Entry> found;
        for (; m_at < m_lines.size() && !isHeading(m_lines[m_at]); ++m_at) {
            const Line& line = m_lines[m_at];
            const auto entry = entryIn(line);
            if (entry) {
                if (known(*entry, kQuestionKeys, found)) found.push_back(*entry);
            } else if (!isBlank(line) && !found.empty()) {
                if (found.back().key == "answer" || found.back().key == "tolerance")
                    fail(line.where, "found " + inQuotes(line.text), "a key such as \"hint:\"");
                else
                    found.back().value.push_back(trimmed(line));
            }
        }
        return found;
    }

    void apply(const Entry& entry, PageState& state) {
        if (entry.key == "stage") {
            if (const auto stage = pipeline::findStage(entry.line().text)) {
                state.stage = *stage;
            } else {
                std::vector<std::string> names;
                for (const pipeline::StageId id : pipeline::kStages) names.emplace_back(pipeline::stageInfo(id).name);
                failUnknown(entry.line().where, "stage", entry.line().text, names);
            }
        }
        if (entry.key == "channel") {
            const auto channel = std::string_view("rgb").find(entry.line().text);
            if (entry.line().text.size() == 1 && channel != std::string_view::npos)
                state.channel = int(channel);
            else
                fail(entry.line().where, "found " + inQuotes(entry.line().text), "r, g or b");
        }
        if (entry.key == "pixel") pixel(entry.line(), state);
        if (entry.key == "buffers")
            for (const Line& name : commaSeparated(entry.line())) buffer(name, state);
    }
    static std::vector<Line> commaSeparated(const Line& line) {
        std::vector<Line> parts;
        for (Line rest = line;;) {
            const auto end = rest.text.find(',');
            parts.push_back(trimmed({rest.text.substr(0, end), rest.where}));
            if (end == std::string_view::npos) return parts;
            rest = {rest.text.substr(end + 1), advanced(rest.where, rest.text.substr(0, end + 1))};
        }
    }
    void buffer(const Line& name, PageState& state) {
        const auto buffer = pipeline::findBuffer(name.text);
        if (!buffer)
            fail(name.where, "no buffer " + inQuotes(name.text) + "; " + pipeline::insteadOfBuffer(name.text));
        else if (buffer->light >= int(state.scene.lights.size()))
            fail(name.where, "no buffer " + inQuotes(name.text), "a light that the scene has");
        else
            state.buffers.push_back(*buffer);
    }
    void pixel(const Line& line, PageState& state) {
        const std::vector<Line> parts = commaSeparated(line);
        const glm::ivec2 size{state.scene.settings.width, state.scene.settings.height};
        glm::ivec2 pixel{0};
        bool good = parts.size() == 2;
        for (int i = 0; good && i < 2; ++i) {
            const std::string_view text = parts[std::size_t(i)].text;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), pixel[i]);
            good = error == std::errc() && end == text.data() + text.size() && pixel[i] >= 0 && pixel[i] < size[i];
        }
        if (good)
            state.pixel = pixel;
        else
            fail(line.where, "found the pixel " + inQuotes(line.text),
                 "\"x, y\", x from 0 to " + std::to_string(size.x - 1) + ", y from 0 to " + std::to_string(size.y - 1));
    }

    Prose prose(std::span<const Line> lines, const Scope& scope) {
        auto prose = parseProse(lines, scope);
        if (prose) return std::move(prose).value();
        fail({}, prose.errors());
        return {};
    }

    std::optional<Question> questionFrom(const std::vector<Entry>& entries, const pipeline::Scene& scene, Names names) {
        Question question;
        const Entry* const asked = find(entries, "question");
        const Entry* const answer = find(entries, "answer");
        if (!asked || !answer) {
            fail(entries.front().where, std::string("no \"") + (asked ? "answer" : "question") + "\" here",
                 "both a question and its answer");
            return {};
        }
        auto expression = parseExpression(answer->line().text, answer->line().where, {scene, &names});
        for (const auto& [key, text] : {std::pair{"question", &question.text}, {"hint", &question.hint}})
            if (const Entry* entry = find(entries, key)) *text = prose(entry->value, {scene, &names});
        if (expression)
            names.insert_or_assign("answer", question.answer = std::move(expression).value());
        else
            fail({}, expression.errors());
        // What is said after an answer may speak of it.
        for (const auto& [key, text] : {std::pair{"right", &question.right}, {"wrong", &question.wrong}})
            if (const Entry* entry = find(entries, key)) *text = prose(entry->value, {scene, &names});
        if (const Entry* entry = find(entries, "tolerance")) {
            const auto tolerance = numberIn(entry->line().text);
            if (tolerance && *tolerance >= 0)
                question.tolerance = *tolerance;
            else
                fail(entry->line().where, "found " + inQuotes(entry->line().text), "a number from 0 on");
        }
        return question;
    }

    std::vector<Line> m_lines;
    const std::string& m_file;
    const SceneSource& m_sceneNamed;
    std::size_t m_at = 0;  // the next line
    std::vector<Entry> m_header;
    bool m_headerChecked = false;
    std::map<std::string, std::optional<pipeline::Scene>> m_scenes;
    Errors m_errors;
};

// A scene that comes with the program, or a file in the lesson's folder.
Result<pipeline::Scene> sceneFor(std::string_view name, const std::filesystem::path& folder,
                                 const pipeline::Stop& stop) {
    std::vector<std::string> names;
    for (const pipeline::BuiltInScene& scene : pipeline::builtInScenes()) {
        if (scene.name == name) return pipeline::readScene(scene.file, {{}, stop});
        names.push_back(scene.name);
    }
    const std::filesystem::path file = std::filesystem::path(name).filename();  // of this folder alone
    std::error_code ignored;
    if (file == name && std::filesystem::is_regular_file(folder / file, ignored)) {
        const auto inside = pipeline::pathInFolder(folder, name, "lesson");
        return inside ? pipeline::readScene(folder / file, {{}, stop}) : inside.errors();
    }
    return Error{{}, "no scene " + inQuotes(name) + "; " + pipeline::insteadOf(name, names), {}};
}

}  // namespace

Result<Lesson> parseLesson(std::string_view text, const std::string& file, const SceneSource& sceneNamed) {
    return Reader(text, file, sceneNamed).read();
}

Result<Lesson> readLesson(const std::filesystem::path& folder, const pipeline::Stop& stop) {
    const std::filesystem::path file = folder / "lesson.md";
    const auto text = pipeline::readFile(file, kMaxLessonBytes);
    if (!text) return pipeline::namedAt({file.string()}, text.errors());
    auto lesson = parseLesson(pipeline::escapedControls(*text), file.string(),
                              [&](std::string_view name) { return sceneFor(name, folder, stop); });
    if (!lesson) return lesson;
    Lesson named = std::move(lesson).value();
    std::error_code ignored;
    const std::filesystem::path whole = std::filesystem::absolute(folder, ignored).lexically_normal();  // "." and "x/"
    named.folder = folder;
    named.name = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
    return named;
}

}  // namespace lessons
