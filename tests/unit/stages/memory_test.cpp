// What the system's memory is asked for.
#include <gtest/gtest.h>

#include <fstream>
#include <numeric>

#include <fmt/format.h>

#include "pipeline/core/memory.h"
#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/scene_folder.h"
#include "tests/support/files.h"

namespace pipeline {
namespace {

// Of 9 MB and more whole pages in a piece become large ones, wherever it begins.
TEST(Memory, UnderLargePagesWhatStandsThereStays) {
    for (const std::size_t count : {0, 1, 1000, 1'000'000, 6'000'000}) {
        std::vector<std::uint32_t> numbers(count);
        std::iota(numbers.begin(), numbers.end(), 7U);
        for (const std::size_t from : {0, 1, 500})
            if (from < count) preferLargePages(&numbers[from], (count - from) * sizeof numbers[0]);
        preferLargePages(numbers.data(), count * sizeof numbers[0]);
        for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(numbers[i], i + 7);
        numbers.resize(2 * count, 5U);
        EXPECT_EQ(std::accumulate(numbers.begin() + std::ptrdiff_t(count), numbers.end(), std::size_t(0)), 5 * count);
    }
}

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

// Of this process, bytes: "VmRSS", what it holds; "VmHWM", the most that it has held.
double heldBytes(const std::string& name) {
    std::ifstream file("/proc/self/status");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with(name + ":")) return 1024 * std::stod(line.substr(name.size() + 1));
    return 0;
}

template <class T>
double bytesOf(const std::vector<T>& list) {
    return double(list.capacity() * sizeof(T));
}

// A square of side × side pairs of triangles, every vertex with a normal.
std::string squareText(int side) {
    std::string text;
    for (int y = 0; y <= side; ++y)
        for (int x = 0; x <= side; ++x) text += fmt::format("v {} {} {}\nvn 0 0 1\n", x, y, (x * y) % 7);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const int a = y * (side + 1) + x + 1, b = a + side + 1;
            text += fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", a, a + 1, b + 1);
            text += fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", a, b + 1, b);
        }
    return text;
}

// A model takes no more memory while it is read than twice its mesh, and 4 MB for the pieces of its text.
void readAndExit(const std::filesystem::path& path) {
    keepFreedMemory();  // as the program does
    giveBackFreedMemory();
    std::ofstream("/proc/self/clear_refs") << "5";  // the most so far is what is held now
    const double before = heldBytes("VmHWM");
    const Result<NamedFile> file = openFile(path);
    const Result<LoadedModel> model = readModel({file->text, file->path, {}, file->tail}, ".obj",
                                                [](std::string_view) -> Result<NamedFile> { return Error{}; });
    const Mesh& mesh = *model->objects[0].mesh;
    const double size = double(mesh.positions.bytes() + mesh.normals.bytes()) + bytesOf(mesh.polygonPlaces) +
                        bytesOf(mesh.triangles) + bytesOf(mesh.corners) + bytesOf(mesh.firstCorner);
    const double taken = heldBytes("VmHWM") - before;
    fmt::print(stderr, "{:.1f} MB for a mesh of {:.1f} MB, beside {:.1f} MB\n", taken / 1e6, size / 1e6, before / 1e6);
    std::exit(size > 10e6 && taken < 2 * size + 4e6 ? 0 : 1);
}

TEST(MemoryDeathTest, ReadingAModelTakesAtMostTwiceItsMesh) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");  // in a process that has done nothing else
    const test::TemporaryFolder folder;
    test::writeText(folder / "square.obj", squareText(400));
    EXPECT_EXIT(readAndExit(folder / "square.obj"), testing::ExitedWithCode(0), "MB for a mesh");
}

#endif

}  // namespace
}  // namespace pipeline
