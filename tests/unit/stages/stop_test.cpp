// Texts and pictures that are read beside models and scenes, and shadow buffers before the first of them is drawn: how
// often each looks at a stop, and that it ends there.
#include "pipeline/core/stop.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "lessons/state/cue_list.h"
#include "pipeline/export/buffers/byte_file.h"
#include "pipeline/export/export_frame.h"
#include "pipeline/export/json/study_json.h"
#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/png_scene.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/run/stage_parts.h"
#include "pipeline/scene/settings_table.h"
#include "pipeline/scene/shape_stop.h"
#include "tests/support/files.h"
#include "tests/support/gltf_files.h"
#include "tests/support/looks.h"
#include "tests/support/scenes.h"
#include "tests/support/studies.h"

namespace pipeline {
namespace {

using test::Looks;

constexpr std::size_t kLong = 200'000;  // bytes, at least

const FileLoader kNoFile = [](std::string_view) -> Result<NamedFile> { return Error{{}, "no file", {}}; };

std::string manyCues() {
    std::string text;
    while (text.size() < kLong)
        text += fmt::format("[[cue]]\nname = \"{}\"\nscene = \"pyramid\"\nnote = \"{:400}\"\n", text.size(), "x");
    return text;
}

std::string longStudy() {
    StudyReport report = test::sphereStudy();
    report.axes.resize(1);
    report.axes[0].key = "exponent", report.axes[0].values.clear();
    report.points.clear();
    for (std::size_t i = 0; i < 1000; ++i) {
        report.axes[0].values.push_back(std::to_string(i + 1));
        report.points.push_back(test::studyPoint(i, {std::to_string(i + 1)}, 1, 0.01));
    }
    return studyFileText(report);
}

// Texts that stand before the pixels. libpng reads on where the checksum of one is wrong.
std::string pictureOfTexts() {
    const auto number = [](std::size_t n) { return std::string{char(n >> 24), char(n >> 16), char(n >> 8), char(n)}; };
    std::string png = "\x89PNG\r\n\x1a\n";
    png += number(13) + "IHDR" + number(1) + number(1) + std::string("\x08\0\0\0\0", 5) + "\x3a\x7e\x9b\x55";
    while (png.size() < kLong) {
        png += number(4000) + "tEXt";
        png.append(4000, 'a');
        png += number(0);
    }
    return png;
}

// One triangle, in a buffer that goes on behind it.
std::string longDataUri() {
    const std::string bytes = test::bytesOf<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + std::string(kLong, '\0');
    test::Parts parts = test::squareParts();
    parts["buffers"] = fmt::format(R"([{{"byteLength": {}, "uri": "{}"}}])", bytes.size(), test::dataUri(bytes));
    parts["bufferViews"] = R"([{"buffer": 0, "byteLength": 36}])";
    parts["accessors"] = R"([{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}])";
    parts["meshes"] = R"([{"primitives": [{"attributes": {"POSITION": 0}}]}])";
    return test::fileOf(parts);
}

template <class T>
std::string whatIsWrong(const Result<T>& read) {
    return read ? "" : format(read.errors());
}

// Reads it; gives what is wrong.
struct LongText {
    const char* name;
    std::string (*text)();
    std::string (*read)(const std::string& text);
    double passes;  // over the text, each of which looks
};
const std::vector<LongText> kTexts{
    {"cues", manyCues, [](const auto& text) { return whatIsWrong(lessons::readCues(text, "f", Looks::stop())); }, 3},
    {"study", longStudy, [](const auto& text) { return whatIsWrong(studyFromJson(text, "f", Looks::stop())); }, 1},
    {"png", pictureOfTexts,
     [](const auto& text) {
         const std::string found = whatIsWrong(readPngScene({text, "f", {{}, Looks::stop()}}, kNoFile));
         return found.find("carries no scene") == found.npos ? found : "";
     },
     1},
    {"gltf", longDataUri,
     [](const auto& text) {
         return whatIsWrong(readModel({text, "f", {{}, Looks::stop()}}, ".gltf", kNoFile));
     },
     3},
};

class StopInAText : public testing::TestWithParam<LongText> {};

// A look comes at least every 4096 bytes of every pass; after a stop a few more looks may find it again.
TEST_P(StopInAText, IsSeenAtTheNextLook) {
    const std::string text = GetParam().text();
    ASSERT_GE(text.size(), kLong);
    const Looks whole;
    EXPECT_EQ(GetParam().read(text), "");
    const std::size_t looks = Looks::count();
    EXPECT_GE(double(Looks::items()), 0.9 * GetParam().passes * double(text.size())) << "up to each pass' last look";
    EXPECT_LE(Looks::most(), 2 * StopCheck::kItemsPerLook);
    for (std::size_t part = 0; part <= 8; ++part) {
        const std::size_t at = 1 + part * (looks - 1) / 8;
        const Looks stopping(at);
        EXPECT_EQ(GetParam().read(text), "f: reading was stopped\n") << at << " of " << looks;
        EXPECT_LE(Looks::count(), at + 10);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, StopInAText, testing::ValuesIn(kTexts),
                         [](const auto& one) { return std::string(one.param.name); });

// A setting that remakes a shape knows of no stop; the command line has one.
TEST(StopInAShape, IsSeenWhereASettingRemakesIt) {
    Scene scene;
    scene.objects.emplace_back().shape = Shape{ShapeKind::Teapot, 1};
    scene.objects[0].mesh = makeShape(*scene.objects[0].shape);
    const auto remake = [&] {
        const ShapeStop stop(Looks::stop());
        return withSetting(scene, "object.0.tessellation=64");
    };
    const Looks whole;
    const auto remade = remake();
    ASSERT_TRUE(remade) << format(remade.errors());
    EXPECT_GT(remade->objects[0].mesh->polygonCount(), 100'000u);
    const std::size_t looks = Looks::count();
    EXPECT_GT(looks, 20u);
    EXPECT_LE(Looks::most(), 2 * StopCheck::kItemsPerLook);
    for (std::size_t part = 0; part <= 4; ++part) {
        const std::size_t at = 1 + part * (looks - 1) / 4;
        const Looks stopping(at);
        [[maybe_unused]] const auto none = remake();
        EXPECT_LE(Looks::count(), at + 10);
    }
}

// An area light may have thousands of faces: room for one is made when it is drawn.
TEST(StopInShadowBuffers, LeavesNoRoomForFacesThatAreNotDrawn) {
    ShadowBufferInputs inputs;
    inputs.size = 64;
    inputs.casters.push_back({LightKind::Point, {Vec3d(1, 2, 3), Vec3d(3, 2, 1)}});
    TransformOutput<double> in;
    in.topology = std::make_shared<const Topology>();
    in.world.makeOwn(100);
    std::ranges::fill(in.world.own(), Vec3d(1, 1, 1));
    ShadowPreparation<double> by;
    by.makesRoom = false;
    for (const bool isStopped : {true, false}) {
        std::stop_source stop;
        if (isStopped) stop.request_stop();
        Threads threads(1, stop.get_token());
        auto out = prepareShadowBuffer(inputs, in, by);
        drawShadows<double>(in, ShadowCull::None, {}, out.lights[0], threads);
        for (const LightView<double>& sample : out.lights[0])
            for (const auto& depth : sample.depth) EXPECT_EQ(depth->pixels.size(), isStopped ? 0u : 64u * 64u);
    }
}

std::size_t residentBytes() {
    std::size_t all = 0, resident = 0;
    std::istringstream(test::readText("/proc/self/statm")) >> all >> resident;
    return resident * std::size_t(sysconf(_SC_PAGESIZE));
}

// Clearing a picture of 6000² takes seconds. What is not cleared is only reserved: nobody has touched its memory.
TEST(StopInAPicture, TouchesNoPixelAfterwards) {
    constexpr glm::ivec2 kSize{2048, 2048};
    constexpr std::size_t kBytes = 2048 * 2048 * 8;  // of z_view alone, in double
    Scene scene = test::pyramid();
    scene.settings.precision = Precision::Double;
    const FramePtr small = test::frameOf(scene, {});
    const FrameData<double>& data = *dataOf<double>(*small);
    TransformOutput<double> transform = *data.transform;
    transform.view.size = kSize;
    const ShadingSources<double> all = data.shadingSources();
    const ShadingSources<double> in{transform, all.normals, all.shadow, all.zBuffer, all.cull};
    for (const bool isStopped : {true, false}) {
        std::stop_source stop;
        if (isStopped) stop.request_stop();
        Threads threads(1, stop.get_token());
        const auto touched = [&](const auto& make) {
            const std::size_t before = residentBytes();
            const auto made = make();
            return std::max(residentBytes(), before) - before;
        };
        const std::size_t depths = touched([&] { return clearedZBuffer<double>(kSize, {}, {}, threads); });
        const std::size_t terms = touched([&] { return clearedShading(data.keys.shading, in, {}, threads); });
        EXPECT_EQ(depths < kBytes / 4, isStopped) << depths;
        EXPECT_EQ(terms < kBytes / 4, isStopped) << terms;
    }
}

// Of a large buffer a file takes a second and more. Of an even picture hardly a byte of PNG comes out: pixels count, too.
TEST(ExportFrame, CancellingWithinAFileLeavesNothing) {
    Scene scene;
    scene.settings.width = 1024, scene.settings.height = 768;
    const FramePtr frame = test::frameOf(scene, setOf({BufferId::Depth}));
    // Bytes of npy; pixels of PNG; numbers and pixels of EXR; at least "0,0,1\n" a line of CSV.
    constexpr std::size_t kPixels = 1024 * 768;
    for (const auto& [format, items] :
         {std::pair("npy", 4 * kPixels), {"png", kPixels}, {"exr", 2 * kPixels}, {"csv", 6 * kPixels}}) {
        const test::TemporaryFolder folder;
        const ExportRequest request{folder / "out", {{BufferId::Depth}}, {format}, {}};
        std::size_t calls = 0;
        const std::string file = std::string("depth.") + format;
        const auto whole = exportFrame(*frame, request, [&](double, std::string_view of) {
            calls += of == file;
            return true;
        });
        ASSERT_TRUE(whole);
        EXPECT_GE(calls, items / WriterWatch::kItems) << format;
        std::filesystem::remove_all(folder / "out");
        const std::size_t last = calls / 2;
        calls = 0;
        const auto stopped = exportFrame(*frame, request, [&](double, std::string_view) { return ++calls < last; });
        ASSERT_TRUE(stopped);
        EXPECT_TRUE(stopped->cancelled) << format;
        EXPECT_EQ(calls, last) << format;
        EXPECT_EQ(folder.names(), std::vector<std::string>{});
    }
}

}  // namespace
}  // namespace pipeline
