#pragma once
#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

#include "pipeline/check/case.h"
#include "pipeline/core/result.h"

// Texts through the readers of the program.
namespace pipeline::check {

struct Reading {
    Errors errors;
    std::vector<Object> objects;  // where there is no error
};
// By the ending of the name, as for a file of that name; no file that it names is there.
Reading read(const std::string& name, const std::string& text);

struct Text {
    std::string name, text;
    bool placed = true;  // the error names line and column
};
// Ours: how many texts are read without an error, or with one that does not say where. The first place refused is
// what a table shows.
Finding refusing(Trial& trial, double naive, const std::vector<Text>& texts, std::string naiveText = {});

template <class T>
std::string bytesOf(std::initializer_list<T> values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), std::data(values), bytes.size());
    return bytes;
}

}  // namespace pipeline::check
