// Time of `compare` for the picture alone, at 640 × 480, against every known error: of a picture that one of them explains,
// and of one that none does, and of the stages alone.
//   renderer_bench                  the scene that compare --starter writes
//   renderer_bench my_scene.toml
#include <chrono>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "pipeline/compare/verdict.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/run/runner.h"
#include "tests/bench/rounds.h"
#include "tests/support/files.h"

namespace {

using namespace pipeline;

// The frame buffer as another renderer would hand it in; redHalved: an error that is not in the table.
void writePicture(const Scene& scene, bool redHalved, const std::filesystem::path& file) {
    FrameRequest request;
    request.wanted = setOf({BufferId::Color});
    const FramePtr frame = runFrame(std::make_shared<const Scene>(scene), request, nullptr);
    const auto color = frame->buffer({BufferId::Color});
    std::ofstream out(file, std::ios::binary);
    out << fmt::format("P6\n{} {}\n255\n", scene.settings.width, scene.settings.height);
    for (std::size_t y = 0; y < color->rows(); ++y)
        for (std::size_t x = 0; x < color->columns(); ++x)
            for (int c = 0; c < 3; ++c) out.put(char(int(color->value(x, y, c)) / (redHalved && c == 0 ? 2 : 1)));
}

double secondsOf(const Scene& scene, const std::filesystem::path& picture, const foreign::CompareOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    const auto report = foreign::compareRenderer(scene, {picture.string()}, options);
    if (!report) fmt::print(stderr, "{}\n", format(report.errors().front()));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int main(int argc, char** argv) {
    const std::filesystem::path file = argc > 1 ? argv[1] : resourceFolder() / "starter" / "check_me.toml";
    auto read = readScene(file);
    if (!read) {
        fmt::print(stderr, "{}\n", format(read.errors().front()));
        return 3;
    }
    Scene scene = std::move(read).value();
    scene.settings.width = 640, scene.settings.height = 480;
    Scene wrong = scene;
    wrong.settings.defect = Defect::NoMax;
    const test::TemporaryFolder folder;
    fmt::print("{}, {} processors; 640 × 480, the picture alone\n\n", bench::processorName(), bench::processorCount());
    fmt::print("{:<34} {:>8} {:>13}\n", "the picture is explained by", "s", "stages, s");
    for (const bool known : {true, false}) {
        const auto picture = folder / (known ? "known/color.ppm" : "unknown/color.ppm");
        std::filesystem::create_directories(picture.parent_path());
        writePicture(known ? wrong : scene, !known, picture);
        foreign::CompareOptions options;
        const double names = secondsOf(scene, picture, options);
        options.known = false;
        fmt::print("{:<34} {:>8.2f} {:>13.2f}\n", known ? "a known error" : "none", names,
                   secondsOf(scene, picture, options));
        std::fflush(stdout);
    }
}
