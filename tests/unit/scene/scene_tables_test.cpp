// Lecture 1's arrays as tables, and their texts.
#include "pipeline/inspect/scene_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "pipeline/core/csv.h"
#include "pipeline/export/buffers/csv_file.h"
#include "pipeline/export/json/table_json.h"
#include "pipeline/inspect/table_text.h"
#include "pipeline/plan/needs.h"
#include "pipeline/stages/cull.h"
#include "tests/support/files.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

const TableColumn& column(const SceneTable& table, std::string_view heading) {
    const auto found = std::ranges::find(table.columns, heading, &TableColumn::heading);
    EXPECT_NE(found, table.columns.end()) << heading;
    return *found;
}
bool has(const SceneTable& table, std::string_view heading) {
    return std::ranges::find(table.columns, heading, &TableColumn::heading) != table.columns.end();
}
std::string text(const SceneTable& table, std::string_view heading, std::size_t row) {
    const TableColumn& c = column(table, heading);
    return readableText(c, c.cell(row));
}
SceneTable tableOf(const Scene& scene, TableId id) { return sceneTable(test::frameOf(scene, {}), id); }
std::string written(const SceneTable& table, TableFormat format) {
    std::string all;
    writeTable(table, allRows(table), format, [&](std::string_view piece) { all += piece; });
    return all;
}

// The numbers that the lecture's example files give, under the lecture's names.
TEST(SceneTables, ObjectsAsTheLectureWritesThem) {
    const SceneTable table = tableOf(test::pyramid(), TableId::Objects);
    ASSERT_EQ(table.rows, 1u);
    const std::pair<const char*, const char*> expected[]{
        {"i", "0"},    {"num_pts", "5"}, {"num_polys", "5"}, {"w_pts", "0 to 4"}, {"polys", "0 to 4"},
        {"kr", "0.2"}, {"kg", "0.5"},    {"kb", "0.9"},      {"ks", "0.4"},       {"n", "8"},
        {"sx", "1.8"}, {"sy", "1"},      {"sz", "1"},        {"αx", "0"},         {"αy", "0"},
        {"αz", "0"},   {"tx", "200"},    {"ty", "0"},        {"tz", "0"}};
    for (const auto& [heading, value] : expected) EXPECT_EQ(text(table, heading, 0), value) << heading;
    EXPECT_EQ(column(table, "kr").name, "material.#.kr");
}

// k_s in three colours has three columns; the lecture's one stands where they are equal.
TEST(SceneTables, ColouredHighlightsHaveThreeColumns) {
    Scene scene = test::pyramid();
    EXPECT_FALSE(has(tableOf(scene, TableId::Objects), "ksr"));
    scene.objects[0].material.specular = {0.4, 0.3, 0.2};
    const SceneTable table = tableOf(scene, TableId::Objects);
    EXPECT_FALSE(has(table, "ks"));
    EXPECT_EQ(text(table, "ksg", 0), "0.3");
}

// Right's intensities are derived in tests/reference/lecture1_pyramid_test.cpp: blue 45 + 69.714 + 0.025,
// red 10 + 0.2·77.46 + 0.025. Its edges give N = (0, 2, 1)/sqrt 5.
TEST(SceneTables, PolygonsAsTheLectureWritesThem) {
    const SceneTable table = tableOf(test::pyramid(), TableId::Polygons);
    ASSERT_EQ(table.rows, 5u);
    EXPECT_EQ(text(table, "inds", 2), "2, 3, 4");
    EXPECT_EQ(text(table, "inds", 4), "0, 3, 2, 1");
    EXPECT_EQ(text(table, "num_verts", 2), "3");
    EXPECT_EQ(text(table, "num_verts", 4), "4");
    EXPECT_EQ(text(table, "visibility", 2), "kept");
    EXPECT_EQ(text(table, "visibility", 4), "back-facing");
    EXPECT_EQ(text(table, "n[0]", 2), "0.0000");
    EXPECT_EQ(text(table, "n[1]", 2), "0.8944");
    EXPECT_EQ(text(table, "n[2]", 2), "0.4472");
    EXPECT_EQ(text(table, "lred", 2), "25.517");
    EXPECT_EQ(text(table, "lblue", 2), "114.739");
    EXPECT_EQ(text(table, "lblue", 4), "–") << "culling dropped it: nobody has evaluated it";
}

// world = scale · object + translation; then lecture 1's viewing transformation of (200, 0, 0):
// x_v = −200 sin 45°, y_v = −200 cos 60° cos 45°, z_v = 1000 − 200 sin 60° cos 45°,
// x_s = 320 + 200 x_v / z_v, y_s = 240 − 200 y_v / z_v.
TEST(SceneTables, VerticesInTheThreeSpaces) {
    const SceneTable table = tableOf(test::pyramid(), TableId::Vertices);
    ASSERT_EQ(table.rows, 5u);
    const auto value = [&](const char* heading, std::size_t row) {
        return double(std::get<float>(column(table, heading).cell(row)));
    };
    EXPECT_EQ(value("xw", 0), 200);
    EXPECT_EQ(value("xw", 4), 335);
    EXPECT_EQ(value("zw", 4), 150);
    EXPECT_NEAR(value("xv", 0), -141.421, 1e-3);
    EXPECT_NEAR(value("yv", 0), -70.711, 1e-3);
    EXPECT_NEAR(value("zv", 0), 877.526, 1e-3);
    EXPECT_NEAR(value("xs", 0), 320 - 200 * 141.42136 / 877.52551, 1e-3);
    EXPECT_NEAR(value("ys", 0), 240 + 200 * 70.71068 / 877.52551, 1e-3);
    EXPECT_EQ(text(table, "xw", 4), "335.000") << "three decimals where the eye sees a thousand units far";
    ASSERT_EQ(table.facts.size(), 4u);
    EXPECT_EQ(table.facts[0].heading(), "scrn_dist");
    EXPECT_EQ(std::get<double>(table.facts[0].value), 200);
}

TEST(SceneTables, LightsAsTheLectureWritesThem) {
    Scene scene = test::pyramid();
    scene.lights.push_back({LightKind::Point, {0, 10, 20}, 30, Vec3d(1), true});
    const SceneTable table = tableOf(scene, TableId::Lights);
    ASSERT_EQ(table.rows, 2u);
    EXPECT_EQ(text(table, "Lx", 0), "500");
    EXPECT_EQ(text(table, "Lz", 1), "20");
    EXPECT_EQ(text(table, "Ip", 0), "100");
    EXPECT_EQ(text(table, "kind", 1), "point");
    EXPECT_EQ(text(table, "L x", 0), "0.5774");
    EXPECT_EQ(text(table, "L x", 1), "–") << "every surface point sees it elsewhere";
    EXPECT_FALSE(has(table, "spot_cutoff")) << "only OpenGL's model reads it";
    const auto fact = std::ranges::find(table.facts, "la", &TableFact::heading);
    ASSERT_NE(fact, table.facts.end());
    EXPECT_EQ(std::get<double>(fact->value), 50);
    scene.settings.model = Model::OpenGl;
    EXPECT_TRUE(has(tableOf(scene, TableId::Lights), "spot_cutoff"));
}

TEST(SceneTables, WhatThePlanLeftOutIsEmptyAndSaysWhy) {
    Scene scene = test::pyramid();
    scene.settings.cull = CullMode::None;
    const FramePtr frame = test::frameOf(scene, {});
    const SceneTable vertices = sceneTable(frame, TableId::Vertices);
    EXPECT_EQ(column(vertices, "N x").whyEmpty, "Flat shading needs polygon normals only.");
    EXPECT_EQ(text(vertices, "N x", 0), "–");
    const SceneTable polygons = sceneTable(frame, TableId::Polygons);
    const TableColumn& verdict = column(polygons, "visibility");
    EXPECT_EQ(verdict.whyEmpty, frame->whyAbsent({BufferId::PolygonsVerdict}));
    EXPECT_EQ(verdict.whyEmpty.empty(), !std::holds_alternative<std::monostate>(verdict.cell(0)));
}

// Whatever the scene: headings differ, cells are the buffers' numbers, a table can be read at every place.
TEST(SceneTables, AgreeWithTheFramesBuffers) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        const FramePtr frame = test::frameOf(test::randomScene(seed));
        for (std::size_t id = 0; id < kTableCount; ++id) {
            const SceneTable table = sceneTable(frame, TableId(id));
            std::set<std::string> headings;
            for (const TableColumn& c : table.columns) {
                EXPECT_TRUE(headings.insert(c.heading()).second) << c.heading();
                EXPECT_FALSE(c.meaning.empty()) << c.heading();
                for (std::size_t row = 0; row < table.rows; row += 1 + table.rows / 50) c.cell(row);
            }
        }
        const SceneTable polygons = sceneTable(frame, TableId::Polygons);
        const auto normals = frame->buffer({BufferId::PolygonsNormal});
        ASSERT_TRUE(normals);
        ASSERT_EQ(normals->rows(), polygons.rows);
        for (std::size_t row = 0; row < polygons.rows; ++row)
            for (int c = 0; c < 3; ++c) {
                const Cell cell = column(polygons, "n[" + std::to_string(c) + "]").cell(row);
                const double value =
                    std::holds_alternative<float>(cell) ? double(std::get<float>(cell)) : std::get<double>(cell);
                EXPECT_EQ(value, normals->flat(3 * row + std::size_t(c)));
            }
    }
}

// The cells of a row of a buffer's CSV file, without the row's number; empty text where there is no value.
std::vector<std::vector<std::string>> csvRows(const AnyBuffer& buffer) {
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "buffer.csv";
    EXPECT_TRUE(writeCsv({buffer, {}, {}}, file));
    std::vector<std::vector<std::string>> rows;
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);  // the names
    while (std::getline(in, line)) {
        std::vector<std::string>& row = rows.emplace_back();
        for (std::size_t comma = line.find(','); comma != line.npos;) {
            const std::size_t next = line.find(',', comma + 1);
            row.push_back(line.substr(comma + 1, next == line.npos ? next : next - comma - 1));
            comma = next;
        }
    }
    return rows;
}

// What is kept is lit, whether a pixel shows it or not; what culling drops is not, nor a vertex of such polygons alone.
TEST(SceneTables, AgreeWithAnExportOnWhatCulledPolygonsHave) {
    std::size_t dropped = 0, kept = 0;
    for (unsigned seed = 0; seed < 30; ++seed) {
        Scene scene = test::randomScene(seed);
        scene.settings.shading = seed % 2 == 0 ? Shading::Flat : Shading::Gouraud;
        const bool flat = seed % 2 == 0;
        const TableId id = flat ? TableId::Polygons : TableId::Vertices;
        const BufferId buffer = flat ? BufferId::PolygonsIntensity : BufferId::VerticesIntensity;
        const FramePtr shown = test::frameOf(scene, tableBuffers(scene, id));
        const FramePtr exported = test::frameOf(scene, usefulBuffers(scene));
        const auto written = exported->buffer({buffer});
        if (!written) continue;  // no outline is lit
        const SceneTable table = sceneTable(shown, id);
        const TableColumn& red = column(table, flat ? "lred" : "I(r)");
        const auto csv = csvRows(*written);
        ASSERT_EQ(csv.size(), table.rows);
        std::vector<bool> isKept(table.rows, false);
        const auto verdicts = exported->buffer({BufferId::PolygonsVerdict});
        for (std::size_t p = 0; p < exported->topology().polygonCount(); ++p) {
            if (verdicts && !goesOn(Verdict(int(verdicts->flat(p))))) continue;
            const auto corners = exported->topology().corners(p);
            if (flat) isKept[p] = true;
            for (std::size_t i = 0; !flat && i < corners.size(); ++i) isKept[corners[i]] = true;
        }
        for (std::size_t row = 0; row < table.rows; ++row) {
            const Cell cell = red.cell(row);
            const bool isEmpty = std::holds_alternative<std::monostate>(cell);
            ASSERT_EQ(!isEmpty, isKept[row] || !verdicts) << seed << " row " << row;
            ASSERT_EQ(isEmpty, csv[row][0].empty()) << seed << " row " << row;
            if (!isEmpty) {
                ASSERT_EQ(std::visit(
                              [](const auto& v) -> double {
                                  if constexpr (std::is_arithmetic_v<std::decay_t<decltype(v)>>) return double(v);
                                  return NAN;
                              },
                              cell),
                          written->flat(3 * row));
            }
            isEmpty ? ++dropped : ++kept;
        }
        EXPECT_EQ(statistics(*written).withoutValue,
                  std::size_t(std::ranges::count(isKept, false)) * (verdicts ? 1 : 0));
    }
    EXPECT_GT(dropped, 100u);
    EXPECT_GT(kept, 100u);
}

TEST(SceneTables, CountWhatIsNotLit) {
    const Scene scene = test::pyramid();
    const SceneTable table =
        sceneTable(test::frameOf(scene, tableBuffers(scene, TableId::Polygons)), TableId::Polygons);
    ASSERT_EQ(table.facts.size(), 2u);
    EXPECT_EQ(table.facts[1].heading(), "polygons that are not lit: culled, or seen in no pixel");
    EXPECT_EQ(std::get<std::int64_t>(table.facts[1].value), 2);  // Left and Base
}

TEST(SceneTables, OutliveTheirFrame) {
    FramePtr frame = test::frameOf(test::pyramid());
    const SceneTable table = sceneTable(frame, TableId::Vertices);
    frame.reset();
    EXPECT_EQ(text(table, "xw", 4), "335.000");
}

TEST(SceneTables, SortByValueWithEmptyRowsLast) {
    SceneTable table;
    const std::vector<Cell> cells{2.5, {}, -3.0, 10.0, 2.5};
    table.rows = cells.size();
    table.columns.push_back({"a", "a", "", "", -1, {}, [cells](std::size_t i) { return cells[i]; }});
    EXPECT_EQ(sortedRows(table, 0, false), (std::vector<std::uint32_t>{2, 0, 4, 3, 1}));
    EXPECT_EQ(sortedRows(table, 0, true), (std::vector<std::uint32_t>{3, 0, 4, 2, 1}));
}

SceneTable smallTable() {
    SceneTable table;
    table.rows = 2;
    table.meaning = "Small.";
    table.columns.push_back(
        {"num_pts", "count", "", "A count.", -1, {}, [](std::size_t i) { return Cell(std::int64_t(i)); }});
    table.columns.push_back({"", "name", "", "A name.", -1, {}, [](std::size_t i) {
                                 return i == 0 ? Cell(std::string("a|b, \"50 %\"")) : Cell();
                             }});
    table.columns.push_back({"x", "x", "pixels", "A place.", 2, {}, [](std::size_t) { return Cell(-0.1f); }});
    return table;
}

TEST(TableText, CsvIsExactAndQuoted) {
    EXPECT_EQ(written(smallTable(), TableFormat::Csv), "num_pts,name,x\n0,\"a|b, \"\"50 %\"\"\",-0.1\n1,,-0.1\n");
}

// A spreadsheet calculates what begins like a formula, also in quotes; numbers may begin with a sign.
TEST(TableText, CsvHoldsNoFormulas) {
    for (const char* text : {"=1+1", "@sum(a)", "+cmd", "-x", "=", "-"})
        EXPECT_EQ(csvField(text), "'" + std::string(text));
    EXPECT_EQ(csvField("=\"a\",b"), "\"'=\"\"a\"\",b\"");
    for (const char* text : {"-1", "-1e-30", "-inf", "a=b", "", "1-2"}) EXPECT_EQ(csvField(text), text);
}

TEST(TableText, MarkdownKeepsItsCells) {
    EXPECT_EQ(written(smallTable(), TableFormat::Markdown),
              "| num\\_pts | name | x |\n| ---: | --- | ---: |\n| 0 | a\\|b, \"50 %\" | −0.10 |\n| 1 | – | −0.10 |\n");
}

TEST(TableText, LatexIsATabular) {
    EXPECT_EQ(written(smallTable(), TableFormat::Latex),
              "\\begin{tabular}{rlr}\n\\hline\nnum\\_pts & name & x \\\\\n\\hline\n0 & a|b, \"50 \\%\" & $-$0.10 \\\\\n"
              "1 & -- & $-$0.10 \\\\\n\\hline\n\\end{tabular}\n");
}

// −0.1f in the digits of a float; a row without a name has the empty text, one without a number NaN.
TEST(TableText, NumPyIsAStructuredArray) {
    EXPECT_EQ(written(smallTable(), TableFormat::NumPy),
              "np.array([(0, 'a|b, \"50 %\"', -0.1),\n          (1, '', -0.1)],\n"
              "         dtype=[('num_pts', 'i8'), ('name', 'U11'), ('x', 'f4')])\n");
    SceneTable odd;
    odd.rows = 2;
    odd.columns.push_back(
        {"", "it's", "", "", -1, {}, [](std::size_t i) { return i == 0 ? Cell(std::int64_t(7)) : Cell(); }});
    EXPECT_EQ(written(odd, TableFormat::NumPy),
              "np.array([(7,),\n          (np.nan,)],\n         dtype=[('it\\'s', 'f8')])\n");
}

TEST(TableText, TextIsAligned) {
    EXPECT_EQ(written(smallTable(), TableFormat::Text),
              "Small.\n\n\nnum_pts  name             x\n      0  a|b, \"50 %\"  −0.10\n      1  –            −0.10\n\n"
              "num_pts  A count. (count)\nname     A name.\nx        A place. (pixels)\n");
}

TEST(TableText, JsonHasEveryColumnInEveryRow) {
    const SceneTable table = tableOf(test::pyramid(), TableId::Polygons);
    std::string all;
    writeTableJson(table, allRows(table), [&](std::string_view piece) { all += piece; });
    const auto json = nlohmann::json::parse(all);
    EXPECT_EQ(json["table"], "polygons");
    ASSERT_EQ(json["rows"].size(), 5u);
    for (const auto& row : json["rows"]) EXPECT_EQ(row.size(), json["columns"].size());
    EXPECT_EQ(json["columns"][3]["lecture"], "num_verts");
    EXPECT_EQ(json["rows"][4][3], 4);
    EXPECT_EQ(json["facts"][0]["value"], 5);
}

}  // namespace
}  // namespace pipeline
