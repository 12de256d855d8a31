#pragma once
#include <cstddef>
#include <span>
#include <string>

// Files that a careless reader takes quadratic time for, one or several of each format, of any size.
namespace test {

struct HostileFile {
    const char* name;  // "obj: names of objects"
    std::string (*text)(std::size_t n);
    // Reads a text in memory, whatever it says, with a stop that nobody asks for; beside it there are no files.
    void (*read)(const std::string& text);
    // The work grows with this power of n at most. 1.5 where the corners of one concave outline are searched in a tree of
    // points in the plane: a search for those in a region takes up to the square root of their number.
    double power = 1;
};
std::span<const HostileFile> hostileFiles();

}  // namespace test
