// PLY and STL as people have them: strips, what is left out, counts that were never filled in, records without an end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "pipeline/formats/model_reader.h"

namespace pipeline {
namespace {

Result<LoadedModel> read(std::string_view text, std::string_view extension) {
    return readModel({text, "m"}, extension, [](std::string_view) -> Result<NamedFile> {
        return Error{{}, "none", {}};
    });
}
LoadedModel modelOf(std::string_view text, std::string_view extension) {
    const Result<LoadedModel> model = read(text, extension);
    EXPECT_TRUE(model) << (model ? "" : format(model.errors()));
    return model ? *model : LoadedModel{};
}
std::string errorsOf(std::string_view text, std::string_view extension) {
    const Result<LoadedModel> model = read(text, extension);
    return model ? "" : format(model.errors());
}

using Texts = std::vector<std::string>;
Texts remarksOf(const LoadedModel& model) {
    Texts texts;
    for (const Remark& remark : model.remarks) texts.push_back(remark.text);
    return texts;
}
std::vector<Triangle> trianglesOf(const LoadedModel& model) {
    return model.objects.empty() ? std::vector<Triangle>{} : model.objects[0].mesh->triangles;
}

template <class T>
std::string listBytes(std::initializer_list<T> values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), std::data(values), bytes.size());
    return bytes;
}

const std::string kVertices = "element vertex 6\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kStrips = "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";

// Of a strip every other triangle is turned round, so that all face alike; -1 begins the next strip, which counts anew.
TEST(PlyLenient, TriangleStripsAreRead) {
    const std::vector<Triangle> expected{{{0, 1, 2}}, {{1, 3, 2}}, {{2, 3, 4}}, {{1, 4, 5}}};
    const std::string text = "ply\nformat ascii 1.0\n" + kVertices + kStrips +
                             "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n9 0 1 2 3 4 -1 1 4 5\n";
    EXPECT_EQ(trianglesOf(modelOf(text, ".ply")), expected);
    EXPECT_EQ(remarksOf(modelOf(text, ".ply")), Texts{});
    const std::string binary = "ply\nformat binary_little_endian 1.0\n" + kVertices + kStrips +
                               listBytes<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0, 1, 2, 0}) +
                               listBytes<std::int32_t>({9, 0, 1, 2, 3, 4, -1, 1, 4, 5});
    EXPECT_EQ(trianglesOf(modelOf(binary, ".ply")), expected);
    // A corner that is repeated goes on elsewhere: two triangles of no area, which are no loss.
    const std::string bridge =
        "ply\nformat ascii 1.0\n" + kVertices + kStrips + "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n5 0 1 2 2 3\n";
    EXPECT_EQ(trianglesOf(modelOf(bridge, ".ply")), (std::vector<Triangle>{{{0, 1, 2}}}));
    EXPECT_EQ(remarksOf(modelOf(bridge, ".ply")), Texts{});
    EXPECT_EQ(errorsOf("ply\nformat ascii 1.0\n" + kVertices + kStrips +
                           "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n3 0 1 -2\n",
                       ".ply"),
              "m:16:7: found \"-2\", expected a vertex index from 0 to 5\n");
}

TEST(PlyLenient, WhatIsLeftOutIsSaidWithACount) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\nelement edge 1\n"
        "property int a\nelement face 1\nproperty list uchar int vertex_indices\nproperty uchar red\nend_header\n"
        "0 0 0 1 2 3 9\n1 0 0 1 2 3 9\n0 1 0 1 2 3 9\n0\n3 0 1 2 7\n";
    EXPECT_EQ(remarksOf(modelOf(text, ".ply")), (Texts{"\"quality\" of 3 rows of the element \"vertex\" is not read.",
                                                       "The element \"edge\" (1 row) is not read.",
                                                       "The colours of 1 row of the element \"face\" are not read."}));
}

// As MeshLab and three.js read them: a line is a row, and comments may stand between rows.
TEST(PlyLenient, LongerRowsAndCommentsBetweenThemRefuseNothing) {
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
    const std::vector<Triangle> expected{{{0, 1, 2}}, {{0, 2, 1}}};
    const LoadedModel longer =
        modelOf(header + "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2 9 9\n3 0 2 1\n", ".ply");
    EXPECT_EQ(trianglesOf(longer), expected);
    EXPECT_EQ(remarksOf(longer), Texts{"4 rows with more words than the header says are read without them."});
    EXPECT_EQ(longer.remarks[0].about, "m:10");
    const LoadedModel commented = modelOf(
        header + "0 0 0\n1 0 0\ncomment 3 0 1 2\n0 1 0\nobj_info x\n\n# y\n3 0 1 2\n3 0 2 1\ncomment end\n", ".ply");
    EXPECT_EQ(trianglesOf(commented), expected);
    EXPECT_EQ(remarksOf(commented), Texts{});
}

// The first byte of the numbers may be that of a LF: here the lowest of the float 0x3F80000A.
TEST(PlyLenient, AHeaderWhoseLinesEndWithCrAloneEndsThere) {
    std::string header =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    std::ranges::replace(header, '\n', '\r');
    const std::string numbers = listBytes<std::uint32_t>({0x3F80000A, 0, 0, 0, 0x3F800000, 0, 0, 0, 0x3F800000}) +
                                '\3' + listBytes<std::int32_t>({0, 1, 2});
    const LoadedModel model = modelOf(header + numbers, ".ply");
    ASSERT_EQ(trianglesOf(model).size(), 1u);
    EXPECT_EQ(model.objects[0].mesh->positions[0].x, 1 + 10 * 0x1p-23);
    EXPECT_EQ(remarksOf(model), Texts{});
    std::string text = header + "0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r";
    text.replace(text.find("binary_little_endian"), 20, "ascii");
    EXPECT_EQ(trianglesOf(modelOf(text, ".ply")).size(), 1u);
}

TEST(PlyLenient, WordsOfItsOwnInTheHeaderRefuseNothing) {
    const auto withLine = [](const std::string& line) {
        return "ply\nformat ascii 1.0\n" + line +
               "\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
               "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    };
    const LoadedModel model = modelOf(withLine("Created by hand"), ".ply");
    EXPECT_EQ(trianglesOf(model).size(), 1u);
    EXPECT_EQ(remarksOf(model), Texts{"1 line of the header, from line 3 on, has no keyword of PLY and is not read."});
    EXPECT_EQ(errorsOf(withLine("propery float w"), ".ply"),
              "m:3:1: found \"propery\", expected format, comment, element, property or end_header\n");
}

// A normal that is no number makes no shape wrong.
TEST(PlyLenient, NormalsWithoutADirectionRefuseNothing) {
    const std::string text =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\nelement face 1\nproperty list uchar int "
        "vertex_indices\n"
        "end_header\n" +
        listBytes<float>({0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0, 1, 0, 0, 0, 1}) +
        '\3' + listBytes<std::int32_t>({0, 1, 2});
    const LoadedModel model = modelOf(text, ".ply");
    EXPECT_EQ(trianglesOf(model).size(), 1u);
    EXPECT_TRUE(model.objects.at(0).mesh->normals.empty());
    EXPECT_EQ(remarksOf(model), Texts{"1 normal has no direction; the normals of the file are not used."});
    // However a program spells it, and in properties that are left out anyhow.
    for (const char* none : {"nan", "-nan(ind)", "inf", "-1.#IND", "1.#QNAN"}) {
        const std::string written = fmt::format(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty "
            "float quality\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 {0}\n1 0 0 "
            "{0}\n0 1 0 "
            "{0}\n3 0 1 2\n",
            none);
        EXPECT_EQ(trianglesOf(modelOf(written, ".ply")).size(), 1u) << none;
    }
}

std::string binaryStl(std::uint32_t announced, int facets, std::uint16_t attributes = 0) {
    std::string bytes(80, ' ');
    bytes += listBytes<std::uint32_t>({announced});
    for (int i = 0; i < facets; ++i) {
        const float x = float(i);
        bytes += listBytes<float>({0, 0, 1, x, 0, 0, x + 1, 0, 0, x, 1, 0}) + listBytes<std::uint16_t>({attributes});
    }
    return bytes;
}

TEST(StlLenient, ACountOfZeroIsThatOfTheSize) {
    const LoadedModel model = modelOf(binaryStl(0, 4), ".stl");
    EXPECT_EQ(trianglesOf(model).size(), 4u);
    EXPECT_EQ(remarksOf(model), Texts{"The file announces 0 facets; as many are read as its size has room for: 4."});
    EXPECT_EQ(errorsOf(binaryStl(0, 0), ".stl"), "m: found no polygon, expected a model with polygons\n");
}

TEST(StlLenient, AttributesAreLeftOutWithACount) {
    EXPECT_EQ(remarksOf(modelOf(binaryStl(3, 3, 0x8001), ".stl")),
              Texts{"The attributes of 3 facets, in which some programs write a colour, are not read."});
}

std::string facet(int i, const std::string& end) {
    return fmt::format("facet normal 0 0 1\nouter loop\nvertex {0} 0 0\nvertex {1} 0 0\nvertex {0} 1 0\n{2}", i, i + 1,
                       end);
}

TEST(StlLenient, KeywordsInTwoWordsAreRead) {
    const LoadedModel model = modelOf(
        "solid a b\n" + facet(0, "end loop\nend facet\n") + facet(1, "End Loop\nENDFACET\n") + "end solid a b\n",
        ".stl");
    EXPECT_EQ(trianglesOf(model).size(), 2u);
    EXPECT_EQ(model.objects.at(0).name, "a b");
    EXPECT_EQ(remarksOf(model), Texts{});
    EXPECT_EQ(errorsOf("solid\n" + facet(0, "end hook\nendfacet\n") + "endsolid\n", ".stl"),
              "m:7:1: found \"end\", expected solid, facet, outer loop, vertex, endloop, endfacet or endsolid\n");
}

// Whatever keyword follows the third vertex, the facet is there.
TEST(StlLenient, NoFacetIsLostWithoutAWord) {
    for (const char* end : {"endfacet\n", "", "facet normal 0 0 1\nendfacet\n"}) {
        const std::string text =
            "solid a\n" + facet(0, "endloop\nendfacet\n") + facet(1, end) + facet(2, end) + "endsolid a\n";
        EXPECT_EQ(trianglesOf(modelOf(text, ".stl")).size(), 3u) << end;
    }
    EXPECT_EQ(
        remarksOf(modelOf("solid a\n" + facet(0, "endloop\nendfacet\n") + facet(1, "") + facet(2, "") + "endsolid a\n",
                          ".stl")),
        Texts{"2 facets are without endloop, the first at line 9; they are read all the same."});
    EXPECT_EQ(
        remarksOf(modelOf("solid a\n" + facet(0, "endloop\nendfacet\nfacet normal 0 0 1\nendfacet\n") + "endsolid a\n",
                          ".stl")),
        Texts{"1 facet is without vertices; nothing of it is drawn."});
    // With two vertices there is no saying what was meant.
    EXPECT_EQ(
        errorsOf("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendfacet\nendsolid a\n", ".stl"),
        "m:6:1: a loop of fewer than three vertices, expected three\n");
}

}  // namespace
}  // namespace pipeline
