#pragma once
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "pipeline/core/result.h"

namespace pipeline {

// Where the settings of a scene were given: "light.0.x", or "light.0" for the table that they stand in.
class KeyPlaces {
public:
    // Where a key is given again, that counts.
    void add(std::string key, SourceLocation where) { m_places.insert_or_assign(std::move(key), std::move(where)); }

    // The errors with the place of the first of their keys that was given, else of the first whose table was.
    Errors placed(Errors errors) const;

private:
    const SourceLocation* find(const Error& error) const;
    std::map<std::string, SourceLocation, std::less<>> m_places;
};

// Errors that stand in no line of a file, with the place of who named the file, or said the words.
Errors namedAt(const SourceLocation& where, Errors errors);

// "light.0" of "light.0.x"; empty of a setting that stands in no table.
std::string_view tableOf(std::string_view key);

}  // namespace pipeline
