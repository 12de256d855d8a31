// PLY and STL: what small files written by hand become, and what wrong ones get.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "pipeline/formats/model_reader.h"

namespace pipeline {
namespace {

Result<NamedFile> noFiles(std::string_view) { return Error{{}, "no such file", {}}; }

std::vector<Object> objectsOf(std::string_view text, std::string_view extension) {
    const Result<LoadedModel> model = readModel({text, "m"}, extension, noFiles);
    EXPECT_TRUE(model) << (model ? "" : format(model.errors()));
    return model ? model->objects : std::vector<Object>{};
}

std::string errorsOf(std::string_view text, std::string_view extension) {
    const Result<LoadedModel> model = readModel({text, "m"}, extension, noFiles);
    return model ? "" : format(model.errors());
}

std::vector<std::string> remarksOf(std::string_view text, std::string_view extension) {
    const Result<LoadedModel> model = readModel({text, "m"}, extension, noFiles);
    EXPECT_TRUE(model) << (model ? "" : format(model.errors()));
    std::vector<std::string> texts;
    for (const Remark& remark : model ? model->remarks : std::vector<Remark>()) texts.push_back(remark.text);
    return texts;
}

std::vector<std::uint32_t> polygon(const Object& object, std::size_t i) {
    const auto corners = object.mesh->polygon(i);
    return {corners.begin(), corners.end()};
}

template <class T>
std::string valueBytes(T value, bool reversed = false) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    return reversed ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

using Indices = std::vector<std::uint32_t>;
const std::vector<Vec3d> kSquareCorners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

std::string plyHeader(std::string_view form) {
    return fmt::format(
        "ply\nformat {} 1.0\ncomment by hand\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n",
        form);
}
const std::string kPlyData = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

std::string binaryPly(bool big) {
    std::string text = plyHeader(big ? "binary_big_endian" : "binary_little_endian");
    for (const Vec3d& p : kSquareCorners)
        for (int axis = 0; axis < 3; ++axis) text += valueBytes(static_cast<float>(p[axis]), big);
    text += '\4';
    for (const std::int32_t index : {0, 1, 2, 3}) text += valueBytes(index, big);
    return text;
}

std::string withReplaced(std::string text, std::string_view old, std::string_view with) {
    text.replace(text.find(old), old.size(), with);
    return text;
}

TEST(PlyReader, QuadInAllThreeForms) {
    for (const std::string& text : {plyHeader("ascii") + kPlyData, binaryPly(false), binaryPly(true)}) {
        const auto objects = objectsOf(text, ".ply");
        ASSERT_EQ(objects.size(), 1u);
        EXPECT_EQ(objects[0].mesh->positions, kSquareCorners);
        ASSERT_EQ(objects[0].mesh->polygonCount(), 1u);
        EXPECT_EQ(polygon(objects[0], 0), (Indices{0, 1, 2, 3}));
        EXPECT_TRUE(objects[0].mesh->normals.empty());
    }
    const auto places = objectsOf(plyHeader("ascii") + kPlyData, ".ply")[0].mesh->polygonPlaces;
    EXPECT_EQ(places, (std::vector<TextPosition>{{15, 1}}));
}

TEST(PlyReader, LineEndsAndMissingNewline) {
    std::string text = plyHeader("ascii") + kPlyData;
    text.pop_back();
    EXPECT_EQ(errorsOf(text, ".ply"), "");
    std::string windows = "\xEF\xBB\xBF";
    for (const char c : text) windows += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(errorsOf(windows, ".ply"), "");
}

TEST(PlyReader, NormalsAreMadeUnit) {
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double nx\nproperty double ny\nproperty double nz\n"
        "property uchar red\nproperty double x\nproperty double y\nproperty double z\n"
        "element face 1\nproperty list uchar uint vertex_index\nelement edge 1\nproperty int v\nend_header\n";
    const auto objects = objectsOf(header + "0 0 2 255 0 0 0\n0 3 4 0 1 0 0\n1 0 0 7 1 1 0\n3 0 1 2\n9", ".ply");
    EXPECT_EQ(objects[0].mesh->normals, (std::vector<Vec3d>{{0, 0, 1}, {0, 0.6, 0.8}, {1, 0, 0}}));
    EXPECT_EQ(objects[0].mesh->positions, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
    const auto without = objectsOf(header + "0 0 0 255 0 0 0\n0 3 4 0 1 0 0\n1 0 0 7 1 1 0\n3 0 1 2\n9", ".ply");
    EXPECT_TRUE(without[0].mesh->normals.empty()) << "one of them has no direction";
}

TEST(PlyReader, IndexOutOfRange) {
    for (const char* index : {"4", "-1", "2147483648", "9223372036854775808", "1.5"})
        EXPECT_EQ(
            errorsOf(withReplaced(plyHeader("ascii") + kPlyData, "4 0 1 2 3", fmt::format("3 0 1 {}", index)), ".ply"),
            fmt::format("m:15:7: found \"{}\", expected a vertex index from 0 to 3\n", index));
    std::string binary = binaryPly(false);
    binary.replace(binary.size() - 4, 4, valueBytes(std::int32_t{-1}));
    // The header has 185 bytes, then come 4 * 12 + 1 + 3 * 4.
    ASSERT_EQ(plyHeader("binary_little_endian").size(), 185u);
    EXPECT_EQ(errorsOf(binary, ".ply"), "m: found -1 at byte 246, expected a vertex index from 0 to 3\n");
}

TEST(PlyReader, CoordinateThatIsNone) {
    EXPECT_EQ(errorsOf(withReplaced(plyHeader("ascii") + kPlyData, "1 1 0\n", "1 1e10 0\n"), ".ply"),
              "m:13:3: found \"1e10\", expected a coordinate of vertex 2, a number from -1e9 to 1e9\n");
    EXPECT_EQ(errorsOf(withReplaced(plyHeader("ascii") + kPlyData, "1 1 0\n", "1 nan 0\n"), ".ply"),
              "m:13:3: found \"nan\", expected a number\n");
    std::string binary = binaryPly(false);
    binary.replace(185 + 12, 4, valueBytes(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_EQ(errorsOf(binary, ".ply"),
              "m: found nan at byte 197, expected a coordinate of vertex 1, a number from -1e9 to 1e9\n");
}

TEST(PlyReader, MoreAnnouncedThanThereIs) {
    EXPECT_EQ(errorsOf(withReplaced(plyHeader("ascii") + kPlyData, "vertex 4", "vertex 4294967295"), ".ply"),
              "m: 4 294 967 295 elements \"vertex\" announced, the file ends after 213 bytes\n");
    EXPECT_EQ(errorsOf(withReplaced(binaryPly(false), "vertex 4", "vertex 18446744073709551615"), ".ply"),
              "m: 18 446 744 073 709 551 615 elements \"vertex\" announced, the file ends after 269 bytes\n");
    EXPECT_EQ(errorsOf(binaryPly(false).substr(0, 241), ".ply"),
              "m: found 4 at byte 233, expected the length of a list that the file has room for\n");
    EXPECT_EQ(errorsOf(plyHeader("ascii") + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1", ".ply"),
              "m:15:1: found \"4\", expected the length of a list that the file has room for\n");
}

TEST(PlyReader, HeadersThatAreWrong) {
    const std::string text = plyHeader("ascii") + kPlyData;
    EXPECT_EQ(errorsOf("plx\n", ".ply"), "m:1:1: found \"plx\", expected ply\n");
    EXPECT_EQ(errorsOf("ply", ".ply"), "m:1:1: found the end of the file, expected end_header\n");
    EXPECT_EQ(errorsOf(withReplaced(text, "ascii", "text"), ".ply"),
              "m:2:8: found \"text\", expected ascii, binary_little_endian or binary_big_endian\n"
              "m:10:1: found \"end_header\", expected format before end_header\n");
    EXPECT_EQ(errorsOf(withReplaced(text, "float y", "real y"), ".ply"),
              "m:6:10: found \"real\", expected a number's type, as float or int\n");
    EXPECT_EQ(errorsOf(withReplaced(text, "float z", "float w"), ".ply"),
              "m:10:1: found no element vertex with x, y, z\n");
    EXPECT_EQ(errorsOf(withReplaced(text, "list uchar int", "list float int"), ".ply"),
              "m:9:15: found \"float\", expected a whole number's type, as uchar or int\n");
}

using Texts = std::vector<std::string>;

TEST(PlyReader, SaysWhatItLeavesOut) {
    const std::string text = withReplaced(plyHeader("ascii"), "face 1", "face 4") + kPlyData;
    // Corners 1 1 2: two different ones. 0 1 2 0: three, the first is written twice.
    EXPECT_EQ(remarksOf(text + "3 1 1 2\n2 0 1\n4 0 1 2 0\n", ".ply"),
              (Texts{"2 polygons have fewer than three different corners, and so no area; they are left out."}));
    EXPECT_EQ(remarksOf(plyHeader("ascii") + kPlyData + " \n\n", ".ply"), Texts{});
    EXPECT_EQ(remarksOf(plyHeader("ascii") + kPlyData + "\n4 3 2 1 0\n", ".ply"),
              (Texts{"What stands after the last element, from line 17 on, is not read."}));
    EXPECT_EQ(remarksOf(binaryPly(true), ".ply"), Texts{});
    EXPECT_EQ(remarksOf(binaryPly(false) + "xyz", ".ply"),
              (Texts{"The last 3 bytes after the last element are not read."}));
}

std::string binaryStl(const std::vector<std::array<Vec3d, 3>>& facets, std::uint32_t announced) {
    std::string text(80, ' ');
    text += valueBytes(announced);
    for (const auto& facet : facets) {
        text += std::string(12, '\0');
        for (const Vec3d& p : facet)
            for (int axis = 0; axis < 3; ++axis) text += valueBytes(static_cast<float>(p[axis]));
        text += std::string(2, '\0');
    }
    return text;
}

// A tetrahedron, faces outward.
const Vec3d kA{0, 0, 0}, kB{1, 0, 0}, kC{0, 1, 0}, kD{0, 0, 1};
const std::vector<std::array<Vec3d, 3>> kTetrahedron{{kA, kC, kB}, {kA, kB, kD}, {kA, kD, kC}, {kB, kC, kD}};

std::string textStl() {
    std::string text = "solid part one\n";
    for (const auto& facet : kTetrahedron) {
        text += "  facet normal 0 0 0\n    outer loop\n";
        for (const Vec3d& p : facet) text += fmt::format("      vertex {} {} {}\n", p.x, p.y, p.z);
        text += "    endloop\n  endfacet\n";
    }
    return text + "endsolid part one\n";
}

TEST(StlReader, TetrahedronIsWeldedAndClosed) {
    std::string solid = binaryStl(kTetrahedron, 4);
    solid.replace(0, 5, "solid");
    for (const std::string& text : {textStl(), binaryStl(kTetrahedron, 4), solid}) {
        const auto objects = objectsOf(text, ".stl");
        ASSERT_EQ(objects.size(), 1u);
        // In the order in which the facets bring them.
        EXPECT_EQ(objects[0].mesh->positions, (std::vector<Vec3d>{kA, kC, kB, kD}));
        EXPECT_EQ(polygon(objects[0], 1), (Indices{0, 2, 3}));
        EXPECT_TRUE(objects[0].mesh->facts.closed);
        EXPECT_TRUE(objects[0].mesh->facts.convex);
    }
    EXPECT_EQ(objectsOf(textStl(), ".stl")[0].name, "part one");
    EXPECT_EQ(objectsOf(textStl() + textStl(), ".stl").size(), 2u) << "one object for each solid";
}

TEST(StlReader, SaysWhatItLeavesOut) {
    auto facets = kTetrahedron;
    facets.push_back({kA, kA, kB});
    const Texts one{"1 polygon has fewer than three different corners, and so no area; it is left out."};
    EXPECT_EQ(remarksOf(binaryStl(facets, 5), ".stl"), one);
    const std::string flat = "solid\nfacet\nouter loop\nvertex 1 2 3\nvertex 1 2 3\nvertex 4 5 6\nendloop\nendsolid\n";
    EXPECT_EQ(remarksOf(textStl() + flat, ".stl"), one);
    EXPECT_EQ(remarksOf(binaryStl(kTetrahedron, 4), ".stl"), Texts{});
    EXPECT_EQ(remarksOf(binaryStl(kTetrahedron, 3), ".stl"),
              (Texts{"The last 50 bytes after the last of 3 facets are not read."}));
}

TEST(StlReader, KeywordsMayBeInCapitals) {
    std::string capitals = textStl(), mixed = textStl();
    std::ranges::transform(capitals, capitals.begin(), [](char c) { return char(std::toupper(c)); });
    for (const char* word : {"solid", "facet", "vertex"})
        mixed = withReplaced(mixed, word, std::string(1, char(std::toupper(word[0]))) + (word + 1));
    const auto plain = objectsOf(textStl(), ".stl");
    for (const std::string& text : {capitals, mixed}) {
        const auto objects = objectsOf(text, ".stl");
        ASSERT_EQ(objects.size(), 1u);
        EXPECT_EQ(objects[0].mesh->positions, plain[0].mesh->positions);
        EXPECT_EQ(objects[0].mesh->triangles, plain[0].mesh->triangles);
    }
    EXPECT_EQ(objectsOf(capitals, ".stl")[0].name, "PART ONE") << "a name is left as it is";
}

TEST(StlReader, MinusZeroIsZero) {
    const std::string text = withReplaced(textStl(), "vertex 0 0 0", "vertex -0 0 -0.0");
    EXPECT_TRUE(objectsOf(text, ".stl")[0].mesh->facts.closed);
}

TEST(StlReader, BinaryFilesThatAreWrong) {
    EXPECT_EQ(errorsOf(binaryStl(kTetrahedron, 4294967295u), ".stl"),
              "m: 4 294 967 295 facets announced, the file ends after 284 bytes\n");
    EXPECT_EQ(errorsOf(binaryStl(kTetrahedron, 4).substr(0, 283), ".stl"),
              "m: 4 facets announced, the file ends after 283 bytes\n");
    EXPECT_EQ(errorsOf(std::string(20, '\xFF'), ".stl"),
              "m: the file ends after 20 bytes, expected an STL file: \"solid\", or 84 bytes before the first facet\n");
    auto facets = kTetrahedron;
    facets[1][2].y = std::numeric_limits<double>::quiet_NaN();
    // 84 + 50 + 12 + 2 * 12 + 4
    EXPECT_EQ(errorsOf(binaryStl(facets, 4), ".stl"),
              "m: facet 1, corner 2: y is nan at byte 174, expected a number from -1e9 to 1e9\n");
    EXPECT_EQ(errorsOf(binaryStl({}, 0), ".stl"), "m: found no polygon, expected a model with polygons\n");
}

TEST(StlReader, TextFilesThatAreWrong) {
    EXPECT_EQ(errorsOf(withReplaced(textStl(), "vertex 0 1 0", "vertex 0 inf 0"), ".stl"),
              "m:5:16: found \"inf\", expected y of a vertex, a number from -1e9 to 1e9\n");
    EXPECT_EQ(errorsOf(withReplaced(textStl(), "      vertex 0 1 0\n", ""), ".stl"),
              "m:6:5: a loop of fewer than three vertices, expected three\n");
    EXPECT_EQ(errorsOf("solid\nfacet normal 0 0 1\n", ".stl"),
              "m:2:19: found the end of the file, expected endsolid\n");
    EXPECT_EQ(errorsOf("solid\nfacets normal 0 0 1\nendsolid", ".stl"),
              "m:2:1: found \"facets\", expected solid, facet, outer loop, vertex, endloop, endfacet or endsolid\n");
}

std::string onOneLine(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    return text;
}

// Words mean the same on whatever lines they stand: a facet on one line, two vertices on one, a word on each.
TEST(StlReader, ReadsByWordsNotByLines) {
    const auto plain = objectsOf(textStl(), ".stl");
    const std::string body = textStl().substr(15);  // behind the line "solid part one"
    std::string facets = body, pairs = textStl(), words = body;
    for (std::size_t at = 0; (at = facets.find('\n', at)) != facets.npos; ++at)
        if (!facets.substr(0, at).ends_with("endfacet")) facets[at] = ' ';
    pairs = withReplaced(withReplaced(pairs, "vertex 0 0 0\n", "vertex 0 0 0 "), "outer loop\n", "outer loop ");
    std::ranges::replace(words, ' ', '\n');
    words = withReplaced(words, "endsolid\npart\none", "endsolid part one");
    for (const std::string& text : {"solid part one\n" + facets, pairs, "solid part one\n" + words,
                                    "solid part one\n" + onOneLine(body), onOneLine(textStl())}) {
        const auto objects = objectsOf(text, ".stl");
        ASSERT_EQ(objects.size(), 1u) << text;
        EXPECT_EQ(objects[0].name, "part one") << text;
        EXPECT_EQ(objects[0].mesh->positions, plain[0].mesh->positions) << text;
        EXPECT_EQ(objects[0].mesh->triangles, plain[0].mesh->triangles) << text;
    }
    const auto two = objectsOf(onOneLine(textStl() + withReplaced(textStl(), "one", "two")), ".stl");
    ASSERT_EQ(two.size(), 2u);
    EXPECT_EQ(two[1].name, "part two") << "solid on the line of the endsolid before it";
    EXPECT_TRUE(two[1].mesh->facts.closed);
    EXPECT_EQ(objectsOf(withReplaced(textStl(), "part one", "solid facet"), ".stl")[0].name, "solid facet")
        << "words of a name";
}

TEST(StlReader, PlacesOfWordsOnOneLine) {
    const std::string facet = "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet ";
    const auto objects = objectsOf("solid é " + facet + facet + "endsolid", ".stl");
    ASSERT_EQ(objects.size(), 1u);
    // "solid é " has 8 characters, a facet 86.
    ASSERT_EQ(facet.size(), 86u);
    EXPECT_EQ(objects[0].mesh->polygonPlaces, (std::vector<TextPosition>{{1, 9}, {1, 95}}));
    // 8 + 50 characters stand before the x of the second vertex.
    ASSERT_EQ(facet.substr(43, 8), "vertex 1");
    EXPECT_EQ(errorsOf("solid é " + withReplaced(facet, "vertex 1 0", "vertex x 0"), ".stl"),
              "m:1:59: found \"x\", expected x of a vertex, a number from -1e9 to 1e9\n");
    EXPECT_EQ(errorsOf("solid\nouter loop vertex 0 0\nvertex 1 0 0\nendsolid\n", ".stl"),
              "m:3:1: found \"vertex\", expected z of a vertex, a number from -1e9 to 1e9\n");
    EXPECT_EQ(errorsOf("solid\nfacet normal 0 0 1 0 outer loop\nendsolid\n", ".stl"),
              "m:2:20: found \"0\", expected solid, facet, outer loop, vertex, endloop, endfacet or endsolid\n");
    EXPECT_EQ(errorsOf("solid " + facet + "endsolid solid b " + facet, ".stl"),
              "m:1:196: found the end of the file, expected endsolid\n");  // after 6 + 86 + 17 + 86
    EXPECT_EQ(errorsOf("solid\nouter loop vertex 0 0", ".stl"),
              "m:2:22: found the end of the file, expected z of a vertex, a number from -1e9 to 1e9\n");
}

// Counting a place from the beginning of its line takes the time of the square: for 100 000 facets on one line, 8.6 MB,
// some 4e11 characters, or minutes. Once through takes some 0.05 s.
TEST(StlReader, AllOnOneLineTakesTheTimeOfItsLength) {
    std::string text = "solid ";
    for (int i = 0; i < 100'000; ++i)
        text += "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet ";
    const auto start = std::chrono::steady_clock::now();
    const auto objects = objectsOf(text + "endsolid", ".stl");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    ASSERT_EQ(objects.size(), 1u);
    EXPECT_EQ(objects[0].mesh->polygonCount(), 100'000u);
}

// Found by fuzzing: polygons after the first had the places of others.
TEST(StlReader, EveryPolygonHasAPlaceWithoutAFacetToo) {
    const std::string loop = "outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n";
    const auto objects = objectsOf("solid a\n" + loop + "facet\n" + loop + "endfacet\nendsolid\n", ".stl");
    ASSERT_EQ(objects.size(), 1u);
    EXPECT_EQ(objects[0].mesh->polygonPlaces, (std::vector<TextPosition>{{6, 1}, {7, 1}}));
}

// Found by fuzzing: an endloop of its own took the corners of the object before.
TEST(StlReader, CornersOfALoopAreThoseOfIt) {
    const std::string facet = "facet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    EXPECT_EQ(errorsOf("solid a\n" + facet + "endsolid\nsolid b\nendloop\nendsolid\n", ".stl"),
              "m:11:1: a loop of fewer than three vertices, expected three\n");
    EXPECT_EQ(errorsOf("solid a\n" + facet + "endloop\nendsolid\n", ".stl"),
              "m:9:1: a loop of fewer than three vertices, expected three\n");
}

}  // namespace
}  // namespace pipeline
