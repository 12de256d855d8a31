#include "lessons/grading/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/check.h"
#include "lessons/grading/sheet_blanks.h"
#include "lessons/lesson_text.h"
#include "lessons/pages/handout.h"
#include "lessons/questions/judge.h"
#include "pipeline/core/printable.h"
#include "pipeline/core/text.h"
#include "pipeline/export/folder/file_hash.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/key_places.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::Errors;
using pipeline::inQuotes;
using pipeline::Result;

constexpr std::size_t kMaxTemplateBytes = std::size_t{1} << 20, kMostValues = 10000, kMostTries = 1000;
constexpr std::size_t kMostSheets = 500, kMostVaries = 50;
constexpr std::string_view kVary = "vary ", kKeep = "keep:";

// SplitMix64 (Steele, Lea, Flood 2014): the same on every machine.
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EB;
    return x ^ (x >> 31);
}
std::uint64_t drawnFor(std::uint64_t seed, std::size_t sheet, std::size_t attempt, std::string_view key) {
    std::uint64_t state = mixed(seed);
    for (const std::uint64_t part : {std::uint64_t(sheet), std::uint64_t(attempt)}) state = mixed(state ^ part);
    for (const char c : key) state = mixed(state ^ std::uint64_t(static_cast<unsigned char>(c)));
    return state;
}

// Takes the lines of vary and keep out of a lesson's header.
class TemplateReader {
public:
    TemplateReader(const std::string& text, SheetTemplate& made) : m_text(text), m_made(made) {}

    Errors read() {
        bool inHeader = true;
        for (const Line& line : linesOf(m_text, m_made.file)) {
            inHeader &= !line.text.starts_with("# ");
            if (inHeader && line.text.starts_with(kVary))
                readVary({line.text.substr(kVary.size()), at(line, kVary.size())});
            else if (inHeader && line.text.starts_with(kKeep))
                readKeep({line.text.substr(kKeep.size()), at(line, kKeep.size())});
            else
                m_made.text += line.text;
            m_made.text += '\n';
        }
        if (m_made.vary.empty() && m_complaints.empty())
            m_complaints.add({m_made.file, 1, 1}, "nothing varies in this lesson",
                             "\"vary KEY: VALUES\" in its header");
        if (m_made.vary.size() > kMostVaries)
            m_complaints.add({m_made.file, 1, 1}, fmt::format("found {} lines with vary", m_made.vary.size()),
                             "at most 50");
        return m_complaints.empty() ? Errors() : m_complaints.take();
    }

private:
    static pipeline::SourceLocation at(const Line& line, std::size_t more) {
        return advanced(line.where, line.text.substr(0, more));
    }
    void readKeep(const Line& line) {
        const Line condition = trimmed(line);
        m_made.keep.push_back({std::string(condition.text), condition.where});
    }
    void readVary(const Line& line) {
        const auto parts = splitAt(line, ":");
        if (!parts || parts->first.text.empty() || parts->second.text.empty())
            return m_complaints.add(line.where, "found " + inQuotes(line.text), "\"vary KEY: VALUES\"");
        SheetTemplate::Vary vary{std::string(parts->first.text), {}, 0, 0, parts->second.where};
        if (std::ranges::find(m_made.vary, vary.key, &SheetTemplate::Vary::key) != m_made.vary.end())
            m_complaints.add(line.where, "found " + inQuotes(vary.key) + " a second time", "each key once");
        if (parts->second.text.starts_with("pixel of polygon "))
            readPixel(parts->second, vary);
        else
            for (const Line& value : separated(parts->second)) readValues(value, vary);
        m_made.vary.push_back(std::move(vary));
    }
    // 300..700+100, or one value
    void readValues(const Line& line, SheetTemplate::Vary& vary) {
        const auto range = splitAt(line, "..");
        if (!range) return vary.values.emplace_back(line.text), void();
        const auto rest = splitAt(range->second, "+");
        const auto first = numberIn(range->first.text), last = numberIn(rest ? rest->first.text : range->second.text);
        const auto step = rest ? numberIn(rest->second.text) : std::optional(1.0);
        if (!first || !last || !step || !(*step > 0) || !(*last >= *first) ||
            !((*last - *first) / *step < double(kMostValues)))
            return m_complaints.add(line.where, "found " + inQuotes(line.text), "FIRST..LAST+STEP");
        const auto count = std::size_t((*last - *first) / *step + 1e-9) + 1;
        for (std::size_t i = 0; i < count; ++i)
            // Twelve digits: 0.2 + 0.1 is 0.3 for a reader.
            vary.values.push_back(fmt::format("{:.12g}", *first + double(i) * *step));
    }
    // pixel of polygon 2, 12 px inside
    void readPixel(const Line& line, SheetTemplate::Vary& vary) {
        const auto parts = separated(line);
        const auto polygon = numberIn(parts[0].text.substr(std::string_view("pixel of polygon ").size()));
        std::optional<double> inside = 0.0;
        if (parts.size() == 2)
            inside =
                parts[1].text.ends_with(" px inside")
                    ? numberIn(parts[1].text.substr(0, parts[1].text.size() - std::string_view(" px inside").size()))
                    : std::nullopt;
        if (const std::string why = whyNoName(vary.key); !why.empty())
            m_complaints.add(line.where, "found the name " + inQuotes(vary.key), why);
        if (!polygon || !inside || *polygon < 0 || *polygon > 1e9 || *polygon != std::trunc(*polygon) || *inside < 0 ||
            *inside > 1000 || parts.size() > 2)
            return m_complaints.add(line.where, "found " + inQuotes(line.text), "pixel of polygon 2, 12 px inside");
        vary.polygon = std::size_t(*polygon), vary.inside = int(*inside);
    }

    const std::string& m_text;
    SheetTemplate& m_made;
    Complaints m_complaints;
};

// The pixels at which a polygon is seen with nothing else within `inside` pixels along the row and the column.
std::vector<glm::ivec2> pixelsOf(const pipeline::Frame& frame, std::size_t polygon, int inside) {
    std::vector<glm::ivec2> found;
    const auto ids = frame.buffer({pipeline::BufferId::PolygonId});
    if (!ids) return found;
    const int width = int(ids->columns()), height = int(ids->rows());
    const auto is = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < width && y < height &&
               ids->value(std::size_t(x), std::size_t(y)) == double(polygon);
    };
    for (int y = inside; y < height - inside; ++y)
        for (int x = inside; x < width - inside; ++x) {
            bool all = is(x, y);
            for (int d = 1; all && d <= inside; ++d) all = is(x - d, y) && is(x + d, y) && is(x, y - d) && is(x, y + d);
            if (all) found.emplace_back(x, y);
        }
    return found;
}

// One answer, as far as two of them can be compared.
struct Answer {
    std::string text;
    std::optional<double> number;
    double tolerance = 0;
    bool differsFrom(const Answer& other) const {
        if (!number || !other.number) return text != other.text;
        return std::abs(*number - *other.number) > std::max(tolerance, other.tolerance);
    }
};

class Maker {
public:
    Maker(const SheetTemplate& made, const SheetOptions& options, const pipeline::Stop& stop)
        : m_made(made), m_options(options), m_stop(stop) {}

    // The next sheet, or why there is none.
    Result<std::pair<Sheet, Lesson>> next(std::size_t number) {
        Errors last;
        for (std::size_t attempt = 0; attempt < kMostTries; ++attempt) {
            if (m_stop.stop_requested()) return Error{{}, "stopped", {}};
            Sheet sheet{number, {}, {}, {}};
            auto lesson = drawnSheet(sheet, attempt, last);
            if (!lesson) continue;
            sheet.answers.clear();
            for (const Answer& answer : m_answers.back()) sheet.answers.push_back(answer.text);
            return std::pair(std::move(sheet), *std::move(lesson));
        }
        if (m_stop.stop_requested()) return Error{{}, "stopped", {}};
        Errors errors{{{m_made.file, 1, 1},
                       fmt::format("none of 1000 draws fits as sheet {}", number),
                       "more values to vary, or less to keep"}};
        errors.insert(errors.end(), last.begin(), last.end());
        return errors;
    }

private:
    std::optional<Lesson> parsed(const std::string& text, Errors& errors) {
        auto lesson = parseLesson(text, m_made.file, [&](std::string_view name) {
            auto known = m_scenes.find(name);
            if (known == m_scenes.end())
                known = m_scenes.emplace(std::string(name), sceneOfLesson(name, m_made.folder, m_stop)).first;
            return known->second;
        });
        if (!lesson) {
            errors = lesson.errors();
            return {};
        }
        Lesson made = std::move(lesson).value();
        made.folder = m_made.folder;
        return made;
    }

    // Nothing where it does not fit; `errors` says why.
    std::optional<Lesson> drawnSheet(Sheet& sheet, std::size_t attempt, Errors& errors) {
        std::string before;  // what is put before the first page
        for (const SheetTemplate::Vary& vary : m_made.vary) {
            if (vary.values.empty()) continue;
            const std::uint64_t drawn = drawnFor(m_options.seed, sheet.number, attempt, vary.key);
            sheet.drawn.emplace_back(vary.key, vary.values[drawn % vary.values.size()]);
            before += fmt::format("set: {} = {}\n", vary.key, sheet.drawn.back().second);
        }
        std::map<std::string, std::string> pixels;
        if (!drawPixels(sheet, attempt, before, pixels, errors)) return {};
        sheet.text = withDrawn(before, pixels);
        auto lesson = parsed(sheet.text, errors);
        if (!lesson || !keeps(lesson->pages.front().first.state.scene, pixels, errors)) return {};
        std::vector<Answer> answers;
        bool answered = true;
        const bool all = runPages(*lesson, m_stop, [&](const Page& page, std::size_t, const PageFrames& frames) {
            const Context context{.frame = *frames.first, .stop = m_stop};
            if (answered && page.question) answered = addAnswer(*page.question, context, answers, errors);
        });
        if (!all || !answered) return {};
        if (!isApart(answers)) {
            errors = {{{m_made.file, 1, 1}, "its answers are those of a sheet before it", {}}};
            return {};
        }
        if (const Errors wrong = checkLesson(*lesson, m_stop); !wrong.empty()) {
            errors = wrong;
            return {};
        }
        m_answers.push_back(std::move(answers));
        return lesson;
    }

    // From a frame with the settings that were drawn before.
    bool drawPixels(Sheet& sheet, std::size_t attempt, const std::string& before,
                    std::map<std::string, std::string>& pixels, Errors& errors) {
        std::optional<pipeline::FramePtr> frame;
        for (const SheetTemplate::Vary& vary : m_made.vary) {
            if (!vary.values.empty()) continue;
            if (!frame) {
                std::map<std::string, std::string> anywhere;  // until they are drawn
                for (const SheetTemplate::Vary& other : m_made.vary)
                    if (other.values.empty()) anywhere[other.key] = "0, 0";
                const auto lesson = parsed(withDrawn(before, anywhere), errors);
                if (!lesson) return false;
                pipeline::FrameRequest request;
                request.wanted.set(index(pipeline::BufferId::PolygonId));
                request.stop = m_stop;
                frame = runFrame(std::make_shared<const pipeline::Scene>(lesson->pages.front().first.state.scene),
                                 request, nullptr);
            }
            if (!*frame) return false;
            const auto found = pixelsOf(**frame, vary.polygon, vary.inside);
            if (found.empty()) {
                errors = {{vary.where, fmt::format("no pixel of polygon {} is {} px inside", vary.polygon, vary.inside),
                           "a polygon that is seen, or fewer pixels"}};
                return false;
            }
            const std::uint64_t drawn = drawnFor(m_options.seed, sheet.number, attempt, vary.key);
            const glm::ivec2 at = found[drawn % found.size()];
            pixels[vary.key] = fmt::format("{}, {}", at.x, at.y);
            sheet.drawn.emplace_back(vary.key, pixels[vary.key]);
        }
        return true;
    }

    // The lesson with its settings, and the pixels in place of their names.
    std::string withDrawn(const std::string& before, const std::map<std::string, std::string>& pixels) const {
        std::string text, names;
        for (const auto& [name, place] : pixels) {
            const std::size_t comma = place.find(',');
            names += fmt::format("let: {0}_x = {1}\nlet: {0}_y = {2}\n", name, place.substr(0, comma),
                                 place.substr(comma + 2));
        }
        bool inHeader = true;
        for (const Line& line : linesOf(m_made.text, m_made.file)) {
            if (inHeader && line.text.starts_with("# ")) {
                inHeader = false;
                text += before + names;
            }
            const auto entry = entryIn(line);
            const auto place =
                entry && entry->key == "pixel" ? pixels.find(std::string(entry->line().text)) : pixels.end();
            text += place == pixels.end() ? std::string(line.text) : "pixel: " + place->second;
            text += '\n';
        }
        return text;
    }

    // In the frame of this scene, before the pages are run: most draws that do not fit fail here.
    bool keeps(const pipeline::Scene& drawn, const std::map<std::string, std::string>& pixels, Errors& errors) {
        const auto scene = std::make_shared<const pipeline::Scene>(drawn);
        Names names;
        const auto name = [&](const std::string& word, std::string_view value) {
            if (auto read = parseExpression(value, {}, {*scene})) names[word] = std::move(read).value();
        };
        for (const auto& [word, place] : pixels) {
            const std::size_t comma = place.find(',');
            name(word + "_x", place.substr(0, comma)), name(word + "_y", place.substr(comma + 2));
        }
        for (const SheetTemplate::Keep& keep : m_made.keep) {
            const auto condition = parseExpression(keep.condition, keep.where, {*scene, &names});
            if (!condition || condition->root.type != Type::Truth) {
                errors = condition ? Errors{{keep.where, "found " + inQuotes(keep.condition), "a condition"}}
                                   : condition.errors();
                return false;
            }
            pipeline::FrameRequest request;
            request.wanted = condition->buffers;
            request.stop = m_stop;
            const auto own = runFrame(scene, request, nullptr);
            const auto holds = own ? evaluate(*condition, {.frame = *own, .stop = m_stop}) : Error{{}, "stopped", {}};
            if (!holds || holds->numbers[0] != 1) {
                errors = holds ? Errors{{keep.where, "it does not hold", {}}} : holds.errors();
                return false;
            }
        }
        return true;
    }

    bool addAnswer(const Question& question, const Context& context, std::vector<Answer>& answers, Errors& errors) {
        const auto text = answerText(question, context);
        if (!text) {
            errors = text.errors();
            return false;
        }
        Answer answer{*text, {}, 0};
        if (const auto* number = std::get_if<NumberQuestion>(&question.kind))
            if (const auto value = evaluate(number->answer, context)) {
                answer.number = value->numbers[0];
                answer.tolerance = toleranceOf(*number, *answer.number);
            }
        answers.push_back(std::move(answer));
        return true;
    }

    // More than half of the numbers asked for differ from each sheet before; where none is asked for, some answer does.
    bool isApart(const std::vector<Answer>& answers) const {
        for (const std::vector<Answer>& before : m_answers) {
            std::size_t numbers = 0, apart = 0, differing = 0;
            for (std::size_t i = 0; i < std::min(answers.size(), before.size()); ++i) {
                const bool differs = answers[i].differsFrom(before[i]);
                numbers += answers[i].number.has_value();
                apart += answers[i].number && differs;
                differing += differs;
            }
            if (numbers > 0 ? 2 * apart <= numbers : differing == 0) return false;
        }
        return true;
    }

    const SheetTemplate& m_made;
    const SheetOptions& m_options;
    const pipeline::Stop& m_stop;
    std::map<std::string, Result<pipeline::Scene>, std::less<>> m_scenes;
    std::vector<std::vector<Answer>> m_answers;  // of the sheets so far
};

}  // namespace

Result<SheetTemplate> readSheetTemplate(const std::filesystem::path& folder) {
    SheetTemplate made;
    made.folder = folder;
    made.file = (folder / "lesson.md").string();
    const auto text = pipeline::readFile(made.file, kMaxTemplateBytes);
    if (!text) return pipeline::namedAt({made.file}, text.errors());
    const std::string escaped = pipeline::escapedControls(*text);
    const Errors errors = TemplateReader(escaped, made).read();
    if (!errors.empty()) return errors;
    return made;
}

Result<Sheets> makeSheets(const SheetTemplate& made, const SheetOptions& options, const pipeline::Stop& stop,
                          const std::function<void(std::size_t sheet)>& progress) {
    if (options.count < 1 || options.count > kMostSheets)
        return Error{{}, fmt::format("{} sheets", options.count), "1 to 500"};
    Maker maker(made, options, stop);
    Sheets sheets;
    for (std::size_t i = 0; i < options.count; ++i) {
        if (progress) progress(i);
        auto next = maker.next(i + 1);
        if (!next) return next.errors();
        auto [sheet, lesson] = std::move(next).value();
        sheet.draw = drawNumber(sheet);
        lesson.title += fmt::format(", sheet {}", sheet.number);
        lesson.lecture += fmt::format("{}draw {}", lesson.lecture.empty() ? "" : ", ", sheet.draw);
        const auto handout = makeHandout(lesson, stop);
        if (!handout) return handout.errors();
        if (i == 0) sheets.leftOut = handout->leftOut;
        sheets.pages.push_back(blanked(*handout, options.blanks, drawnFor(options.seed, sheet.number, 0, "blanks")));
        sheets.sheets.push_back(std::move(sheet));
    }
    return sheets;
}

}  // namespace lessons
