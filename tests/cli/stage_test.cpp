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

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    return at == text.npos ? text : text.replace(at, what.size(), with);
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

// The stage of normals, its starter completed: cross products of the first three vertices, of length 1. In a pyramid that is
// every polygon's normal; turned round it is the known error normal-flip, of this stage.
TEST(Stage, aWholeStageIsComparedWithWhatItWasHanded) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(stage({"normals", "--starter", "python", "-o", folder.path().string()}).status, 0);
    const fs::path file = folder / "normals.py";
    const std::string starter = test::readText(file);
    EXPECT_TRUE(has(starter, "# CalcNormal(v0, v1, v2): Two edges from v0")) << starter;
    const auto judge = [&](const std::string& sign) {
        test::writeText(file, replaced(starter, "    return {}", R"(    v, normals = given["vertices.world"], []
    for p in given["polygons"]:
        n = cross(sub(v[p[1]], v[p[0]]), sub(v[p[2]], v[p[0]]))
        normals.append(times()" + sign + R"( / length(n), n))
    return {"polygons.normal": normals})"));
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

// Three lights of different colours: the starter as it is differs first for the first of them, at polygon 0, since terms of
// polygons are computed before those of pixels.
TEST(Stage, aCallOfShadingIsOfAPlaceAndALight) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(stage({"lambert", "--starter", "python", "-o", folder.path().string()}).status, 0);
    const auto judged = stage(
        {"lambert", "coloured_lights", "--size", "40x30", "--with", "python3 " + (folder / "lambert.py").string()});
    EXPECT_TRUE(has(judged.out, "The first is polygon 0, light 0: lambert returns (0, 0, 0)")) << judged.out;
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
