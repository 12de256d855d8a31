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

struct Writer {
    std::string_view word, name;
    UpAxis up;
};
// What each writes unless it is told otherwise.
constexpr auto kWriters = std::to_array<Writer>({
    {"blender", "Blender", UpAxis::Y},
    {"3ds max", "3ds Max", UpAxis::Y},
    {"wings 3d", "Wings 3D", UpAxis::Y},
    {"zbrush", "ZBrush", UpAxis::Y},
    {"max2obj", "Max2Obj", UpAxis::Y},
    {"cinema 4d", "Cinema 4D", UpAxis::Y},
    {"daz studio", "DAZ Studio", UpAxis::Y},
    {"poser", "Poser", UpAxis::Y},
    {"this file uses centimeters as units", "Maya", UpAxis::Y},
    {"freecad", "FreeCAD", UpAxis::Z},
    {"openscad", "OpenSCAD", UpAxis::Z},
});

std::optional<UpGuess> byWriter(std::string_view text) {
    for (std::size_t line = 0; line < kFirstLines && !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view words = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!words.starts_with('#')) continue;
        const std::string small = inSmallLetters(words);
        for (const Writer& writer : kWriters)
            if (small.find(writer.word) != small.npos)
                return UpGuess{writer.up, fmt::format("its comments name {}", writer.name)};
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

std::optional<UpGuess> byExtents(std::span<const Object> objects) {
    Vec3d low = objects[0].mesh->facts.low, high = objects[0].mesh->facts.high;
    for (const Object& object : objects) {
        low = glm::min(low, object.mesh->facts.low);
        high = glm::max(high, object.mesh->facts.high);
    }
    const Vec3d size = high - low;
    const auto begins = [&](int axis) { return std::abs(low[axis]) < 0.01 * size[axis]; };
    const auto isAround = [&](int axis) { return low[axis] < -0.25 * size[axis] && high[axis] > 0.25 * size[axis]; };
    if (const auto up = theOne([&](int axis) { return begins(axis) && isAround(3 - axis); }))
        return UpGuess{*up, fmt::format("it begins at 0 along {} and lies around 0 along {}", letter(*up),
                                        letter(*up == UpAxis::Y ? UpAxis::Z : UpAxis::Y))};
    // What is drawn in a plane may stand or lie.
    if (size.x == 0 || size.y == 0 || size.z == 0) return {};
    const auto isTall = [&](int axis) { return size[axis] > 1.5 * size.x && size[axis] > 1.5 * size[3 - axis]; };
    if (const auto up = theOne(isTall)) return UpGuess{*up, fmt::format("it is tallest along {}", letter(*up))};
    return {};
}

}  // namespace

UpGuess guessUp(std::string_view text, std::span<const Object> objects) {
    if (auto guess = byWriter(text)) return *std::move(guess);
    if (auto guess = byFloor(objects)) return *std::move(guess);
    if (auto guess = byExtents(objects)) return *std::move(guess);
    return {};
}

}  // namespace pipeline
