#pragma once
#include <algorithm>
#include <map>

#include "lessons/expression/expression.h"
#include "pipeline/buffers/any_buffer.h"

namespace lessons {

// The numbers of an expression at every element of a frame's buffers: at pixels in reading order, at vertices,
// polygons or texels. Truth is 1 and 0.
class ElementValues {
public:
    // What does not vary from element to element is evaluated here, once. Errors name the buffer that the frame lacks.
    static pipeline::Result<ElementValues> of(const Node& root, const Context& context);

    std::size_t count() const { return m_count; }  // of elements; 0 where the expression reads no buffer
    // root.size numbers of each element in [first, first + count).
    std::vector<double> numbers(std::size_t first, std::size_t count) const;

private:
    explicit ElementValues(const Node& root) : m_root(&root) {}
    std::optional<pipeline::Error> prepare(const Node& node, const Context& context);
    std::vector<double> at(const Node& node, std::size_t first, std::size_t count) const;
    std::vector<double> read(const Node& node, std::size_t first, std::size_t count) const;

    const Node* m_root;
    std::size_t m_count = 0, m_columns = 1;
    std::map<const Node*, pipeline::AnyBuffer> m_buffers;
    std::map<const Node*, std::vector<double>> m_constants;
};

// visit(first, numbers) for runs of elements, whose numbers stay in the cache. False where it was stopped.
template <class Visit>
bool goThrough(const ElementValues& values, std::size_t count, const pipeline::Stop& stop, Visit visit) {
    constexpr std::size_t kRun = 1024;
    for (std::size_t first = 0; first < count; first += kRun) {
        if (stop.stop_requested()) return false;
        visit(first, values.numbers(first, std::min(kRun, count - first)));
    }
    return true;
}

}  // namespace lessons
