#include "pipeline/formats/numbers/number_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pipeline {

namespace {

struct NumberFormat {
    std::string_view ending;
    Result<NumberFile> (*read)(std::string_view bytes, const std::string& name, std::size_t most);
};
constexpr std::array kNumberFormats{
    NumberFormat{"npy", readNpy}, NumberFormat{"png", readPngNumbers}, NumberFormat{"ppm", readPnm},
    NumberFormat{"pgm", readPnm}, NumberFormat{"pbm", readPnm},        NumberFormat{"pnm", readPnm},
    NumberFormat{"pfm", readPnm}, NumberFormat{"exr", readExrNumbers}, NumberFormat{"csv", readCsvNumbers},
    NumberFormat{"tga", readTga}, NumberFormat{"bmp", readBmp},
};

const NumberFormat* numberFormat(std::string_view ending) {
    const auto found = std::ranges::find_if(kNumberFormats, [&](const NumberFormat& format) {
        return std::ranges::equal(format.ending, ending, [](char a, char b) { return a == (b | 0x20); });
    });
    return found == kNumberFormats.end() ? nullptr : &*found;
}

}  // namespace

std::string NumberFile::sizeText() const {
    // A picture's width stands first, as people say it; no more than four channels follow.
    std::vector<std::size_t> said = shape;
    const bool isPicture = said.size() == 2 ? said[1] > 4 : said.size() == 3 && said[2] <= 4;
    if (isPicture) std::swap(said[0], said[1]);
    const std::string text = fmt::format("{}", fmt::join(said, " × "));
    return said.size() < 2 ? text : fmt::format("{} (NumPy's shape {})", text, fmt::join(shape, ", "));
}

bool readsNumbers(std::string_view ending) { return numberFormat(ending) != nullptr; }

std::string numberFormats() {
    std::string all;
    for (const NumberFormat& format : kNumberFormats) all += (all.empty() ? "" : ", ") + std::string(format.ending);
    return all;
}

Error wrongAt(const std::string& name, std::size_t offset, std::string found, std::string expected) {
    return Error{{fmt::format("{}:{}", name, offset)}, std::move(found), std::move(expected)};
}

void countStrange(NumberFile& file) {
    file.nan = file.infinite = 0;
    for (const double value : file.values) {
        if (std::isnan(value))
            ++file.nan;
        else if (std::isinf(value))
            ++file.infinite;
    }
}

Result<NumberFile> readNumbers(std::string_view bytes, const std::string& name, std::size_t most) {
    const NumberFormat* const format = numberFormat(name.substr(name.rfind('.') + 1));
    if (!format) return Error{{name}, "the ending is none of a file of numbers", numberFormats()};
    auto read = format->read(bytes, name, most);
    if (!read) return read;
    NumberFile file = std::move(read).value();
    countStrange(file);
    return file;
}

}  // namespace pipeline
