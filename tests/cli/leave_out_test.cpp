#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

using Json = nlohmann::json;
using test::run;

std::string countsOf(const std::string& scene) {
    const auto done = run({"plan", scene, "--buffers", "color", "--counts"});
    EXPECT_EQ(done.status, 0) << done.err;
    const auto at = done.out.find("Counts\n");
    return scene + "\n" + (at == done.out.npos ? done.out : done.out.substr(at + 7));
}

// The counters of scenes of every kind, exact: whoever changes what the pipeline does sees it here.
// A change that is meant goes into counts.txt.
TEST(LeaveOut, CountersAreTheGoldenOnes) {
    std::ifstream file(SHADESCOPE_COUNTS);
    ASSERT_TRUE(file);
    std::ostringstream golden;
    golden << file.rdbuf();
    std::string counts;
    for (const char* scene :
         {"pyramid", "two_pyramids", "lambert", "highlight_exponents", "point_light_shadow", "near_plane", "gl_cube"})
        counts += countsOf(scene) + "\n";
    EXPECT_EQ(counts, golden.str());
}

TEST(LeaveOut, NoLeaveOutRunsEverything) {
    const Json json = Json::parse(run({"plan", "pyramid", "--no-leave-out", "--json"}).out);
    for (const Json& stage : json["plan"]) EXPECT_EQ(stage["action"], "runs") << stage["stage"];
}

TEST(LeaveOut, ThePlanNamesTheRule) {
    const Json json = Json::parse(run({"plan", "pyramid", "--json"}).out);
    EXPECT_EQ(json["plan"][3]["rule"], "convex_shadow");
    const Json off = Json::parse(run({"plan", "pyramid", "--json", "--set", "rule.convex_shadow=off"}).out);
    EXPECT_EQ(off["plan"][3]["action"], "runs");
}

// The pyramid is convex and opaque, and has Phong's model: what else runs says for whom.
TEST(LeaveOut, WhatRunsOnlyBecauseItsRuleIsOffSaysSo) {
    const auto why = [](std::vector<std::string> more, std::size_t stage, const std::string& name) {
        more.insert(more.begin(), {"plan", "pyramid", "--json"});
        const Json plan = Json::parse(run(more).out)["plan"];
        for (const Json& part : plan[stage]["parts"])
            if (part["part"] == name) return part["action"].get<std::string>() + ": " + part["why"].get<std::string>();
        return std::string("no such part");
    };
    const std::vector<std::string> all{"--no-leave-out"};
    EXPECT_EQ(why(all, 5, "translucent pass"), "runs: Every surface is opaque, but leave_out is off.");
    EXPECT_EQ(why(all, 5, "sort of layers"), "runs: Every surface is opaque, but leave_out is off.");
    EXPECT_EQ(why({"--no-leave-out", "--buffers", "color"}, 3, "light 0"),
              "runs: The only object is convex: it cannot shadow itself, but leave_out is off.");
    EXPECT_EQ(why({"--set", "rule.translucent_pass=off"}, 5, "translucent pass"),
              "runs: Every surface is opaque, but rule.translucent_pass is off.");
    EXPECT_EQ(why({"--set", "rule.translucent_pass=off"}, 5, "H"),
              "left out: The specular terms are Phong's, of R and not of H.");
    EXPECT_EQ(why({"--no-leave-out", "--set", "material.0.ks=0"}, 5, "specular of light 0"),
              "runs: k_s is 0 in every material, but leave_out is off.");
}

// Those that the plan calls left out are those that an export does not have.
TEST(LeaveOut, ThePlanNamesTheBuffersThatAreNotThere) {
    const auto names = [](const Json& buffers) {
        std::set<std::string> found;
        for (const Json& buffer : buffers) {
            std::string name = buffer["name"];
            if (name.ends_with(".0")) name.back() = 'k';
            found.insert(name);
        }
        return found;
    };
    const test::TemporaryFolder folder;
    for (const std::vector<std::string>& more : {std::vector<std::string>{},
                                                 {"--no-leave-out"},
                                                 {"--no-leave-out", "--set", "visibility=none"},
                                                 {"--no-leave-out", "--set", "visibility=painter"},
                                                 {"--set", "rule.unread_buffers=off"}}) {
        const auto with = [&](std::vector<std::string> arguments) {
            arguments.insert(arguments.end(), more.begin(), more.end());
            return run(arguments);
        };
        const Json plan = Json::parse(with({"plan", "pyramid", "--json"}).out);
        ASSERT_EQ(
            with({"export", "pyramid", "--size", "16x12", "--format", "npy", "-o", folder.path().string()}).status, 0);
        const Json manifest = Json::parse(test::readText(folder / "manifest.json"));
        EXPECT_EQ(names(plan["absent"]), names(manifest["absent"])) << testing::PrintToString(more);
    }
}

// The spheres of this scene give their normals, and no light casts a shadow.
TEST(LeaveOut, ThePlanSaysWhyNobodyReadsNormals) {
    const auto normals = [](const char* scene, const char* buffer) {
        return Json::parse(run({"plan", scene, "--json", "--buffers", buffer}).out)["plan"][2];
    };
    const Json smooth = normals("lambert", "color");
    EXPECT_EQ(smooth["action"], "runs");
    EXPECT_EQ(smooth["parts"][0]["why"], "Every vertex has a normal of its own, and there are no shadows.");
    EXPECT_EQ(smooth["parts"][0]["rule"], "polygon_normals");
    EXPECT_EQ(smooth["parts"][1]["why"], "Every vertex has a normal of its own.");
    EXPECT_EQ(smooth["parts"][2]["action"], "runs");
    const Json depth = normals("lambert", "z_view");
    EXPECT_EQ(depth["action"], "left out");
    EXPECT_EQ(depth["why"], "The run ends after z-buffer, and nobody asks for them.");
    EXPECT_EQ(normals("lambert", "vertices.normal")["action"], "runs");
}

TEST(LeaveOut, BenchComparesInOneRun) {
    const auto done = run({"bench", "--leave-out", "pyramid", "--repeat", "2", "--warm-up", "0", "--json"});
    ASSERT_EQ(done.status, 0) << done.err;
    const Json json = Json::parse(done.out);
    ASSERT_EQ(json.size(), 1u);
    // Three of five polygons face the eye; without leaving out, five vertices are evaluated beside all five.
    EXPECT_EQ(json[0]["counters"]["light evaluations"]["with"], 3);
    EXPECT_EQ(json[0]["counters"]["light evaluations"]["without"], 10);
    EXPECT_GT(json[0]["buffer_megabytes"]["without"], json[0]["buffer_megabytes"]["with"]);
    const auto table = run({"bench", "--leave-out", "--repeat", "1", "--warm-up", "0", "--size", "64x48"});
    EXPECT_NE(table.out.find("Teapot"), std::string::npos) << table.out;
    // Names of any length: the percentage of every row ends in the head's column.
    std::istringstream lines(table.out);
    std::string head, line;
    std::getline(lines, head);
    while (std::getline(lines, line)) {
        std::erase_if(line, [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; });  // "–"
        EXPECT_EQ(line.find('%'), head.find("deciding") + 7) << line;
    }
    EXPECT_EQ(run({"bench"}).status, 2);
}

}  // namespace
