#pragma once
#include <string>

#include "pipeline/compare/verdict.h"

namespace pipeline::foreign {

// A report as one page that needs nothing else: verdict, stages, where it shows first, the worst pixel with its equation,
// hints folded, what follows, conventions, what it rests on, and the command. HTML 5; a script turns hints open for
// printing and moves the wipe.
std::string reportHtml(const Report& report, const std::string& command);

// A buffer as a picture in sRGB, both renderers' by the same range.
struct PicturePair {
    Buffer2D<Color8> mine, reference;
};
PicturePair picturesOf(const Report& report, const Finding& finding);
// The signed or absolute difference; grey where there is none.
Buffer2D<Color8> differencePicture(const Report& report, const Finding& finding);
// Classes in the colours of the legend over a pale reference.
Buffer2D<Color8> classPicture(const Finding& finding, const Buffer2D<Color8>& reference);
Color8 classColor(Class of);

}  // namespace pipeline::foreign
