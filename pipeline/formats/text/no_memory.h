#pragma once
#include <string>

#include "pipeline/core/result.h"

namespace pipeline {

// That a reader gave up for lack of memory. what: "scene".
inline Error noMemoryToRead(SourceLocation at, const std::string& what) {
    return {std::move(at), "not enough memory to read the " + what};
}
// Whether it did: nothing is wrong with the file then.
inline bool isOfMemory(const Error& error) { return error.found.starts_with("not enough memory to read the "); }

}  // namespace pipeline
