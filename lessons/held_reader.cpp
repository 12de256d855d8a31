#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "lessons/expression/value.h"
#include "lessons/held.h"
#include "pipeline/core/text.h"
#include "pipeline/scene/object_matrix.h"
#include "pipeline/scene/vertex_settings.h"
#include "pipeline/scene/view.h"

namespace lessons {

namespace {

using pipeline::Hold;
using pipeline::inQuotes;
using pipeline::Vec3d;

constexpr std::string_view kHoldForms =
    "light.N around X, Y, Z; light.N on ground; camera; object.N.rz on X, Y, Z; object.N along view from A to B; "
    "vertex.OBJECT.NUMBER; material.N.n at rim from A to B; pixel along row Y; or SETTING from A to B; then | NAME";
constexpr double kVertexReach = 1.3;  // of its object's largest half side
constexpr std::size_t kMostHolds = 3, kStripPictures = 3;

class HoldReader {
public:
    HoldReader(const Line& line, const pipeline::Scene& scene, Complaints& complaints)
        : m_line(line), m_scene(scene), m_complaints(complaints) {}

    std::vector<Hold> read() {
        std::vector<Line> parts = separated(m_line, "|");
        const auto rule = splitAt(parts[0], " ");
        m_key = rule ? rule->first.text : parts[0].text;
        m_rest = rule ? rule->second : Line{{}, parts[0].where};
        if (parts.size() > 1) m_hold.name = parts[1].text;
        if (parts.size() > 2) m_hold.symbol = parts[2].text;
        if (m_hold.name.empty()) return refuse("no name", "\" | NAME\" at the end, as a screen reader says it");
        if (m_key == "camera" && m_rest.text.empty()) return eye();
        if (const auto index = numbered("light.", m_scene.lights.size())) return lamp(*index);
        if (const auto index = numbered("object.", m_scene.objects.size()); index && takes("along"))
            return along(*index);
        if (m_key.starts_with(pipeline::kVertexPrefix) && std::ranges::count(m_key, '.') == 2) return vertex();
        if (takes("at")) return rim();
        return takes("on") ? turn() : number();
    }

private:
    std::vector<Hold> refuse(std::string found, std::string_view expected = kHoldForms) {
        m_complaints.add(m_line.where, std::move(found), std::string(expected));
        return {};
    }
    // The number behind `prefix`, if there is nothing else.
    std::optional<std::size_t> numbered(std::string_view prefix, std::size_t count) const {
        if (!m_key.starts_with(prefix)) return {};
        const auto number = numberIn(m_key.substr(prefix.size()));
        for (std::size_t i = 0; number && i < count; ++i)
            if (double(i) == *number) return i;
        return {};
    }
    // Whether the next word is this one, which is dropped then.
    bool takes(std::string_view word) {
        if (!m_rest.text.starts_with(word)) return false;
        const std::string_view rest = m_rest.text.substr(word.size());
        if (!rest.empty() && rest[0] != ' ') return false;
        m_rest = trimmed({rest, advanced(m_rest.where, word)});
        return true;
    }
    std::optional<Vec3d> point() const {
        const std::vector<Line> parts = separated(m_rest);
        Vec3d point;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto number = parts.size() == 3 ? numberIn(parts[i].text) : std::nullopt;
            if (!number) return {};
            point[int(i)] = *number;
        }
        return point;
    }
    // "x", "y" or "z".
    bool axisTaken() {
        static constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
        const auto axis = std::ranges::find_if(kAxes, [&](std::string_view name) { return takes(name); });
        if (axis == kAxes.end()) return false;
        m_hold.axis = Vec3d(0), m_hold.axis[int(axis - kAxes.begin())] = 1;
        return true;
    }
    // "from A to B".
    bool range() {
        const auto sides = takes("from") ? splitAt(m_rest, " to ") : std::nullopt;
        const auto low = sides ? numberIn(sides->first.text) : std::nullopt;
        const auto high = sides ? numberIn(sides->second.text) : std::nullopt;
        if (!low || !high || !(*low < *high)) return false;
        m_hold.low = *low, m_hold.high = *high;
        return true;
    }
    std::vector<Hold> one(Hold::Kind kind, std::vector<std::string> keys) {
        m_hold.kind = kind, m_hold.keys = std::move(keys);
        return {m_hold};
    }

    std::vector<Hold> eye() {
        if (m_scene.camera.kind == pipeline::CameraKind::Spherical)
            return one(Hold::Kind::Eye, {"camera.theta", "camera.phi"});
        return one(Hold::Kind::Eye, {"camera.eye_x", "camera.eye_y", "camera.eye_z"});
    }
    std::vector<Hold> lamp(std::size_t index) {
        m_hold.index = index;
        const auto key = [&](const char* part) { return fmt::format("light.{}.{}", index, part); };
        const bool atInfinity = m_scene.lights[index].kind == pipeline::LightKind::AtInfinity;
        if (takes("around")) {
            const auto around = point();
            if (!around || !atInfinity) return refuse(around ? "this light is at a place" : "no point", "on ground");
            m_hold.point = *around;
            return one(Hold::Kind::LampAtInfinity, {key("x"), key("y"), key("z")});
        }
        if (!takes("on") || m_rest.text != "ground") return refuse("found " + inQuotes(m_line.text));
        if (atInfinity) return refuse("this light is at infinity", "around X, Y, Z");
        std::vector<Hold> both = one(Hold::Kind::LampFoot, {key("x"), key("y")});
        m_hold.name += ", height";
        both.push_back(one(Hold::Kind::LampTop, {key("z")}).front());
        return both;
    }
    std::vector<Hold> turn() {
        const auto on = point();
        const auto ref = pipeline::findSetting(m_scene, m_key);
        if (!ref) {
            m_complaints.add(m_line.where, ref.errors());
            return {};
        }
        static constexpr std::array<std::string_view, 3> kTurns{"object.#.rx", "object.#.ry", "object.#.rz"};
        const auto axis = std::size_t(std::ranges::find(kTurns, ref->setting->key) - kTurns.begin());
        if (!on || axis > 2) return refuse("found " + inQuotes(m_line.text));
        m_hold.index = ref->index, m_hold.point = *on;
        // The rotation about x is applied first: those about y and z turn its axis.
        pipeline::ObjectTransform outer;
        outer.rotation = m_scene.objects[ref->index].transform.rotation;
        for (std::size_t i = 0; i <= axis; ++i) outer.rotation[int(i)] = 0;
        m_hold.axis = pipeline::makeObjectMatrix(outer).linear[int(axis)];
        return one(Hold::Kind::Turn, {std::string(m_key)});
    }
    std::vector<Hold> along(std::size_t index) {
        if (takes("view"))
            m_hold.axis = makeView(m_scene).forward;
        else if (!axisTaken())
            return refuse("found " + inQuotes(m_rest.text), "view, x, y or z");
        if (!range()) return refuse("found " + inQuotes(m_rest.text), "from A to B");
        m_hold.index = index, m_hold.point = m_scene.objects[index].transform.translation;
        const auto key = [&](const char* part) { return fmt::format("object.{}.{}", index, part); };
        return one(Hold::Kind::Along, {key("tx"), key("ty"), key("tz")});
    }
    // "vertex.0.2", "vertex.0.2 in z", "vertex.0.2 in z over".
    std::vector<Hold> vertex() {
        const std::string key(m_key);
        const auto ref = pipeline::findSetting(m_scene, key + ".x");
        if (!ref) {
            m_complaints.add(m_line.where, ref.errors());
            return {};
        }
        const auto of = *pipeline::vertexOf(*ref);
        m_hold.axis = Vec3d(0);
        if (takes("in") && !axisTaken()) return refuse("found " + inQuotes(m_rest.text), "x, y or z");
        m_hold.turnsOver = takes("over");
        if (!m_rest.text.empty()) return refuse("found " + inQuotes(m_rest.text), "in x, y or z, and over");
        const pipeline::MeshFacts& facts = m_scene.objects[of.object].mesh->facts;
        const Vec3d half = (facts.high - facts.low) / 2.0;
        m_hold.index = of.object, m_hold.vertex = of.vertex;
        m_hold.point = facts.low + half, m_hold.high = kVertexReach * std::max({half.x, half.y, half.z});
        return one(Hold::Kind::Vertex, {key + ".x", key + ".y", key + ".z"});
    }
    std::vector<Hold> rim() {
        const auto ref = pipeline::findSetting(m_scene, m_key);
        const bool isExponent = ref && ref->setting->key == "material.#.n" && takes("rim");
        if (!isExponent || !m_scene.objects[ref->index].shape ||
            m_scene.objects[ref->index].shape->kind != pipeline::ShapeKind::Sphere)
            return refuse("found " + inQuotes(m_line.text), "material.N.n at rim from A to B, of a sphere");
        if (!range() || !(m_hold.low > 0)) return refuse("found " + inQuotes(m_line.text), "from A to B, above 0");
        m_hold.index = ref->index;
        return one(Hold::Kind::Rim, {std::string(m_key)});
    }
    std::vector<Hold> number() {
        const auto ref = pipeline::findSetting(m_scene, m_key);
        if (!ref) {
            m_complaints.add(m_line.where, ref.errors());
            return {};
        }
        const pipeline::SettingKind kind = ref->setting->kind;
        const bool isNumber = kind == pipeline::SettingKind::Number || kind == pipeline::SettingKind::Integer;
        if (!isNumber || !range()) return refuse("found " + inQuotes(m_line.text));
        if (m_hold.low < ref->setting->min || m_hold.high > ref->setting->max)
            return refuse("found " + inQuotes(m_rest.text),
                          fmt::format("from {} to {} at most", ref->setting->min, ref->setting->max));
        return one(Hold::Kind::Number, {std::string(m_key)});
    }

    const Line m_line;
    const pipeline::Scene& m_scene;
    Complaints& m_complaints;
    std::string_view m_key;
    Line m_rest;
    Hold m_hold;
};

// Reads what is beside the holds.
class HeldReader {
public:
    HeldReader(const pipeline::Scene& scene, const Names& names, Held held, Complaints& complaints)
        : m_scene(scene), m_names(names), m_complaints(complaints), m_held(std::move(held)) {
        m_held.play.reset();
        m_held.strip.clear();
    }

    Held read(std::span<const Entry> entries) {
        if (find(entries, "hold")) m_held.holds.clear(), m_held.shows = {}, m_held.spot.reset(), m_held.file.clear();
        for (const Entry& entry : entries)
            if (entry.key == "hold") hold(entry);
        if (m_held.holds.size() > kMostHolds)
            m_complaints.add(m_held.where, fmt::format("found {} grips", m_held.holds.size()), "at most 3");
        if (const Entry* entry = find(entries, "shows"))
            m_held.shows = m_complaints.valueOf(parseProse({&entry->line(), 1}, {m_scene, &m_names}));
        if (const Entry* entry = find(entries, "figure")) figure(entry->line());
        if (const Entry* entry = find(entries, "play")) play(*entry);
        if (const Entry* entry = find(entries, "strip")) strip(entry->line());
        if (const Entry* entry = find(entries, "file")) file(entry->line());
        if (const Entry* entry = find(entries, "pixels")) {
            m_held.hardPixels = entry->line().text == "hard";
            if (!m_held.hardPixels)
                m_complaints.add(entry->line().where, "found " + inQuotes(entry->line().text), "hard");
        }
        return std::move(m_held);
    }

private:
    void hold(const Entry& entry) {
        if (entry.line().text == "none") return;  // of a second half: nothing of the first one's
        if (m_held.holds.empty()) m_held.where = entry.where;
        if (entry.line().text.starts_with("pixel ")) return spot(entry.line());
        for (Hold& one : HoldReader(entry.line(), m_scene, m_complaints).read()) m_held.holds.push_back(std::move(one));
    }
    // "pixel along row 240 | Spot"
    void spot(const Line& line) {
        constexpr std::string_view kForm = "pixel along row ";
        const std::vector<Line> parts = separated(line, "|");
        const auto row = parts[0].text.starts_with(kForm) ? numberIn(parts[0].text.substr(kForm.size())) : std::nullopt;
        if (!row || parts.size() != 2 || !(*row >= 0 && *row < m_scene.settings.height && *row == std::floor(*row)))
            return m_complaints.add(line.where, "found " + inQuotes(line.text),
                                    "pixel along row Y | NAME, with a row of the picture");
        m_held.spot = Spot{int(*row), std::string(parts[1].text)};
    }
    // The title of an object's file as lecture 1 writes one: of the object whose vertex is held.
    void file(const Line& line) {
        m_held.file = line.text;
        const auto isVertex = [](const Hold& hold) { return hold.kind == Hold::Kind::Vertex; };
        if (std::ranges::none_of(m_held.holds, isVertex))
            m_complaints.add(line.where, "found a file without a vertex that is held",
                             "hold: vertex.OBJECT.NUMBER | NAME");
    }
    void figure(const Line& line) {
        const auto found = std::ranges::find(kFigureNames, line.text);
        if (found == kFigureNames.end())
            m_complaints.addUnknown(line.where, "figure", line.text, {kFigureNames.begin(), kFigureNames.end()});
        else
            m_held.figure = Figure(found - kFigureNames.begin());
    }
    // Its condition and its finding are on lines of their own, indented.
    void play(const Entry& entry) {
        Play play{std::string(entry.line().text), {}, {}, entry.where};
        for (std::size_t i = 1; i < entry.value.size(); ++i) {
            const auto part = entryIn(entry.value[i]);
            if (part && part->key == "until")
                play.until =
                    m_complaints.valueOf(parseExpression(part->line().text, part->line().where, {m_scene, &m_names}));
            else if (part && part->key == "done")
                play.done = part->line().text;
            else
                m_complaints.add(entry.value[i].where, "found " + inQuotes(entry.value[i].text), "until: … or done: …");
        }
        if (play.done.empty() || play.until.text.empty())
            m_complaints.add(entry.where, "this play has no end",
                             "indented lines \"until: CONDITION\" and \"done: …\"");
        else if (play.until.root.type != Type::Truth)
            m_complaints.add(play.until.root.where, "found " + inQuotes(play.until.text), "a condition");
        m_held.play = std::move(play);
    }
    // "0, 20, 40"; of a hold with several settings "1, 0, 0; 0, 1, 0; 0, 0, 1".
    void strip(const Line& line) {
        if (m_held.holds.empty()) return m_complaints.add(line.where, "found a strip without a hold");
        const std::vector<std::string>& keys = m_held.holds.front().keys;
        std::vector<Line> tuples = separated(line, keys.size() == 1 ? "," : ";");
        for (const Line& tuple : tuples) {
            const std::vector<Line> numbers = separated(tuple);
            pipeline::Assignments values;
            for (std::size_t i = 0; i < std::min(numbers.size(), keys.size()); ++i)
                if (const auto number = numberIn(numbers[i].text)) values.emplace_back(keys[i], *number);
            if (values.size() == keys.size() && numbers.size() == keys.size())
                m_held.strip.push_back(pipeline::toText(values));
        }
        if (m_held.strip.size() != kStripPictures || tuples.size() != kStripPictures)
            m_complaints.add(line.where, "found " + inQuotes(line.text),
                             fmt::format("three values of {}, with \"{}\" between them", fmt::join(keys, ", "),
                                         keys.size() == 1 ? "," : ";"));
    }

    const pipeline::Scene& m_scene;
    const Names& m_names;
    Complaints& m_complaints;
    Held m_held;
};

}  // namespace

Held heldFrom(std::span<const Entry> entries, const pipeline::Scene& scene, const Names& names, Held held,
              Complaints& complaints) {
    return HeldReader(scene, names, std::move(held), complaints).read(entries);
}

std::vector<HeldFile> filesOf(const Held& held, const pipeline::Scene& scene) {
    const auto vertex = std::ranges::find(held.holds, Hold::Kind::Vertex, &Hold::kind);
    if (held.file.empty() || vertex == held.holds.end()) return {};
    std::vector<HeldFile> files;
    if (auto lines = sceneLines(scene, held.file); !lines.empty())
        files.push_back({held.file.substr(0, held.file.rfind('.')) + ".scene", std::move(lines)});
    files.push_back({held.file, objectLines(scene.objects[vertex->index])});
    return files;
}

std::string filesText(const Held& held, const pipeline::Scene& scene) {
    std::string text;
    for (const HeldFile& file : filesOf(held, scene)) {
        text += fmt::format("\n\n`{}`\n\n```\n", file.title);
        for (const pipeline::LectureLine& line : file.lines) text += fmt::format("{:<22}{}\n", line.text, line.meaning);
        text += "```\n";
    }
    return text;
}

pipeline::BufferSet buffersOf(const Held& held) {
    pipeline::BufferSet buffers = buffersOf(held.shows);
    if (held.play) buffers |= held.play->until.buffers;
    if (held.figure == Figure::Row) buffers.set(index(pipeline::BufferId::PolygonId));
    return buffers;
}

}  // namespace lessons
