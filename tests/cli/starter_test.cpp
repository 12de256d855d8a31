// The starters of shadescope stage, completed in six languages: right, and with 30 planted errors that have a name.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <regex>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"
#include "tests/support/sweep.h"

namespace {

namespace fs = std::filesystem;
using test::has;

struct Language {
    std::string name, extension, compiler;
    std::string number, vector;  // how a variable is declared
    std::string left, right;     // around the components of a vector
    std::string point;           // in place of `left` for a point
    std::string max;             // the greater one of two numbers
    std::string build, run;      // with FILE and OUT; build may be empty
    std::string cull;            // the stage that keeps every polygon
    std::string helpers = {};    // before the body
};
const std::vector<Language> kLanguages{
    {"python", ".py", "python3", "", "", "[", "]", "[", "max", "", "python3 FILE",
     "return {\"polygons.visible\": [1 for polygon in given[\"polygons\"]]}"},
    {"cpp", ".cpp", "g++", "double ", "Vector ", "Vector{", "}", "Point{", "std::max",
     "g++ -std=c++17 -Wall -Werror FILE -o OUT", "OUT",
     "return {{\"polygons.visible\", Rows(given[\"polygons\"].size(), {1.0})}};",
     "[[maybe_unused]] auto add = [](Vector a, Vector b) { return a + b; };\n"
     "[[maybe_unused]] auto sub = [](Vector a, Vector b) { return a - b; };\n"
     "[[maybe_unused]] auto times = [](double k, Vector a) { return k * a; };\n"},
    {"js", ".js", "node", "const ", "const ", "[", "]", "[", "max", "", "node FILE",
     "return { \"polygons.visible\": given.polygons.map(() => 1) };"},
    {"c", ".c", "gcc", "double ", "Vector ", "(Vector){", "}", "(Point){", "fmax",
     "gcc -std=c99 -Wall -Werror FILE -lm -o OUT", "OUT",
     "printf(\"polygons.visible %d 1\\n\", block(\"polygons\")->rows); "
     "for (int i = 0; i < block(\"polygons\")->rows; ++i) puts(\"1\");",
     "(void)result;\n"},
    {"java", ".java", "java", "double ", "double[] ", "new double[] {", "}", "new double[] {", "Math.max", "",
     "java FILE",
     "double[][] kept = new double[given.get(\"polygons\").length][]; java.util.Arrays.fill(kept, new double[] {1}); "
     "result.put(\"polygons.visible\", kept); return result;"},
    {"rust", ".rs", "rustc", "let ", "let ", "[", "]", "[", "f64::max", "rustc FILE -o OUT", "OUT",
     "return vec![(\"polygons.visible\", given[\"polygons\"].iter().map(|_| vec![1.0]).collect())];"},
};

// What stands in the place of the starter's return: in words that all six languages share, but for NUMBER and VECTOR before a
// variable and the brackets of vectors and points.
struct Task {
    std::string function, scene;
    std::vector<std::string> settings;
    std::string right;
    std::array<std::pair<std::string, std::string>, 3> wrong;  // by the mistake's id
};
const std::string kUnit = "; return times(1.0 / length(n), n)";
const std::vector<Task> kTasks{
    {"CalcNormal",
     "pyramid",
     {},
     "VECTOR n = cross(sub(v1, v0), sub(v2, v0))" + kUnit,
     {{{"normal-flip", "VECTOR n = cross(sub(v2, v0), sub(v1, v0))" + kUnit},
       {"not-normalised", "return cross(sub(v1, v0), sub(v2, v0))"},
       {"edge-v1-v2", "VECTOR n = cross(sub(v1, v0), v2)" + kUnit}}}},
    {"facesEye",
     "near_plane",
     {},
     "return dot(N, sub(eye, p)) > 0.0",
     {{{"cull-axis", "return dot(N, axis) < 0.0"},
       {"cull-sign", "return dot(N, sub(p, eye)) > 0.0"},
       {"p-forgotten", "return dot(N, eye) > 0.0"}}}},
    {"project",
     "two_pyramids",
     {},
     "return POINT<W / 2.0 + d * v[0] / v[2], H / 2.0 - d * v[1] / v[2]>",
     {{{"y-down", "return POINT<W / 2.0 + d * v[0] / v[2], H / 2.0 + d * v[1] / v[2]>"},
       {"no-divide", "return POINT<W / 2.0 + d * v[0], H / 2.0 - d * v[1]>"},
       {"half-pixel", "return POINT<W / 2.0 + d * v[0] / v[2] - 0.5, H / 2.0 - d * v[1] / v[2] - 0.5>"}}}},
    {"depthAt",
     "intersecting_polygons",
     {"camera.projection=perspective"},
     "return 1.0 / (lambda[0] / z[0] + lambda[1] / z[1] + lambda[2] / z[2])",
     {{{"z-affine", "return dot(lambda, z)"},
       {"reciprocal", "return lambda[0] / z[0] + lambda[1] / z[1] + lambda[2] / z[2]"},
       {"mean-depth", "return (z[0] + z[1] + z[2]) / 3.0"}}}},
    {"perspectiveWeights",
     "z_buffer_gouraud",
     {},
     "VECTOR w = <lambda[0] / z[0], lambda[1] / z[1], lambda[2] / z[2]>; return times(1.0 / (w[0] + w[1] + w[2]), w)",
     {{{"affine", "return lambda"},
       {"no-sum", "return <lambda[0] / z[0], lambda[1] / z[1], lambda[2] / z[2]>"},
       {"times-z",
        "VECTOR w = <lambda[0] * z[0], lambda[1] * z[1], lambda[2] * z[2]>; "
        "return times(1.0 / (w[0] + w[1] + w[2]), w)"}}}},
    {"lightVector",
     "point_light_shadow",
     {},
     "VECTOR n = sub(pL, p)" + kUnit,
     {{{"l-raw", "return sub(pL, p)"},
       {"light-from", "VECTOR n = sub(p, pL)" + kUnit},
       {"at-infinity", "return times(1.0 / length(pL), pL)"}}}},
    {"lambert",
     "z_buffer_phong",
     {},
     "NUMBER c = max(0.0, dot(N, L)); return <kd[0] * I[0] * c, kd[1] * I[1] * c, kd[2] * I[2] * c>",
     {{{"no-max", "NUMBER c = dot(N, L); return <kd[0] * I[0] * c, kd[1] * I[1] * c, kd[2] * I[2] * c>"},
       {"abs", "NUMBER c = max(dot(N, L), -dot(N, L)); return <kd[0] * I[0] * c, kd[1] * I[1] * c, kd[2] * I[2] * c>"},
       {"no-k", "return times(max(0.0, dot(N, L)), I)"}}}},
    {"mirror",
     "reflection_law",
     {},
     "return sub(times(2.0 * dot(N, L), N), L)",
     {{{"r-flip", "return sub(L, times(2.0 * dot(N, L), N))"},
       {"no-2", "return sub(times(dot(N, L), N), L)"},
       {"no-minus-l", "return times(2.0 * dot(N, L), N)"}}}},
    {"halfway",
     "phong_blinn",
     {"model=blinn-phong"},
     "VECTOR n = add(L, V)" + kUnit,
     {{{"mean", "return times(0.5, add(L, V))"},
       {"sum", "return add(L, V)"},
       {"difference", "VECTOR n = sub(L, V)" + kUnit}}}},
    {"blend",
     "translucent",
     {},
     "return add(times(alpha, C), times(1.0 - alpha, behind))",
     {{{"alpha-swapped", "return add(times(1.0 - alpha, C), times(alpha, behind))"},
       {"additive", "return add(times(alpha, C), behind)"},
       {"no-behind", "return times(alpha, C)"}}}},
};

std::string withReplaced(const std::string& text, const std::string& what, const std::string& with) {
    return std::regex_replace(text, std::regex(what), with);
}

std::string bodyIn(const Language& of, std::string text) {
    text = withReplaced(text, "POINT<([^>]*)>", of.point + "$1" + of.right);
    text = withReplaced(text, "([ =])<([^>]*)>", "$1" + of.left + "$2" + of.right);
    text = withReplaced(withReplaced(text, "NUMBER ", of.number), "VECTOR ", of.vector);
    text = withReplaced(text, "\\bmax\\(", of.max + "(");
    if (of.name == "python") text = withReplaced(text, "\\blambda\\b", "lambda_");
    if (of.name == "c")
        for (const auto& [index, member] : {std::pair{"0", "x"}, {"1", "y"}, {"2", "z"}})
            text = withReplaced(text, "\\[" + std::string(index) + "\\]", "." + std::string(member));
    return of.helpers + text + (of.name == "python" ? "" : ";");
}

// The starter with these lines in the place of its own result; before: the words after the function.
std::string completed(const Language& of, const std::string& starter, const std::string& body, const char* before) {
    const std::size_t reader = starter.find(before);
    const bool isWholeInC = of.name == "c" && starter.find("static void stage(void)") != starter.npos;
    std::size_t begin = starter.rfind("return", reader), end = starter.find('\n', begin);
    if (of.name == "rust" || isWholeInC) end = starter.rfind("\n}", reader), begin = starter.rfind('\n', end - 1) + 1;
    return starter.substr(0, begin) + body + starter.substr(end);
}

test::Finished starterStage(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "stage");
    return test::runIn({"PATH=/usr/local/bin:/usr/bin:/bin"}, arguments);
}

class Starters : public testing::TestWithParam<Language> {};

// Five versions of each of ten functions: right, with each of three mistakes, and the starter as it is.
TEST_P(Starters, agreeWhenTheyAreRightAndAreNamedWhenTheyAreWrong) {
    const Language& of = GetParam();
    if (std::system(("command -v " + of.compiler + " >/dev/null").c_str()) != 0)
        GTEST_SKIP() << of.compiler << " is missing: the starters in " << of.name << " were not tried";
    constexpr std::size_t kVersions = 5;
    const std::size_t all = kTasks.size() * kVersions;
    // All of them in one language, in each other one some, from another one on.
    const auto shift = 7 * std::size_t(std::ranges::find(kLanguages, of.name, &Language::name) - kLanguages.begin());
    for (const std::size_t one : test::sweep(all, test::longRun(), of.name == "js" ? all : 5)) {
        const std::size_t sample = (one + shift) % all;
        const Task& task = kTasks[sample / kVersions];
        const std::size_t version = sample % kVersions;
        const test::TemporaryFolder folder;
        const auto written = starterStage({task.function, "--starter", of.name, "-o", folder.path().string()});
        ASSERT_EQ(written.status, 0) << written.err;
        const fs::path file = folder / (task.function + of.extension), out = folder / "mine";
        if (version < 4) {
            const std::string body = bodyIn(of, version == 0 ? task.right : task.wrong[version - 1].second);
            test::writeText(file, completed(of, test::readText(file), body, "Reads the calls"));
        }
        const auto command = [&](const std::string& pattern) {
            return withReplaced(withReplaced(pattern, "FILE", file.string()), "OUT", out.string());
        };
        const std::string title = of.name + ", " + task.function + ", version " + std::to_string(version) + "\n";
        const int built = of.build.empty() ? 0 : std::system(command(of.build).c_str());
        ASSERT_EQ(built, 0) << title << test::readText(file);
        std::vector<std::string> arguments{task.function, task.scene, "--with", command(of.run)};
        for (const std::string& setting : task.settings) arguments.insert(arguments.end(), {"--set", setting});
        const auto judged = starterStage(arguments);
        EXPECT_EQ(judged.status, version == 0 ? 0 : 1) << title << judged.out << judged.err;
        const std::string expected = version == 0 ? "Right: all" : version == 4 ? " differ." : "The mistake: ";
        EXPECT_TRUE(has(judged.out, expected)) << title << judged.out;
        const std::string name = version % 4 == 0 ? "" : "(" + task.wrong[version - 1].first + ").";
        EXPECT_TRUE(has(judged.out, name)) << title << judged.out;
    }
}

// The starter of a whole stage gives nothing as it is; with its line it leaves out culling, and reads and writes blocks.
TEST_P(Starters, ofAWholeStageReadAndWriteBlocks) {
    const Language& of = GetParam();
    if (std::system(("command -v " + of.compiler + " >/dev/null").c_str()) != 0)
        GTEST_SKIP() << of.compiler << " is missing: the starters in " << of.name << " were not tried";
    const test::TemporaryFolder folder;
    ASSERT_EQ(starterStage({"cull", "--starter", of.name, "-o", folder.path().string()}).status, 0);
    const fs::path file = folder / ("cull" + of.extension), out = folder / "mine";
    const std::string starter = test::readText(file);
    const auto command = [&](const std::string& pattern) {
        return withReplaced(withReplaced(pattern, "FILE", file.string()), "OUT", out.string());
    };
    const auto judge = [&] {
        EXPECT_EQ(of.build.empty() ? 0 : std::system(command(of.build).c_str()), 0) << test::readText(file);
        return starterStage({"cull", "pyramid", "--with", command(of.run)});
    };
    const auto asItIs = judge();
    EXPECT_TRUE(has(asItIs.err, "found its end, expected one of polygons.visible")) << asItIs.err;
    test::writeText(file, completed(of, starter, of.cull, "Reads the blocks"));
    const auto kept = judge();
    EXPECT_EQ(kept.status, 1) << kept.err;
    EXPECT_TRUE(has(kept.out, "Cull is the first wrong stage")) << kept.out;
}

INSTANTIATE_TEST_SUITE_P(Stage, Starters, testing::ValuesIn(kLanguages), [](const auto& of) { return of.param.name; });

}  // namespace
