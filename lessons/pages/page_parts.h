#pragma once
#include <map>
#include <string>
#include <string_view>

#include "pipeline/core/result.h"

namespace lessons {

// What pages with scripts are put together from: the files of app/web/page and the core, found beside the installed
// program's resources, or in the source tree and its folder build/web. A script comes without its comments.
pipeline::Result<std::string> readPageFile(std::string_view name);

// What reads a student's lines and what runs them, for questions of kind write. reader: acorn, then the reader itself.
// notice: acorn's licence, which goes wherever it goes.
struct WriterParts {
    std::string reader, lines, notice;
};
pipeline::Result<WriterParts> writerParts();

// What a page's content policy calls a script or a style: "sha256-…".
std::string policyHash(std::string_view text);

// Each hole @NAME@ of the page filled once: what is put in is not looked through again. A hole without a value stays.
using PageValues = std::map<std::string, std::string, std::less<>>;
std::string withHolesFilled(std::string_view page, const PageValues& values);

}  // namespace lessons
