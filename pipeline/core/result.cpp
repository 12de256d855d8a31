#include "pipeline/core/result.h"

#include "pipeline/core/printable.h"

namespace pipeline {

std::string format(const Error& error) {
    std::string text = escaped(error.where.file);
    if (error.where.line > 0) {
        text += ':' + std::to_string(error.where.line);
        if (error.where.column > 0) text += ':' + std::to_string(error.where.column);
    }
    if (!text.empty()) text += ": ";
    text += escaped(error.found);
    if (!error.expected.empty()) text += ", expected " + escaped(error.expected);
    return text;
}

std::string format(const Errors& errors) {
    std::string text;
    for (const Error& error : errors) text += format(error) + '\n';
    if (errors.size() >= kMaxErrors) text += "These are the first errors; there may be more.\n";
    return text;
}

}  // namespace pipeline
