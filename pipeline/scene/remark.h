#pragma once
#include <string>

namespace pipeline {

// Something strange that is no error: the scene is computed all the same.
struct Remark {
    std::string about;  // the key of a setting, the name of an object, or a file
    std::string text;   // what is strange, and what the program does about it: one or two sentences
    bool operator==(const Remark&) const = default;
};

}  // namespace pipeline
