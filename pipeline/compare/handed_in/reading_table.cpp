#include <algorithm>
#include <cmath>

#include "pipeline/compare/handed_in/reading.h"

namespace pipeline::foreign {

namespace {

using C = Coding;

constexpr std::array kCodings{
    CodingInfo{C::AsIs, "", "", ""},
    CodingInfo{C::Srgb, "encoding", "srgb",
               "encoded as sRGB; if that is not meant, it is the error gamma: nearly the same bytes"},
    CodingInfo{C::Gamma22, "encoding", "gamma-2.2",
               "encoded with a gamma of 2.2; if that is not meant, it is the error gamma"},
    CodingInfo{C::MinusZ, "depth", "minus-z", "−z_view"},
    CodingInfo{C::Distance, "depth", "distance", "distance to the eye"},
    CodingInfo{C::Ndc, "depth", "ndc", "NDC depth −1 to 1"},
    CodingInfo{C::Window, "depth", "window", "window depth 0 to 1"},
    CodingInfo{C::Reversed, "depth", "reversed", "reversed depth 1 to 0"},
    CodingInfo{C::Inverse, "depth", "inverse", "1 / z_view"},
    CodingInfo{C::Linear, "depth", "linear", "linear from near 0 to far 1"},
    CodingInfo{C::LinearReversed, "depth", "linear-reversed", "linear from near 1 to far 0"},
    CodingInfo{C::Grey, "depth", "grey", "grey, near is black"},
    CodingInfo{C::GreyReversed, "depth", "grey-reversed", "grey, near is white"},
    CodingInfo{C::WorldRgb, "normals", "world-rgb", "world normals as colours"},
    CodingInfo{C::View, "normals", "view", "view normals, z away"},
    CodingInfo{C::ViewTowards, "normals", "view-towards", "view normals, z towards the viewer"},
    CodingInfo{C::ViewRgb, "normals", "view-rgb", "view normals as colours, z away"},
    CodingInfo{C::ViewTowardsRgb, "normals", "view-towards-rgb", "view normals as colours, z towards the viewer"},
    CodingInfo{C::Signed, "values", "signed", "0 to 1 stands for −1 to 1"},
    CodingInfo{C::OfIMax, "values", "of-i-max", "shares of I_max"},
    CodingInfo{C::CutAtZero, "dot_products", "cut-at-0", "max(0, …): nothing below 0"},
    CodingInfo{C::LitIsZero, "shadow", "lit-is-0", "0 is lit"},
    CodingInfo{C::FromOne, "ids", "from-1", "ids from 1"},
    CodingInfo{C::Permuted, "ids", "permuted", "ids in another order"},
    CodingInfo{C::Codes, "verdicts", "codes", "codes, 0 is kept"},
    CodingInfo{C::Flags, "verdicts", "kept-is-1", "1 is kept, 0 is dropped"},
    CodingInfo{C::DroppedIsOne, "verdicts", "dropped-is-1", "1 is dropped, 0 is kept"},
    CodingInfo{C::PixelFromCentre, "screen", "whole", "whole numbers are pixel centres"},
    CodingInfo{C::Corner, "sample", "corner", "pixels are sampled at their corner"},
    CodingInfo{C::TowardsViewer, "view_z", "towards-viewer", "z towards the viewer"},
    CodingInfo{C::WindowOfOwnPlanes, "depth", "window-own-planes",
               "window or NDC depth of other near and far planes than chosen here"},
    CodingInfo{C::LinearOfOwnPlanes, "depth", "linear-own-planes", "linear in z_view, of another unit and beginning"},
    CodingInfo{C::FromTheFoot, "screen", "y-up",
               "y from the bottom up, as the rows; if that is not meant, it is the error y-down"},
    CodingInfo{C::WhiteIsOne, "encoding", "white-is-1", "white is the intensity 1, what is brighter is cut off"},
    CodingInfo{C::WhiteIsHundred, "encoding", "white-is-100",
               "white is the intensity 100, what is brighter is cut off"},
};
static_assert([] {
    for (std::size_t i = 0; i < kCodings.size(); ++i)
        if (std::size_t(kCodings[i].id) != i) return false;
    return true;
}());

std::vector<Coding> codingsOfDepth(bool levels, bool opensPlanes) {
    if (levels) return {C::Window, C::Reversed, C::Linear, C::LinearReversed, C::Inverse, C::Grey, C::GreyReversed};
    std::vector<Coding> codings{C::AsIs,     C::MinusZ,  C::Distance, C::Ndc,           C::Window,
                                C::Reversed, C::Inverse, C::Linear,   C::LinearReversed};
    if (opensPlanes) codings.insert(codings.end(), {C::WindowOfOwnPlanes, C::LinearOfOwnPlanes});
    return codings;
}

std::vector<Coding> codingsOf(const HandedFile& file, bool opensPlanes) {
    const bool levels = holdsLevels(file.numbers);
    using enum BufferId;
    switch (file.name.buffer.id) {
        case Color: return {C::AsIs, C::Srgb, C::Gamma22, C::WhiteIsOne, C::WhiteIsHundred};
        case ZView: return codingsOfDepth(levels, opensPlanes);
        case VerticesView: return {C::AsIs, C::TowardsViewer};
        case Normal:
            if (levels) return {C::WorldRgb, C::ViewRgb, C::ViewTowardsRgb};
            return {C::AsIs, C::View, C::ViewTowards, C::WorldRgb, C::ViewRgb, C::ViewTowardsRgb};
        case VerticesNormal:
        case PolygonsNormal: return {C::AsIs, C::View, C::ViewTowards};
        case ObjectId:
        case PolygonId:
            if (file.numbers.shape.size() == 3 && file.numbers.channels() >= 3) return {C::Permuted};
            return {C::AsIs, C::FromOne, C::Permuted};
        case PolygonsVerdict:
            return file.name.form == Form::Visible ? std::vector{C::Flags, C::DroppedIsOne}
                                                   : std::vector{C::Codes, C::Flags};
        case VerticesScreen:
            return file.name.form == Form::AsTable ? std::vector{C::AsIs, C::PixelFromCentre} : std::vector{C::AsIs};
        case NDotL:
        case RDotV:
        case NDotH: return levels ? std::vector{C::AsIs, C::CutAtZero, C::Signed} : std::vector{C::AsIs, C::CutAtZero};
        case Shadow: return {C::AsIs, C::LitIsZero};
        case Ambient:
        case Diffuse:
        case Specular:
        case Emission:
        case Intensity: return levels ? std::vector{C::OfIMax} : std::vector{C::AsIs, C::OfIMax};
        default: return {C::AsIs};
    }
}

}  // namespace

const CodingInfo& codingInfo(Coding coding) { return kCodings[std::size_t(coding)]; }
std::span<const CodingInfo> codingTable() { return kCodings; }

std::string readingText(const Reading& reading) {
    std::string text;
    const auto add = [&](std::string_view words) {
        if (!words.empty()) text += (text.empty() ? "" : ", ") + std::string(words);
    };
    if (reading.bottomUp) add("rows bottom-up");
    if (reading.mirrored) add("columns right to left");
    if (reading.bgr) add("BGR");
    add(codingInfo(reading.coding).words);
    return text;
}

std::vector<Reading> readingsOf(const HandedFile& file, const ReadingContext& context) {
    std::vector<Reading> readings;
    const Domain domain = bufferInfo(file.name.buffer.id).domain;
    for (const Coding coding : codingsOf(file, context.opensPlanes)) {
        if (const double white = whiteOf(coding); white > 0 && std::abs(white - context.iMax) < 1e-6 * white) continue;
        if (domain != Domain::Pixel) {
            readings.push_back({false, false, false, coding});
            continue;
        }
        for (const bool bgr : {false, true})
            if (!bgr || file.name.buffer.id == BufferId::Color)
                for (const bool mirrored : {false, true})
                    for (const bool bottomUp : {false, true}) readings.push_back({bottomUp, mirrored, bgr, coding});
    }
    return readings;
}

}  // namespace pipeline::foreign
