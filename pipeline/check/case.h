#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/stop.h"
#include "pipeline/run/runner.h"
#include "pipeline/scene/scene.h"

// The catalogue of stiff and extreme cases: inputs on which a formula that looks right fails, and what the program
// gives there. A case is one row and one function, in the file of its group.
namespace pipeline::check {

enum class Group : std::uint8_t { Geometry, Camera, Raster, Depth, Shading, Shadow, Limits };
inline constexpr std::size_t kGroupCount = 7;
std::string_view name(Group group);   // "geometry", as --group takes it
std::string_view title(Group group);  // "Geometry"

// How a case ends. There is no fourth way.
enum class Outcome : std::uint8_t { Value, Empty, Error };
std::string_view name(Outcome outcome);  // "value"

// What running a case found. Both numbers are in the case's measure, smaller is better.
struct Finding {
    // Of the naive form, evaluated and not quoted; NaN where that is what it gives.
    double naive = std::numeric_limits<double>::quiet_NaN();
    double ours = std::numeric_limits<double>::quiet_NaN();
    std::string naiveText{}, oursText{};  // what a table shows instead of the numbers; may be empty
};

// Runs the program's own stages for a case and watches over what every case promises.
class Trial {
public:
    explicit Trial(int threads) : m_threads(threads) {}

    // The frame of a scene that checkScene accepts, with every buffer that `wanted` has. NaN, and any infinity but
    // that of a depth where nothing was drawn, breaks the case.
    FramePtr frame(const Scene& scene, BufferSet wanted = BufferSet().set(), StageId until = StageId::Shading);
    // What must be true beside the measure.
    void demand(bool truth, std::string_view otherwise);

    const std::string& broken() const { return m_broken; }  // why the case breaks; empty while it holds

private:
    int m_threads;
    std::string m_broken;
};

// What makes a case stiff, over its range: the errors of both forms, in the case's measure.
struct Knob {
    std::string_view label{};    // "exponent e"; empty: the case has no knob
    std::string_view setting{};  // the key of the scene's setting that it is, or empty
    double low = 1, high = 10;
    bool logarithmic = true;
    double (*naive)(double at) = nullptr;
    double (*ours)(double at) = nullptr;
    Scene (*scene)(double at) = nullptr;  // the case's scene there, where no one setting makes it
};

struct Case {
    std::string_view id;  // "S10": stable, of the catalogue
    Group group = Group::Geometry;
    std::string_view title{};            // "Specular exponent"
    std::string_view input{};            // "e = 1 to 10⁶, 4000 angles each"
    std::string_view naive{};            // the naive form, one line
    std::string_view stable{};           // ours, one line
    std::string_view measure{}, unit{};  // what the numbers are: "largest error", "°"
    std::string_view reference{};        // what they are measured against
    double bound = 0;                    // holds when ours <= bound
    Outcome outcome = Outcome::Value;
    Finding (*run)(Trial&) = nullptr;
    Scene (*scene)() = nullptr;  // the case as a scene, where it has one
    // Settings that let the stages use the naive form in that scene, "KEY=VALUE" by blanks; empty where it has none.
    std::string_view naiveWith{};
    Knob knob{};
};

// All cases, group by group.
std::span<const Case> caseTable();
// Null where there is no such id; letters in any case.
const Case* findCase(std::string_view id);

struct CaseResult {
    const Case* what = nullptr;
    Finding finding;
    bool holds = false;
    std::string reason;  // why it breaks; empty where it holds
    double milliseconds = 0;

    std::string naiveText() const, oursText() const, boundText() const;
};
// "1.1e-7", "0 pixels", "NaN"
std::string measured(double value, std::string_view unit);

// Which cases run: with no id, all of a group; with neither, all.
struct Filter {
    std::vector<std::string> ids{};
    std::vector<Group> groups{};
    bool admits(const Case& which) const;
};

// The scene of a case as the naive form shows it. Nothing where none of its settings does.
std::optional<Scene> withNaiveForm(const Case& which, Scene scene);

CaseResult runCase(const Case& which, int threads = 1);
// In the order of the table, several at a time. threads 0: as many as the machine has. Cases not begun when a stop
// is asked for are not in the result. `each` is told of every result as it comes, by the threads that run the cases.
std::vector<CaseResult> runChecks(const Filter& filter, int threads, Stop stop = {},
                                  const std::function<void(const CaseResult&)>& each = {});

// The rows of each file of cases.
std::span<const Case> geometryCases();
std::span<const Case> polygonCases();
std::span<const Case> readerCases();
std::span<const Case> cameraCases();
std::span<const Case> coverageCases();
std::span<const Case> clipCases();
std::span<const Case> depthCases();
std::span<const Case> normalCases();
std::span<const Case> lightCases();
std::span<const Case> highlightCases();
std::span<const Case> biasCases();
std::span<const Case> shadowCases();
std::span<const Case> limitCases();

}  // namespace pipeline::check
