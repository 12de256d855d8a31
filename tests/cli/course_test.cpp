// Assignments in which students' programs run: a class, one student, and programs that do not end.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;
using test::has;

// Two scenes that students see and two hidden ones: a quarter of the 12 points each.
const std::string kCourse = R"(title = "Normals"
seconds = 3
[[task]]
stage = "CalcNormal"
scenes = ["pyramid", "cube.toml"]
hidden = ["two_pyramids", "secret.toml"]
run = "python3 CalcNormal.py"
points = 12
)";
const std::string kRight = "n = cross(sub(v1, v0), sub(v2, v0)); return times(1 / length(n), n)";
const std::string kFlipped = "n = cross(sub(v2, v0), sub(v1, v0)); return times(1 / length(n), n)";

test::Finished command(std::vector<std::string> arguments) {
    return test::runIn({"PATH=/usr/local/bin:/usr/bin:/bin"}, arguments);
}

class Course : public testing::Test {
protected:
    Course() {
        fs::create_directories(m_folder / "course");
        test::writeText(m_folder / "course/course.toml", kCourse);
        for (const char* name : {"cube.toml", "secret.toml"})
            fs::copy_file(test::scene("gl_cube.toml"), m_folder / "course" / name);
        for (const char* name : {"cube.des", "box.des"}) fs::copy_file(test::scene(name), m_folder / "course" / name);
        EXPECT_EQ(command({"stage", "CalcNormal", "--starter", "python", "-o", m_folder / "starter"}).status, 0);
        m_starter = test::readText(m_folder / "starter/CalcNormal.py");
    }

    // The starter with another result. before: lines at the beginning of the file.
    void handIn(const std::string& student, const std::string& body, const std::string& before = {}) {
        const fs::path folder = m_folder / "handed-in" / student;
        fs::create_directories(folder);
        std::string text = m_starter;
        const std::string zero = "return [0, 0, 0]";
        test::writeText(folder / "CalcNormal.py", before + text.replace(text.find(zero), zero.size(), body));
    }

    std::string path(const std::string& name) const { return m_folder / name; }
    test::Finished mark() {
        return command({"compare", "--class", path("course/course.toml"), path("handed-in"), "-o", path("class")});
    }

    test::TemporaryFolder m_folder;
    std::string m_starter;
};

// Right: 4 · 3. A known mistake: 4 · 1.5. The first scene right alone: the pyramid has 5 polygons, and no other scene does: 3.
// A hanging one, one that ends with an error, one that prints nothing and an empty folder: none. None stops the others.
TEST_F(Course, ProgramsOfAClassGetThePointsThatAreComputedByHand) {
    const std::map<std::string, double> points{{"ann", 12}, {"ben", 6}, {"cem", 3}, {"dora", 0},
                                               {"eva", 0},  {"fay", 0}, {"gus", 0}, {"hal", 0}};
    handIn("ann", kRight);
    handIn("ben", kFlipped);
    handIn("cem", "n = cross(sub(v1, v0), sub(v2, v0)); return times((rows == 5) / length(n), n)");
    handIn("dora", kRight, "while True: pass\n");
    handIn("eva", kRight, "def f(n): return f(n) + 1\nf(0)\n");
    handIn("fay", kRight, "sum(range(10**12))\n");
    handIn("gus", kRight, "raise SystemExit\n");
    fs::create_directories(path("handed-in/hal"));
    fs::create_symlink(path("handed-in/ann/CalcNormal.py"), path("handed-in/hal/CalcNormal.py"));
    const std::string before = test::readText(path("handed-in/ann/CalcNormal.py"));

    const auto marked = mark();
    EXPECT_EQ(marked.status, 3) << marked.out << marked.err;  // some could not be judged
    EXPECT_TRUE(has(marked.err, "not confined")) << marked.err;
    EXPECT_TRUE(has(marked.err, "confine = \"bwrap ")) << marked.err;
    const auto all = nlohmann::json::parse(test::readText(path("class/class.json")));
    ASSERT_EQ(all["students"].size(), points.size());
    std::map<std::string, nlohmann::json> students;
    for (const auto& student : all["students"]) {
        const std::string name = student["student"];
        students[name] = student;
        EXPECT_EQ(student["points"], points.at(name)) << student.dump(1);
        EXPECT_EQ(student["of"], 12);
    }
    EXPECT_EQ(students["ben"]["tasks"][0]["error"]["id"], "normal-flip");
    EXPECT_EQ(students["ben"]["tasks"][0]["first_wrong"], "Normals");
    EXPECT_TRUE(has(students["dora"].dump(), "still running after 3 s"));
    EXPECT_TRUE(has(students["dora"].dump(), "not run after it was ended"));
    EXPECT_TRUE(has(students["eva"].dump(), "RecursionError"));
    EXPECT_TRUE(has(students["fay"].dump(), "still running after 3 s"));
    EXPECT_TRUE(has(students["gus"].dump(), "found its end"));
    EXPECT_TRUE(has(students["hal"].dump(), "a link to another file"));
    EXPECT_EQ(all["errors"][0]["students"], nlohmann::json({"ben"}));

    const std::string table = test::readText(path("class/students.csv"));
    EXPECT_TRUE(has(table, "ben,6,12,6,Normals,normal-flip,0")) << table;
    EXPECT_TRUE(has(test::readText(path("class/moodle.csv")), "ann,ann,12,12"));
    EXPECT_TRUE(has(test::readText(path("class/junit.xml")), "name=\"hidden 2\""));
    EXPECT_EQ(nlohmann::json::parse(test::readText(path("class/students/ben/results.json")))["score"], 6);
    EXPECT_TRUE(fs::exists(path("class/students/ben/CalcNormal.pyramid.html")));

    // Hidden scenes stay hidden, and hand-ins as they were.
    for (const auto& file : fs::recursive_directory_iterator(path("class")))
        EXPECT_FALSE(file.is_regular_file() && has(test::readText(file.path()), "secret")) << file.path();
    EXPECT_EQ(test::readText(path("handed-in/ann/CalcNormal.py")), before);
    EXPECT_EQ(std::distance(fs::directory_iterator(path("handed-in/ann")), {}), 1);

    // Marked already, nobody waits for the hanging ones again: a program that would now be right is not run.
    const std::string marks = test::readText(path("class/students/dora/marks.json"));
    EXPECT_EQ(mark().status, 3);
    EXPECT_EQ(test::readText(path("class/students/dora/marks.json")), marks);
}

// The student's file has no hidden scenes: half of the points for each scene that is left.
TEST_F(Course, AStudentSeesThePointsOfTheScenesThatAreGivenOut) {
    handIn("ann", kRight);
    handIn("ben", kFlipped);
    std::string given = kCourse;
    given.erase(given.find("hidden"), given.find("run = ") - given.find("hidden"));
    test::writeText(path("course/given.toml"), given);
    const auto run = [&](const std::string& student, const std::string& course) {
        return command({"stage", "--course", path("course/" + course), path("handed-in/" + student), "-o",
                        path("pages of " + student)});
    };
    const auto right = run("ann", "given.toml");
    EXPECT_EQ(right.status, 0) << right.out << right.err;
    EXPECT_TRUE(has(right.out, "CalcNormal: Right in 2 scenes.")) << right.out;
    EXPECT_TRUE(has(right.out, "12 of 12 points")) << right.out;
    const auto wrong = run("ben", "given.toml");
    EXPECT_EQ(wrong.status, 1) << wrong.out << wrong.err;
    EXPECT_TRUE(has(wrong.out, "3 of 6  pyramid: differs; one known error explains the results")) << wrong.out;
    EXPECT_TRUE(has(wrong.out, "6 of 12 points")) << wrong.out;
    EXPECT_TRUE(has(wrong.out, "(normal-flip)")) << wrong.out;
    EXPECT_TRUE(has(test::readText(path("pages of ben/CalcNormal.pyramid.html")), "Where they differ"));
    EXPECT_TRUE(has(test::readText(path("pages of ben/index.html")), "CalcNormal.pyramid.html"));
    EXPECT_TRUE(has(run("ben", "course.toml").out, "hidden 1: differs")) << "with the teacher's file";
    EXPECT_EQ(command({"stage", "--course", path("course/given.toml"), path("nobody")}).status, 3);
    EXPECT_EQ(command({"stage", "--course", path("course/given.toml"), path("handed-in/ann"), "--watch"}).status, 2);
}

// What a course gives away in students' pages: with 1 neither the place nor the mistake.
TEST_F(Course, GivesAwayNoMoreThanItsHints) {
    handIn("ben", kFlipped);
    test::writeText(path("course/course.toml"), "hints = 1\n" + kCourse);
    EXPECT_EQ(mark().status, 0);
    const std::string page = test::readText(path("class/students/ben/CalcNormal.pyramid.html"));
    EXPECT_TRUE(has(page, "Not yet: 5 of 5 results"));
    EXPECT_FALSE(has(page, "polygon 0"));
    EXPECT_FALSE(has(page, "wrong order"));
    EXPECT_EQ(nlohmann::json::parse(test::readText(path("class/class.json")))["errors"][0]["id"], "normal-flip");
}

// A whole stage has its points by buffer; a program is built once; both sit in a folder of their own.
TEST_F(Course, AStageIsBuiltAndHasPointsByBuffer) {
    test::writeText(path("course/course.toml"), R"([[task]]
stage = "normals"
folder = "second"
scenes = ["pyramid"]
build = "gcc -std=c99 normals.c -o normals"
run = "./normals"
points = {"polygons.normal" = 8, "vertices.normal" = 4}
)");
    fs::create_directories(path("handed-in/ann/second"));
    test::writeText(path("handed-in/ann/second/normals.c"), R"(#include <stdio.h>
int main(void) {
    puts("polygons.normal 5 3");
    for (int i = 0; i < 5; ++i) puts("0 0 1");
}
)");
    fs::create_directories(path("handed-in/ben/second"));
    test::writeText(path("handed-in/ben/second/normals.c"), "int main(void) { return }");
    EXPECT_EQ(mark().status, 3);
    const auto all = nlohmann::json::parse(test::readText(path("class/class.json")));
    const auto& ann = all["students"][0]["tasks"][0];
    EXPECT_EQ(ann["marks"][0]["name"], "pyramid: polygons.normal");
    EXPECT_EQ(ann["marks"][0]["of"], 8);
    EXPECT_EQ(ann["marks"][0]["points"], 0) << ann.dump(1);  // upwards, which no known error explains
    EXPECT_EQ(ann["marks"][1]["words"], "no file");
    EXPECT_TRUE(has(all["students"][1].dump(), "build: Your program ended with status 1.")) << all["students"][1];
}

TEST_F(Course, AFileThatCannotBeMarkedSaysWhere) {
    const auto says = [&](const std::string& what, const std::string& with, const char* words) {
        std::string text = kCourse;
        test::writeText(path("course/course.toml"), text.replace(text.find(what), what.size(), with));
        const auto result = command({"stage", "--course", path("course/course.toml"), m_folder.path().string()});
        EXPECT_EQ(result.status, 3);
        EXPECT_TRUE(has(result.err, "course.toml:") && has(result.err, words)) << result.err;
    };
    says("\"CalcNormal\"", "\"CalcNorml\"", "course.toml:4:");
    says("\"CalcNormal\"", "\"shadowFactor\"", "never called in this scene");
    says("run = \"python3 CalcNormal.py\"", "", "scenes, run and points");
    says("cube.toml", "../cube.toml", "no scene");
    says("two_pyramids", "pyramid", "two scenes are called pyramid");
    says("points = 12", "points = {color = 2}", "points");
}

// The line that the message prints, where bwrap may be used.
TEST_F(Course, ACourseCanConfineItsPrograms) {
    const std::string line =
        "bwrap --ro-bind / / --dev /dev --proc /proc --tmpfs /tmp --bind $PWD $PWD --chdir $PWD --unshare-all "
        "--die-with-parent";
    if (std::system("bwrap --ro-bind / / --unshare-all true 2>/dev/null") != 0)
        GTEST_SKIP() << "bwrap is missing, or may not be used here";
    handIn("ann", kRight, "open('written here', 'w')\n");
    handIn("ben", kRight, "open('" + path("written there") + "', 'w')\n");
    test::writeText(path("course/course.toml"), "confine = \"" + line + "\"\n" + kCourse);
    const auto marked = mark();
    EXPECT_FALSE(has(marked.err, "not confined")) << marked.err;
    EXPECT_TRUE(has(test::readText(path("class/students.csv")), "ann,12,12")) << marked.err;
    EXPECT_TRUE(has(test::readText(path("class/students.csv")), "ben,0,12"));
}

}  // namespace
