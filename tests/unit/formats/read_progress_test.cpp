// How far a file has been read, for who waits, and reading that is given up.
#include "pipeline/formats/text/read_progress.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/formats/scene_reader.h"
#include "tests/support/files.h"
#include "tests/support/gltf_files.h"
#include "tests/support/model_files.h"

namespace pipeline {
namespace {

constexpr int kReadTriangles = 3000;

std::string objText() { return test::objText(kReadTriangles); }
std::string plyAscii() { return test::plyText(kReadTriangles); }
std::string plyBinary() { return test::plyBytes(kReadTriangles); }
std::string stlAscii() { return test::stlText(kReadTriangles); }
std::string stlBinary() { return test::stlBytes(kReadTriangles); }

std::string readDescription() {
    std::string text = fmt::format("{} {}\n", 3 * kReadTriangles, kReadTriangles);
    for (int i = 0; i < 3 * kReadTriangles; ++i) text += test::cornerText(i / 3, i % 3) + "\n";
    for (int i = 0; i < kReadTriangles; ++i) text += fmt::format("3 {} {} {}\n", 3 * i, 3 * i + 1, 3 * i + 2);
    return text + "1 1 1 0.5 10\n";
}

struct ReadFile {
    const char* name;
    std::string (*text)();
    const char* told;  // the file that is told of
};

class ReadProgressOf : public testing::TestWithParam<ReadFile> {
protected:
    ReadProgressOf() {
        test::writeText(folder / GetParam().name, GetParam().text());
        test::writeText(folder / "model.obj", objText());
    }
    Result<Scene> read(const ReadProgress& progress) { return readScene(folder / GetParam().name, progress); }
    test::TemporaryFolder folder;
};

TEST_P(ReadProgressOf, GrowsToTheEnd) {
    std::vector<double> shares;
    const auto scene = read({[&](double share, std::string_view file) {
        EXPECT_TRUE(file.ends_with(GetParam().told)) << file;
        shares.push_back(share);
    }});
    ASSERT_TRUE(scene) << format(scene.errors());
    ASSERT_GT(shares.size(), 50u);
    EXPECT_LT(shares.size(), 500u) << "as often as somebody can see";
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_LT(shares.front(), 0.05);
    EXPECT_GT(shares.back(), 0.95);
    EXPECT_LE(shares.back(), 1);
}

TEST_P(ReadProgressOf, StoppedThereIsNoScene) {
    for (const double until : {0.0, 0.5}) {
        std::stop_source source;
        int after = 0;
        const auto scene = read({[&](double share, std::string_view) {
                                     if (share < until) return;
                                     ++after;
                                     source.request_stop();
                                 },
                                 source.get_token()});
        EXPECT_FALSE(scene);
        EXPECT_LE(after, 3) << "and it is read no further";
    }
}

std::string sceneOfModel() { return "[[object]]\nmodel = \"model.obj\"\n"; }

INSTANTIATE_TEST_SUITE_P(Formats, ReadProgressOf,
                         testing::Values(ReadFile{"a.obj", objText, "a.obj"}, ReadFile{"a.ply", plyAscii, "a.ply"},
                                         ReadFile{"b.ply", plyBinary, "b.ply"}, ReadFile{"a.stl", stlAscii, "a.stl"},
                                         ReadFile{"b.stl", stlBinary, "b.stl"},
                                         ReadFile{"a.des", readDescription, "a.des"},
                                         ReadFile{"a.toml", sceneOfModel, "model.obj"}),
                         [](const auto& which) {
                             std::string name = which.param.name;
                             std::ranges::replace(name, '.', '_');
                             return name;
                         });

TEST(ReadProgress, OfAGltfModelIsToldForEachInstance) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "square.gltf", test::fileOf(test::squareParts()));
    int told = 0;
    const auto scene = readScene(folder / "square.gltf", {[&](double, std::string_view) { ++told; }});
    EXPECT_TRUE(scene);
    EXPECT_GT(told, 0);
    std::stop_source source;
    source.request_stop();
    EXPECT_FALSE(readScene(folder / "square.gltf", {{}, source.get_token()}));
}

}  // namespace
}  // namespace pipeline
