#pragma once
#include <string_view>

namespace pipeline {

// The program's version, as CMakeLists.txt has it: "0.1.0".
std::string_view programVersion();

}  // namespace pipeline
