#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "pipeline/core/printable.h"
#include "pipeline/core/text.h"
#include "pipeline/export/json/study_json.h"
#include "pipeline/formats/text/json_error.h"
#include "pipeline/formats/text/read_progress.h"
#include "pipeline/study/sweep.h"

namespace pipeline {

namespace {

// No study that the program writes comes near; a file that says more is broken.
constexpr double kMost = 1e9;

// A value with its JSON pointer. What is not as it must be is reported, and reads as nothing: 0,
// an empty text, no elements.
class Value {
public:
    Value(const Json* json, std::string pointer, const std::string& file, Errors& errors)
        : m_json(json), m_pointer(std::move(pointer)), m_file(&file), m_errors(&errors) {}

    Value operator[](std::string_view key) const {
        if (!m_json) return inner(nullptr, key);
        if (!m_json->is(Json::kObject)) {
            refuse("an object");
            return inner(nullptr, key);
        }
        if (const Json* const member = m_json->find(key)) return inner(member, key);
        report(fmt::format("{}/{} is missing", m_pointer, key), {});
        return inner(nullptr, key);
    }

    bool has(std::string_view key) const { return m_json && m_json->find(key); }

    void eachElement(const auto& visit) const {
        if (!m_json) return;
        if (!m_json->is(Json::kArray)) return refuse("an array");
        for (std::size_t i = 0; i < m_json->elements().size(); ++i) visit(inner(&(*m_json)[i], std::to_string(i)));
    }

    void eachMember(const auto& visit) const {
        if (!m_json) return;
        if (!m_json->is(Json::kObject)) return refuse("an object");
        for (const auto& [key, member] : m_json->items()) visit(escaped(key), inner(&member, key));
    }

    // Tables, plots and pages show it: what cannot be shown is escaped.
    std::string text() const {
        if (m_json && m_json->is(Json::kString)) return escaped(m_json->text());
        refuse("a text");
        return {};
    }

    double number(double min = std::numeric_limits<double>::lowest()) const {
        if (m_json && m_json->is(Json::kNumber) && m_json->get<double>() >= min) return m_json->get<double>();
        refuse(min >= 0 ? fmt::format("a number from {}", min) : "a number");
        return 0;
    }

    std::optional<double> numberOrNull(double min = std::numeric_limits<double>::lowest()) const {
        if (m_json && m_json->is(Json::kNull)) return std::nullopt;
        return number(min);
    }

    long long whole(long long min, double max = kMost) const {
        if (m_json && m_json->is(Json::kWhole)) {
            const auto value = m_json->get<double>();  // whatever its sign and size
            if (value >= static_cast<double>(min) && value <= max) return m_json->get<long long>();
        }
        refuse(fmt::format("a whole number from {} to {:g}", min, max));
        return min;
    }

    std::vector<std::string> texts() const {
        std::vector<std::string> all;
        eachElement([&](const Value& value) { all.push_back(value.text()); });
        return all;
    }

    StageId stage() const {
        const std::optional<StageId> found = findStage(text());
        if (!found && m_json && m_json->is(Json::kString)) refuse("the name of a stage");
        return found.value_or(StageId::Transform);
    }

    // "POINTER is VALUE, expected …". Nothing of a value that is not there: that has been said.
    void refuse(std::string expected) const {
        if (!m_json) return;
        const std::string shown = m_json->is(Json::kStructured)
                                      ? std::string(m_json->is(Json::kArray) ? "an array" : "an object")
                                  : m_json->is(Json::kString) ? inQuotes(m_json->text())
                                                              : m_json->dump();
        report(fmt::format("{} is {}", m_pointer.empty() ? "the file" : m_pointer, shown), std::move(expected));
    }

private:
    void report(std::string found, std::string expected) const {
        if (m_errors->size() < kMaxErrors) m_errors->push_back({{*m_file}, std::move(found), std::move(expected)});
    }

    Value inner(const Json* json, std::string_view key) const {
        std::string pointer = m_pointer + '/';
        for (const char c : key) {
            if (c == '~' || c == '/')
                pointer += c == '~' ? "~0" : "~1";
            else
                pointer += c;
        }
        return {json, std::move(pointer), *m_file, *m_errors};
    }

    const Json* m_json;
    std::string m_pointer;
    const std::string* m_file;
    Errors* m_errors;
};

int count(const Value& value, long long min) { return static_cast<int>(value.whole(min)); }

ErrorKind kindOf(const Value& value) {
    const std::string text = value.text();
    for (std::size_t kind = 0; kind < kErrorKinds; ++kind)
        if (text == name(static_cast<ErrorKind>(kind))) return static_cast<ErrorKind>(kind);
    value.refuse("\"model\", \"arithmetic\" or \"storage\"");
    return ErrorKind::Model;
}

TimeSamples readTimes(const Value& value) {
    TimeSamples times;
    value.eachElement([&](const Value& process) {
        std::vector<double>& samples = times.processes.emplace_back();
        process.eachElement([&](const Value& sample) { samples.push_back(sample.number(0)); });
    });
    return times;
}

ErrorRow readError(const Value& value) {
    ErrorRow row{value["buffer"].text(), value["stage"].stage(), value["measure"].text(), value["unit"].text()};
    for (std::size_t kind = 0; kind < kErrorKinds; ++kind)
        row.value[kind] = value[name(static_cast<ErrorKind>(kind))].numberOrNull();
    if (!value.has("drawn")) return row;
    std::vector<double> ends;
    value["drawn"].eachElement([&](const Value& end) { ends.push_back(end.numberOrNull().value_or(0)); });
    if (ends.size() == 2)
        row.drawn = {ends[0], ends[1]};
    else
        value["drawn"].refuse("two numbers");
    return row;
}

StudyPoint readPoint(const Value& value) {
    StudyPoint point;
    point.number = static_cast<std::size_t>(value["number"].whole(0));
    point.values = value["values"].texts();
    point.failure = value["failure"].text();
    point.megabytes = value["megabytes"].number(0);
    value["counters"].eachMember(
        [&](const std::string& what, const Value& v) { point.counters[what] = v.whole(0, 9e15); });
    value["errors"].eachElement([&](const Value& row) { point.errors.push_back(readError(row)); });
    value["blame"].eachElement([&](const Value& blame) {
        constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();
        point.blame.push_back({blame["stage"].stage(), blame["error"].numberOrNull(0).value_or(kNotKnown),
                               blame["share"].numberOrNull().value_or(kNotKnown)});
    });
    point.frame = readTimes(value["frame"]);
    value["stages"].eachMember([&](const std::string& stage, const Value& times) {
        if (const auto found = findStage(stage))
            point.stages[index(*found)] = readTimes(times);
        else
            times.refuse("nothing: no stage has this name");
    });
    return point;
}

void readHead(const Value& root, StudyReport& report) {
    report.scene = root["scene"].text();
    report.file = root["file"].text();
    report.geometry = root["geometry"].text();
    report.version = root["version"].text();
    report.width = count(root["width"], 1);
    report.height = count(root["height"], 1);
    report.threads = count(root["threads"], 0);
    report.warmups = count(root["warmups"], 0);
    report.repeats = count(root["repeats"], 0);
    report.processes = count(root["processes"], 0);
    report.machine = root["machine"].text();
    report.compiler = root["compiler"].text();
    root["load"].eachElement([&](const Value& load) { report.load.push_back(load.number(-1)); });
    root["settings"].eachMember([&](const std::string& key, const Value& v) { report.settings[key] = v.text(); });
    root["axes"].eachElement([&](const Value& axis) {
        report.axes.push_back({axis["key"].text(), axis["label"].text(), axis["values"].texts()});
        if (report.axes.back().values.empty()) axis["values"].refuse("at least one value");
    });
    const Value choice = root["choice"];
    report.choice = {choice["buffer"].text(), choice["measure"].text(), kindOf(choice["kind"])};
    root["references"].eachElement([&](const Value& reference) {
        const std::size_t kind = index(kindOf(reference["kind"]));
        report.references[kind] = reference["name"].text();
        report.whyNone[kind] = reference["why_none"].text();
    });
    // Older files have one bar for all measures, which is that of none.
    if (root.has("error_bars"))
        root["error_bars"].eachElement([&](const Value& row) { report.errorBars.push_back(readError(row)); });
    report.errorWhy = root["error_why"].text();
}

void checkPoint(const Value& value, const StudyReport& report) {
    const StudyPoint& point = report.points.back();
    const bool known = std::ranges::none_of(report.axes, [](const SweepAxis& axis) { return axis.values.empty(); }) &&
                       point.number < pointCount(report.axes);
    if (!known) {
        value["number"].refuse("the number of a point of the sweep");
    } else if (const std::vector<std::string> values = valuesOf(report.axes, point.number); values != point.values) {
        value["values"].refuse(fmt::format("{}, the values of point {}", fmt::join(values, ", "), point.number));
    }
    if (report.points.size() > 1 && report.points[report.points.size() - 2].number >= point.number)
        value["number"].refuse("a number above the one before it");
}

}  // namespace

Result<StudyReport> studyFromJson(std::string_view text, const std::string& file, const Stop& stop) {
    StopCheck check(stop);
    const std::optional<Json> json = Json::read(text, {}, stop);
    if (stop.stop_requested()) return readingStopped(file);
    if (!json) {
        const TextPosition place = positionOf(text, jsonErrorAt(text, stop));
        return Error{{file, place.line, place.column}, "this is not JSON", "a study that the program wrote"};
    }
    Errors errors;
    const Value root(&*json, {}, file, errors);
    if (!json->is(Json::kObject) || root["format"].text() != "shadescope study")
        return Error{{file}, "this is no study", "a study that the program wrote"};
    if (const Value version = root["format_version"]; version.whole(0) != 1) version.refuse("1");
    if (!errors.empty()) return errors;

    StudyReport report;
    readHead(root, report);
    constexpr std::size_t kValuesOfPoint = 100;  // about as many as the program writes for each
    bool isStopped = false;
    root["points"].eachElement([&](const Value& value) {
        if (isStopped = isStopped || check.stopped(kValuesOfPoint); isStopped) return;
        report.points.push_back(readPoint(value));
        checkPoint(value, report);
    });
    if (stop.stop_requested()) return readingStopped(file);
    if (!errors.empty()) return errors;
    return report;
}

}  // namespace pipeline
