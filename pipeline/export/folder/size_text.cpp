#include "pipeline/export/folder/size_text.h"

#include <fmt/format.h>

namespace pipeline {

std::string sizeText(std::uint64_t bytes) {
    if (bytes < 1000) return fmt::format("{} B", bytes);
    if (bytes < 100'000) return fmt::format("{:.1f} kB", double(bytes) / 1e3);
    return fmt::format("{:.1f} MB", double(bytes) / 1e6);
}

}  // namespace pipeline
