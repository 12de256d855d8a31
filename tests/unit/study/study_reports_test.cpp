#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "pipeline/export/html/html_text.h"
#include "pipeline/export/json/study_json.h"
#include "pipeline/export/study/study_csv.h"
#include "pipeline/export/study/study_files.h"
#include "pipeline/export/study/study_html.h"
#include "pipeline/export/study/study_text.h"
#include "pipeline/study/analysis_text.h"
#include "tests/support/files.h"
#include "tests/support/studies.h"

namespace pipeline {
namespace {

using test::sphereStudy;

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string page(const StudyReport& report, const std::vector<StudyPictures>& pictures = {}) {
    return studyHtml(report, analyse(report, report.choice), {1e-3, 1}, pictures);
}

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

std::size_t count(const std::string& text, const std::string& words) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(words, at)) != std::string::npos; ++at) ++found;
    return found;
}

// Every element but those without content is closed, in order.
void expectBalanced(const std::string& html) {
    std::vector<std::string> open;
    for (std::size_t at = 0; (at = html.find('<', at)) != std::string::npos; ++at) {
        const bool closes = html[at + 1] == '/';
        const std::size_t start = at + (closes ? 2 : 1);
        const std::string tag = html.substr(start, html.find_first_of(" >\n", start) - start);
        if (tag == "!DOCTYPE" || tag == "meta" || tag == "img" || tag == "source") continue;
        if (!closes) {
            open.push_back(tag);
        } else {
            ASSERT_FALSE(open.empty()) << tag;
            ASSERT_EQ(open.back(), tag) << "at byte " << at;
            open.pop_back();
        }
    }
    EXPECT_TRUE(open.empty());
}

// Of six samples 1 to 6 the median is 3.5 and its interval all of them; of one table a row is written out.
TEST(StudyCsv, HasARowForEachPointAndMeasure) {
    StudyReport report = sphereStudy();
    report.points.resize(8);
    report.points[0].frame.processes = {{1, 2, 3, 4, 5, 6}};
    report.points[0].errors[0].drawn = {0.03, 0.05};
    const std::vector<std::string> lines = linesOf(studyCsv(report));
    ASSERT_EQ(lines.size(), 1 + 2 + 6 + 1u);  // names; two measures; one each; the one that failed
    EXPECT_EQ(lines[0],
              "point,shading,tessellation,failure,buffer,stage,measure,unit,model,arithmetic,storage,"
              "model_low,model_high,reference_error,ms_min,ms_median,ms_p95,ms_median_low,ms_median_high,ms_transform,"
              "ms_cull,ms_normals,ms_"
              "shadow-buffer,ms_z-buffer,"
              "ms_shading,megabytes,fragments,triangles\r");
    EXPECT_EQ(lines[1],
              "0,flat,4,,intensity,shading,RMSE,,0.042,,,0.03,0.05,2e-16,1,3.5,6,1,6,,,,,,0.375,21.5,205887,320\r");
    EXPECT_EQ(
        lines[2],
        "0,flat,4,,normal,normals,largest angle,degrees,10.4,1.2e-5,0,,,,1,3.5,6,1,6,,,,,,0.375,21.5,205887,320\r");
    EXPECT_EQ(lines.back(), "7,gouraud,128,stopped after 60 s,,,,,,,,,,,,,,,,,,,,,,0,,\r");
}

TEST(StudyCsv, EveryRowHasAsManyFieldsAsTheNames) {
    StudyReport report = sphereStudy();
    report.points[7].failure = "stopped after \"60 s\", 2 of 21 done";
    const std::vector<std::string> lines = linesOf(studyCsv(report));
    const auto commas = std::count(lines[0].begin(), lines[0].end(), ',');
    for (const std::string& line : lines) {
        const bool quoted = has(line, "\"stopped after \"\"60 s\"\", 2 of 21 done\"");
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas + (quoted ? 1 : 0)) << line;
    }
}

TEST(StudyText, SortsPointsByTimeAndEndsWithTheAnswers) {
    const StudyReport report = sphereStudy();
    const std::string text = studyText(report, analyse(report, report.choice), {1e-3, 1});
    const std::vector<std::string> lines = linesOf(text);
    ASSERT_GT(lines.size(), 15u);
    EXPECT_EQ(lines[0], "sphere, 512 \u00d7 512: RMSE of intensity, model error");
    EXPECT_EQ(lines[2], "  Shading  Tessellation     ms   95 % interval   error  beaten by");
    EXPECT_EQ(lines[3], "  flat                4  0.590  0.587 to 0.593  4.2e-2  on the front");
    EXPECT_EQ(lines[7], "  phong               4   2.70    2.69 to 2.71  4.4e-3  gouraud, tessellation 16");
    EXPECT_EQ(lines[14], "  gouraud           128                                 stopped after 60 s");
    EXPECT_TRUE(has(text, "Order p where the error falls with h^p, h = 1 / tessellation."));
    EXPECT_TRUE(has(text, "RMSE of intensity up to 0.001 takes at least 2.94 ms: phong, tessellation 16.\n"));
    EXPECT_TRUE(has(text, "Within 1 ms RMSE of intensity is at best 2.1e-3: gouraud, tessellation 16.\n"));
    EXPECT_TRUE(
        has(text, "  model: analytic, its own RMSE of intensity 2.0e-16 (against the same rays in long double)\n"));
    EXPECT_TRUE(has(text, "  storage: none. Nothing is stored with fewer digits.\n"));
    EXPECT_TRUE(has(text, "Times: median of 21 frames (1 process of 21, each after 2 that do not count), 1 thread."));
    StudyReport one = report;
    one.repeats = 1;
    EXPECT_TRUE(protocolText(one).starts_with("Times: one frame (1 process of 1, each after 2 "));
}

// How many pixels the error leaves out stands beside it, in the table of a terminal, of the page and in the rows of the
// file; where an error leaves out none there is no such column.
TEST(StudyReports, SayHowManyPixelsAnErrorLeavesOut) {
    StudyReport report = sphereStudy();
    EXPECT_FALSE(has(studyText(report, analyse(report, report.choice), {1e-3, 1}), kLeftOut));
    report.points[0].errors.push_back(
        {"object_id", StageId::ZBuffer, "pixels that differ", "pixels", {84, std::nullopt, std::nullopt}});
    const std::vector<std::string> lines = linesOf(studyText(report, analyse(report, report.choice), {1e-3, 1}));
    EXPECT_TRUE(has(lines[2], "error  pixels that differ  beaten by")) << lines[2];
    EXPECT_TRUE(has(lines[3], "4.2e-2                  84  on the front")) << lines[3];
    EXPECT_TRUE(has(page(report), "<td class=n>4.2e-2</td><td class=n>84</td><td class=front>"));
    expectBalanced(page(report));
    EXPECT_TRUE(has(studyCsv(report), "0,flat,4,,object_id,z-buffer,pixels that differ,pixels,84,,,"));
}

TEST(StudyHtml, IsOneWholePage) {
    const StudyReport report = sphereStudy();
    const std::string html = page(report, {{0, "PNG1", "PNG2", "PNG3", "\u22120.05 to 0.05"}});
    expectBalanced(html);
    EXPECT_TRUE(html.starts_with("<!DOCTYPE html>"));
    EXPECT_FALSE(has(html, "<script"));
    EXPECT_FALSE(has(html, "http"));  // nothing is fetched
    EXPECT_EQ(count(html, "data:image/svg+xml;base64,"), 2u);
    EXPECT_EQ(count(html, "data:image/png;base64,UE5H"), 3u);  // "PNG"
    EXPECT_TRUE(has(html, "Error, signed, \u22120.05 to 0.05"));
    EXPECT_EQ(count(html, "<details"), report.points.size() + 1);  // and the settings
    EXPECT_EQ(count(html, "<details open>"), 1u);
}

TEST(StudyHtml, ShowsNumbersOfEveryKind) {
    const std::string html = page(sphereStudy());
    EXPECT_TRUE(has(html,
                    "<td>flat</td><td>4</td><td class=n>0.590</td><td class=n>0.587 to 0.593</td>"
                    "<td class=n>4.2e-2</td><td class=front>on the front</td>"));
    EXPECT_TRUE(has(html, "<tr class=failed><td>gouraud</td><td>128</td>"));
    EXPECT_TRUE(
        has(html, "<td>largest angle, degrees</td><td class=n>10</td><td class=n>1.2e-5</td><td class=n>0</td>"));
    EXPECT_TRUE(has(html, "<span style=\"width:97.0%\"></span></td><td class=n>97 %</td>"));
    EXPECT_TRUE(has(html, "<span style=\"width:0.0%\"></span></td><td class=n>\u22122 %</td>"));
    EXPECT_TRUE(has(html, "205887 fragments, 320 triangles, 21.5 MB in buffers."));
    EXPECT_TRUE(has(html, "<td class=code>light.0.x</td><td class=n>-0.5</td>"));
}

TEST(StudyHtml, EscapesEveryText) {
    StudyReport report = sphereStudy();
    const std::string bad = "<b>&\"'";
    report.scene = report.file = report.version = report.machine = report.compiler = report.errorWhy = bad;
    report.settings = {{bad, bad}};
    for (std::string& name : report.references) name = bad;
    for (SweepAxis& axis : report.axes) axis.label = bad;
    report.axes[0].values[0] = bad;
    report.choice = {bad, bad, ErrorKind::Model};
    for (StudyPoint& point : report.points) {
        point.values[0] = bad;
        if (!point.failure.empty()) point.failure = bad;
        if (!point.counters.empty()) point.counters = {{bad, 1}};
        for (ErrorRow& row : point.errors) row.buffer = row.measure = row.unit = bad;
    }
    const std::string html = page(report);
    EXPECT_FALSE(has(html, "<b>"));
    EXPECT_FALSE(has(html, "&\""));
    expectBalanced(html);
}

TEST(StudyFiles, AreAllThereOrNone) {
    const StudyReport report = sphereStudy();
    const test::TemporaryFolder folder;
    test::writeText(folder / "notes.txt", "mine");
    const auto names = writeStudyFiles(report, analyse(report, report.choice), {1e-3, 1}, {}, folder.path());
    ASSERT_TRUE(names) << format(names.errors());
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"notes.txt", "plot-dark.png", "plot-dark.svg", "plot.png",
                                                        "plot.svg", "report.html", "study.csv", "study.json"}));
    EXPECT_EQ(names->size(), 7u);
    EXPECT_EQ(test::readPng(folder / "plot.png").width, 1920);
    const auto read = studyFromJson(test::readText(folder / "study.json"), "study.json");
    ASSERT_TRUE(read) << format(read.errors());
    EXPECT_EQ(*read, report);

    const auto refused = writeStudyFiles(report, analyse(report, report.choice), {1e-3, 1}, {}, folder / "notes.txt");
    ASSERT_FALSE(refused);
    EXPECT_EQ(folder.names().size(), 8u);
    EXPECT_EQ(test::readText(folder / "notes.txt"), "mine");
}

// The test vectors of RFC 4648, section 10.
TEST(HtmlText, EncodesBase64) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

// 2³² − 1 is 82·85⁴ + 23·85³ + 54·85² + 12·85. The texts are those of Python's base64.b85encode, its alphabet for this one.
TEST(HtmlText, EncodesBase85) {
    EXPECT_EQ(base85(""), "");
    EXPECT_EQ(base85(std::string(1, '\0')), "!!");
    EXPECT_EQ(base85("\xff\xff\xff\xff"), "|=_1!");
    EXPECT_EQ(base85("f"), "Hl");
    EXPECT_EQ(base85("foobar"), "HxK[|GC-");
}

}  // namespace
}  // namespace pipeline
