#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/result.h"

namespace pipeline {

// Numbers as a file of another program holds them: an array of NumPy, a picture, a table. Nothing is known of what they
// mean.
enum class NumberKind : std::uint8_t { Real, Whole, Levels8, Levels16 };

struct NumberFile {
    std::string name;                // for messages
    std::vector<std::size_t> shape;  // row-major, as the file has it: {H, W}, {H, W, 3}, {N, 3}, {N}
    std::vector<double> values;
    // Real: binary floating point. Whole: counts. Levels: of a picture with so many bits, 0 to 255 or 65535; what they
    // stand for the file does not say.
    NumberKind kind = NumberKind::Real;
    int digits = 53;                    // of a Real's significand: 11, 24 or 53
    std::size_t nan = 0, infinite = 0;  // counted among the values

    std::size_t rows() const { return shape.empty() ? 1 : shape[0]; }
    std::size_t columns() const { return shape.size() < 2 ? 1 : shape[1]; }
    std::size_t channels() const { return shape.size() < 3 ? 1 : shape[2]; }
    std::string sizeText() const;  // "640 × 480 × 3"
};

// The endings that are read: npy, png, ppm, pgm, pbm, pnm, pfm, exr, csv, tga, bmp.
bool readsNumbers(std::string_view ending);
std::string numberFormats();  // "npy, png, …" for messages

// What is wrong with a file stands at a byte, FILE:OFFSET, or in a CSV file at LINE:COLUMN. `most` numbers are read at
// most: a header that announces more is refused before anything is allocated. The ending of the name tells the format.
Result<NumberFile> readNumbers(std::string_view bytes, const std::string& name, std::size_t most);

// Format by format, under the same rules.
Result<NumberFile> readNpy(std::string_view bytes, const std::string& name, std::size_t most);
Result<NumberFile> readPngNumbers(std::string_view bytes, const std::string& name, std::size_t most);
// PBM, PGM and PPM, plain and raw, and PFM, whose rows are turned top-down.
Result<NumberFile> readPnm(std::string_view bytes, const std::string& name, std::size_t most);
// Colours or greys of 8 bits, packed or not; the rows and columns of the file are put in order.
Result<NumberFile> readTga(std::string_view bytes, const std::string& name, std::size_t most);
Result<NumberFile> readBmp(std::string_view bytes, const std::string& name, std::size_t most);
// Of a layer, or of the file's own name: R G B, X Y Z, else the only one, or depth Z. The picture is its display window:
// outside the data window it has zeros.
Result<NumberFile> readExrNumbers(std::string_view bytes, const std::string& name, std::size_t most,
                                  const std::string& layer);
Result<NumberFile> readExrNumbers(std::string_view bytes, const std::string& name, std::size_t most);
// The names of a file's layers, "ViewLayer.Depth."; of its colours without a layer "", of its Z without one "Z". None where
// it is no such file.
std::vector<std::string> exrLayers(std::string_view bytes);
// One row a line; words in the first line are a heading. Leading columns named row, column, x, y, vertex, polygon, index
// or id give the place where the heading says so.
Result<NumberFile> readCsvNumbers(std::string_view bytes, const std::string& name, std::size_t most);

// For these readers.
Error wrongAt(const std::string& name, std::size_t offset, std::string found, std::string expected);
void countStrange(NumberFile& file);

}  // namespace pipeline
