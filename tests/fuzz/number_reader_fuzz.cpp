// Any bytes as a file of numbers: the first one chooses the format. What is read has as many numbers as its shape says,
// and no more than may be read.
#include <array>
#include <cstdint>
#include <string>

#include "pipeline/formats/numbers/number_file.h"
#include "tests/fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::array kEndings{"npy", "png", "ppm", "pfm", "exr", "csv", "tga", "bmp"};
    constexpr std::size_t kMost = 1u << 16;
    if (size == 0) return 0;
    const std::string name = std::string("mine.") + kEndings[data[0] % kEndings.size()];
    const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
    const auto read = pipeline::readNumbers(bytes, name, kMost);
    if (!read) {
        fuzz::checkErrors(read.errors());
        return 0;
    }
    std::size_t count = 1;
    for (const std::size_t side : read->shape) count *= side;
    fuzz::require(count == read->values.size() && count <= kMost);
    return 0;
}
