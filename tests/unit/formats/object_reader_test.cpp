// What a bad object description gets. Each text is a triangle with one thing wrong, and the
// place is counted by eye.
#include <gtest/gtest.h>

#include <clocale>

#include "pipeline/formats/lecture/lecture_formats.h"
#include "pipeline/formats/text/text_scanner.h"

namespace pipeline {
namespace {

std::string objectErrors(std::string_view text) {
    Errors errors;
    readObjectDescription({text, "o.des"}, errors);
    EXPECT_LE(errors.size(), kMaxErrors);
    return format(errors);
}

TEST(ObjectReader, TriangleIsRead) {
    EXPECT_EQ(objectErrors("3 1\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n0.2 0.5 0.9 0.4 8"), "");
}

TEST(ObjectReader, WordWhereAnIndexBelongs) {
    EXPECT_EQ(objectErrors("3 1\n0 0 0 1 0 0 0 1 0\n3,(0,x4,2)\n0.2 0.5 0.9 0.4 8"),
              "o.des:3:6: found \"x4\", expected a vertex index from 0 to 2\n");
}

TEST(ObjectReader, IndexOutOfRange) {
    for (const std::string index : {"3", "-1", "4294967296", "99999999999999999999", "1.0", "1e0", "0x1", "0x"})
        EXPECT_EQ(objectErrors("3 1\n0 0 0 1 0 0 0 1 0\n3 0 1 " + index + "\n0.2 0.5 0.9 0.4 8"),
                  "o.des:3:7: found \"" + index + "\", expected a vertex index from 0 to 2\n");
}

TEST(ObjectReader, PolygonWithTooFewVertices) {
    for (const std::string polygon : {"2 0 1", "1 0", "0"})
        EXPECT_EQ(objectErrors("3 2\n0 0 0 1 0 0 0 1 0\n3 0 1 2 " + polygon + "\n0.2 0.5 0.9 0.4 8"),
                  "o.des:3:9: found \"" + polygon.substr(0, 1) +
                      "\", expected the number of vertices of polygon 1, from 3 to 1 048 576\n");
}

TEST(ObjectReader, SameVertexTwiceInARow) {
    EXPECT_EQ(objectErrors("3 1\n0 0 0 1 0 0 0 1 0\n4 0 1 1 2\n0.2 0.5 0.9 0.4 8"),
              "o.des:3:7: found \"1\", expected a vertex other than the one before\n");
    EXPECT_EQ(objectErrors("3 1\n0 0 0 1 0 0 0 1 0\n4 0 1 2 0\n0.2 0.5 0.9 0.4 8"),
              "o.des:3:9: found \"0\", expected a vertex other than the polygon's first: a polygon closes by itself\n");
}

TEST(ObjectReader, NumbersThatAreNone) {
    for (const std::string number : {"nan",
                                     "NaN",
                                     "-nan",
                                     "nan0",
                                     "inf",
                                     "-inf",
                                     "infinity",
                                     "1e999",
                                     "-1e999",
                                     "1e99999999999",
                                     "3x",
                                     "0x10",
                                     "1e",
                                     "1e+",
                                     "--1",
                                     "+-1",
                                     "-+1",
                                     "++1",
                                     "-",
                                     "+",
                                     ".",
                                     "1.2.3",
                                     "e5",
                                     "1;2",
                                     "1_000",
                                     "1'000",
                                     "\xC2\xA0"
                                     "1",
                                     "²"})
        EXPECT_EQ(objectErrors("3 1\n0 0 0 1 " + number + " 0 0 1 0\n3 0 1 2\n0.2 0.5 0.9 0.4 8"),
                  "o.des:2:9: found " + quotedInput(number) + ", expected y of vertex 1, a number from -1e9 to 1e9\n");
}

TEST(ObjectReader, TooManyZerosAreNotTooSmall) {
    // 0.000…01e+5000 with 4000 digits before the 1 is 1e999; with e+4000 it is 0.1.
    EXPECT_FALSE(parseNumber("0." + std::string(4000, '0') + "1e5000"));
    EXPECT_EQ(parseNumber("0." + std::string(4000, '0') + "1e4000"), 0.1);
    EXPECT_EQ(parseNumber("0." + std::string(4000, '0') + "1"), 0.0);
    EXPECT_EQ(parseNumber("1" + std::string(4000, '0') + "e-4000"), 1.0);
    EXPECT_FALSE(parseNumber("1" + std::string(400, '0')));
    EXPECT_EQ(parseNumber("1" + std::string(400, '0') + "e-9999"), 0.0);
    EXPECT_EQ(parseNumber("1e-99999999999999999999"), 0.0);
    EXPECT_EQ(parseNumber("4.9e-324"), 4.9e-324);
}

TEST(ObjectReader, CoefficientOutsideItsRange) {
    const std::string mesh = "3 1\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n";
    EXPECT_EQ(objectErrors(mesh + "1500 -1001 0.9 2000 -8"),
              "o.des:4:1: found \"1500\", expected k_r red, a number from -1000 to 1000\n"
              "o.des:4:6: found \"-1001\", expected k_g green, a number from -1000 to 1000\n"
              "o.des:4:16: found \"2000\", expected k_s specular, a number from -1000 to 1000\n"
              "o.des:4:21: found \"-8\", expected n exponent, a number from 0 to 1000000\n");
}

TEST(ObjectReader, FarTooManyAnnounced) {
    EXPECT_EQ(objectErrors("4294967295 1\n(0,0,0)"),
              "o.des:1:1: 4 294 967 295 vertices announced, the file ends after 20 bytes\n");
    EXPECT_EQ(objectErrors("3 4294967295 (0,0,0)"),
              "o.des:1:3: 4 294 967 295 polygons announced, the file ends after 20 bytes\n");
    EXPECT_EQ(objectErrors("3 1\n0 0 0 1 0 0 0 1 0\n1048576 0 1 2\n0.2 0.5 0.9 0.4 8"),
              "o.des:3:1: 1 048 576 vertices announced, the file ends after 53 bytes\n");
}

TEST(ObjectReader, CountThatIsNoCount) {
    for (const std::string count : {"-3", "3.5", "3.0", "1e3", "three", "99999999999999999999"})
        EXPECT_EQ(objectErrors(count + " 1\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n0.2 0.5 0.9 0.4 8"),
                  "o.des:1:1: found \"" + count + "\", expected the number of vertices, from 3 to 134 217 728\n");
    EXPECT_EQ(objectErrors("3 0\n0 0 0 1 0 0 0 1 0\n0.2 0.5 0.9 0.4 8"),
              "o.des:1:3: found \"0\", expected the number of polygons, from 1 to 134 217 728\n");
}

TEST(ObjectReader, OnePointTooManyAnnounced) {
    // The fourth vertex takes "3 0 1" of the polygon, which leaves "2 0.2 0.5" for a polygon of two.
    EXPECT_EQ(objectErrors("4 1\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n0.2 0.5 0.9 0.4 8").substr(0, 69),
              "o.des:3:7: found \"2\", expected the number of vertices of polygon 0, f");
}

TEST(ObjectReader, OnePointTooFewAnnounced) {
    // The polygon's number of vertices is the last vertex' x.
    EXPECT_EQ(objectErrors("3 1\n0 0 0 1 0 0 0 1 0 0.5 1 0\n3 0 1 2\n0.2 0.5 0.9 0.4 8"),
              "o.des:2:19: found \"0.5\", expected the number of vertices of polygon 0, from 3 to 1 048 576\n");
}

TEST(ObjectReader, OnePolygonTooManyAnnounced) {
    EXPECT_EQ(objectErrors("3 2\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n0.2 0.5 0.9 0.4 8"),
              "o.des:4:1: found \"0.2\", expected the number of vertices of polygon 1, from 3 to 1 048 576\n");
}

TEST(ObjectReader, OnePolygonTooFewAnnounced) {
    EXPECT_EQ(objectErrors("3 1\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n3 2 1 0\n0.2 0.5 0.9 0.4 8"),
              "o.des:5:5: found \"0.5\", expected the end of the file\n");
}

TEST(ObjectReader, FileThatEndsTooSoon) {
    EXPECT_EQ(objectErrors("3 1\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n0.2 0.5 0.9\n"),
              "o.des:5:1: found the end of the file, expected k_s specular, a number from -1000 to 1000\n");
}

TEST(ObjectReader, TextAfterTheEnd) {
    EXPECT_EQ(objectErrors("3 1\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n0.2 0.5 0.9 0.4 8\n\nmore and more"),
              "o.des:6:1: found \"more\", expected the end of the file\n");
}

TEST(ObjectReader, NothingInIt) {
    const std::string expected = "found the end of the file, expected the number of vertices, from 3 to 134 217 728\n";
    EXPECT_EQ(objectErrors(""), "o.des:1:1: " + expected);
    EXPECT_EQ(objectErrors("// nothing\n//at all"), "o.des:2:9: " + expected);
    EXPECT_EQ(objectErrors("\xEF\xBB\xBF\n , ()"), "o.des:2:6: " + expected);
}

TEST(ObjectReader, ZeroByteIsShownAndRefused) {
    std::string text = "3 1\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n0.2 0.5 0.9 0.4 8";
    text[2] = '\0';
    EXPECT_EQ(objectErrors(text),
              "o.des:1:3: found \"\\x00\", expected the number of polygons, from 1 to 134 217 728\n");
}

TEST(ObjectReader, InputInMessagesIsEscapedAndShort) {
    EXPECT_EQ(quotedInput("a\x1B[31m\"\\\x7F"), R"("a\x1B[31m\"\\\x7F")");
    EXPECT_EQ(quotedInput("α\xCE\xFF\xE2\x80\xAE"), R"("α\xCE\xFF\xE2\x80\xAE")");  // cut off; no UTF-8; right to left
    std::string wide, shown;
    for (int i = 0; i < 41; ++i) wide += "ä";
    for (int i = 0; i < 40; ++i) shown += "ä";
    EXPECT_EQ(quotedInput(wide), '"' + shown + "…\"");
    EXPECT_EQ(quotedInput(shown), '"' + shown + '"');
}

TEST(ObjectReader, ColumnsCountCharactersNotBytes) {
    EXPECT_EQ(objectErrors("// Größe\n3 1\n0 0 0 1 0 0 0 1 0\n3 äöü 1 x\n0.2 0.5 0.9 0.4 8"),
              "o.des:4:3: found \"äöü\", expected a vertex index from 0 to 2\n"
              "o.des:4:9: found \"x\", expected a vertex index from 0 to 2\n");
}

TEST(ObjectReader, LineEndsCountOnce) {
    for (const std::string end : {"\n", "\r\n", "\r"})
        EXPECT_EQ(objectErrors("3 1" + end + end + "// c" + end + "0 0 0 1 0 0 0 1 x"),
                  "o.des:4:17: found \"x\", expected z of vertex 2, a number from -1e9 to 1e9\n"
                  "o.des:4:18: found the end of the file, expected the number of vertices of polygon 0, "
                  "from 3 to 1 048 576\n");
}

TEST(ObjectReader, TwentyErrorsAndNoMore) {
    std::string text = "10 1\n";
    for (int i = 0; i < 30; ++i) text += "x ";
    text += "\n3 0 1 2\n0.2 0.5 0.9 0.4 8";
    Errors errors;
    readObjectDescription({text, "o.des"}, errors);
    ASSERT_EQ(errors.size(), kMaxErrors);
    EXPECT_EQ(errors.back().where, (SourceLocation{"o.des", 2, 39}));  // the twentieth x
}

TEST(ObjectReader, LocaleDoesNotMatter) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) std::setlocale(LC_ALL, name);
    EXPECT_EQ(objectErrors("3 1\n0 0 0 1.5 0 0 0 1 0\n3 0 1 2\n0.2 0.5 0.9 0.4 8"), "");
    std::setlocale(LC_ALL, before.c_str());
}

TEST(ObjectReader, WordWithoutEndIsNotQuoted) {
    EXPECT_EQ(objectErrors("3 1\n0 0 " + std::string(5000, '0') + " 1 0 0 0 1 0\n3 0 1 2\n0.2 0.5 0.9 0.4 8"),
              "o.des:2:5: found a word of 5 000 bytes, expected z of vertex 0, a number from -1e9 to 1e9\n");
}

// All on one line: finding the place of each polygon must not count the line from its start.
// Quadratic time would be hours, which the limit of a test ends.
TEST(ObjectReader, LargeFileIsRead) {
    const std::size_t count = 300'000;
    std::string text = std::to_string(count) + ' ' + std::to_string(count) + ' ';
    for (std::size_t i = 0; i < count; ++i) text += "(0.12345," + std::to_string(i) + ",-17.5), ";
    for (std::size_t i = 0; i < count; ++i)
        text += "3,(0," + std::to_string(i / 2 + 1) + ',' + std::to_string(i / 2 + 2) + "), ";
    text += "0.2 0.5 0.9 0.4 8";
    Errors errors;
    const ObjectDescription description = readObjectDescription({text, "o.des"}, errors);
    EXPECT_TRUE(errors.empty()) << format(errors);
    EXPECT_EQ(description.mesh.polygonCount(), count);
    EXPECT_EQ(description.mesh.polygonPlaces.back().line, 1);
}

}  // namespace
}  // namespace pipeline
