// shadescope stage: a function of the pipeline in a program of one's own, as its author would write, run and mend it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;
using test::has;

// The environment of a user who finds python3 and node.
const std::vector<std::string> kUser{"PATH=/usr/local/bin:/usr/bin:/bin"};

test::Finished stage(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "stage");
    return test::runIn(kUser, arguments);
}

struct Language {
    std::string name, extension, zero, right, flipped;  // what the starter returns, and what stands in its place
    std::string build, run;                             // with FILE and OUT; build may be empty
};
const std::vector<Language> kLanguages{
    {"python", ".py", "return [0, 0, 0]", "n = cross(sub(v1, v0), sub(v2, v0)); return times(1 / length(n), n)",
     "n = cross(sub(v2, v0), sub(v1, v0)); return times(1 / length(n), n)", "", "python3 FILE"},
    {"cpp", ".cpp", "return {};", "Vector n = cross(v1 - v0, v2 - v0); return 1 / length(n) * n;",
     "Vector n = cross(v2 - v0, v1 - v0); return 1 / length(n) * n;", "g++ -std=c++17 -Wall -Werror FILE -o OUT",
     "OUT"},
    {"c", ".c", "return result;", "result = cross(sub(v1, v0), sub(v2, v0)); return times(1 / length(result), result);",
     "result = cross(sub(v2, v0), sub(v1, v0)); return times(1 / length(result), result);",
     "gcc -std=c99 -Wall -Werror FILE -lm -o OUT", "OUT"},
    {"js", ".js", "return [0, 0, 0];", "const n = cross(sub(v1, v0), sub(v2, v0)); return times(1 / length(n), n);",
     "const n = cross(sub(v2, v0), sub(v1, v0)); return times(1 / length(n), n);", "", "node FILE"},
};

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    return at == text.npos ? text : text.replace(at, what.size(), with);
}
std::string command(const std::string& pattern, const fs::path& file, const fs::path& out) {
    return replaced(replaced(pattern, "FILE", file.string()), "OUT", out.string());
}

TEST(Stage, startersAreCompletedBuiltAndJudgedInFourLanguages) {
    for (const Language& of : kLanguages) {
        if (of.name == "js" && std::system("command -v node >/dev/null") != 0) continue;
        const test::TemporaryFolder folder;
        const auto written = stage({"CalcNormal", "--starter", of.name, "-o", folder.path().string()});
        ASSERT_EQ(written.status, 0) << written.err;
        const fs::path file = folder / ("CalcNormal" + of.extension), out = folder / "mine";
        const std::string starter = test::readText(file);
        for (const auto& [body, status, words] : {std::tuple{of.right, 0, "Right: all 5 results"},
                                                  {of.flipped, 1, "normal-flip"},
                                                  {of.zero, 1, "Not yet"}}) {
            test::writeText(file, replaced(starter, of.zero, body));
            const std::string build = of.build.empty() ? "true" : command(of.build, file, out);
            ASSERT_EQ(std::system(build.c_str()), 0) << of.name;
            const auto judged = stage({"CalcNormal", "pyramid", "--with", command(of.run, file, out)});
            EXPECT_EQ(judged.status, status) << of.name << ": " << judged.out << judged.err;
            EXPECT_TRUE(has(judged.out, words)) << of.name << ": " << judged.out;
        }
    }
}

TEST(Stage, startersOfEveryFunctionRunAsTheyAre) {
    const test::TemporaryFolder folder;
    // Points, lists, a truth, and a parameter that is a word of Python.
    for (const char* function :
         {"isVisible", "vertexNormal", "project", "depthAt", "setpixel", "total", "frameBuffer"}) {
        ASSERT_EQ(stage({function, "--starter", "python", "-o", folder.path().string()}).status, 0);
        const fs::path file = folder / (std::string(function) + ".py");
        const auto judged = stage({function, "two_pyramids", "--size", "64x48", "--with", "python3 " + file.string()});
        EXPECT_EQ(judged.status, 1) << function << ": " << judged.out << judged.err;
    }
}

// The starter of setpixel with z < zbuffer, and with a depth that is never written: later fragments then meet a depth that the
// right function never leaves, and the program is asked again.
TEST(Stage, thePictureGoesOnWithWhatTheProgramStored) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(stage({"setpixel", "--starter", "python", "-o", folder.path().string()}).status, 0);
    const fs::path file = folder / "setpixel.py", page = folder / "report.html";
    const std::string starter = test::readText(file);
    const auto judge = [&](const char* body) {
        test::writeText(file, replaced(starter, "return [0, 0]", body));
        return stage(
            {"setpixel", "two_pyramids", "--size", "80x60", "--with", "python3 " + file.string(), "-o", page.string()});
    };
    EXPECT_EQ(judge("return [z, c] if z < zbuffer else [zbuffer, color]").status, 0);
    EXPECT_TRUE(has(test::readText(page), "The pictures are equal"));
    const auto never = judge("return [zbuffer, c] if z < zbuffer else [zbuffer, color]");
    EXPECT_EQ(never.status, 1);
    EXPECT_TRUE(has(never.out, "z-no-write")) << never.out;
    EXPECT_TRUE(has(never.out, "color = -1")) << never.out;  // the first fragment meets an empty pixel
    EXPECT_FALSE(has(never.out, "stand in")) << never.out;
    EXPECT_TRUE(has(test::readText(page), "Where they differ"));
}

// The stage of normals in Python: cross products of the first three vertices, of length 1. In a pyramid that is every polygon's
// normal; turned round it is the known error normal-flip, of this stage.
TEST(Stage, aWholeStageIsComparedWithWhatItWasHanded) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "normals.py";
    const std::string program = R"(
import sys
words = iter(sys.stdin.read().split())
blocks = {}
for name in words:
    rows, columns = int(next(words)), int(next(words))
    if name != "picture":
        blocks[name] = [[float(next(words)) for _ in range(columns or int(next(words)))] for _ in range(rows)]
v, polygons = blocks["vertices.world"], blocks["polygons"]
print("polygons.normal", len(polygons), 3)
for p in polygons:
    a, b = ([x - y for x, y in zip(v[int(p[i])], v[int(p[0])])] for i in (1, 2))
    n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    print(*(SIGN * x / sum(y * y for y in n) ** 0.5 for x in n))
)";
    const auto judge = [&](const char* sign) {
        test::writeText(file, replaced(program, "SIGN", sign));
        return stage({"normals", "pyramid", "--with", "python3 " + file.string()});
    };
    const auto right = judge("1"), flipped = judge("-1");
    EXPECT_EQ(right.status, 0) << right.out << right.err;
    EXPECT_EQ(flipped.status, 1) << flipped.out << flipped.err;
    EXPECT_TRUE(has(flipped.out, "Normals is the first wrong stage")) << flipped.out;
    const auto wrong = stage({"normals", "pyramid", "--with", "echo polygons.normal 4 3"});
    EXPECT_EQ(wrong.status, 3);
    EXPECT_TRUE(has(wrong.err, "found \"4\", expected 5 rows of polygons.normal")) << wrong.err;
}

TEST(Stage, whatAProgramSaysNeverBecomesMarkup) {
    const test::TemporaryFolder folder;
    const fs::path page = folder / "report.html";
    const auto judged = stage(
        {"iMax", "pyramid", "--with", "echo '<script>alert(1)</script>' >&2; echo iMax 1 1 7", "-o", page.string()});
    EXPECT_EQ(judged.status, 1) << judged.out << judged.err;
    EXPECT_TRUE(has(test::readText(page), "&lt;script&gt;alert(1)"));
    EXPECT_FALSE(has(test::readText(page), "<script>alert"));
}

TEST(Stage, whatCannotBeJudgedSaysWhy) {
    const auto says = [](const std::vector<std::string>& arguments, int status, const char* words) {
        const auto result = stage(arguments);
        EXPECT_EQ(result.status, status) << result.out << result.err;
        EXPECT_TRUE(has(result.err, words)) << result.err;
    };
    says({"CalcNorml", "pyramid", "--with", "true"}, 2, "the nearest name is CalcNormal");
    says({"CalcNormal", "pyramid"}, 2, "--with is missing");
    says({"CalcNormal", "pyramid", "--with", "true"}, 3, "found its end, expected \"CalcNormal 5 3\"");
    says({"CalcNormal", "pyramid", "--with", "echo CalcNormal 4 3"}, 3, "found \"4\", expected 5 rows");
    says({"CalcNormal", "pyramid", "--with", "echo no such luck >&2; exit 7"}, 3, "no such luck");
    says({"normalAt", "pyramid", "--with", "true"}, 3, "shading = phong");
    says({"CalcNormal", "--starter", "python"}, 2, "--starter needs -o");
}

}  // namespace
