#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/result.h"

namespace lessons {

// One of the views that stand in the middle of the window: a buffer view or a 3D view, each kind numbered from 0.
struct ViewLeaf {
    enum class Kind : unsigned char { Buffer, Space };
    Kind kind = Kind::Buffer;
    int number = 0;
    bool operator==(const ViewLeaf&) const = default;
};

// How views share the room: a tree of rows and columns, whose leaves are views.
struct ViewTree {
    enum class Kind : unsigned char { Leaf, Row, Column };
    Kind kind = Kind::Leaf;
    ViewLeaf leaf = {};  // of a leaf
    // Its part of the row or column that it stands in, in proportion to the others'; above 0.
    int weight = 1;
    // Of a row from left to right, of a column from top to bottom: two or more, none of the same kind as this.
    std::vector<ViewTree> parts = {};
    bool operator==(const ViewTree&) const = default;
};

inline constexpr std::size_t kMostViews = 16;

// As a file has it: "buffer | (buffer / 3d)", where | stands between what is side by side and / between what is one above
// the other; with weights where the parts are not equal: "612: buffer | 408: 3d". The first word "buffer" is buffer view 0,
// the next one 1, whatever their numbers were.
std::string text(const ViewTree& tree);
pipeline::Result<ViewTree> parseViewTree(std::string_view text);

// The named ones: "one" buffer beside a 3D view; "two", one above the other, beside it; "four", three buffers and a 3D view
// in two rows; "compare", two side by side; "space", a 3D view alone; "buffer", one buffer alone. Equal parts.
std::optional<ViewTree> arrangementNamed(std::string_view name);
std::vector<std::string> arrangementNames();
// The name of the one that has these views in these places, whatever their numbers and weights; else empty.
std::string arrangementName(const ViewTree& tree);
// Its name where it has one and equal parts, else its text: what arrangementOf reads.
std::string arrangementText(const ViewTree& tree);
pipeline::Result<ViewTree> arrangementOf(std::string_view nameOrText);

// Whether buffer views zoom and move together unless the user says otherwise: where buffers are there to be compared.
bool linksViews(const ViewTree& tree);

std::vector<ViewLeaf> leavesOf(const ViewTree& tree);  // row by row, as they are read
bool contains(const ViewTree& tree, ViewLeaf leaf);
// The least number that no view of that kind has.
int freeNumber(const ViewTree& tree, ViewLeaf::Kind kind);
// The leaves of that kind, as they are read, get these numbers, and further ones the least that are free.
void renumber(ViewTree& tree, ViewLeaf::Kind kind, const std::vector<int>& numbers);
// The same views in the same places, whatever their weights.
bool haveSameViews(const ViewTree& a, const ViewTree& b);
// The view `step` places on among the leaves, around the end; the first one where `from` is none of them.
ViewLeaf neighbour(const ViewTree& tree, ViewLeaf from, int step);
bool isEven(const ViewTree& tree);  // equal parts everywhere
void makeEven(ViewTree& tree);

// Gives half of `at`'s room to `added`, at its right (Row) or below it (Column). False where `at` is not in the tree, or
// it has as many views as it can have.
bool split(ViewTree& tree, ViewLeaf at, ViewTree::Kind direction, ViewLeaf added);
// Its room goes to what stands beside it. False where it is the only view, or none.
bool close(ViewTree& tree, ViewLeaf at);
bool replace(ViewTree& tree, ViewLeaf at, ViewLeaf by);

// Pixels.
struct ViewSize {
    int width = 0, height = 0;
    bool operator==(const ViewSize&) const = default;
};
// The least room in which every view has `least`, with `gap` pixels between views.
ViewSize smallest(const ViewTree& tree, ViewSize least, int gap);
// What of the tree is shown in `room`: the last views go, until the others have `least`. The first one always stays.
ViewTree fitted(ViewTree tree, ViewSize room, ViewSize least, int gap);

}  // namespace lessons
