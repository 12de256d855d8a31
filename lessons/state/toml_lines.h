#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace lessons {

// One thing of a TOML file, with the line or lines that it stands in.
struct TomlItem {
    enum class Kind : unsigned char { Blank, Comment, Header, Entry };
    Kind kind = Kind::Blank;
    std::string text;      // all of it, its last line end too
    std::string name;      // of a header, "[[cue.view]]"; of an entry its key
    std::string value;     // of an entry, as it is written
    std::string before;    // of an entry: what stands before its value
    std::string comments;  // within or behind it, a line each
};

// Takes a file apart that is TOML; its texts put together are the file, with a line end at the end. Of what is no TOML it
// gives something.
std::vector<TomlItem> tomlItems(std::string_view file);

// The entry with another value; its comments stay, those within the old value above it.
TomlItem withValue(const TomlItem& entry, const std::string& value);

}  // namespace lessons
