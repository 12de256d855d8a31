// A lesson's page asks no file for its hash.
#include "pipeline/export/file_hash.h"

namespace pipeline {

std::optional<std::string> sha256(const std::filesystem::path&) { return {}; }
std::string sha256Of(std::string_view) { return {}; }

}  // namespace pipeline
