#include "pipeline/formats/up_axis.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include <fmt/format.h>

#include "pipeline/core/text.h"

namespace pipeline {
namespace {

constexpr std::size_t kFirstLines = 20;

std::string inSmallLetters(std::string_view text) {
    std::string small(text);
    std::ranges::transform(small, small.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return small;
}

// What each writes unless it is told otherwise.
struct Writer {
    std::string_view word, name;
    UpAxis obj, ply;
};
constexpr UpAxis kY = UpAxis::Y, kZ = UpAxis::Z;
constexpr auto kWriters = std::to_array<Writer>({
    {"blender", "Blender", kY, kZ},
    {"3ds max", "3ds Max", kY, kY},
    {"wings 3d", "Wings 3D", kY, kY},
    {"zbrush", "ZBrush", kY, kY},
    {"max2obj", "Max2Obj", kY, kY},
    {"cinema 4d", "Cinema 4D", kY, kY},
    {"daz studio", "DAZ Studio", kY, kY},
    {"poser", "Poser", kY, kY},
    {"this file uses centimeters as units", "Maya", kY, kY},
    {"freecad", "FreeCAD", kZ, kZ},
    {"openscad", "OpenSCAD", kZ, kZ},
});

// "z up", "Z-up", "up: z", "up axis = Z": said by the comment itself.
std::optional<UpAxis> saidBy(std::string_view comment) {
    std::string words;
    for (const char c : comment)
        if (std::isalnum(static_cast<unsigned char>(c)))
            words += c;
        else if (!words.ends_with(' '))
            words += ' ';
    const auto has = [&](std::string_view phrase) { return (" " + words + " ").find(phrase) != words.npos; };
    for (const auto& [up, axis] : {std::pair{kY, 'y'}, {kZ, 'z'}})
        for (const char* form : {" {} up ", " {}up ", " up {} ", " up axis {} ", " upaxis {} "})
            if (has(fmt::format(fmt::runtime(form), axis))) return up;
    return {};
}

std::optional<UpGuess> byComments(std::string_view text) {
    const bool isPly = text.starts_with("ply");
    for (std::size_t line = 0; line < kFirstLines && !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view words = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!words.starts_with(isPly ? "comment" : "#")) continue;
        const std::string small = inSmallLetters(words);
        if (const auto up = saidBy(small)) return UpGuess{*up, "its comments say so"};
        for (const Writer& writer : kWriters)
            if (small.find(writer.word) != small.npos)
                return UpGuess{isPly ? writer.ply : writer.obj, fmt::format("its comments name {}", writer.name)};
    }
    return {};
}

// y and z, and what the guess is where one of them fits alone.
template <class Fits>
std::optional<UpAxis> theOne(Fits fits) {
    if (fits(1) == fits(2)) return {};
    return fits(1) ? UpAxis::Y : UpAxis::Z;
}
char letter(UpAxis up) { return up == UpAxis::Y ? 'y' : 'z'; }

std::optional<UpGuess> byFloor(std::span<const Object> objects) {
    for (const Object& object : objects) {
        const std::string name = inSmallLetters(object.name);
        const auto isNamed = [&](std::string_view word) { return name.find(word) != name.npos; };
        if (!isNamed("floor") && !isNamed("ground") && !isNamed("terrain") && !isNamed("ceiling")) continue;
        const Vec3d size = object.mesh->facts.high - object.mesh->facts.low;
        const auto isFlat = [&](int axis) { return size[axis] < 0.1 * size.x && size[axis] < 0.1 * size[3 - axis]; };
        if (const auto up = theOne(isFlat))
            return UpGuess{*up, fmt::format("its object {} is flat along {}", inQuotes(object.name), letter(*up))};
    }
    return {};
}

struct Extents {
    Vec3d low, high;
    Vec3d size() const { return high - low; }
};
Extents extentsOf(std::span<const Object> objects) {
    Extents all{objects[0].mesh->facts.low, objects[0].mesh->facts.high};
    for (const Object& object : objects) {
        all.low = glm::min(all.low, object.mesh->facts.low);
        all.high = glm::max(all.high, object.mesh->facts.high);
    }
    return all;
}

// How much of the area lies across an axis, and whether all of it faces one way along it.
struct Facing {
    double share = 0;
    bool oneWay = false;
};
Facing facingOf(std::span<const Object> objects, int axis, StopCheck& check) {
    constexpr double kAcross = 0.999;  // of a normal of length 1, along the axis
    double across = 0, all = 0;
    bool up = false, down = false, upright = false;
    for (const Object& object : objects)
        for (const Triangle& triangle : object.mesh->triangles) {
            if (check.stopped()) return {};
            const Vec3d a = object.mesh->positions[triangle.vertices[0]];
            const Vec3d normal = glm::cross(object.mesh->positions[triangle.vertices[1]] - a,
                                            object.mesh->positions[triangle.vertices[2]] - a);
            const double area = glm::length(normal);
            all += area, across += std::abs(normal[axis]) > kAcross * area ? area : 0;
            up = up || normal[axis] > 0, down = down || normal[axis] < 0, upright = upright || normal[axis] == 0;
        }
    return {all > 0 ? across / all : 0, !upright && up != down};
}
// Along an axis alone, but not flat.
bool isThin(const Vec3d& size, int axis) {
    return size[axis] > 0 && size[axis] < 0.25 * std::min(size[(axis + 1) % 3], size[(axis + 2) % 3]);
}

// Terrain, or a function of two variables.
std::optional<UpGuess> byHeights(std::span<const Object> objects, StopCheck& check) {
    const Vec3d size = extentsOf(objects).size();
    const auto up = theOne([&](int axis) { return isThin(size, axis) && facingOf(objects, axis, check).oneWay; });
    if (!up) return {};
    return UpGuess{*up, fmt::format("its polygons are heights over a plane, thin along {}", letter(*up))};
}

std::optional<UpGuess> byExtents(std::span<const Object> objects, StopCheck& check) {
    const Extents all = extentsOf(objects);
    const Vec3d size = all.size();
    const auto begins = [&](int axis) { return std::abs(all.low[axis]) < 0.01 * size[axis]; };
    const auto isAround = [&](int axis) {
        return all.low[axis] < -0.25 * size[axis] && all.high[axis] > 0.25 * size[axis];
    };
    const auto stands = [&](int axis) { return begins(axis) && isAround(0) && isAround(3 - axis); };
    if (const auto up = theOne(stands))
        return UpGuess{*up, fmt::format("it begins at 0 along {} and lies around 0 along x and {}", letter(*up),
                                        letter(*up == kY ? kZ : kY))};
    // The beds of printers; what hangs on a wall has more relief.
    constexpr double kPlate = 0.8;
    if (isThin(size, 2) && isAround(0) && isAround(1) && facingOf(objects, 2, check).share > kPlate)
        return UpGuess{kZ, "it is a plate around 0, thin along z"};
    return {};
}

}  // namespace

UpGuess guessUp(std::string_view text, std::span<const Object> objects, const Stop& stop) {
    StopCheck check(stop);
    if (auto guess = byComments(text)) return *std::move(guess);
    if (auto guess = byFloor(objects)) return *std::move(guess);
    if (auto guess = byHeights(objects, check)) return *std::move(guess);
    if (auto guess = byExtents(objects, check)) return *std::move(guess);
    return {kY, "as in most OBJ and PLY files"};
}

}  // namespace pipeline
