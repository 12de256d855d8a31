#include "pipeline/core/csv.h"

#include "pipeline/core/number.h"

namespace pipeline {

std::string csvField(std::string_view text) {
    const bool isFormula =
        !text.empty() && std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos && !readNumber(text);
    const std::string field = isFormula ? '\'' + std::string(text) : std::string(text);
    if (field.find_first_of(",\"\r\n") == field.npos) return field;
    std::string quoted = "\"";
    for (const char c : field) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

}  // namespace pipeline
