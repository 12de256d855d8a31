#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lessons/state/state_text.h"
#include "lessons/state/view_tree.h"
#include "pipeline/buffers/buffer_table.h"
#include "pipeline/core/text.h"
#include "pipeline/inspect/compare.h"

namespace lessons {

using pipeline::Place;
using pipeline::StageId;
using pipeline::TomlValues;
using std::string_view;

namespace {

constexpr double kMost = 1e300;  // of any number: all but what is none
constexpr std::size_t kMaxViews = 16, kMaxList = 10000;

const KnownKeys kKeys{"scene",    "set",         "scene_text", "stage",     "place",  "step", "pixel",
                      "equation", "arrangement", "view",       "bookmarks", "view3d", "pins", "selected",
                      "linked",   "condition",   "mix",        "algorithm", "sliders"};
const KnownKeys kViewKeys{"buffer", "channel",    "range",   "overlays", "counts", "against", "compare", "wipe",
                          "metric", "difference", "flipped", "region",   "zoom",   "center",  "size"};
constexpr std::array<string_view, 2> kCounts{"linear", "logarithmic"};
const KnownKeys kSpaceKeys{"space", "target", "right", "up", "forward", "distance", "fov", "orthographic", "options"};

std::vector<string_view> stageNames() {
    std::vector<string_view> names;
    for (const StageId stage : pipeline::kStages) names.push_back(stageInfo(stage).name);
    return names;
}
std::vector<string_view> stepNames() {
    std::vector<string_view> names;
    for (std::size_t i = 0; i < pipeline::kStepLevelCount; ++i) names.push_back(name(pipeline::StepLevel(i)));
    return names;
}

class StateReader {
public:
    StateReader(const std::string& path, TomlValues& values)
        : m_path(path.empty() ? "" : path + '.'), m_values(values) {}

    WindowState read(const toml::table& table, const KnownKeys& others) {
        KnownKeys keys = kKeys;
        keys.insert(keys.end(), others.begin(), others.end());
        known(table, m_path, keys);
        WindowState state;
        text(table, "scene", state.scene);
        text(table, "scene_text", state.sceneText);
        text(table, "condition", state.condition);
        text(table, "mix", state.mix);
        state.set = strings(table, "set", m_path);
        state.sliders = strings(table, "sliders", m_path);
        if (state.sliders.size() > kMostSliders)
            m_values.refuse(*table.get("sliders"), m_path + "sliders",
                            fmt::format("at most {} keys of settings", kMostSliders));
        const auto stages = stageNames(), steps = stepNames();
        if (const auto* node = table.get("stage"))
            if (const auto i = m_values.choice(*node, m_path + "stage", stages)) state.stage = pipeline::kStages[*i];
        if (const auto* node = table.get("step"))
            if (const auto i = m_values.choice(*node, m_path + "step", steps)) state.step = pipeline::StepLevel(*i);
        state.algorithm = flag(table, "algorithm", m_path).value_or(false);
        if (const auto* node = table.get("equation"))
            if (const auto i = m_values.choice(*node, m_path + "equation", kEquationChannels)) state.channel = int(*i);
        if (const auto* node = table.get("place")) state.place = place(*node, m_path + "place");
        if (const auto* node = table.get("pixel"))
            if (const auto xy = m_values.wholeNumbers(*node, m_path + "pixel", 2, 0, 1 << 20))
                state.pixel = {(*xy)[0], (*xy)[1]};
        if (const auto* node = table.get("bookmarks")) state.bookmarks = places(*node);
        if (const auto* node = table.get("view")) {
            state.views.clear();
            for (const toml::table* view : m_values.tables(*node, m_path + "view", kMaxViews))
                state.views.push_back(readView(*view, m_path + "view."));
            if (state.views.empty()) state.views.emplace_back();
        }
        if (const auto* node = table.get("view3d")) readSpaces(*node, state.spaces);
        state.arrangement = readArrangement(table, state.views.size());
        if (const auto* node = table.get("pins")) state.pins = readPins(*node);
        if (const auto* node = table.get("selected")) state.selected = readSelected(*node);
        state.linked = flag(table, "linked", m_path);
        if (m_values.errors().empty())             // else nobody asks
            for (const auto& [key, node] : table)  // one 3D view is a table
                addPlaces(node, key == "view3d" && node.is_table() ? "view3d.0" : std::string(key.str()), state.places);
        return state;
    }

private:
    void known(const toml::table& table, const std::string& path, const KnownKeys& keys) {
        for (const auto& [key, node] : table)
            if (std::ranges::find(keys, key.str()) == keys.end())
                m_values.unknown(key, path + std::string(key.str()), keys);
    }
    void addPlaces(const toml::node& node, const std::string& key, StatePlaces& places) {
        places.add(key, m_values.place(node.source()));
        if (const toml::table* table = node.as_table())
            for (const auto& [name, value] : *table) addPlaces(value, key + '.' + std::string(name.str()), places);
        if (const toml::array* array = node.as_array())
            for (std::size_t i = 0; i < std::min(array->size(), kMaxList); ++i)
                addPlaces((*array)[i], fmt::format("{}.{}", key, i), places);
    }
    void text(const toml::table& table, string_view key, std::string& value) {
        if (const auto* node = table.get(key))
            value = m_values.text(*node, m_path + std::string(key)).value_or(std::move(value));
    }
    std::vector<std::string> strings(const toml::table& table, string_view key, const std::string& path) {
        std::vector<std::string> all;
        const toml::node* node = table.get(key);
        if (!node) return all;
        const toml::array* array = node->as_array();
        if (!array || array->size() > kMaxList)
            m_values.refuse(*node, path + std::string(key), "an array of strings");
        else
            for (const toml::node& one : *array)
                if (auto string = m_values.text(one, path + std::string(key))) all.push_back(std::move(*string));
        return all;
    }
    std::optional<Place> place(const toml::node& node, const std::string& path) {
        const auto words = m_values.text(node, path);
        if (!words) return {};
        const auto place = pipeline::parsePlace(*words);
        if (place) return *place;
        m_values.fail(node.source(), path + ": " + place.errors().front().found, place.errors().front().expected);
        return {};
    }
    std::vector<Place> places(const toml::node& node) {
        std::vector<Place> all;
        const toml::array* array = node.as_array();
        if (!array) m_values.refuse(node, m_path + "bookmarks", "an array of places");
        for (std::size_t i = 0; array && i < std::min(array->size(), kMaxList); ++i)
            if (const auto one = place((*array)[i], m_path + "bookmarks")) all.push_back(*one);
        return all;
    }
    // Where nothing is said, one that has all the buffers.
    std::string readArrangement(const toml::table& table, std::size_t buffers) {
        const std::string usual = buffers < 2 ? "one" : buffers == 2 ? "two" : "four";
        const auto* node = table.get("arrangement");
        const auto words = node ? m_values.text(*node, m_path + "arrangement") : std::nullopt;
        if (!words) return usual;
        const auto tree = arrangementOf(*words);
        if (tree) return *words;
        m_values.fail(node->source(), m_path + tree.errors().front().found, tree.errors().front().expected);
        return usual;
    }
    template <std::size_t n>
    std::optional<std::array<double, n>> numbers(const toml::table& table, string_view key, const std::string& path,
                                                 double min = -kMost) {
        const auto* node = table.get(key);
        const auto found = node ? m_values.numbers(*node, path + std::string(key), n, min, kMost) : std::nullopt;
        if (!found) return {};
        std::array<double, n> all{};
        std::ranges::copy(*found, all.begin());
        return all;
    }

    std::optional<bool> flag(const toml::table& table, string_view key, const std::string& path) {
        const toml::node* node = table.get(key);
        if (!node) return {};
        if (const auto* value = node->as_boolean()) return value->get();
        m_values.refuse(*node, path + std::string(key), "true or false");
        return {};
    }

    // One table, or an array of them where there are more 3D views.
    void readSpaces(const toml::node& node, std::vector<SpaceShown>& spaces) {
        const std::string path = m_path + "view3d";
        std::vector<const toml::table*> tables;
        if (node.is_array())
            tables = m_values.tables(node, path, kMaxViews);
        else if (const toml::table* one = m_values.table(node, path))
            tables = {one};
        if (!tables.empty()) spaces.clear();
        for (const toml::table* one : tables) spaces.push_back(readSpace(*one, path + '.'));
    }
    std::map<int, std::array<int, 2>> readPins(const toml::node& node) {
        std::map<int, std::array<int, 2>> pins;
        const toml::array* array = node.as_array();
        if (!array || array->size() > 9) m_values.refuse(node, m_path + "pins", "an array of up to 9 [number, x, y]");
        for (std::size_t i = 0; array && i < std::min<std::size_t>(array->size(), 9); ++i)
            if (const auto pin = m_values.wholeNumbers((*array)[i], m_path + "pins", 3, 0, 1 << 20)) {
                const int number = (*pin)[0];
                if (number < 1 || number > 9)
                    m_values.refuse((*array)[i], m_path + "pins", "a number from 1 to 9 before x and y");
                else
                    pins[number] = {int((*pin)[1]), int((*pin)[2])};
            }
        return pins;
    }
    std::optional<Selection> readSelected(const toml::node& node) {
        const auto words = m_values.text(node, m_path + "selected");
        if (!words) return {};
        for (std::size_t i = 0; i < kSelectedKinds.size(); ++i) {
            if (!words->starts_with(std::string(kSelectedKinds[i]) + ' ')) continue;
            Selection thing{Selection::Kind(i)};
            const char *begin = words->data() + kSelectedKinds[i].size() + 1, *last = words->data() + words->size();
            const auto [end, error] = std::from_chars(begin, last, thing.index);
            if (error == std::errc() && end == last && begin != last) return thing;
        }
        m_values.fail(node.source(), m_path + "selected is " + pipeline::inQuotes(*words),
                      "object, polygon, vertex or light, and its number");
        return {};
    }
    std::optional<BufferShown::Compared> readCompared(const toml::table& table, const std::string& path) {
        const auto* against = table.get("against");
        const auto with = against ? m_values.text(*against, path + "against") : std::nullopt;
        if (!with) return {};
        BufferShown::Compared compared;
        compared.with = *with;
        if (const auto* node = table.get("compare"))
            if (const auto i = m_values.choice(*node, path + "compare", kCompareModes))
                compared.mode = kCompareModes[*i];
        if (const auto* node = table.get("wipe"))
            compared.wipe = m_values.number(*node, path + "wipe", 0, 1).value_or(compared.wipe);
        if (const auto* node = table.get("metric")) {
            std::vector<string_view> names;
            for (const pipeline::MetricInfo& metric : pipeline::metricTable()) names.push_back(metric.name);
            if (const auto i = m_values.choice(*node, path + "metric", names)) compared.metric = names[*i];
        }
        compared.range = numbers<2>(table, "difference", path);
        return compared;
    }

    BufferShown readView(const toml::table& table, const std::string& path) {
        known(table, path, kViewKeys);
        BufferShown view;
        if (const auto* node = table.get("buffer"))
            if (const auto words = m_values.text(*node, path + "buffer")) {
                if (pipeline::findAnyBuffer(*words))
                    view.buffer = *words;
                else
                    m_values.fail(node->source(), path + "buffer is " + pipeline::inQuotes(*words),
                                  "the name of a buffer; " + pipeline::insteadOfAnyBuffer(*words));
            }
        if (const auto* node = table.get("channel"))
            if (const auto i = m_values.choice(*node, path + "channel", kShownChannels))
                view.channel = ShownChannel(*i);
        if (const auto* node = table.get("range")) {
            view.range = numbers<2>(table, "range", path);
            if (view.range && (*view.range)[0] == (*view.range)[1]) {
                m_values.fail(node->source(), path + "range ends where it begins", "two numbers");
                view.range.reset();
            }
        }
        if (table.contains("overlays")) view.overlays = strings(table, "overlays", path);
        if (const auto* node = table.get("counts"))
            if (const auto i = m_values.choice(*node, path + "counts", kCounts)) view.logCounts = *i == 1;
        view.compared = readCompared(table, path);
        view.flipped = flag(table, "flipped", path).value_or(view.flipped);
        if (const auto* node = table.get("region"))
            if (const auto r = m_values.wholeNumbers(*node, path + "region", 4, 0, 1 << 20))
                view.region = {(*r)[0], (*r)[1], (*r)[2], (*r)[3]};
        if (const auto* node = table.get("zoom")) {
            const auto factor = m_values.number(*node, path + "zoom", 1e-3, 1e3);
            const auto center = numbers<2>(table, "center", path), size = numbers<2>(table, "size", path, 1);
            if (factor && center && size)
                view.zoom = {*factor, *center, *size};
            else if (factor)
                m_values.fail(node->source(), path + "zoom stands without center or size", "all three");
        }
        return view;
    }

    SpaceShown readSpace(const toml::table& table, const std::string& path) {
        known(table, path, kSpaceKeys);
        SpaceShown space;
        if (const auto* node = table.get("space"))
            space.space = m_values.text(*node, path + "space").value_or(space.space);
        if (const auto* node = table.get("distance")) space.camera = readCamera(*node, table, path);
        if (const auto* node = table.get("options"))
            if (const toml::table* options = m_values.table(*node, path + "options"))
                for (const auto& [key, value] : *options)
                    if (const auto number =
                            m_values.number(value, path + "options." + std::string(key.str()), -kMost, kMost))
                        space.options[std::string(key.str())] = *number;
        return space;
    }

    std::optional<SpaceShown::Camera> readCamera(const toml::node& distance, const toml::table& table,
                                                 const std::string& path) {
        SpaceShown::Camera camera;
        const auto vector = [&](string_view key, pipeline::Vec3d& into) {
            const auto xyz = numbers<3>(table, key, path);
            if (xyz) into = {(*xyz)[0], (*xyz)[1], (*xyz)[2]};
            return xyz.has_value();
        };
        const auto length = m_values.number(distance, path + "distance", 1e-300, kMost);
        const bool placed = vector("target", camera.target) && vector("right", camera.right) &&
                            vector("up", camera.up) && vector("forward", camera.forward);
        if (!length) return {};
        if (!placed || !isOrthonormal(camera)) {
            m_values.fail(distance.source(), path + "distance stands without a camera around it",
                          "target, right, up and forward, the last three orthonormal");
            return {};
        }
        camera.distance = *length;
        if (const auto* node = table.get("fov"))
            camera.fov = m_values.number(*node, path + "fov", 1e-3, 180).value_or(camera.fov);
        camera.orthographic = flag(table, "orthographic", path).value_or(camera.orthographic);
        return camera;
    }

    // Within what a few hundred turns of the mouse may leave.
    static bool isOrthonormal(const SpaceShown::Camera& camera) {
        constexpr double kLoose = 1e-6;
        const std::array axes{camera.right, camera.up, camera.forward};
        for (std::size_t i = 0; i < axes.size(); ++i)
            for (std::size_t k = 0; k <= i; ++k)
                if (!(std::abs(glm::dot(axes[i], axes[k]) - (i == k ? 1 : 0)) < kLoose)) return false;
        return true;
    }

    std::string m_path;
    TomlValues& m_values;
};

}  // namespace

pipeline::SourceLocation StatePlaces::of(string_view key) const {
    for (;; key = key.substr(0, key.rfind('.'))) {
        if (const auto found = m_places.find(key); found != m_places.end()) return found->second;
        if (key.rfind('.') == key.npos) return {};
    }
}

WindowState readStateTable(const toml::table& table, const std::string& path, const KnownKeys& others,
                           TomlValues& values) {
    return StateReader(path, values).read(table, others);
}

pipeline::Result<WindowState> readState(std::string_view text, const std::string& file) {
    const auto table = pipeline::parseToml({text, file});
    if (!table) return table.errors();
    TomlValues values(file);
    WindowState state = readStateTable(*table, "", {}, values);
    const pipeline::Errors errors = values.errors();
    if (!errors.empty()) return errors;
    return state;
}

}  // namespace lessons
