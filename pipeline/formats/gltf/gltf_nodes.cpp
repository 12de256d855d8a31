#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/formats/gltf/gltf_formats.h"
#include "pipeline/formats/model_formats.h"

namespace pipeline {
namespace {

constexpr std::size_t kMaxLevels = 1024;
constexpr std::size_t kNoParent = SIZE_MAX;

glm::dmat3 rotationOf(const std::array<double, 4>& q) {
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    glm::dmat3 turn;
    turn[0] = {1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)};
    turn[1] = {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)};
    turn[2] = {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)};
    return turn;
}

// Section 3.5.3: a matrix, column by column, or translation · rotation · scale.
glm::dmat4 transformOf(const GltfValue& node) {
    constexpr double kFar = kFarthestVertex;
    glm::dmat4 matrix(1.0);
    if (const GltfValue given = node["matrix"]; given.isThere()) {
        std::array<double, 16> m{};
        if (!given.numbers(m, -kFar, kFar)) return matrix;
        for (std::size_t i = 0; i < 16; ++i)
            matrix[static_cast<glm::length_t>(i / 4)][static_cast<glm::length_t>(i % 4)] = m[i];
        // Written by way of floats the row may be off by a rounding.
        constexpr double kRounding = 1.0 / (1 << 20);
        const double off = std::max({std::abs(m[3]), std::abs(m[7]), std::abs(m[11]), std::abs(m[15] - 1)});
        if (off > kRounding) given.refuse("a matrix whose last row is 0 0 0 1");
        for (glm::length_t column = 0; column < 4; ++column) matrix[column][3] = column == 3;
        return matrix;
    }
    std::array<double, 3> move{0, 0, 0}, scale{1, 1, 1};
    std::array<double, 4> turn{0, 0, 0, 1};
    node["translation"].numbers(move, -kFar, kFar);
    node["scale"].numbers(scale, -kFar, kFar);
    if (const GltfValue rotation = node["rotation"]; rotation.numbers(turn, -kFar, kFar)) {
        // Scaled by a power of two: squares of small parts stay normal.
        double largest = 0;
        for (const double part : turn) largest = std::max(largest, std::abs(part));
        int exponent = 0;
        std::frexp(largest, &exponent);
        double square = 0;
        for (double& part : turn) part = std::ldexp(part, -exponent), square += part * part;
        const double length = std::sqrt(square);
        if (length == 0) {
            rotation.fail(fmt::format("{} is (0, 0, 0, 0)", rotation.pointer()), "a quaternion of length 1");
            return matrix;
        }
        for (double& part : turn) part /= length;
        constexpr double kWell = 1.0 / 256;  // what quaternions in normalised bytes are off by
        if (std::abs(std::ldexp(length, exponent) - 1) > kWell)
            remark(node.file(), "A rotation is no quaternion of length 1; its direction alone counts.", "node");
    }
    const glm::dmat3 rotation = rotationOf(turn);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto column = static_cast<glm::length_t>(axis);
        matrix[column] = glm::dvec4(rotation[column] * scale[axis], 0);
        matrix[3][column] = move[axis];
    }
    return matrix;
}

struct Graph {
    std::vector<std::vector<std::size_t>> children;
    std::vector<std::size_t> parents;
};

// False where a node would be drawn twice or without end.
bool readGraph(const GltfValue& nodes, Graph& graph) {
    const std::size_t count = nodes.size();
    graph.children.resize(count);
    graph.parents.assign(count, kNoParent);
    for (std::size_t i = 0; i < count; ++i) {
        const GltfValue children = nodes.at(i)["children"];
        if (nodes.file().check.stopped()) return false;
        for (std::size_t k = 0; k < children.size(); ++k) {
            if (nodes.file().check.stopped()) return false;
            const auto child = children.at(k).whole(0, count - 1);
            if (!child) return false;
            if (graph.parents[*child] != kNoParent) {
                children.at(k).fail(
                    fmt::format("node {} is a child of node {} and of node {}", *child, graph.parents[*child], i),
                    "nodes that are a tree");
                return false;
            }
            graph.parents[*child] = i;
            graph.children[i].push_back(*child);
        }
    }
    return nodes.file().errors.empty();
}

// The nodes of the scene that the file shows, or of its first one. Without scenes: every node that is no child.
std::vector<std::size_t> rootsOf(const GltfValue& top, const Graph& graph) {
    std::vector<std::size_t> roots;
    const GltfValue scenes = top["scenes"], shown = top["scene"];
    if (scenes.size() == 0) {
        for (std::size_t i = 0; i < graph.parents.size(); ++i)
            if (graph.parents[i] == kNoParent) roots.push_back(i);
        return roots;
    }
    if (scenes.size() > 1) remark(top.file(), "The file has several scenes; the one that it shows first is read.");
    const std::size_t errors = top.file().errors.size();
    const GltfValue scene = (shown.isThere() ? shown.element("scenes") : std::nullopt).value_or(scenes.at(0));
    dropErrors(top.file(), errors, "the first scene is shown", {});
    const GltfValue list = scene["nodes"];
    std::vector<bool> taken(graph.parents.size());
    for (std::size_t k = 0; k < list.size(); ++k) {
        if (!list.at(k).element("nodes")) return {};
        const std::size_t node = *list.at(k).whole(0, graph.parents.size() - 1);
        if (graph.parents[node] != kNoParent || taken[node]) {
            list.at(k).refuse("a node that is no child and stands there once");
            return {};
        }
        taken[node] = true;
        roots.push_back(node);
    }
    return roots;
}

// With at most one parent each, what no root leads to is a ring, or hangs on one, or is of another scene.
void refuseRings(const GltfValue& nodes, const Graph& graph, const std::vector<bool>& drawn) {
    std::vector<std::size_t> walk(graph.parents.size(), 0);  // which walk came by, from 1
    for (std::size_t i = 0; i < graph.parents.size(); ++i) {
        std::size_t node = i;
        while (node != kNoParent && !drawn[node] && walk[node] == 0) {
            walk[node] = i + 1;
            node = graph.parents[node];
        }
        if (node != kNoParent && walk[node] == i + 1)
            return nodes.at(node).fail(fmt::format("node {} stands below itself", node), "nodes that are a tree");
    }
}

}  // namespace

std::vector<GltfNode> nodesOf(GltfFile& file) {
    const GltfValue top(file), nodes = top["nodes"];
    std::vector<GltfNode> all;
    Graph graph;
    if (!readGraph(nodes, graph)) return all;

    struct Visit {
        std::size_t node, level;
        glm::dmat4 parent;
    };
    std::vector<Visit> open;
    std::vector<bool> seen(graph.parents.size());
    const auto push = [&](const std::vector<std::size_t>& list, std::size_t level, const glm::dmat4& parent) {
        for (auto node = list.rbegin(); node != list.rend(); ++node) open.push_back({*node, level, parent});
    };
    push(rootsOf(top, graph), 1, glm::dmat4(1.0));
    while (!open.empty() && file.errors.size() < kMaxErrors && !file.check.stopped()) {
        const Visit visit = open.back();
        open.pop_back();
        seen[visit.node] = true;
        const GltfValue node = nodes.at(visit.node);
        if (visit.level > kMaxLevels) {
            node.fail(fmt::format("{} stands below {} others", node.pointer(), kMaxLevels),
                      fmt::format("at most {} levels", kMaxLevels));
            break;
        }
        const glm::dmat4 toWorld = visit.parent * transformOf(node);
        all.push_back({node, toWorld});
        push(graph.children[visit.node], visit.level + 1, toWorld);
    }
    if (file.errors.empty()) refuseRings(nodes, graph, seen);
    return all;
}

std::vector<GltfInstance> instancesOf(GltfFile& file) {
    std::vector<GltfInstance> instances;
    for (const GltfNode& of : nodesOf(file)) {
        if (of.node["skin"].isThere())
            remark(file, "Skins are not read; what they move stays as it is written.", "node");
        if (const auto mesh = of.node["mesh"].element("meshes")) instances.push_back({of, *mesh});
    }
    return instances;
}

}  // namespace pipeline
