// Written as the library writes it, which is the reference here.
#include "pipeline/export/json/json_value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "pipeline/export/json/json.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

using Reference = nlohmann::ordered_json;

// The same text for both, with braces inside: a list of values.
#define SAME_TEXT(...)                        \
    for (const int indent : {-1, 1, 2})       \
    EXPECT_EQ(Json(__VA_ARGS__).dump(indent), \
              Reference(__VA_ARGS__).dump(indent, ' ', false, Reference::error_handler_t::replace))

TEST(JsonValue, IsWrittenAsTheLibraryWritesIt) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    SAME_TEXT({{"a", 1}, {"b", {{"c", nullptr}, {"d", true}}}, {"a", 2}});
    SAME_TEXT({{"pair", "of texts"}, {"list", {"x", 2, "y"}}, {"pairs", {{1, 2}, {3, 4}}}});
    SAME_TEXT({0.1, 1.0, 1e300, -0.0, 5e-324, 0.1f, 1e15, 1e16, 123456789.125, NAN, kInfinity, -kInfinity});
    SAME_TEXT({std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::uint64_t>::max(), 'a', false});
    SAME_TEXT({"\"\\\b\f\n\r\t\x01\x7f/<", "n\u00e4h\U0001F600", "no\xff.des", "\xc3", "\xe2\x82", "\xed\xa0\x80"});
    SAME_TEXT(std::vector<std::vector<double>>{{1, 0.5}, {}});
    SAME_TEXT(std::array<int, 3>{1, -2, 3});
    SAME_TEXT(std::map<std::string, std::vector<std::string>>{{"b", {"x"}}, {"a", {}}});
    EXPECT_EQ(Json::object().dump(2) + Json::array().dump(2) + Json().dump(2), "{}[]null");
}

TEST(JsonValue, IsReadAsTheLibraryReadsIt) {
    for (const char* text : {R"({"b": [1, -1, 1.5, 1e3, true, null, "ä\u00e4\n"], "a": {}, "b": 3, "": [[]]})", "[]",
                             "-7", "18446744073709551615", "18446744073709551616", "\"x\""})
        for (const int indent : {-1, 2}) EXPECT_EQ(Json::parse(text).dump(indent), Reference::parse(text).dump(indent));
    for (const char* text : {"", "{", "[1,]", "nul", "[1e999]", "\"\xff\"", "{\"a\" 1}", "1 2"}) {
        EXPECT_FALSE(Json::read(text)) << text;
        std::string ours, theirs;
        try {
            Json::parse(text);
        } catch (const std::exception& error) {
            ours = error.what();
        }
        try {
            static_cast<void>(Reference::parse(text).size());
        } catch (const std::exception& error) {
            theirs = error.what();
        }
        EXPECT_EQ(ours, theirs) << text;
        EXPECT_NE(ours, "") << text;
    }
}

TEST(JsonValue, SaysWhatIsMissingOrOfAnotherKind) {
    const auto said = [](const auto& call) {
        try {
            call();
        } catch (const std::exception& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const Json json{{"a", 1}, {"b", "text"}};
    EXPECT_NE(said([&] { json.at("c"); }).find("key 'c' not found"), std::string::npos);
    EXPECT_NE(said([&] { json.at("a").at("c"); }).find("cannot use at() with number"), std::string::npos);
    EXPECT_NE(said([&] { json["b"].get<double>(); }).find("must be number, but is string"), std::string::npos);
    EXPECT_NE(said([&] { json.get<std::string>(); }).find("must be string, but is object"), std::string::npos);
    EXPECT_EQ(json["c"]["d"], Json()) << "null, and nothing thrown";
    EXPECT_EQ(json["a"].text(), "");
}

TEST(JsonValue, NumbersAreEqualByValueAndObjectsInOrder) {
    EXPECT_EQ(Json(1), Json(1u));
    EXPECT_EQ(Json(1), Json(1.0));
    EXPECT_NE(Json(-1), Json(std::numeric_limits<std::uint64_t>::max() - 1));
    EXPECT_NE(Json(1), Json(true));
    EXPECT_NE(Json(1), Json("1"));
    EXPECT_NE((Json{{"a", 1}, {"b", 2}}), (Json{{"b", 2}, {"a", 1}}));
    EXPECT_NE(Json::array(), Json::object());
}

// A stranger's file: a level a byte, which no stack has room for.
TEST(JsonValue, DeepLevelsAreFreedAndLeftOut) {
    const std::string deep = std::string(200'000, '[') + std::string(200'000, ']');
    EXPECT_TRUE(Json::read(deep)->is(Json::kArray));
    EXPECT_EQ(Json::read(deep, {.levels = 3})->dump(), "[[[]]]");
    EXPECT_EQ(Json::read(R"({"s": {"s": 1}, "a": {"s": 2}, "b": [[3]]})", {.levels = 3, .without = "s"})->dump(),
              R"({"a":{"s":2},"b":[[]]})");
}

TEST(Json, HoldsAWholePixelReport) {
    const FramePtr frame = test::frameOf(test::pyramid(), {});
    const Json json = toJson(*frame, inspectPixel(*frame, {268, 281}));
    // Lecture 1's right face by hand: I_max = 0.9·50 + 100·(0.9 + 0.4) = 175.
    EXPECT_EQ(json["covered"], true);
    EXPECT_EQ(json["polygon"], 2);
    EXPECT_EQ(json["i_max"], 175);
    EXPECT_EQ(json["color"], Json::array({37, 93, 167}));
    EXPECT_EQ(json["equation"]["b"][0]["role"], "symbols");
    EXPECT_EQ(json["fragments"][0]["stored"], Json(INFINITY));
    EXPECT_EQ(Json::parse(json.dump())["fragments"][0]["stored"], nullptr);
    const Json background = toJson(*frame, inspectPixel(*frame, {0, 0}));
    EXPECT_EQ(background["covered"], false);
    EXPECT_FALSE(background.find("polygon"));
}

}  // namespace
}  // namespace pipeline
