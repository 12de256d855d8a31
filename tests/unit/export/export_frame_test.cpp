#include "pipeline/export/export_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "pipeline/export/buffers/byte_file.h"
#include "pipeline/export/json/json.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/plan/needs.h"
#include "tests/support/files.h"
#include "tests/support/gltf_files.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

namespace fs = std::filesystem;

Scene smallPyramid() {
    Scene scene = test::pyramid();
    scene.settings.width = 64, scene.settings.height = 48;
    scene.camera.pixelsPerUnit = 0.1;
    return scene;
}

FramePtr usefulFrame() { return test::frameOf(smallPyramid(), usefulBuffers(smallPyramid())); }

Json manifestIn(const fs::path& folder) { return Json::parse(test::readText(folder / "manifest.json")); }

std::vector<std::string> filesOf(const Json& manifest, const std::string& buffer) {
    std::vector<std::string> names;
    for (const Json& one : manifest["buffers"])
        if (one["name"] == buffer)
            for (const Json& file : one["files"]) names.push_back(file["file"].text());
    return names;
}

// Somebody who saves one buffer after the other into a folder has them all, and a manifest that says so.
TEST(ExportFrame, AddsToAnExportOfTheSameFrame) {
    const test::TemporaryFolder folder;
    const FramePtr frame = usefulFrame();
    const fs::path out = folder / "out";
    const auto exported = [&](BufferId id, std::vector<std::string> formats) {
        const auto summary = exportFrame(*frame, {out, {{id}}, std::move(formats), {}});
        ASSERT_TRUE(summary);
        EXPECT_EQ(summary->removed, std::vector<std::string>{});
    };
    exported(BufferId::Depth, {"npy", "scene"});
    exported(BufferId::Color, {"npy"});
    exported(BufferId::Depth, {"csv"});
    const Json manifest = manifestIn(out);
    EXPECT_EQ(manifest["buffers"].elements().size(), 2u);
    EXPECT_EQ(filesOf(manifest, "depth"), (std::vector<std::string>{"depth.csv", "depth.npy"}));
    EXPECT_EQ(filesOf(manifest, "color"), std::vector<std::string>{"color.npy"});
    EXPECT_EQ(manifest["files"].elements().size(), 1u);
    // One that somebody has taken away is not spoken of any more.
    fs::remove(out / "color.npy");
    exported(BufferId::Depth, {"npy"});
    EXPECT_EQ(filesOf(manifestIn(out), "color"), std::vector<std::string>{});
    EXPECT_EQ(filesOf(manifestIn(out), "depth"), (std::vector<std::string>{"depth.npy", "depth.csv"}));
}

// Somebody has painted in a picture, or copied files of another export over it: what is there is no longer the frame's,
// so that nothing is added to it.
TEST(ExportFrame, ReplacesAnExportWhoseFilesAreNotThoseOfItsManifestAndSaysSo) {
    const FramePtr frame = usefulFrame();
    const auto exported = [&](const fs::path& out, BufferId id) {
        auto summary = exportFrame(*frame, {out, {{id}}, {"npy"}, {}});
        EXPECT_TRUE(summary);
        return summary ? *summary : ExportSummary{};
    };
    const auto changed = [&](auto change) {
        const test::TemporaryFolder folder;
        exported(folder / "out", BufferId::Depth);
        EXPECT_EQ(exported(folder / "out", BufferId::Color).inDoubt, "");
        change(folder / "out");
        const ExportSummary summary = exported(folder / "out", BufferId::Overdraw);
        EXPECT_EQ(summary.removed, (std::vector<std::string>{"color.npy", "depth.npy"}));
        EXPECT_EQ(folder.names(), (std::vector<std::string>{"out", "out/manifest.json", "out/overdraw.npy"}));
        return summary.inDoubt;
    };
    EXPECT_EQ(changed([&](const fs::path& out) {
                  test::writeText(out / "color.npy", std::string(fs::file_size(out / "color.npy"), 'x'));
              }),
              "color.npy is not as manifest.json has it");
    EXPECT_EQ(changed([&](const fs::path& out) { test::writeText(out / "depth.npy", "painted in"); }),
              "depth.npy is not as manifest.json has it");
    // A pipe is never read, for that would wait for ever.
    EXPECT_EQ(changed([&](const fs::path& out) {
                  fs::remove(out / "color.npy");
                  fs::create_symlink("/dev/zero", out / "color.npy");
              }),
              "color.npy is not as manifest.json has it");
    // One of an earlier version.
    EXPECT_EQ(changed([&](const fs::path& out) {
                  std::string manifest = test::readText(out / "manifest.json");
                  manifest.replace(manifest.find("\"contents\""), 10, "\"content\"");
                  test::writeText(out / "manifest.json", manifest);
              }),
              "manifest.json does not list what its files hold");
}

// SHA-256 of "abc": FIPS 180-4, example 1 of the secure hash standard's example values.
TEST(ExportFrame, ListsEveryFileWithItsSizeAndHash) {
    const test::TemporaryFolder folder;
    ExportRequest request{folder / "out", {{BufferId::Color}}, {"npy", "png", "scene"}, {}};
    request.writeMore = [](const fs::path& where) -> Result<std::vector<fs::path>> {
        test::writeText(where / "world.png", "abc");
        return std::vector{where / "world.png"};
    };
    ASSERT_TRUE(exportFrame(*usefulFrame(), request));
    std::vector<std::string> listed{"out", "out/manifest.json"};
    const Json manifest = manifestIn(folder / "out");
    for (const Json& file : manifest["contents"]) {
        listed.push_back("out/" + file["file"].get<std::string>());
        EXPECT_EQ(file["bytes"], fs::file_size(folder / listed.back()));
        const bool isOfAbc = file["sha256"] == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        EXPECT_EQ(isOfAbc, file["file"] == "world.png");
    }
    std::ranges::sort(listed);
    EXPECT_EQ(listed, folder.names());
}

// Two at once, of different frames and files: the later one takes the place of the earlier one, whichever it is.
TEST(ExportFrame, OfTwoAtOnceOneIsLeftWhole) {
    const FramePtr frame = usefulFrame();
    Scene scene = frame->scene();
    scene.settings.width /= 2;
    const FramePtr other = test::frameOf(scene, setOf({BufferId::Color}));
    for (int round = 0; round < 50; ++round) {
        const test::TemporaryFolder folder;
        const auto exported = [&](const FramePtr& of, BufferId id, const char* format) {
            EXPECT_TRUE(exportFrame(*of, {folder / "out", {{id}}, {format}, {}}));
        };
        {
            const std::jthread one([&] { exported(frame, BufferId::Depth, "npy"); });
            const std::jthread two([&] { exported(other, BufferId::Color, "csv"); });
        }
        const bool isOne = manifestIn(folder / "out")["buffers"][0]["name"] == "depth";
        const std::vector<std::string> names{"out", isOne ? "out/depth.npy" : "out/color.csv", "out/manifest.json"};
        ASSERT_EQ(folder.names(), names) << round;
    }
}

// A manifest may name anything; removed is what an export can have written.
TEST(ExportFrame, RemovesNothingThatNoExportWrites) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "out");
    for (const char* name : {"out/notes.txt", "out/old.npy", "out/.png"}) test::writeText(folder / name, "text");
    test::writeText(folder / "out/manifest.json",
                    R"({"program": {"name": "Shadescope"}, "views": ["notes.txt", "old.npy", ".png"]})");
    const auto summary = exportFrame(*usefulFrame(), {folder / "out", {{BufferId::Color}}, {"npy"}, {}});
    ASSERT_TRUE(summary);
    EXPECT_EQ(summary->removed, std::vector<std::string>{"old.npy"});
    EXPECT_TRUE(fs::exists(folder / "out/notes.txt"));
    EXPECT_TRUE(fs::exists(folder / "out/.png"));
}

TEST(ExportFrame, ReplacesAnExportOfAnotherFrame) {
    const test::TemporaryFolder folder;
    const FramePtr frame = usefulFrame();
    Scene scene = frame->scene();
    scene.settings.width /= 2;
    const FramePtr other = test::frameOf(scene, setOf({BufferId::Color}));
    ExportRequest both{folder / "out", {{BufferId::Depth}, {BufferId::Color}}, {"npy", "scene"}, {}};
    both.writeMore = [](const fs::path& where) -> Result<std::vector<fs::path>> {
        test::writeText(where / "world.png", "");
        return std::vector{where / "world.png"};
    };
    ASSERT_TRUE(exportFrame(*frame, both));
    test::writeText(folder / "out/normal.npy", "of somebody else");
    const ExportRequest one{folder / "out", {{BufferId::Color}}, {"npy"}, {}};

    const auto cancelled = exportFrame(*other, one, [](double share, std::string_view) { return share < 1; });
    ASSERT_TRUE(cancelled);
    EXPECT_TRUE(fs::exists(folder / "out/depth.npy"));

    const auto summary = exportFrame(*other, one);
    ASSERT_TRUE(summary);
    EXPECT_EQ(summary->removed, (std::vector<std::string>{"depth.npy", "pyramid.toml", "world.png"}));
    EXPECT_EQ(folder.names(),
              (std::vector<std::string>{"out", "out/color.npy", "out/manifest.json", "out/normal.npy"}));
    const auto again = exportFrame(*other, one);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->removed, std::vector<std::string>{});
}

// Of a model that has changed since, what is there already is of another frame; so it may be of a .gltf, whose vertices
// stand in other files.
TEST(ExportFrame, KnowsAFrameByTheFilesOfItsModels) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder / "sub");
    const auto write = [&](const char* apex) {
        test::writeText(folder / "sub/x.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 ") + apex + "\nf 1 2 3\n");
    };
    test::writeText(folder / "s.toml", "[[object]]\nmodel = \"sub/x.obj\"\n");
    const auto exported = [&](BufferId id, const std::string& file) {
        const auto scene = readScene(folder / file);
        EXPECT_TRUE(scene) << (scene ? "" : format(scene.errors()));
        const FramePtr frame = test::frameOf(*scene, setOf({id}));
        EXPECT_TRUE(exportFrame(*frame, {folder / "out", {{id}}, {"npy"}, {}}));
        std::vector<std::string> names;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder / "out"))
            if (entry.path().extension() == ".npy") names.push_back(entry.path().filename().string());
        std::ranges::sort(names);
        return names;
    };
    using Names = std::vector<std::string>;
    write("0");
    exported(BufferId::Color, "s.toml");
    EXPECT_EQ(exported(BufferId::ZView, "s.toml"), (Names{"color.npy", "z_view.npy"}));
    write("1");
    EXPECT_EQ(exported(BufferId::Overdraw, "s.toml"), Names{"overdraw.npy"});

    test::writeText(folder / "m.gltf", test::fileOf(test::squareParts()));
    exported(BufferId::Color, "m.gltf");
    EXPECT_EQ(exported(BufferId::ZView, "m.gltf"), Names{"z_view.npy"});
}

// Whoever wrote it: what nests without end would be copied level by level.
TEST(ExportFrame, PutsUpWithAManifestThatNestsWithoutEnd) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder / "out");
    for (const char* key : {"scene", "buffers", "views"}) {
        test::writeText(folder / "out/manifest.json", R"({"program": {"name": "Shadescope"}, ")" + std::string(key) +
                                                          "\": " + std::string(300'000, '[') +
                                                          std::string(300'000, ']') + "}");
        EXPECT_TRUE(exportFrame(*usefulFrame(), {folder / "out", {{BufferId::Color}}, {"npy"}, {}})) << key;
        EXPECT_EQ(folder.names(), (std::vector<std::string>{"out", "out/color.npy", "out/manifest.json"}));
    }
}

// Anybody may have written it.
TEST(ExportFrame, RemovesNothingThatAManifestHasNoRightTo) {
    const FramePtr frame = usefulFrame();
    const auto exported = [&](const std::string& manifest) {
        const test::TemporaryFolder folder;
        fs::create_directories(folder / "out/inner");
        for (const char* file : {"mine", "out/mine", "out/inner/mine"}) test::writeText(folder / file, "mine");
        test::writeText(folder / "out/manifest.json", manifest);
        const auto summary = exportFrame(*frame, {folder / "out", {{BufferId::Color}}, {"npy"}, {}});
        EXPECT_TRUE(summary);
        EXPECT_EQ(folder.names(), (std::vector<std::string>{"mine", "out", "out/color.npy", "out/inner",
                                                            "out/inner/mine", "out/manifest.json", "out/mine"}))
            << manifest;
    };
    const std::string ours = R"({"program": {"name": "Shadescope"}, )";
    exported(ours + R"("views": ["../mine", "inner/mine", "inner", "..", ".", "", "missing", 1, null, ["mine"]]})");
    exported(ours + R"("files": [{"file": "../mine"}, "mine", {"file": 3}, {}], "buffers": [{"files": "mine"}, 7]})");
    exported(ours + R"("files": "mine", "buffers": {"files": ["mine"]}})");
    exported(R"({"program": {"name": "Another"}, "views": ["mine"]})");
    exported(R"(["program", "views", "mine"])");
    exported("{\"views\": [\"mine\"");
}

TEST(ExportFrame, WritesWhatItPlanned) {
    const test::TemporaryFolder folder;
    const FramePtr frame = usefulFrame();
    ExportRequest request{folder / "out", {}, {"npy", "png", "csv", "exr"}, {}};
    std::vector<std::string> expected{"manifest.json"};
    for (const PlannedFile& file : plannedFiles(*frame, request)) {
        EXPECT_NE(file.file.empty(), file.whyNot.empty()) << file.buffer.text() << ' ' << file.format;
        if (!file.file.empty()) expected.push_back(file.file);
    }
    const auto summary = exportFrame(*frame, request);
    ASSERT_TRUE(summary);
    std::vector<std::string> found;
    std::uint64_t bytes = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "out")) {
        found.push_back(entry.path().filename().string());
        bytes += entry.file_size();
    }
    std::ranges::sort(expected);
    std::ranges::sort(found);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(summary->files.size(), expected.size());
    EXPECT_EQ(summary->bytes, bytes);
    for (const PlannedFile& file : plannedFiles(*frame, request))
        EXPECT_TRUE(!file.exact || fs::file_size(folder / ("out/" + file.file)) == file.bytes) << file.file;
}

TEST(ExportFrame, ManifestDescribesEveryBuffer) {
    const test::TemporaryFolder folder;
    const FramePtr frame = usefulFrame();
    ASSERT_TRUE(exportFrame(*frame, {folder / "out", {}, {"npy", "png"}, {}}));
    const Json manifest = Json::parse(test::readText(folder / "out/manifest.json"));
    EXPECT_EQ(manifest["scene"]["name"], "pyramid");
    EXPECT_EQ(manifest["settings"]["width"], 64);
    EXPECT_EQ(manifest["settings"]["shading"], "flat");
    EXPECT_EQ(manifest["settings"]["light.0.shadow"], true);
    EXPECT_EQ(manifest["plan"].elements().size(), kStageCount);
    EXPECT_EQ(manifest["plan"][3]["action"], "left out");
    EXPECT_EQ(manifest["plan"][3]["why"], "The only object is convex: it cannot shadow itself.");
    EXPECT_EQ(manifest["stages"].elements().size(), kStageCount);
    EXPECT_EQ(manifest["verdicts"][1]["verdict"], "back-facing");

    const test::Npy verdicts = test::readNpy(folder / "out/polygons.verdict.npy");
    for (const Json& buffer : manifest["buffers"]) {
        const auto name = findBuffer(buffer["name"].get<std::string>());
        ASSERT_TRUE(name);
        const test::Npy npy = test::readNpy(folder / ("out/" + name->text() + ".npy"));
        EXPECT_EQ(buffer["shape"], Json(npy.shape)) << name->text();
        double min = INFINITY, max = -INFINITY;
        std::size_t nonFinite = 0;
        for (std::size_t i = 0; i < npy.values.size(); ++i) {
            const double value = npy.values[i];
            if (name->id == BufferId::PolygonsIntensity && verdicts.values[i / 3] != 0) continue;  // culled: not lit
            nonFinite += !std::isfinite(value);
            if (std::isfinite(value)) min = std::min(min, value), max = std::max(max, value);
        }
        EXPECT_EQ(buffer["minimum"], min) << name->text();
        EXPECT_EQ(buffer["maximum"], max) << name->text();
        EXPECT_EQ(buffer["non_finite"], nonFinite) << name->text();
        EXPECT_EQ(buffer["unit"], bufferInfo(name->id).unit);
        EXPECT_EQ(buffer["files"][0]["file"], name->text() + ".npy");
    }
    for (const Json& absent : manifest["absent"]) EXPECT_FALSE(absent["why"].get<std::string>().empty());
    const auto isAbsent = [&](const char* name) {
        return std::ranges::any_of(manifest["absent"], [&](const Json& entry) { return entry["name"] == name; });
    };
    EXPECT_TRUE(isAbsent("shadow_buffer.0"));
    EXPECT_TRUE(isAbsent("n_dot_h.0"));
    EXPECT_FALSE(isAbsent("n_dot_l.0"));
}

TEST(ExportFrame, CancellingAtAnyFileLeavesNothing) {
    const FramePtr frame = usefulFrame();
    const ExportRequest wanted{{}, {{BufferId::Depth}, {BufferId::Color}}, {"npy"}, {}};
    // depth.npy, color.npy, manifest.json, and before they are moved.
    for (int last = 0; last < 4; ++last) {
        const test::TemporaryFolder folder;
        ExportRequest request = wanted;
        request.folder = folder / "deep/out";
        int calls = 0;
        double before = -1;
        const auto summary = exportFrame(*frame, request, [&](double share, std::string_view) {
            EXPECT_GE(share, before);
            EXPECT_LE(share, 1);
            before = share;
            return calls++ < last;
        });
        ASSERT_TRUE(summary);
        EXPECT_TRUE(summary->cancelled);
        EXPECT_EQ(calls, last + 1);
        EXPECT_EQ(folder.names(), std::vector<std::string>{});
    }
}

TEST(ExportFrame, ADiskThatIsFullLeavesTheOldFiles) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "out");
    test::writeText(folder / "out/depth.npy", "old");
    const FramePtr frame = usefulFrame();
    const auto summary = [&] {
        const test::FullDisk full(4096);  // 64 · 48 · 4 bytes are more
        return exportFrame(*frame, {folder / "out", {{BufferId::Depth}}, {"npy"}, {}});
    }();
    ASSERT_FALSE(summary);
    EXPECT_EQ(format(summary.errors()[0]), (folder / "out/depth.npy").string() + ": could not write: File too large");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"out", "out/depth.npy"}));
    EXPECT_EQ(test::readText(folder / "out/depth.npy"), "old");
}

TEST(ExportFrame, MoreFilesStandInTheManifestOrNothingDoes) {
    const test::TemporaryFolder folder;
    const FramePtr frame = usefulFrame();
    ExportRequest request{folder / "out", {{BufferId::Color}}, {"npy"}, {}};
    request.writeMore = [](const fs::path& where) -> Result<std::vector<fs::path>> {
        test::writeText(where / "world.png", "picture");
        return std::vector{where / "world.png"};
    };
    ASSERT_TRUE(exportFrame(*frame, request));
    EXPECT_EQ(Json::parse(test::readText(folder / "out/manifest.json"))["views"], Json::array({"world.png"}));
    request.folder = folder / "second";
    request.writeMore = [](const fs::path&) -> Result<std::vector<fs::path>> { return Error{{}, "no OpenGL", {}}; };
    const auto failed = exportFrame(*frame, request);
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.errors()[0].found, "no OpenGL");
    EXPECT_FALSE(fs::exists(folder / "second"));
}

}  // namespace
}  // namespace pipeline
