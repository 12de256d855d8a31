#pragma once
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "pipeline/core/stop.h"
#include "pipeline/formats/numbers/number_file.h"
#include "pipeline/run/frame.h"

namespace pipeline::foreign {

// What a file holds, by its name.
enum class Form : std::uint8_t {
    AsTable,  // the buffer of that name
    Visible,  // polygons.visible: 1 kept, 0 dropped
    Clip,     // vertices.clip: x y z w
    Ndc,      // vertices.ndc: x y z
};
struct HandedName {
    BufferName buffer{BufferId::Color};
    Form form = Form::AsTable;
    std::string text() const;  // "polygons.visible"
    bool operator==(const HandedName&) const = default;
};
// "color", "colour", "image", "depth", "n_dot_l.0", "visible"; nothing where no buffer is called so.
std::optional<HandedName> findHanded(std::string_view stem, std::size_t lights);
// The nearest name that there is, for messages.
std::string insteadOfHanded(std::string_view stem);

struct HandedFile {
    HandedName name;
    std::string path;  // as it was given, or FOLDER/NAME
    NumberFile numbers;
    std::string fileName() const { return path.substr(path.rfind('/') + 1); }
};

// What a folder, or files, hold of a renderer's buffers.
struct HandedIn {
    std::vector<HandedFile> files;    // in the order of the stages
    Errors errors;                    // of files that could not be read or have another size: left out
    std::vector<std::string> others;  // "final.png is not known; the nearest is …"
    std::string conventions;          // text of mine.toml, empty where there is none
    std::string conventionsName;
};

// A file that may be a buffer.
struct OfferedFile {
    std::string path;
    bool asked = false;  // by itself, not as one of a folder: a file that is no buffer is an error
    std::function<Result<std::string>(std::size_t most)> read;  // its bytes; an error where there are more
};
Error noSuchFile(const std::string& path);  // of a path that was named
// Of two files of a buffer the one with more digits is taken, and the other told among `others`. Sizes are checked against
// those of the reference's buffers.
HandedIn takeHandedIn(std::span<const OfferedFile> files, const Frame& reference, const Stop& stop);
// A folder's files, or files by themselves.
HandedIn readHandedIn(const std::vector<std::string>& paths, const Frame& reference, const Stop& stop);
// The same of files in memory, each with the bytes of its name: "depth.npy".
HandedIn readHandedIn(const std::map<std::string, std::string_view>& files, const Frame& reference);

}  // namespace pipeline::foreign
