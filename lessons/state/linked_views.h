#pragma once
#include <optional>

#include "lessons/state/view_tree.h"

namespace lessons {

// Whether buffer views zoom and move together. chosen: by the user; nothing: as the arrangement has it.
bool areLinked(const ViewTree& tree, std::optional<bool> chosen);

// What a buffer view shows a picture of.
struct LinkedPicture {
    int columns = 0, rows = 0;  // 0: there is no picture
    bool texels = false;        // of a shadow buffer, not of the frame
};
// Whether the same place of the one is the same place of the other, so that they can move together.
bool moveTogether(const LinkedPicture& a, const LinkedPicture& b);

}  // namespace lessons
