#include "lessons/prose.h"

#include <charconv>

#include "lessons/expression/changed_frames.h"
#include "lessons/text_position.h"
#include "pipeline/core/text.h"

namespace lessons {

namespace {

constexpr int kMostDigits = 12;

pipeline::Result<Prose::Hole> parseHole(std::string_view text, const pipeline::SourceLocation& where,
                                        const Scope& scope) {
    const auto colon = text.rfind(':');
    auto expression = parseExpression(text.substr(0, colon), where, scope);
    if (!expression) return expression.errors();
    Prose::Hole hole{std::move(expression).value(), {}};
    if (colon == text.npos) return hole;
    const auto first = text.find_first_not_of(' ', colon + 1);
    const std::string_view digits =
        first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(' ') - first + 1);
    int count = -1;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
    if (error != std::errc() || end != digits.data() + digits.size() || count < 0 || count > kMostDigits)
        return pipeline::Error{advanced(where, text.substr(0, colon + 1)), "found " + pipeline::inQuotes(digits),
                               "a number of digits from 0 to " + std::to_string(kMostDigits)};
    hole.digits = count;
    return hole;
}

}  // namespace

pipeline::Result<Prose> parseProse(std::span<const Line> lines, const Scope& scope) {
    Prose prose{{""}, {}};
    pipeline::Errors errors;
    for (const Line& line : lines) {
        const std::string_view text = line.text;
        pipeline::SourceLocation here =
            line.where;  // of text[counted]: from the line's beginning it would be quadratic
        std::size_t counted = 0;
        const auto placeOf = [&](std::size_t at) {
            here = advanced(here, text.substr(counted, at - counted));
            counted = at;
            return here;
        };
        for (std::size_t at = 0; at < text.size(); ++at) {
            if (text.substr(at).starts_with("\\{")) {
                prose.pieces.back() += text[++at];
            } else if (text[at] != '{') {
                prose.pieces.back() += text[at];
            } else if (const auto end = text.find('}', at); end == text.npos) {
                errors.push_back({placeOf(at), "found \"{\" without its end", "\"}\" in the same line"});
                break;
            } else {
                auto hole = parseHole(text.substr(at + 1, end - at - 1), placeOf(at + 1), scope);
                if (!hole) {
                    errors.insert(errors.end(), hole.errors().begin(), hole.errors().end());
                    if (errors.size() >= pipeline::kMaxErrors) break;
                } else {
                    prose.holes.push_back(std::move(hole).value());
                    prose.pieces.emplace_back();
                }
                at = end;
            }
        }
        if (&line != &lines.back()) prose.pieces.back() += '\n';
    }
    if (errors.size() > pipeline::kMaxErrors) errors.resize(pipeline::kMaxErrors);
    if (!errors.empty()) return errors;
    return prose;
}

pipeline::Result<std::string> filled(const Prose& prose, const Context& context) {
    std::string text = prose.pieces.empty() ? std::string() : prose.pieces.front();
    pipeline::Errors errors;
    ChangedFrames changed;
    Context own = context;
    if (!own.changed) own.changed = &changed;
    for (std::size_t i = 0; i < prose.holes.size() && !(i > 0 && context.stop.stop_requested()); ++i) {
        const auto value = evaluate(prose.holes[i].expression, own);
        if (value)
            text += toText(*value, prose.holes[i].digits) + prose.pieces[i + 1];
        else
            errors.insert(errors.end(), value.errors().begin(), value.errors().end());
    }
    if (!errors.empty()) return errors;
    return text;
}

pipeline::Result<std::string> filled(const Prose& prose, const pipeline::Frame& frame) {
    return filled(prose, Context{.frame = frame});
}

std::string filled(const Prose& prose, const Context& context, pipeline::Errors& errors) {
    auto text = filled(prose, context);
    if (text) return std::move(text).value();
    errors.insert(errors.end(), text.errors().begin(), text.errors().end());
    return {};
}

std::string withGaps(const Prose& prose) {
    std::string text = prose.pieces.empty() ? std::string() : prose.pieces.front();
    for (std::size_t i = 0; i < prose.holes.size(); ++i) text += "…" + prose.pieces[i + 1];
    return text;
}

pipeline::BufferSet buffersOf(const Prose& prose) {
    pipeline::BufferSet buffers;
    for (const Prose::Hole& hole : prose.holes) buffers |= hole.expression.buffers;
    return buffers;
}

}  // namespace lessons
