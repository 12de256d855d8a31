#include "lessons/window_keys.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "lessons/derived_buffer.h"
#include "lessons/expression/expression.h"
#include "lessons/state/selection.h"
#include "lessons/state/shown_words.h"
#include "pipeline/core/text.h"

namespace lessons {

namespace {

using pipeline::inQuotes;

// How the value of a key is written in a state.
enum class Form : std::uint8_t { Words, Numbers, Flag, List };
struct KeyForm {
    std::string_view key, written;  // of the page, of the state
    Form form;
};
constexpr std::array<KeyForm, 8> kStateForms{{{"place", "place", Form::Words},
                                              {"step", "step", Form::Words},
                                              {"algorithm", "algorithm", Form::Flag},
                                              {"arrangement", "arrangement", Form::Words},
                                              {"linked", "linked", Form::Flag},
                                              {"condition", "condition", Form::Words},
                                              {"mix", "mix", Form::Words},
                                              {"selected", "selected", Form::Words}}};
constexpr std::array<KeyForm, 10> kViewForms{{{"shown", "channel", Form::Words},
                                              {"range", "range", Form::Numbers},
                                              {"overlays", "overlays", Form::List},
                                              {"counts", "counts", Form::Words},
                                              {"region", "region", Form::Numbers},
                                              {"against", "against", Form::Words},
                                              {"compare", "compare", Form::Words},
                                              {"wipe", "wipe", Form::Numbers},
                                              {"metric", "metric", Form::Words},
                                              {"difference", "difference", Form::Numbers}}};

// Whether its colours depend on a range: not those of names, nor of bytes, which are colours as they are.
bool hasPaletteRange(const pipeline::BufferInfo& info) {
    return !isOfNames(info) && !(info.palette == pipeline::Palette::Color && info.element == pipeline::Element::UInt8);
}

std::string inTomlQuotes(std::string_view words) {
    std::string text = "\"";
    for (const char c : words) {
        if (c == '"' || c == '\\') text += '\\';
        text += c;
    }
    return text + '"';
}

// Reads the window of one half. What a cue's reader checks is left to it: the keys are written as a state, a line each,
// and its errors get the places of the lines that they come from.
class WindowReader {
public:
    WindowReader(std::span<const Entry> entries, const pipeline::Scene& scene, Complaints& complaints)
        : m_scene(scene), m_complaints(complaints) {
        for (const Entry& entry : entries) m_entries.insert_or_assign(entry.key, &entry);
    }

    WindowState read() {
        WindowState direct;
        if (const Entry* entry = find("stage")) stage(entry->line(), direct);
        if (const Entry* entry = find("channel")) channel(entry->line(), direct);
        if (const Entry* entry = find("pixel"))
            if (const auto place = pixel(separated(entry->line()), entry->line())) direct.pixel = place;
        const std::vector<std::string> buffers = bufferNames();
        write(buffers);
        if (const Entry* entry = find("condition")) checkCondition(entry->line());
        if (const Entry* entry = find("mix")) {
            const auto mix = pipeline::parseMix(entry->line().text, m_scene.lights.size());
            if (!mix) m_complaints.add(entry->line().where, mix.errors().front().found, mix.errors().front().expected);
        }

        auto state = readState(m_text, {});
        if (!state) {
            for (const pipeline::Error& error : state.errors())
                m_complaints.add(placeOf(error), error.found, error.expected);
            return direct;
        }
        WindowState window = std::move(state).value();
        window.stage = direct.stage;
        window.channel = direct.channel;
        window.pixel = direct.pixel;
        window.places = {};
        for (const auto& [key, entry] : m_entries) window.places.add(std::string(key), entry->line().where);
        check(window);
        return window;
    }

private:
    const Entry* find(std::string_view key) const {
        const auto found = m_entries.find(key);
        return found == m_entries.end() ? nullptr : found->second;
    }
    void add(const std::string& line, const pipeline::SourceLocation& where) {
        m_text += line + '\n';
        m_lines.push_back(where);
    }
    pipeline::SourceLocation placeOf(const pipeline::Error& error) const {
        const std::size_t line = std::size_t(std::max(error.where.line, 1));
        return line <= m_lines.size() ? m_lines[line - 1] : pipeline::SourceLocation();
    }

    void stage(const Line& line, WindowState& state) {
        if (const auto stage = pipeline::findStage(line.text)) {
            state.stage = *stage;
            return;
        }
        std::vector<std::string> names;
        for (const pipeline::StageId id : pipeline::kStages) names.emplace_back(pipeline::stageInfo(id).name);
        m_complaints.addUnknown(line.where, "stage", line.text, names);
    }
    void channel(const Line& line, WindowState& state) {
        const auto channel = std::string_view("rgb").find(line.text);
        if (line.text.size() == 1 && channel != std::string_view::npos)
            state.channel = int(channel);
        else
            m_complaints.add(line.where, "found " + inQuotes(line.text), "r, g or b");
    }
    // x and y; `whole` is what the message shows.
    std::optional<std::array<int, 2>> pixel(std::span<const Line> parts, const Line& whole) {
        const glm::ivec2 size{m_scene.settings.width, m_scene.settings.height};
        std::array<int, 2> pixel{};
        bool good = parts.size() == 2;
        for (std::size_t i = 0; good && i < 2; ++i) {
            const std::string_view text = parts[i].text;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), pixel[i]);
            good = error == std::errc() && end == text.data() + text.size() && pixel[i] >= 0 && pixel[i] < size[int(i)];
        }
        if (good) return pixel;
        m_complaints.add(whole.where, "found the pixel " + inQuotes(whole.text),
                         fmt::format("\"x, y\", x from 0 to {}, y from 0 to {}", size.x - 1, size.y - 1));
        return {};
    }
    std::vector<std::string> bufferNames() {
        const Entry* entry = find("buffers");
        if (!entry) return {"color"};
        std::vector<std::string> names;
        for (const Line& name : separated(entry->line())) {
            const auto buffer = pipeline::findAnyBuffer(name.text);
            if (!buffer)
                m_complaints.add(name.where,
                                 "no buffer " + inQuotes(name.text) + "; " + pipeline::insteadOfAnyBuffer(name.text));
            else if (buffer->light >= int(m_scene.lights.size()))
                m_complaints.add(name.where, "no buffer " + inQuotes(name.text), "a light that the scene has");
            else
                names.emplace_back(name.text);
        }
        return names.empty() ? std::vector<std::string>{"color"} : names;
    }

    // "KEY = VALUE" as a state has it; empty where the value is none.
    std::string valueOf(const Line& value, Form form) {
        switch (form) {
            case Form::Words: return inTomlQuotes(value.text);
            case Form::Flag:
                if (value.text == "on" || value.text == "off") return value.text == "on" ? "true" : "false";
                m_complaints.add(value.where, "found " + inQuotes(value.text), "on or off");
                return {};
            case Form::List: {
                std::vector<std::string> words;
                for (const Line& word : separated(value))
                    if (!word.text.empty()) words.push_back(inTomlQuotes(word.text));
                return fmt::format("[{}]", fmt::join(words, ", "));
            }
            case Form::Numbers: return numbers(value);
        }
        return {};
    }
    // "[268, 281]", or a number alone.
    std::string numbers(const Line& value) {
        std::vector<std::string> all;
        for (const Line& part : separated(value)) {
            const auto number = numberIn(part.text);
            if (!number) {
                m_complaints.add(part.where, "found " + inQuotes(part.text), "a number");
                return {};
            }
            all.push_back(pipeline::shortestText(*number));
        }
        return all.size() == 1 ? all[0] : fmt::format("[{}]", fmt::join(all, ", "));
    }
    void writeKey(const KeyForm& form, const Line& value) {
        if (const std::string text = valueOf(value, form.form); !text.empty())
            add(fmt::format("{} = {}", form.written, text), value.where);
    }

    void write(const std::vector<std::string>& buffers) {
        const Entry* space = find("space");
        for (const KeyForm& form : kStateForms)
            if (const Entry* entry = find(form.key)) writeKey(form, entry->line());
        if (!find("arrangement")) add("arrangement = " + inTomlQuotes(usualArrangement(buffers.size(), space)), {});
        if (const Entry* entry = find("pins")) writePins(entry->line());
        if (space || find("camera") || find("options")) writeSpaces(space);
        for (std::size_t i = 0; i < buffers.size(); ++i) {
            add("[[view]]", {});
            add("buffer = " + inTomlQuotes(buffers[i]), {});
            for (const KeyForm& form : kViewForms)
                if (const Entry* entry = find(form.key))
                    if (const auto value = ofView(entry->line(), i, buffers.size());
                        value && (form.key != "range" || takesRange(buffers, i, entry->line())))
                        writeKey(form, *value);
            if (const Entry* entry = find("zoom"))
                if (const auto value = ofView(entry->line(), i, buffers.size())) writeZoom(*value);
        }
    }
    // Buffers alone, or beside a 3D view where the page names a space.
    static std::string usualArrangement(std::size_t buffers, const Entry* space) {
        if (space) return buffers < 2 ? "one" : buffers == 2 ? "two" : "four";
        if (buffers < 3) return buffers == 2 ? "compare" : "buffer";
        if (buffers == 4) return "(buffer | buffer) / (buffer | buffer)";
        std::string text = "buffer";
        for (std::size_t i = 1; i < buffers; ++i) text += " | buffer";
        return text;
    }
    // A range is of one quantity: without ";" it is for the views of the first buffer that has a palette range, and for
    // what has the same unit in the same palette.
    static bool takesRange(const std::vector<std::string>& buffers, std::size_t view, const Line& value) {
        if (separated(value, ";").size() > 1) return true;
        const auto infoOf = [](const std::string& name) -> const pipeline::BufferInfo& {
            return pipeline::bufferInfo(pipeline::findAnyBuffer(name)->id);
        };
        const auto first =
            std::ranges::find_if(buffers, [&](const std::string& name) { return hasPaletteRange(infoOf(name)); });
        if (first == buffers.end()) return view == 0;
        const pipeline::BufferInfo &led = infoOf(*first), &own = infoOf(buffers[view]);
        return own.palette == led.palette && own.unit == led.unit && own.element == led.element;
    }
    // A view's part of a value; nothing where it is empty.
    std::optional<Line> ofView(const Line& value, std::size_t view, std::size_t views) {
        const std::vector<Line> parts = separated(value, ";");
        if (parts.size() > 1 && parts.size() != views && view == 0)
            m_complaints.add(value.where, fmt::format("found values for {} views", parts.size()),
                             fmt::format("one for all, or {} with \";\" between them", views));
        const Line& part = parts[parts.size() == 1 ? 0 : std::min(view, parts.size() - 1)];
        return part.text.empty() ? std::nullopt : std::optional(part);
    }
    // FACTOR at X, Y: the point of the picture in the middle of a view of 640 by 480.
    void writeZoom(const Line& value) {
        const auto sides = splitAt(value, " at ");
        if (!sides)
            return m_complaints.add(value.where, "found " + inQuotes(value.text),
                                    "a factor and a place: \"8 at 268, 281\"");
        const std::string factor = numbers(sides->first), center = numbers(sides->second);
        if (factor.empty() || center.empty()) return;
        add("zoom = " + factor, value.where);
        add("center = " + center, value.where);
        add("size = [640, 480]", value.where);
    }
    // 1: 268, 281; 2: 250, 270
    void writePins(const Line& value) {
        std::vector<std::string> pins;
        for (const Line& pin : separated(value, ";")) {
            const auto sides = splitAt(pin, ":");
            const std::string number = sides ? numbers(sides->first) : std::string();
            const auto place = sides ? pixel(separated(sides->second), sides->second) : std::nullopt;
            if (!sides) m_complaints.add(pin.where, "found " + inQuotes(pin.text), "a pin: \"1: 268, 281\"");
            if (place && !number.empty()) pins.push_back(fmt::format("[{}, {}, {}]", number, (*place)[0], (*place)[1]));
        }
        add(fmt::format("pins = [{}]", fmt::join(pins, ", ")), value.where);
    }
    // Camera and options are those of the first 3D view.
    void writeSpaces(const Entry* space) {
        std::vector<Line> names;
        if (space) names = separated(space->line(), ";");
        if (names.empty()) names.push_back({"world", {}});
        std::vector<std::string> tables;
        for (const Line& name : names) {
            std::string table = "space = " + inTomlQuotes(name.text);
            if (!parseSpace(name.text))
                m_complaints.add(name.where, "found the space " + inQuotes(name.text), kSpaceExpected);
            else if (const auto words = parseSpace(name.text);
                     name.text.starts_with("light") && words->light >= int(m_scene.lights.size()))
                m_complaints.add(name.where, "found the space " + inQuotes(name.text), "a light that the scene has");
            if (&name == &names.front()) table += pairs("camera", ";", {}) + optionsText();
            tables.push_back("{ " + table + " }");
        }
        const Entry* where = space ? space : find("camera") ? find("camera") : find("options");
        add(fmt::format("view3d = [{}]", fmt::join(tables, ", ")), where->line().where);
    }
    std::string optionsText() {
        std::vector<std::string> known;
        for (const SpaceOption& option : kSpaceOptions) known.emplace_back(option.name);
        const std::string options = pairs("options", ",", known);
        return options.empty() ? std::string() : fmt::format(", options = {{ {} }}", options.substr(2));
    }
    // ", KEY = VALUE" of each pair of an entry.
    std::string pairs(std::string_view key, std::string_view separator, const std::vector<std::string>& known) {
        static const std::vector<std::string> kCamera{"target", "right", "up", "forward", "distance", "fov"};
        const std::vector<std::string>& keys = known.empty() ? kCamera : known;
        const Entry* entry = find(key);
        std::string text;
        if (!entry) return text;
        for (const Line& pair : separated(entry->line(), separator)) {
            const auto sides = splitAt(pair, "=");
            if (!sides)
                m_complaints.add(pair.where, "found " + inQuotes(pair.text), "KEY = VALUE");
            else if (std::ranges::find(keys, sides->first.text) == keys.end())
                m_complaints.addUnknown(sides->first.where, known.empty() ? "key of a camera" : "option of a 3D view",
                                        sides->first.text, keys);
            else if (const std::string value = numbers(sides->second); !value.empty())
                text += fmt::format(", {} = {}", sides->first.text, value);
        }
        return text;
    }

    void checkCondition(const Line& line) {
        const auto condition = parseCondition(line.text, line.where, {m_scene});
        if (!condition && !parseNumbers(line.text, line.where, {m_scene})) m_complaints.add({}, condition.errors());
    }
    // What a file alone cannot tell.
    void check(const WindowState& window) {
        if (const Entry* entry = find("overlays"))
            for (const Line& view : separated(entry->line(), ";"))
                for (const Line& word : separated(view))
                    if (!word.text.empty() && std::ranges::find(kOverlayNames, word.text) == kOverlayNames.end())
                        m_complaints.addUnknown(word.where, "overlay", word.text,
                                                {kOverlayNames.begin(), kOverlayNames.end()});
        if (window.selected && !isIn(m_scene, *window.selected))
            m_complaints.add(find("selected")->line().where, "found " + inQuotes(find("selected")->line().text),
                             "something that the scene has");
        if (const Entry* entry = find("place"))
            if (const auto place = pipeline::parsePlace(entry->line().text, m_scene); !place)
                m_complaints.add(entry->line().where, place.errors().front().found, place.errors().front().expected);
        const auto mix = pipeline::parseMix(window.mix, m_scene.lights.size());
        const DerivedRecipe recipe{window.condition, mix ? *mix : pipeline::TermMix()};
        for (const BufferShown& view : window.views)
            if (const auto name = pipeline::findDerived(view.buffer))
                if (const auto buffers = buffersFor(*name, recipe, m_scene); !buffers)
                    m_complaints.add(find("buffers")->line().where, buffers.errors().front().found,
                                     buffers.errors().front().expected);
    }

    const pipeline::Scene& m_scene;
    Complaints& m_complaints;
    std::map<std::string_view, const Entry*> m_entries;
    std::string m_text;                             // the state as TOML
    std::vector<pipeline::SourceLocation> m_lines;  // where each of its lines comes from
};

}  // namespace

WindowState windowFrom(std::span<const Entry> entries, const pipeline::Scene& scene, Complaints& complaints) {
    return WindowReader(entries, scene, complaints).read();
}

}  // namespace lessons
