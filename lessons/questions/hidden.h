#pragma once
#include <vector>

#include "lessons/lesson.h"

namespace lessons {

// What must neither be shown nor told (in tables, tooltips, status bar, palette, copied or read aloud) on a page now.
struct Hidden {
    std::vector<pipeline::BufferName> buffers;  // sorted, each once
    std::vector<Part> parts;                    // sorted, each once
    bool thenHalf = false;                      // there is a second half, and it is not out yet
    // How many things that is, for "4 things hidden until you answer".
    std::size_t count() const { return buffers.size() + parts.size(); }
    bool hides(const pipeline::BufferName& buffer) const;
    bool hides(Part part) const;
};

// Before the question is settled: what the page's `hides` names, the buffers that the answer is read from unless the
// first half shows them itself, and the inspector unless the page names it in `panels`. Nothing afterwards, or on a page
// without a question.
Hidden hiddenOn(const Page& page, bool settled);

}  // namespace lessons
