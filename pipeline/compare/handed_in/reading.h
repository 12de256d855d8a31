#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/compare/handed_in/handed_in.h"
#include "pipeline/compare/handed_in/values.h"
#include "pipeline/scene/view.h"

namespace pipeline::foreign {

// How the numbers of a file are to be understood. A difference of these is a convention and no error.
enum class Coding : std::uint8_t {
    AsIs,
    // color
    Srgb,
    Gamma22,
    // depth
    MinusZ,
    Distance,
    Ndc,
    Window,
    Reversed,
    Inverse,
    Linear,
    LinearReversed,
    Grey,
    GreyReversed,
    // normals
    WorldRgb,
    View,
    ViewTowards,
    ViewRgb,
    ViewTowardsRgb,
    // dot products, terms
    Signed,
    OfIMax,
    CutAtZero,
    // S
    LitIsZero,
    // ids
    FromOne,
    Permuted,
    // verdicts
    Codes,
    Flags,
    DroppedIsOne,
    // vertices in the picture
    PixelFromCentre,
    // pictures: of all files at once
    Corner,
    // vertices in view space
    TowardsViewer,
    // depth, where the scene leaves near and far open
    WindowOfOwnPlanes,
    LinearOfOwnPlanes,
    // vertices in the picture again
    FromTheFoot,
    // color again: intensities above the one that is white are cut off
    WhiteIsOne,
    WhiteIsHundred,
};
constexpr double whiteOf(Coding coding) {  // 0: I_max
    return coding == Coding::WhiteIsOne ? 1 : coding == Coding::WhiteIsHundred ? 100 : 0;
}
// Of directions in view space: whether z points towards the viewer. Nothing of other numbers.
constexpr std::optional<bool> pointsTowards(Coding coding) {
    using enum Coding;
    if (coding == ViewTowards || coding == ViewTowardsRgb) return true;
    if (coding == View || coding == ViewRgb) return false;
    return {};
}
struct CodingInfo {
    Coding id;
    std::string_view key, value;  // in mine.toml: depth = "window"
    std::string_view words;       // "window depth 0 to 1"
};
const CodingInfo& codingInfo(Coding coding);
std::span<const CodingInfo> codingTable();  // in the order of the enumerators

struct Reading {
    bool bottomUp = false;  // the first row of the file is the picture's last
    bool mirrored = false;  // the first column is the last
    bool bgr = false;
    Coding coding = Coding::AsIs;
    bool operator==(const Reading&) const = default;
};
// "rows bottom-up, BGR, window depth 0 to 1"; empty for the program's own.
std::string readingText(const Reading& reading);

// What reading needs of the scene.
struct ReadingContext {
    View view;                    // of the samples
    glm::dvec2 sampleShift{0.0};  // by which its centre is not the picture's, pixels
    bool opensPlanes = false;     // the scene does not say where near and far are
    double iMax = 1;
    std::vector<double> unrounded{};    // color as the reference had it before it was rounded; may be empty
    std::vector<std::uint8_t> covered;  // per pixel, in the reference
    std::size_t width = 0, height = 0;
    double ofShadowBuffers = 0;                         // their tolerance, world units
    std::optional<std::array<double, 3>> background{};  // of theirs, in the codes of its file: read as nothing
};

// Whether a file's numbers are the steps of a picture, 0 to 255 or to 65535.
inline bool holdsLevels(const NumberFile& file) {
    return file.kind == NumberKind::Levels8 || file.kind == NumberKind::Levels16;
}

// All readings that such a file may have, the program's own first, then those that explain least.
std::vector<Reading> readingsOf(const HandedFile& file, const ReadingContext& context);

// What a picture shows where nothing is drawn, if that is not black: the commonest of its colours where the reference has
// nothing, in whatever order of rows and columns. 0 to 255; nothing where it is black or no one colour.
std::optional<std::array<double, 3>> backgroundOf(const HandedFile& file, const ReadingContext& context);

// The numbers of a picture's file as it holds them, at a pixel of the reference.
std::vector<double> numbersAt(const HandedFile& file, const Reading& reading, std::size_t x, std::size_t y);

// The numbers of a file in this program's units and space. `reference` of the same buffer.
Values read(const HandedFile& file, const Reading& reading, const ReadingContext& context, const Values& reference);

}  // namespace pipeline::foreign
