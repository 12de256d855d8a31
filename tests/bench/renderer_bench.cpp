// Time of `compare` for the picture alone, at 640 × 480, against every known error: of a picture that one of them explains,
// and of one that none does, and of the stages alone. CPU times of one process; of the names, what one known error takes.
//   renderer_bench                  the scene that compare --starter writes
//   renderer_bench my_scene.toml
#include <algorithm>
#include <chrono>
#include <ctime>
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

struct Cost {
    double seconds = 0, cpu = 0;
    std::size_t tried = 0;  // known errors
};
Cost costOf(const Scene& scene, const std::filesystem::path& picture, const foreign::CompareOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t before = std::clock();
    const auto report = foreign::compareRenderer(scene, {picture.string()}, options);
    if (!report) fmt::print(stderr, "{}\n", format(report.errors().front()));
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
            double(std::clock() - before) / CLOCKS_PER_SEC, report && report->suspects ? report->suspects->tried : 0};
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
    fmt::print("{:<28} {:>6} {:>8} {:>15} {:>8} {:>18}\n", "the picture is explained by", "s", "CPU, s",
               "stages, CPU s", "share", "a known error, ms");
    for (const bool known : {true, false}) {
        const auto picture = folder / (known ? "known/color.ppm" : "unknown/color.ppm");
        std::filesystem::create_directories(picture.parent_path());
        writePicture(known ? wrong : scene, !known, picture);
        foreign::CompareOptions options;
        const Cost names = costOf(scene, picture, options);
        options.known = false;
        const Cost stages = costOf(scene, picture, options);
        fmt::print("{:<28} {:>6.2f} {:>8.2f} {:>15.2f} {:>6.0f} % {:>18.0f}\n", known ? "a known error" : "none",
                   names.seconds, names.cpu, stages.cpu, 100 * stages.cpu / names.cpu,
                   1000 * (names.cpu - stages.cpu) / double(std::max<std::size_t>(1, names.tried)));
        std::fflush(stdout);
    }
}
