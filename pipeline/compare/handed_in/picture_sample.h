#pragma once
#include "pipeline/compare/handed_in/reading.h"

namespace pipeline::foreign {

// Pixels spread over a picture, as far from the one side as from the other: turned round it is a sample of the picture
// turned round.
struct PictureSample {
    PictureSample() = default;
    PictureSample(std::size_t width, std::size_t height, std::size_t mostColumns, std::size_t mostRows);

    std::vector<std::size_t> columns, rows;

    NumberFile of(const NumberFile& picture) const;
    Values of(const Values& picture) const;
    std::vector<std::uint8_t> of(const std::vector<std::uint8_t>& pixels, std::size_t width) const;
    ReadingContext of(const ReadingContext& context) const;  // without unrounded colours where there are none
};

// The view of a picture of another size.
View scaled(View view, double x, double y);

}  // namespace pipeline::foreign
