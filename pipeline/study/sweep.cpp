#include "pipeline/study/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/core/number.h"
#include "pipeline/core/text.h"

namespace pipeline {
namespace {

constexpr std::size_t kMaxValues = 1000;  // of one axis

std::vector<std::string_view> splitAt(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0;;) {
        const std::size_t end = text.find(separator, begin);
        parts.push_back(text.substr(begin, end == text.npos ? end : end - begin));
        if (end == text.npos) return parts;
        begin = end + 1;
    }
}

bool isNumber(const Setting& setting) { return setting.choices.empty(); }

// "tessellation" of "object.#.tessellation"; empty of a key that has no shorter one.
std::string_view shortKey(std::string_view key) {
    const auto hash = key.find("#.");
    return hash == key.npos ? std::string_view() : key.substr(hash + 2);
}

// The numbers of a range "A..B", "A..B+STEP" or "A..B*FACTOR".
Result<std::vector<double>> rangeOf(const SettingRef& ref, std::string_view text) {
    const auto dots = text.find("..");
    const std::string_view rest = text.substr(dots + 2);
    // The sign of an exponent, "1e+3", is no step.
    std::size_t mark = rest.npos;
    for (std::size_t i = 1; i < rest.size() && mark == rest.npos; ++i)
        if (rest[i] == '*' || (rest[i] == '+' && rest[i - 1] != 'e' && rest[i - 1] != 'E')) mark = i;
    const auto first = parseSetting(ref, text.substr(0, dots)), last = parseSetting(ref, rest.substr(0, mark));
    if (!first) return first.errors();
    if (!last) return last.errors();
    double step = 1;
    if (mark != rest.npos) {
        const std::string_view digits = rest.substr(mark + 1);
        step = readNumber(digits).value_or(std::numeric_limits<double>::infinity());
        if (!std::isfinite(step))
            return Error{{}, fmt::format("the step of {} is {}", inQuotes(text), inQuotes(digits)), "a number"};
    }
    const bool grows = mark != rest.npos && rest[mark] == '*';
    const Error endless{{},
                        fmt::format("the range {} does not get from {} to {}", inQuotes(text), *first, *last),
                        grows ? "a factor that leads there: 4..64*2" : "a step that leads there: 4..7, 0..1+0.25"};
    if (grows ? !(step > 1) || !(*first > 0) : !(step > 0)) return endless;
    if (!(*last >= *first)) return endless;
    std::vector<double> values;
    // Each from the first, so that no error adds up; a little beyond the last is the last: 0..1+0.1.
    for (int i = 0; values.size() <= kMaxValues; ++i) {
        double value = grows ? *first * std::pow(step, i) : *first + i * step;
        const double slack = grows ? *last * 0x1p-40 : step * 0x1p-20;
        if (value > *last + slack) break;
        if (std::abs(value - *last) <= slack) value = *last;
        if (ref.setting->kind == SettingKind::Integer && value != std::round(value))
            return Error{{}, fmt::format("the range {} holds {}", inQuotes(text), value), "whole numbers"};
        values.push_back(value);
    }
    return values;
}

Result<std::vector<double>> valuesIn(const SettingRef& ref, std::string_view text) {
    if (text == "all" && !isNumber(*ref.setting)) {
        std::vector<double> all;
        for (std::size_t i = 0; i < ref.setting->choices.size(); ++i) all.push_back(static_cast<double>(i));
        return all;
    }
    if (isNumber(*ref.setting) && text.find("..") != text.npos) return rangeOf(ref, text);
    const auto value = parseSetting(ref, text);
    if (!value) return value.errors();
    return std::vector<double>{*value};
}

}  // namespace

Result<std::vector<SettingRef>> sweptSettings(const Scene& scene, std::string_view key) {
    const std::span<const Setting> rows = settingsTable();
    auto row = std::ranges::find(rows, key, &Setting::key);
    if (row == rows.end() && !key.empty())
        row = std::ranges::find(rows, key, [](const Setting& s) { return shortKey(s.key); });
    if (row == rows.end()) {
        const auto one = findSetting(scene, key);
        if (!one) return one.errors();
        return std::vector<SettingRef>{*one};
    }
    std::vector<SettingRef> refs;
    std::string_view absent;
    for (std::size_t i = 0; i < row->count(scene); ++i)
        if (const std::string_view why = row->absent(scene, i); why.empty())
            refs.push_back({&*row, i});
        else
            absent = why;
    if (!refs.empty()) return refs;
    if (!absent.empty()) return Error{{}, fmt::format("no setting {}: {}", inQuotes(key), absent), {}};
    const std::string_view owner = row->key.substr(0, row->key.find('.'));
    return Error{{}, fmt::format("no setting {}: this scene has no {}", inQuotes(key), owner), {}};
}

Result<SweepAxis> parseSweep(const Scene& scene, std::string_view text) {
    const auto equals = text.find('=');
    if (equals == text.npos)
        return Error{{}, "found " + inQuotes(text), "KEY=VALUE,VALUE,... or the name of a ready-made sweep"};
    const std::string_view key = text.substr(0, equals);
    const auto refs = sweptSettings(scene, key);
    if (!refs) return refs.errors();
    SweepAxis axis{std::string(key), std::string(refs->front().setting->label), {}};
    for (const std::string_view part : splitAt(text.substr(equals + 1), ',')) {
        const auto values = valuesIn(refs->front(), part);
        if (!values) return values.errors();
        for (const double value : *values) {
            const std::string word = formatSetting(refs->front(), value);
            if (std::ranges::find(axis.values, word) != axis.values.end())
                return Error{{}, fmt::format("{} takes the value {} twice", key, word), "each value once"};
            axis.values.push_back(word);
        }
        if (axis.values.size() > kMaxValues)
            return Error{{}, fmt::format("{} takes more than {} values", key, kMaxValues), "fewer"};
    }
    return axis;
}

namespace {

std::string_view whyIdle(const Scene& scene, const SweepAxis& axis) {
    return sweptSettings(scene, axis.key)->front().setting->idle(scene);
}

// The key of a setting that both axes change: one setting may have a shorter key, and one key stand for several.
std::optional<std::string> inBoth(const Scene& scene, const SweepAxis& a, const SweepAxis& b) {
    const auto ofA = sweptSettings(scene, a.key), ofB = sweptSettings(scene, b.key);
    for (const SettingRef& ref : *ofA)
        if (std::ranges::find(*ofB, ref) != ofB->end()) return ref.key();
    return {};
}

// Why an axis changes nothing, neither in the scene as it is nor with any choice that another axis makes, or the last
// of its numbers.
std::string_view whyWithoutEffect(const Scene& scene, std::span<const SweepAxis> axes, const SweepAxis& axis) {
    const std::string_view why = whyIdle(scene, axis);
    if (why.empty()) return {};
    for (const SweepAxis& other : axes) {
        if (other.key == axis.key) continue;
        std::span<const std::string> values = other.values;
        if (isNumber(*sweptSettings(scene, other.key)->front().setting)) values = values.last(1);
        for (const std::string& value : values) {
            const auto changed = sceneAt(scene, {&other, 1}, {&value, 1});
            if (changed && whyIdle(*changed, axis).empty()) return {};
        }
    }
    return why;
}

}  // namespace

Result<Sweep> parseSweeps(const Scene& scene, std::span<const std::string> texts) {
    Sweep sweep;
    std::vector<std::string> all;
    for (const std::string& text : texts) {
        const NamedSweep* named = findNamedSweep(text);
        if (!named && text.find('=') == text.npos) {
            std::vector<std::string> names;
            for (const NamedSweep& one : namedSweeps()) names.emplace_back(one.name);
            return Error{{}, "found " + inQuotes(text), fmt::format("KEY=VALUES or one of {}", fmt::join(names, ", "))};
        }
        if (!named) {
            all.push_back(text);
            continue;
        }
        if (sweep.choice) return Error{{}, "found a second ready-made sweep, " + inQuotes(text), "one"};
        const std::vector<std::string> axes = named->sweeps(scene);
        if (axes.empty()) return Error{{}, fmt::format("the sweep {} needs {}", named->name, named->needs), {}};
        all.insert(all.end(), axes.begin(), axes.end());
        sweep.choice = choiceOf(*named, scene);
    }
    for (const std::string& text : all) {
        auto axis = parseSweep(scene, text);
        if (!axis) return axis.errors();
        for (const SweepAxis& other : sweep.axes)
            if (const auto both = inBoth(scene, other, *axis))
                return Error{{},
                             other.key == axis->key
                                 ? fmt::format("{} is swept twice", axis->key)
                                 : fmt::format("{} is swept twice, as {} and as {}", *both, other.key, axis->key),
                             "each setting once"};
        sweep.axes.push_back(std::move(axis).value());
    }
    if (const std::size_t count = pointCount(sweep.axes); count > kMaxStudyPoints)
        return Error{{}, fmt::format("the sweep has more than {} points", kMaxStudyPoints), "fewer values"};
    for (const SweepAxis& axis : sweep.axes)
        if (const std::string_view why = whyWithoutEffect(scene, sweep.axes, axis); !why.empty())
            return Error{{}, fmt::format("{} has no effect: {}", axis.key, why), {}};
    return sweep;
}

std::size_t pointCount(std::span<const SweepAxis> axes) {
    std::size_t count = 1;
    // Beyond the limit it does not matter how far.
    for (const SweepAxis& axis : axes) count = std::min(count * axis.values.size(), 10 * kMaxStudyPoints);
    return count;
}

std::vector<std::string> valuesOf(std::span<const SweepAxis> axes, std::size_t number) {
    std::vector<std::string> values(axes.size());
    for (std::size_t i = axes.size(); i-- > 0;) {
        values[i] = axes[i].values[number % axes[i].values.size()];
        number /= axes[i].values.size();
    }
    return values;
}

Result<Scene> sceneAt(const Scene& scene, std::span<const SweepAxis> axes, std::span<const std::string> values) {
    Scene changed = scene;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const auto refs = sweptSettings(changed, axes[i].key);
        if (!refs) return refs.errors();
        for (const SettingRef& ref : *refs) {
            const auto value = parseSetting(ref, values[i]);
            if (!value) return value.errors();
            ref.set(changed, *value);
        }
    }
    if (Errors errors = checkScene(changed); !errors.empty()) return errors;
    return changed;
}

}  // namespace pipeline
