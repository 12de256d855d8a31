#include "lessons/state/view_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

#include "pipeline/core/text.h"

namespace lessons {

using Kind = ViewTree::Kind;

namespace {

struct Named {
    const char *name, *text;
};
constexpr std::array<Named, 6> kNamed{{{"one", "buffer | 3d"},
                                       {"two", "(buffer / buffer) | 3d"},
                                       {"four", "(buffer | buffer) / (buffer | 3d)"},
                                       {"compare", "buffer | buffer"},
                                       {"space", "3d"},
                                       {"buffer", "buffer"}}};

bool haveSameShape(const ViewTree& a, const ViewTree& b) {
    return a.kind == b.kind && (a.kind != Kind::Leaf || a.leaf.kind == b.leaf.kind) &&
           std::ranges::equal(a.parts, b.parts, haveSameShape);
}

void addLeaves(const ViewTree& tree, std::vector<ViewLeaf>& leaves) {
    if (tree.kind == Kind::Leaf) leaves.push_back(tree.leaf);
    for (const ViewTree& part : tree.parts) addLeaves(part, leaves);
}

ViewTree* find(ViewTree& tree, ViewLeaf leaf) {
    if (tree.kind == Kind::Leaf) return tree.leaf == leaf ? &tree : nullptr;
    for (ViewTree& part : tree.parts)
        if (ViewTree* found = find(part, leaf)) return found;
    return nullptr;
}

// The fewest digits for the same proportions; rounded only where they would not stay small numbers.
void simplify(std::vector<ViewTree>& parts, const std::vector<std::int64_t>& weights) {
    constexpr std::int64_t kMostWeight = 100000;
    std::int64_t common = 0, largest = 1;
    for (const std::int64_t w : weights) common = std::gcd(common, w), largest = std::max(largest, w);
    const std::int64_t divisor = std::max<std::int64_t>(common, (largest + kMostWeight - 1) / kMostWeight);
    for (std::size_t i = 0; i < parts.size(); ++i)
        parts[i].weight = int(std::max<std::int64_t>(1, weights[i] / std::max<std::int64_t>(1, divisor)));
}

// A row within a row is the same row; a row of one is what stands in it.
void flatten(ViewTree& tree) {
    for (ViewTree& part : tree.parts) flatten(part);
    if (tree.parts.size() == 1) {
        ViewTree only = std::move(tree.parts.front());
        only.weight = tree.weight;
        tree = std::move(only);
    }
    const auto isSame = [&](const ViewTree& part) { return part.kind == tree.kind && part.kind != Kind::Leaf; };
    const auto inner = std::ranges::find_if(tree.parts, isSame);
    if (inner == tree.parts.end()) return;
    std::int64_t sum = 0;
    for (const ViewTree& part : inner->parts) sum += part.weight;
    std::vector<ViewTree> parts;
    std::vector<std::int64_t> weights;
    for (ViewTree& part : tree.parts) {
        const std::int64_t own = part.weight;
        if (&part != &*inner) {
            weights.push_back(own * sum);
            parts.push_back(std::move(part));
            continue;
        }
        for (ViewTree& deeper : part.parts) {
            weights.push_back(own * deeper.weight);
            parts.push_back(std::move(deeper));
        }
    }
    simplify(parts, weights);
    tree.parts = std::move(parts);
    flatten(tree);
}

bool removeLeaf(ViewTree& tree, ViewLeaf leaf) {
    for (std::size_t i = 0; i < tree.parts.size(); ++i) {
        ViewTree& part = tree.parts[i];
        if (part.kind != Kind::Leaf) {
            if (removeLeaf(part, leaf)) return true;
        } else if (part.leaf == leaf) {
            tree.parts.erase(tree.parts.begin() + std::ptrdiff_t(i));
            return true;
        }
    }
    return false;
}

}  // namespace

std::vector<std::string> arrangementNames() {
    std::vector<std::string> names;
    names.reserve(std::size(kNamed));
    for (const Named& named : kNamed) names.emplace_back(named.name);
    return names;
}

std::optional<ViewTree> arrangementNamed(std::string_view name) {
    const auto found = std::ranges::find(kNamed, name, [](const Named& n) { return std::string_view(n.name); });
    return found == kNamed.end() ? std::nullopt : std::optional(parseViewTree(found->text).value());
}

std::string arrangementName(const ViewTree& tree) {
    for (const Named& named : kNamed)
        if (haveSameShape(tree, parseViewTree(named.text).value())) return named.name;
    return {};
}

std::string arrangementText(const ViewTree& tree) {
    const std::string name = arrangementName(tree);
    return name.empty() || !isEven(tree) ? text(tree) : name;
}

pipeline::Result<ViewTree> arrangementOf(std::string_view nameOrText) {
    if (auto named = arrangementNamed(nameOrText)) return *std::move(named);
    return parseViewTree(nameOrText);
}

bool linksViews(const ViewTree& tree) {
    const std::string name = arrangementName(tree);
    return name == "compare" || name == "four";
}

std::vector<ViewLeaf> leavesOf(const ViewTree& tree) {
    std::vector<ViewLeaf> leaves;
    addLeaves(tree, leaves);
    return leaves;
}

bool contains(const ViewTree& tree, ViewLeaf leaf) { return std::ranges::count(leavesOf(tree), leaf) > 0; }

int freeNumber(const ViewTree& tree, ViewLeaf::Kind kind) {
    int number = 0;
    while (contains(tree, {kind, number})) ++number;
    return number;
}

namespace {

void renumberLeaves(ViewTree& tree, ViewLeaf::Kind kind, const std::vector<int>& numbers, std::size_t& next) {
    if (tree.kind == Kind::Leaf && tree.leaf.kind == kind) tree.leaf.number = numbers[next++];
    for (ViewTree& part : tree.parts) renumberLeaves(part, kind, numbers, next);
}

}  // namespace

void renumber(ViewTree& tree, ViewLeaf::Kind kind, const std::vector<int>& numbers) {
    std::vector<int> all = numbers;
    for (int number = 0; all.size() < kMostViews + numbers.size(); ++number)
        if (std::ranges::count(numbers, number) == 0) all.push_back(number);
    std::size_t next = 0;
    renumberLeaves(tree, kind, all, next);
}

bool haveSameViews(const ViewTree& a, const ViewTree& b) { return haveSameShape(a, b) && leavesOf(a) == leavesOf(b); }

ViewLeaf neighbour(const ViewTree& tree, ViewLeaf from, int step) {
    const std::vector<ViewLeaf> leaves = leavesOf(tree);
    const auto at = std::ranges::find(leaves, from);
    if (at == leaves.end()) return leaves.front();
    const int size = int(leaves.size()), to = (int(at - leaves.begin()) + step) % size;
    return leaves[std::size_t(to < 0 ? to + size : to)];
}

bool isEven(const ViewTree& tree) {
    const auto same = [&](const ViewTree& part) { return part.weight == tree.parts.front().weight && isEven(part); };
    return std::ranges::all_of(tree.parts, same);
}

void makeEven(ViewTree& tree) {
    tree.weight = 1;
    for (ViewTree& part : tree.parts) makeEven(part);
}

bool split(ViewTree& tree, ViewLeaf at, Kind direction, ViewLeaf added) {
    ViewTree* place = find(tree, at);
    if (!place || direction == Kind::Leaf || leavesOf(tree).size() >= kMostViews) return false;
    *place = {direction, {}, place->weight, {{Kind::Leaf, at}, {Kind::Leaf, added}}};
    flatten(tree);
    return true;
}

bool close(ViewTree& tree, ViewLeaf at) {
    if (tree.kind == Kind::Leaf || !removeLeaf(tree, at)) return false;
    flatten(tree);
    return true;
}

bool replace(ViewTree& tree, ViewLeaf at, ViewLeaf by) {
    ViewTree* place = find(tree, at);
    if (place) place->leaf = by;
    return place != nullptr;
}

ViewSize smallest(const ViewTree& tree, ViewSize least, int gap) {
    if (tree.kind == Kind::Leaf) return least;
    ViewSize all;
    const bool across = tree.kind == Kind::Row;
    for (const ViewTree& part : tree.parts) {
        const ViewSize one = smallest(part, least, gap);
        all.width = across ? all.width + one.width : std::max(all.width, one.width);
        all.height = across ? std::max(all.height, one.height) : all.height + one.height;
    }
    (across ? all.width : all.height) += gap * int(tree.parts.size() - 1);
    return all;
}

ViewTree fitted(ViewTree tree, ViewSize room, ViewSize least, int gap) {
    for (ViewSize needed = smallest(tree, least, gap); needed.width > room.width || needed.height > room.height;
         needed = smallest(tree, least, gap)) {
        // The last one that makes room where there is none: what stands beside two views, one above the other, gives no
        // height.
        const auto leaves = leavesOf(tree);
        const auto makesRoom = [&](const auto& leaf) {
            ViewTree without = tree;
            if (!close(without, leaf)) return false;
            const ViewSize then = smallest(without, least, gap);
            return (needed.width > room.width && then.width < needed.width) ||
                   (needed.height > room.height && then.height < needed.height);
        };
        const auto last = std::find_if(leaves.rbegin(), leaves.rend(), makesRoom);
        if (!close(tree, last == leaves.rend() ? leaves.back() : *last)) break;
    }
    return tree;
}

}  // namespace lessons
