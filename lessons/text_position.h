#pragma once
#include <algorithm>
#include <string_view>

#include "pipeline/core/result.h"

namespace lessons {

// The place behind `text` that starts at `where` and stays in its line. Columns count characters,
// so the continuation bytes of UTF-8 do not.
inline pipeline::SourceLocation advanced(pipeline::SourceLocation where, std::string_view text) {
    where.column +=
        int(std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
    return where;
}

}  // namespace lessons
