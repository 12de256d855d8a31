#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "lessons/lesson.h"
#include "lessons/lesson_text.h"
#include "lessons/questions/question_reader.h"
#include "lessons/questions/returning.h"
#include "lessons/window_keys.h"
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
using Keys = std::span<const std::string_view>;

constexpr std::array<std::string_view, 11> kHeaderKeys{"title", "lecture", "minutes", "notions", "summary", "can",
                                                       "next",  "returns", "scene",   "set",     "let"};
constexpr std::array<std::string_view, 6> kFirstKeys{"set", "let", "scene", "hides", "panels", "again"};
constexpr std::array<std::string_view, 3> kSecondKeys{"set", "let", "again"};
constexpr std::array<std::string_view, 5> kRepeatedKeys{"set", "let", "can", "hold", "again"};
constexpr std::array<std::string_view, 4> kAgainKeys{"set", "let", "pixel", "against"};
// Paragraphs for the window or for paper alone; the first one is no key.
constexpr std::string_view kScreenMark = "screen: ", kPaperMark = "paper: ";
constexpr std::array<std::string_view, 2> kMarkWords{"screen", "paper"};
constexpr std::size_t kMostReturns = 9, kMostPages = 1000;
constexpr double kMostMinutes = 600;

bool isHeading(const Line& line) { return line.text.starts_with("# "); }
bool isThen(const Line& line) { return trimmed(line).text == "## then"; }
template <std::size_t n>
std::vector<std::string_view> withWindowKeys(const std::array<std::string_view, n>& keys) {
    std::vector<std::string_view> all(kWindowKeys.begin(), kWindowKeys.end());
    all.insert(all.end(), kHeldKeys.begin(), kHeldKeys.end());
    all.insert(all.end(), keys.begin(), keys.end());
    return all;
}

// Turns the lines of one file into a lesson, collecting what is wrong on the way.
class Reader {
public:
    Reader(std::string_view text, const std::string& file, const SceneSource& sceneNamed)
        : m_lines(linesOf(text, file)), m_file(file), m_sceneNamed(sceneNamed) {}

    // wanted: the numbers of the pages, from 1, that are read, as they return; nothing: all of them, as they are.
    Result<Lesson> read(const std::optional<std::set<std::size_t>>& wanted = {}) {
        Lesson lesson;
        m_returns = wanted.has_value();
        header(lesson);
        if (m_at == m_lines.size())
            m_complaints.add({m_file, int(m_lines.size()), 0}, "the file has no page", "a line \"# HEADING\"");
        for (std::size_t number = 1; m_at < m_lines.size(); ++number)
            lesson.pages.push_back(page(!wanted || wanted->contains(number)));
        if (!m_complaints.empty()) return m_complaints.take();
        return lesson;
    }

private:
    bool isEnd(const Line& line) const { return isHeading(line) || isThen(line); }

    // The entries from here up to a line that is neither blank nor an entry, or begins one of
    // `others`. A line that looks like an entry has to be one.
    std::vector<Entry> entries(Keys keys, Keys others = {}) {
        std::vector<Entry> found;
        for (; m_at < m_lines.size() && !isEnd(m_lines[m_at]); ++m_at) {
            if (isBlank(m_lines[m_at])) continue;
            const auto entry = entryIn(m_lines[m_at]);
            if (!entry && !found.empty() && found.back().key == "play" && m_lines[m_at].text.starts_with("  ")) {
                found.back().value.push_back(trimmed(m_lines[m_at]));
                continue;
            }
            if (!entry || has(others, entry->key) || has(kMarkWords, entry->key)) break;
            if (isKnown(*entry, {keys, kRepeatedKeys, {}, {}}, found, m_complaints)) found.push_back(*entry);
        }
        return found;
    }

    void header(Lesson& lesson) {
        m_header = entries(kHeaderKeys);
        for (; m_at < m_lines.size() && !isHeading(m_lines[m_at]); ++m_at)
            if (!isBlank(m_lines[m_at]))
                m_complaints.add(m_lines[m_at].where, "found " + inQuotes(m_lines[m_at].text),
                                 "\"key: value\" or \"# HEADING\"");
        for (const auto& [key, text] :
             {std::pair{"title", &lesson.title}, {"lecture", &lesson.lecture}, {"summary", &lesson.summary}})
            if (const Entry* entry = find(m_header, key))
                *text = entry->line().text;
            else
                m_complaints.add({m_file, 1, 1}, "no " + std::string(key) + " in the header",
                                 inQuotes(std::string(key) + ": …"));
        if (const Entry* entry = find(m_header, "next")) lesson.next = entry->line().text;
        for (const Entry& entry : m_header)
            if (entry.key == "can") lesson.can.emplace_back(entry.line().text);
        if (const Entry* entry = find(m_header, "notions"))
            for (const Line& notion : separated(entry->line(), ";")) lesson.notions.emplace_back(notion.text);
        if (const Entry* entry = find(m_header, "returns"))
            for (const Line& page : separated(entry->line())) returning(page, lesson);
        if (const Entry* entry = find(m_header, "minutes")) {
            const auto minutes = numberIn(entry->line().text);
            if (minutes && *minutes >= 1 && *minutes <= kMostMinutes && *minutes == std::trunc(*minutes))
                lesson.minutes = int(*minutes);
            else
                m_complaints.add(entry->line().where, "found " + inQuotes(entry->line().text),
                                 "a whole number of minutes from 1 to 600");
        }
    }

    void returning(const Line& line, Lesson& lesson) {
        const auto parts = splitAt(line, "/");
        const auto page = parts ? numberIn(parts->second.text) : std::nullopt;
        if (!page || !(*page >= 1) || !(*page <= double(kMostPages)) || *page != std::trunc(*page))
            return m_complaints.add(line.where, "found " + inQuotes(line.text), "LESSON/PAGE, as back-faces/3");
        if (lesson.returns.size() == kMostReturns)
            return m_complaints.add(line.where, "found more pages that return", "at most 9");
        lesson.returns.push_back({std::string(parts->first.text), std::size_t(*page), line.where});
    }

    // The scene that `entries` or else the header names.
    std::optional<pipeline::Scene> sceneOf(const std::vector<Entry>& entries, const SourceLocation& page) {
        const Entry* entry = find(entries, "scene");
        if (!entry) entry = find(m_header, "scene");
        if (!entry) {
            m_complaints.add(page, "no scene for this page", "\"scene: …\" in the header");
            return {};
        }
        const std::string name(entry->line().text);
        auto known = m_scenes.find(name);
        if (known == m_scenes.end()) {  // pages of one scene share its meshes, and say once what is wrong with it
            auto scene = m_sceneNamed(name);
            if (!scene) m_complaints.add(entry->line().where, scene.errors());
            known = m_scenes.emplace(name, scene ? std::optional(std::move(scene).value()) : std::nullopt).first;
        }
        return known->second;
    }
    // With the settings of these lists, one after the other; checked.
    void set(pipeline::Scene& scene, std::initializer_list<const std::vector<Entry>*> lists,
             const SourceLocation& where) {
        for (const std::vector<Entry>* list : lists)
            for (const Entry& set : *list) {
                if (set.key != "set") continue;
                auto changed = pipeline::withSetting(scene, set.line().text);
                if (changed)
                    scene = std::move(changed).value();
                else if (list != &m_header || !m_headerChecked)
                    m_complaints.add(set.line().where, changed.errors());
            }
        m_headerChecked = true;
        m_complaints.add(where, pipeline::checkSceneAndMemory(scene));
    }

    // Which scene with which settings a window shows, for whoever opens it.
    void name(WindowState& window, const std::vector<Entry>& entries) const {
        const Entry* scene = find(entries, "scene");
        if (!scene) scene = find(m_header, "scene");
        window.scene = scene->line().text;
        for (const std::vector<Entry>* list : {&std::as_const(m_header), &entries})
            for (const Entry& entry : *list)
                if (entry.key == "set") window.set.emplace_back(entry.line().text);
    }

    // Without `isWanted` its lines alone are passed over.
    Page page(bool isWanted) {
        Page page;
        page.where = m_lines[m_at].where;
        page.heading = trimmed({m_lines[m_at].text.substr(2), {}}).text;
        ++m_at;
        const std::vector<Entry> settings = asAsked(entries(withWindowKeys(kFirstKeys), kQuestionKeys));
        const std::vector<Line> text = textLines();
        const std::vector<Entry> question = questionEntries();
        const std::optional<SourceLocation> then =
            m_at < m_lines.size() && isThen(m_lines[m_at]) ? std::optional(m_lines[m_at].where) : std::nullopt;
        std::vector<Entry> thenSettings;
        std::vector<Line> thenText;
        if (then) {
            ++m_at;
            thenSettings = asAsked(entries(withWindowKeys(kSecondKeys)));
            thenText = textLines();
            for (; m_at < m_lines.size() && !isHeading(m_lines[m_at]); ++m_at)
                if (!isBlank(m_lines[m_at]))
                    m_complaints.add(m_lines[m_at].where,
                                     "found " + inQuotes(m_lines[m_at].text) + " after \"## then\"",
                                     "the next page: the question stands before \"## then\"");
        }

        if (!isWanted) return page;
        auto scene = sceneOf(settings, page.where);
        if (!scene) return page;  // names can only be checked against a scene
        set(*scene, {&m_header, &settings}, page.where);
        page.first.state = {*scene, windowFrom(settings, *scene, m_complaints)};
        name(page.first.state.window, settings);
        for (const Entry& entry : settings) apply(entry, page);
        Names names;
        addNames(names, m_header, *scene);
        addNames(names, settings, *scene);
        if (text.empty()) m_complaints.add(page.where, "this page has no text", "Markdown below its keys");
        setText(page.first, text, names);
        page.first.held = heldFrom(settings, *scene, names, {}, m_complaints);
        if (!question.empty()) page.question = questionFrom(question, *scene, m_sceneNamed, names, m_complaints);
        if (!then) return page;

        if (question.empty()) m_complaints.add(*then, "found \"## then\" without a question before it");
        Half half{page.first.state, {}, {}, {}, {}};
        set(half.state.scene, {&thenSettings}, *then);
        if (half.state.scene != page.first.state.scene) names.erase("answer");  // it is a number of the first half
        if (m_complaints.empty()) {  // else what is wrong with the first half is said twice
            std::vector<Entry> both = settings;
            both.insert(both.end(), thenSettings.begin(), thenSettings.end());
            half.state.window = windowFrom(both, half.state.scene, m_complaints);
            name(half.state.window, both);
        }
        if (thenText.empty()) m_complaints.add(*then, "this half has no text", "Markdown below its keys");
        addNames(names, thenSettings, half.state.scene);
        setText(half, thenText, names);
        half.held = heldFrom(thenSettings, half.state.scene, names, page.first.held, m_complaints);
        for (const Entry& entry : thenSettings)
            if (entry.key == "set") half.sets.emplace_back(pipeline::assignedKey(entry.line().text));
        page.then = std::move(half);
        return page;
    }

    // "again: KEY: VALUE" comes in the place of KEY where the page returns, and is passed over where it does not.
    std::vector<Entry> asAsked(const std::vector<Entry>& all) {
        std::vector<Entry> asked;
        for (const Entry& entry : all)
            if (entry.key != "again") asked.push_back(entry);
        for (const Entry& entry : all) {
            if (entry.key != "again") continue;
            const auto other = entryIn(entry.line());
            if (!other || !has(kAgainKeys, other->key))
                m_complaints.add(entry.line().where, "found " + inQuotes(entry.line().text),
                                 "\"set\", \"let\", \"pixel\" or \"against\" with its value");
            else if (m_returns) {
                const auto nameOf = [](const Entry& one) { return splitAt(one.line(), "="); };
                const auto same = std::ranges::find_if(asked, [&](const Entry& one) {
                    const auto name = nameOf(one), otherName = nameOf(*other);
                    return one.key == other->key &&
                           (name ? otherName && name->first.text == otherName->first.text : true);
                });
                same == asked.end() ? asked.push_back(*other) : void(*same = *other);
            }
        }
        return asked;
    }

    // What these entries let names stand for; each may use those before it.
    void addNames(Names& names, const std::vector<Entry>& entries, const pipeline::Scene& scene) {
        for (const Entry& entry : entries)
            if (entry.key == "let") let(entry.line(), scene, names);
    }
    void let(const Line& line, const pipeline::Scene& scene, Names& names) {
        const auto sides = splitAt(line, "=");
        if (!sides) return m_complaints.add(line.where, "found " + inQuotes(line.text), "NAME = EXPRESSION");
        const std::string name(sides->first.text);
        if (const std::string why = whyNoName(name); !why.empty())
            return m_complaints.add(line.where, "found the name " + inQuotes(name) + ": " + why);
        auto expression = parseExpression(sides->second.text, sides->second.where, {scene, &names});
        if (!expression) return m_complaints.add({}, expression.errors());
        if (!names.try_emplace(name, std::move(expression).value()).second)
            m_complaints.add(line.where, "found the name " + inQuotes(name) + " a second time", "another name");
    }

    // The Markdown of a half, without blank lines around it.
    std::vector<Line> textLines() {
        std::vector<Line> lines;
        bool fenced = false;
        for (; m_at < m_lines.size(); ++m_at) {
            const Line& line = m_lines[m_at];
            if (line.text.starts_with("```")) fenced = !fenced;
            const auto entry = fenced ? std::nullopt : entryIn(line);
            if (entry && !has(kMarkWords, entry->key) && has(kQuestionKeys, entry->key)) break;
            if (!fenced && isEnd(line)) break;
            if (!lines.empty() || !isBlank(line)) lines.push_back(line);
        }
        while (!lines.empty() && isBlank(lines.back())) lines.pop_back();
        return lines;
    }
    // Paragraphs that begin with one of the marks are for the window or for paper alone.
    void setText(Half& half, const std::vector<Line>& lines, const Names& names) {
        std::vector<Line> screen, paper;
        bool onScreen = true, onPaper = true, begins = true;
        for (Line line : lines) {
            if (isBlank(line)) {
                begins = true;
            } else if (std::exchange(begins, false)) {
                onScreen = !line.text.starts_with(kPaperMark);
                onPaper = !line.text.starts_with(kScreenMark);
                const std::string_view mark = !onPaper ? kScreenMark : !onScreen ? kPaperMark : "";
                line = {line.text.substr(mark.size()), advanced(line.where, mark)};
            }
            if (onScreen) screen.push_back(line);
            if (onPaper) paper.push_back(line);
        }
        const Scope scope{half.state.scene, &names};
        half.text = m_complaints.valueOf(parseProse(screen, scope));
        if (auto read = parseProse(paper, scope)) half.paper = std::move(read).value();  // its errors are said already
    }

    std::vector<Entry> questionEntries() {
        std::vector<Entry> found;
        for (; m_at < m_lines.size() && !isEnd(m_lines[m_at]); ++m_at) {
            const Line& line = m_lines[m_at];
            const auto entry = entryIn(line);
            if (entry) {
                if (isKnown(*entry, questionKeys(), found, m_complaints)) found.push_back(*entry);
            } else if (!isBlank(line) && !found.empty()) {
                if (goesOn(found.back().key))
                    found.back().value.push_back(trimmed(line));
                else
                    m_complaints.add(line.where, "found " + inQuotes(line.text), "a key such as \"hint:\"");
            }
        }
        return found;
    }

    void apply(const Entry& entry, Page& page) {
        if (entry.key == "hides")
            for (const Line& word : separated(entry.line())) hide(word, page);
        else if (entry.key == "panels")
            for (const Line& word : separated(entry.line())) {
                if (const auto part = partNamed(word.text))
                    page.panels.push_back(*part);
                else
                    m_complaints.addUnknown(word.where, "panel", word.text, {kPartNames.begin(), kPartNames.end()});
            }
    }
    static std::optional<Part> partNamed(std::string_view word) {
        const auto found = std::ranges::find(kPartNames, word);
        return found == kPartNames.end() ? std::nullopt : std::optional(Part(found - kPartNames.begin()));
    }
    void hide(const Line& word, Page& page) {
        if (const auto part = partNamed(word.text))
            page.hiddenParts.push_back(*part);
        else if (const auto name = bufferNamed(word, page.first.state.scene))
            page.hiddenBuffers.push_back(*name);
    }

    std::optional<pipeline::BufferName> bufferNamed(const Line& name, const pipeline::Scene& scene) {
        const auto buffer = pipeline::findBuffer(name.text);
        if (buffer && buffer->light < int(scene.lights.size())) return buffer;
        if (!buffer)
            m_complaints.add(name.where,
                             "no buffer " + inQuotes(name.text) + "; " + pipeline::insteadOfBuffer(name.text));
        else
            m_complaints.add(name.where, "no buffer " + inQuotes(name.text), "a light that the scene has");
        return {};
    }
    std::vector<Line> m_lines;
    const std::string& m_file;
    const SceneSource& m_sceneNamed;
    std::size_t m_at = 0;  // the next line
    std::vector<Entry> m_header;
    bool m_headerChecked = false;
    bool m_returns = false;  // the pages are read as they return
    std::map<std::string, std::optional<pipeline::Scene>> m_scenes;
    Complaints m_complaints;
};

}  // namespace

Result<Lesson> parseOwnPages(std::string_view text, const std::string& file, const SceneSource& sceneNamed) {
    return Reader(text, file, sceneNamed).read();
}

Result<Lesson> parseOutline(std::string_view text, const std::string& file) {
    const SceneSource none;
    return Reader(text, file, none).read(std::set<std::size_t>());
}

Result<Lesson> parseReturning(const LessonText& text, const std::set<std::size_t>& wanted) {
    return Reader(text.text, text.file, text.sceneNamed).read(wanted);
}

}  // namespace lessons
