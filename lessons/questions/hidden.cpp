#include "lessons/questions/hidden.h"

#include <algorithm>

namespace lessons {

namespace {

bool before(const pipeline::BufferName& a, const pipeline::BufferName& b) {
    return std::pair(a.id, a.light) < std::pair(b.id, b.light);
}

// The buffers that a formula reads in the frame of its page.
void gather(const Node& node, std::vector<pipeline::BufferName>& into) {
    if (node.buffer) into.push_back(*node.buffer);
    if (!node.changes.empty()) return;  // of another frame
    for (const Node& operand : node.operands) gather(operand, into);
}

}  // namespace

bool Hidden::hides(const pipeline::BufferName& buffer) const {
    return std::ranges::find(buffers, buffer) != buffers.end();
}
bool Hidden::hides(Part part) const { return std::ranges::find(parts, part) != parts.end(); }

Hidden hiddenOn(const Page& page, bool settled) {
    Hidden hidden;
    if (settled || !page.question) return hidden;
    hidden.thenHalf = page.then.has_value();
    for (const Expression* answer : answersOf(*page.question)) gather(answer->root, hidden.buffers);
    const std::vector<pipeline::BufferName> shown = shownBuffers(page.first.state);
    std::erase_if(hidden.buffers,
                  [&](const pipeline::BufferName& name) { return std::ranges::find(shown, name) != shown.end(); });
    hidden.buffers.insert(hidden.buffers.end(), page.hiddenBuffers.begin(), page.hiddenBuffers.end());
    std::ranges::sort(hidden.buffers, before);
    hidden.buffers.erase(std::unique(hidden.buffers.begin(), hidden.buffers.end()), hidden.buffers.end());
    hidden.parts = page.hiddenParts;
    if (std::ranges::find(page.panels, Part::Inspector) == page.panels.end()) hidden.parts.push_back(Part::Inspector);
    std::ranges::sort(hidden.parts);
    hidden.parts.erase(std::unique(hidden.parts.begin(), hidden.parts.end()), hidden.parts.end());
    return hidden;
}

}  // namespace lessons
