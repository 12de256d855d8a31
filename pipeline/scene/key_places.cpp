#include "pipeline/scene/key_places.h"

#include <string_view>

namespace pipeline {

std::string_view tableOf(std::string_view key) {
    const auto dot = key.rfind('.');
    return dot == key.npos ? std::string_view() : key.substr(0, dot);
}

const SourceLocation* KeyPlaces::find(const Error& error) const {
    for (const std::string& key : error.keys)
        if (const auto found = m_places.find(key); found != m_places.end()) return &found->second;
    for (const std::string& key : error.keys)
        if (const auto found = m_places.find(tableOf(key)); found != m_places.end()) return &found->second;
    return nullptr;
}

Errors KeyPlaces::placed(Errors errors) const {
    for (Error& error : errors)
        if (const SourceLocation* where = find(error)) error.where = *where;
    return errors;
}

Errors namedAt(const SourceLocation& where, Errors errors) {
    if (where.file.empty()) return errors;
    for (Error& error : errors) {
        const bool hasFile = !error.where.file.empty();
        if (hasFile && error.where.line > 0) continue;
        if (hasFile) error.found = error.where.file + ": " + error.found;
        error.where = where;
    }
    return errors;
}

}  // namespace pipeline
