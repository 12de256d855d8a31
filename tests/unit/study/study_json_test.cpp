#include "pipeline/export/json/study_json.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "tests/support/studies.h"

namespace pipeline {
namespace {

using test::sphereStudy;

std::string errorsOf(std::string_view text) {
    const Result<StudyReport> read = studyFromJson(text, "study.json");
    return read ? "no error" : format(read.errors().front());
}

// The sphere's study with one value replaced, given by its JSON pointer.
std::string errorsWith(const char* pointer, const Json& value) {
    Json json = toJson(sphereStudy());
    Json* at = &json;
    std::istringstream tokens(pointer + 1);  // behind the first slash
    for (std::string token; std::getline(tokens, token, '/');)
        at = &(at->is(Json::kArray) ? (*at)[std::stoul(token)] : (*at)[token]);
    *at = value;
    return errorsOf(json.dump());
}

TEST(StudyJson, ReadsBackWhatItWrites) {
    StudyReport report = sphereStudy();
    report.points[1].errors[0].drawn = {0.01, 0.012};
    const Result<StudyReport> read = studyFromJson(toJson(report).dump(), "study.json");
    ASSERT_TRUE(read) << format(read.errors());
    EXPECT_EQ(*read, report);
}

TEST(StudyJson, TheFileHasOnePointALineAndTheSameContent) {
    const StudyReport report = sphereStudy();
    const std::string text = studyFileText(report);
    EXPECT_EQ(Json::parse(text), toJson(report));
    const Result<StudyReport> read = studyFromJson(text, "study.json");
    ASSERT_TRUE(read) << format(read.errors());
    EXPECT_EQ(*read, report);
    std::size_t lines = 0;
    for (std::size_t at = 0; (at = text.find("\n{\"number\"", at)) != std::string::npos; ++at) ++lines;
    EXPECT_EQ(lines, report.points.size());
}

// A file's name may hold any bytes; JSON holds UTF-8.
TEST(StudyJson, ANameThatIsNoUtf8IsWrittenAllTheSame) {
    StudyReport report = sphereStudy();
    report.scene = "no\xff.des";
    const Result<StudyReport> read = studyFromJson(studyFileText(report), "study.json");
    ASSERT_TRUE(read) << format(read.errors());
    EXPECT_EQ(read->scene, "no\uFFFD.des");
}

TEST(StudyJson, AStudyWithoutPointsOrAxesIsOne) {
    StudyReport report;
    report.width = report.height = 1;
    const Result<StudyReport> read = studyFromJson(studyFileText(report), "study.json");
    ASSERT_TRUE(read) << format(read.errors());
    EXPECT_EQ(*read, report);
}

// JSON has no infinity: an error that is none of the finite numbers is not known afterwards.
TEST(StudyJson, WhatIsNotFiniteBecomesNull) {
    StudyReport report = sphereStudy();
    report.points[0].errors[0].value[0] = std::numeric_limits<double>::infinity();
    report.errorBars[0].value[0] = std::numeric_limits<double>::infinity();
    const Json json = toJson(report);
    EXPECT_TRUE(json["points"][0]["errors"][0]["model"].is(Json::kNull));
    const Result<StudyReport> read = studyFromJson(json.dump(), "study.json");
    ASSERT_TRUE(read) << format(read.errors());
    EXPECT_FALSE(read->points[0].errors[0].value[0]);
    EXPECT_FALSE(read->errorBars[0].value[0]);
}

TEST(StudyJson, SaysWhereTheTextIsNoJson) {
    EXPECT_EQ(errorsOf("{\n \"a\": 1,, }").substr(0, 16), "study.json:2:9: ");
    EXPECT_EQ(errorsOf("").substr(0, 16), "study.json:1:1: ");
    EXPECT_EQ(errorsOf("[]"), "study.json: this is no study, expected a study that the program wrote");
    EXPECT_EQ(errorsOf("{\"format\": 3}"), "study.json: this is no study, expected a study that the program wrote");
}

TEST(StudyJson, NamesTheValueThatIsWrong) {
    EXPECT_EQ(errorsWith("/format_version", 2), "study.json: /format_version is 2, expected 1");
    EXPECT_EQ(errorsWith("/width", 0), "study.json: /width is 0, expected a whole number from 1 to 1e+09");
    EXPECT_EQ(errorsWith("/load", "low"), "study.json: /load is \"low\", expected an array");
    EXPECT_EQ(errorsWith("/choice/kind", "total"),
              "study.json: /choice/kind is \"total\", expected \"model\", \"arithmetic\" or \"storage\"");
    EXPECT_EQ(errorsWith("/points/0/errors/0/stage", "paint"),
              "study.json: /points/0/errors/0/stage is \"paint\", expected the name of a stage");
    EXPECT_EQ(errorsWith("/points/1/frame/0/2", -1), "study.json: /points/1/frame/0/2 is -1, expected a number from 0");
    EXPECT_EQ(errorsWith("/points/1/megabytes", nullptr),
              "study.json: /points/1/megabytes is null, expected a number from 0");
    EXPECT_EQ(errorsWith("/points/0/counters/fragments", 0.5),
              "study.json: /points/0/counters/fragments is 0.5, expected a whole number from 0 to 9e+15");
}

TEST(StudyJson, NamesWhatIsMissingOnce) {
    Json json = toJson(sphereStudy());
    Json point = Json::object();
    for (const auto& [key, value] : json["points"][2].items())
        if (key != "frame") point[key] = value;
    json["points"][2] = point;
    EXPECT_EQ(errorsOf(json.dump()), "study.json: /points/2/frame is missing");
}

TEST(StudyJson, RefusesPointsThatTheSweepDoesNotHave) {
    EXPECT_EQ(errorsWith("/points/11/number", 12),
              "study.json: /points/11/number is 12, expected the number of a point of the sweep");
    EXPECT_EQ(errorsWith("/points/5/values/0", "phong"),
              "study.json: /points/5/values is an array, expected gouraud, 16, the values of point 5");
    EXPECT_EQ(errorsWith("/points/5", toJson(sphereStudy())["points"][4]),
              "study.json: /points/5/number is 4, expected a number above the one before it");
}

TEST(StudyJson, TellsAtMostTwentyErrors) {
    Json json = toJson(sphereStudy());
    for (Json& point : json["points"])
        for (Json& time : point["frame"])
            for (Json& sample : time) sample = "slow";
    const Result<StudyReport> read = studyFromJson(json.dump(), "study.json");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.errors().size(), kMaxErrors);
}

// Whatever is cut off a file, the rest is told as an error, not read as a smaller study.
TEST(StudyJson, ACutFileIsNoStudy) {
    StudyReport report = sphereStudy();
    report.points.resize(2);
    const std::string text = studyFileText(report);
    for (std::size_t length = 0; length + 2 < text.size(); length += 7)
        EXPECT_FALSE(studyFromJson(text.substr(0, length), "study.json")) << length;
}

}  // namespace
}  // namespace pipeline
