#include "lessons/pages/page_parts.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "pipeline/export/folder/file_hash.h"
#include "pipeline/export/html/html_text.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_folder.h"

namespace lessons {

using pipeline::Error;
using pipeline::Result;
namespace fs = std::filesystem;

namespace {

// The installed program has both in one folder, the source tree has the page's files apart from what is built.
std::vector<fs::path> liveFolders() {
    const fs::path resources = pipeline::resourceFolder();
    return {resources / "web", resources.parent_path() / "build" / "web",
            resources.parent_path() / "app" / "web" / "page"};
}

// A script without its lines of comments and its indentation, which weigh a fifth of it.
std::string withoutComments(std::string_view script) {
    std::string out;
    bool inComment = false;
    while (!script.empty()) {
        const std::size_t end = std::min(script.find('\n'), script.size() - 1) + 1;
        std::string_view line = script.substr(0, end);
        script.remove_prefix(end);
        line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        if (line.starts_with("/**") && line.find("*/ ") == line.npos) inComment = true;
        const bool isCode = !inComment && !line.starts_with("//") && line != "\n";
        if (inComment && line.find("*/") != line.npos) inComment = false;
        if (isCode) out += line;
    }
    return out;
}

}  // namespace

Result<std::string> readPageFile(std::string_view name) {
    std::error_code ignored;
    for (const fs::path& folder : liveFolders()) {
        if (!fs::exists(folder / name, ignored)) continue;
        auto text = pipeline::readFile(folder / name);
        return text && name.ends_with(".js") ? withoutComments(*text) : text;
    }
    return Error{{std::string(name), 0, 0}, "no such file", {}};
}

Result<WriterParts> writerParts() {
    WriterParts parts;
    for (const auto& [name, text] : {std::pair{"acorn.js", &parts.reader},
                                     {"reader.js", &parts.reader},
                                     {"lines.js", &parts.lines},
                                     {"acorn.txt", &parts.notice}}) {
        const auto read = readPageFile(name);
        if (!read) return read.errors();
        *text += *read;
    }
    return parts;
}

std::string policyHash(std::string_view text) {
    const std::string hex = pipeline::sha256Of(text);
    const auto half = [&](std::size_t i) { return hex[i] <= '9' ? hex[i] - '0' : hex[i] - 'a' + 10; };
    std::string bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 2) bytes += char(16 * half(i) + half(i + 1));
    return "sha256-" + pipeline::base64(bytes);
}

std::string withHolesFilled(std::string_view page, const PageValues& values) {
    std::string out;
    while (!page.empty()) {
        const std::size_t at = page.find('@'), end = at == page.npos ? at : page.find('@', at + 1);
        const auto value = end == page.npos ? values.end() : values.find(page.substr(at + 1, end - at - 1));
        if (value == values.end()) {
            const std::size_t length = at == page.npos ? page.size() : at + 1;
            out += page.substr(0, length);
            page.remove_prefix(length);
            continue;
        }
        out.append(page.substr(0, at)).append(value->second);
        page.remove_prefix(end + 1);
    }
    return out;
}

}  // namespace lessons
