#include "tests/architecture/rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

// First that each rule finds a breach planted for it, and nothing in what only looks like one;
// then that the project keeps it.
namespace architecture {
namespace {

const SourceTree& project() {
    static const SourceTree tree = readSourceTree(SHADESCOPE_ROOT);
    return tree;
}

std::string text(const Breaches& breaches) {
    std::string result;
    for (const std::string& line : breaches) result += line + "\n";
    return result;
}

void expectKept(const Breaches& breaches) { EXPECT_TRUE(breaches.empty()) << text(breaches); }

// One breach, at this place.
void expectOne(const Breaches& breaches, std::string_view place) {
    ASSERT_EQ(breaches.size(), 1u) << text(breaches);
    EXPECT_TRUE(breaches[0].starts_with(place)) << breaches[0];
}

TEST(Architecture, TheProjectIsRead) {
    const auto has = [](std::string_view path) {
        return std::ranges::any_of(project(), [&](const SourceFile& file) { return file.path == path; });
    };
    EXPECT_TRUE(has("pipeline/CMakeLists.txt"));
    EXPECT_TRUE(has("tests/architecture/rules_test.cpp"));
    for (const SourceFile& file : project()) EXPECT_FALSE(file.path.starts_with("build/")) << file.path;
}

TEST(Architecture, IncludesAreRooted) {
    expectOne(
        unrootedIncludes({{"pipeline/run/runner.cpp", {"", "#include \"runner.h\""}}, {"pipeline/run/runner.h", {""}}}),
        "pipeline/run/runner.cpp:2:");
    expectKept(unrootedIncludes(
        {{"pipeline/run/runner.cpp", {"#include \"pipeline/run/runner.h\""}}, {"pipeline/run/runner.h", {""}}}));
    expectKept(unrootedIncludes(project()));
}

TEST(Architecture, IncludesPointOneWay) {
    expectOne(includesPointingBack({{"pipeline/run/runner.cpp", {"#include \"pipeline/formats/scene_reader.h\""}}}),
              "pipeline/run/runner.cpp:1:");
    for (const char* back : {"plan/plan.h", "run/frame.h", "simd/cull.h"})
        expectOne(
            includesPointingBack({{"pipeline/stages/cull.cpp", {"#include \"pipeline/" + std::string(back) + '"'}}}),
            "pipeline/stages/cull.cpp:1:");
    expectOne(includesPointingBack({{"pipeline/plan/plan.cpp", {"#include \"pipeline/run/runner.h\""}}}),
              "pipeline/plan/plan.cpp:1:");
    expectOne(includesPointingBack({{"pipeline/new/new.cpp", {"#include <vector>"}}}), "pipeline/new/new.cpp:1:");
    expectKept(includesPointingBack({{"pipeline/run/runner.cpp", {"#include \"pipeline/plan/plan.h\""}}}));
    expectOne(includesPointingBack({{"pipeline/export/npy.cpp", {"#include \"lessons/lesson.h\""}}}),
              "pipeline/export/npy.cpp:1:");
    expectOne(includesPointingBack({{"lessons/state/cue_list.h", {"#include \"lessons/lesson.h\""}}}),
              "lessons/state/cue_list.h:1:");
    expectOne(includesPointingBack({{"app/document/document.h", {"// ", "#include \"app/inspector/plan_panel.h\""}}}),
              "app/document/document.h:2:");
    expectOne(includesPointingBack({{"app/cli/export.cpp", {"#include \"app/document/document.h\""}}}),
              "app/cli/export.cpp:1:");
    expectOne(includesPointingBack({{"app/web/core/core.cpp", {"#include \"app/cli/cli.h\""}}}),
              "app/web/core/core.cpp:1:");
    expectOne(includesPointingBack({{"lessons/lesson.cpp", {"#include \"tests/unit/scenes.h\""}}}),
              "lessons/lesson.cpp:1:");
    expectKept(includesPointingBack({{"app/inspector/plan_panel.h",
                                      {"#include \"app/document/document.h\"", "#include \"lessons/lesson.h\"",
                                       "#include \"pipeline/export/npy.h\"", "#include \"pipeline/plan/plan.h\""}}}));
    expectOne(includesPointingBack({{"app/new/new.h", {"#include <QWidget>"}}}), "app/new/new.h:1:");
    expectKept(includesPointingBack(project()));
}

TEST(Architecture, PanelsKnowNoOtherPanel) {
    const SourceFile table{"app/docks/panel_table.cpp",
                           {"#include \"app/inspector/plan_panel.h\"", "#include \"app/settings/scene_tree.h\""}};
    const SourceFile own{"app/inspector/plan_panel.cpp",
                         {"#include \"app/inspector/plan_panel.h\"", "#include \"app/widgets/number_field.h\""}};
    expectKept(panelsIncludingPanels({table, own}));
    expectOne(
        panelsIncludingPanels({table, {"app/inspector/plan_row.h", {"", "#include \"app/settings/scene_tree.h\""}}}),
        "app/inspector/plan_row.h:2:");
    expectKept(panelsIncludingPanels(project()));
}

TEST(Architecture, ToolkitsStayInTheirFolders) {
    expectOne(misplacedToolkits({{"pipeline/run/runner.h", {"#include <QString>"}}}), "pipeline/run/runner.h:1:");
    expectOne(misplacedToolkits({{"lessons/lesson.h", {"#include <QtCore/QString>"}}}), "lessons/lesson.h:1:");
    expectOne(misplacedToolkits({{"app/cli/plan.cpp", {"#include <QImage>"}}}), "app/cli/plan.cpp:1:");
    expectOne(misplacedToolkits({{"app/inspector/plan_panel.h", {"#include <QWidget>", "#include <vtkActor.h>"}}}),
              "app/inspector/plan_panel.h:2:");
    expectOne(misplacedToolkits({{"lessons/grading/grade.cpp", {"#include <nlohmann/json.hpp>"}}}),
              "lessons/grading/grade.cpp:1:");
    expectKept(misplacedToolkits({{"app/vtk/world_scene.cpp", {"#include <QOpenGLWidget>", "#include <vtkActor.h>"}}}));
    expectKept(misplacedToolkits(project()));
}

TEST(Architecture, ThePipelineIsPure) {
    expectOne(impurePipeline({{"pipeline/scene/mesh/mesh.cpp", {"#include <iostream>"}}}),
              "pipeline/scene/mesh/mesh.cpp:1:");
    expectOne(impurePipeline({{"pipeline/formats/reader.cpp", {"    std::fprintf(stderr, \"bad\");"}}}),
              "pipeline/formats/reader.cpp:1:");
    expectOne(impurePipeline({{"pipeline/stages/cull.cpp", {"#include <tbb/parallel_for.h>"}}}),
              "pipeline/stages/cull.cpp:1:");
    expectOne(impurePipeline({{"pipeline/stages/cull.h", {"#include \"pipeline/plan/plan.h\""}}}),
              "pipeline/stages/cull.h:1:");
    expectKept(impurePipeline({{"pipeline/core/text.cpp", {"fmt::format(\"{}\", 1);"}},
                               {"pipeline/run/runner.cpp", {"#include <tbb/parallel_for.h>"}},
                               {"app/cli/plan.cpp", {"std::printf(\"plan\");"}}}));
    expectKept(impurePipeline(project()));
}

TEST(Architecture, WhatIsPrintedIsEscaped) {
    expectOne(printingPastMessages({{"app/cli/plan.cpp", {"fmt::print(\"{}\", name);"}}}), "app/cli/plan.cpp:1:");
    expectOne(printingPastMessages({{"app/desktop/main.cpp", {"std::fputs(text, stderr);"}}}),
              "app/desktop/main.cpp:1:");
    expectKept(printingPastMessages({{"app/cli/message.cpp", {"std::fputs(text, stderr);"}}}));
    expectKept(printingPastMessages(project()));
}

TEST(Architecture, MarkupStandsInKnownPlaces) {
    expectOne(markupInNewPlaces({{"app/talk/cue_panel.cpp", {"label->setTextFormat(Qt::RichText);"}}}),
              "app/talk/cue_panel.cpp:1:");
    expectOne(markupInNewPlaces({{"app/tables/table_model.cpp", {"document.setHtml(text);"}}}),
              "app/tables/table_model.cpp:1:");
    expectKept(markupInNewPlaces({{"app/tables/table_model.cpp", {"label->setTextFormat(Qt::PlainText);"}}}));
    expectKept(markupInNewPlaces(project()));
}

TEST(Architecture, NumbersAreTheSameInEveryLocale) {
    expectOne(numbersOfALocale({{"lessons/value.cpp", {"std::snprintf(buffer, size, \"%g\", x);"}}}),
              "lessons/value.cpp:1:");
    expectOne(numbersOfALocale({{"pipeline/check/case.cpp", {"std::stod(text)"}}}), "pipeline/check/case.cpp:1:");
    expectKept(numbersOfALocale(project()));
}

TEST(Architecture, RandomNumbersAreDrawnInAnOrder) {
    for (const char* line :
         {"const Vec3d p(random.between(0, 1), random.between(0, 1), 0);",
          "sphere(1, 3 + int(random() % 5), 3 + int(random() % 8));", "Vec3d(side(random), side(random), 0)"})
        expectOne(unorderedDraws({{"tests/unit/x_test.cpp", {line}}}), "tests/unit/x_test.cpp:1:");
    for (const char* line :
         {"const Vec3d p{random.between(0, 1), random.between(0, 1), 0};", "f(random.between(0, 1), 2);",
          "positions.push_back({inBox(random, 2), inBox(random, 2)});"})
        EXPECT_TRUE(unorderedDraws({{"tests/unit/x_test.cpp", {line}}}).empty()) << line;
    expectKept(unorderedDraws(project()));
}

TEST(Architecture, FramesCallNoElementaryFunctionOfALibrary) {
    const auto stage = [](std::string line) { return SourceTree{{"pipeline/stages/cull.cpp", {std::move(line)}}}; };
    for (const char* call : {"std::sin(x)", "::pow(x, y)", "std::atan2(y, x)", "glm::acos(x)", "std::expf(x)",
                             "std::log1p(x)", "std::hypot(x, y)", "std::fma(a, b, c)", "glm::pow(a, b)"})
        expectOne(functionsOfALibrary(stage(std::string("const double a = ") + call + ";")),
                  "pipeline/stages/cull.cpp:1:");
    for (const char* call :
         {"exp(x)", "std::sqrt(x)", "std::ldexp(x, 3)", "glm::cross(a, b)", "std::fmod(x, y)", "pipeline::log2(x)"})
        expectKept(functionsOfALibrary(stage(std::string("const double a = ") + call + ";")));
    expectKept(functionsOfALibrary(
        {{"pipeline/check/case.cpp", {"std::sin(x)"}}, {"pipeline/core/elementary.h", {"std::exp(x)"}}}));
    expectKept(functionsOfALibrary(project()));
}

TEST(Architecture, FilesAreShort) {
    const auto file = [](std::string path, std::size_t lines) {
        return SourceTree{{std::move(path), std::vector<std::string>(lines)}};
    };
    expectOne(longFiles(file("app/document/document.cpp", 401)), "app/document/document.cpp:401:");
    expectOne(longFiles(file("pipeline/stages/cull.cpp", 201)), "pipeline/stages/cull.cpp:201:");
    expectKept(longFiles(file("app/document/document.cpp", 400)));
    expectKept(longFiles(file("lessons/pyramid/lesson.md", 1000)));
    expectKept(longFiles(project()));
}

TEST(Architecture, SourcesAreListed) {
    expectOne(unlistedSources({{"pipeline/CMakeLists.txt", {"add_library(pipeline plan/stage_plan.cpp)"}},
                               {"pipeline/plan/plan.cpp", {""}},
                               {"pipeline/plan/stage_plan.cpp", {""}}}),
              "pipeline/plan/plan.cpp:1:");
    expectKept(unlistedSources(project()));
}

TEST(Architecture, NoPathOfOneMachine) {
    const std::string home = std::string("/") + "home/";
    expectOne(machinePaths({{"README.md", {"see " + home + "me/notes.txt"}}}), "README.md:1:");
    expectKept(machinePaths({{"README.md", {"docs" + home + "page.md, https://example.org" + home + "page"}}}));
    expectKept(machinePaths(project()));
}

TEST(Architecture, SentencesAreShort) {
    const std::string ten = "one two three four five six seven eight nine ten ";
    const auto page = [](std::vector<std::string> lines) { return SourceTree{{"README.md", std::move(lines)}}; };
    expectOne(longSentences(page({"# Title", "", ten + ten, "and then it goes to six."})), "README.md:3:");
    expectOne(longSentences(page({"- " + ten + ten + "and then five words more, **no**."})), "README.md:1:");
    expectKept(longSentences(page({ten + ten + "and only five words more."})));
    expectKept(longSentences(page({ten + ten + "end.", ten + "end. " + ten + "end"})));
    expectKept(longSentences(page({"- " + ten + ten, "- " + ten + ten, "", ten + ten})));
    expectKept(longSentences(page({"```", ten + ten + ten, "```", "| " + ten + ten + ten + " |"})));
    expectKept(longSentences(page({ten + ten + "`" + ten + "` [a link](to/a/page.md) ![" + ten + "](a.png)"})));
    expectKept(longSentences({{"lessons/pyramid/lesson.md", {ten + ten + ten}}}));
    expectKept(longSentences(project()));
}

TEST(Architecture, WordsAreTheFieldsAndTheDesktops) {
    const auto page = [](std::string line) {
        return SourceTree{{"resources/manual/window.md", {"# Title", std::move(line)}}};
    };
    expectOne(replacedWords(page("| foot | the timeline |")), "resources/manual/window.md:2:");
    expectOne(replacedWords(page("**All Processors** are used.")), "resources/manual/window.md:2:");
    expectKept(replacedWords(page("`foot`, a footing, and *At the foot*")));
    expectKept(replacedWords({{"resources/manual/reference.md", {"foot"}}}));  // written from the program's tables
    expectKept(replacedWords(project()));
}

TEST(Architecture, TheRootHoldsItsEntriesOnly) {
    expectOne(strangersAtTheTop({"app", "notes.txt"}), "notes.txt:1:");
    expectKept(strangersAtTheTop(topLevel(SHADESCOPE_ROOT)));
}

}  // namespace
}  // namespace architecture
