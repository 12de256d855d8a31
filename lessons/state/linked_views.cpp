#include "lessons/state/linked_views.h"

namespace lessons {

bool areLinked(const ViewTree& tree, std::optional<bool> chosen) { return chosen.value_or(linksViews(tree)); }

bool moveTogether(const LinkedPicture& a, const LinkedPicture& b) {
    const bool isThere = a.columns > 0 && a.rows > 0;
    return isThere && a.columns == b.columns && a.rows == b.rows && !a.texels && !b.texels;
}

}  // namespace lessons
