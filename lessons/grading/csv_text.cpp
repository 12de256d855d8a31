#include "lessons/grading/csv_text.h"

#include "lessons/expression/value.h"
#include "pipeline/core/printable.h"

namespace lessons {

std::string csvCell(std::string_view text) {
    std::string plain = pipeline::escaped(text);
    const bool isFormula = !plain.empty() && std::string_view("=+-@").find(plain[0]) != std::string_view::npos;
    if (isFormula && !numberIn(plain)) plain.insert(0, 1, '\'');
    if (plain.find_first_of(",\"'") == std::string::npos) return plain;
    std::string quoted = "\"";
    for (const char c : plain) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

}  // namespace lessons
