#pragma once
#include "pipeline/inspect/table_text.h"

namespace pipeline {

// {"table", "meaning", "facts": [{lecture, name, unit, value}], "columns": [{lecture, name, unit,
// meaning, why_empty}], "rows": [[…], …]}, one row a line. What has no value is null. Given to
// `sink` in pieces.
void writeTableJson(const SceneTable& table, std::span<const std::uint32_t> rows, const TextSink& sink);

}  // namespace pipeline
