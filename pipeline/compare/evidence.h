#pragma once
#include "pipeline/compare/reference.h"

namespace pipeline::foreign {

// What files say before anything is read from them: a buffer that holds nothing, or one number everywhere, accuses nobody.
struct Evidence {
    bool isEmpty = false;            // the picture tells nothing
    bool isOneColored = false;       // of such a picture: something is drawn, in one colour that is not the reference's
    std::vector<std::string> words;  // "depth.npy holds one depth everywhere: it is left out"
};
// Takes what tells nothing out of the files, unless it is the only one. A picture of a square scene that fits transposed
// alone is refused, as one of another shape is.
Evidence weigh(HandedIn& in, const Reference& right);

}  // namespace pipeline::foreign
