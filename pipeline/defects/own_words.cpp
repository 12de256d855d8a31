#include "pipeline/defects/own_words.h"

#include <fmt/format.h>

namespace pipeline {
namespace {

std::string valueText(std::span<const double> at, OwnKind kind) {
    if (kind == OwnKind::Truth) return at[0] != 0 ? "true" : "false";
    std::string text;
    for (const double x : at) text += fmt::format("{}{:.6g}", text.empty() ? "" : ", ", x);
    return at.size() == 1 ? text : "(" + text + ")";
}

}  // namespace

std::string resultText(const OwnContract& contract, const std::optional<OwnValue>& value) {
    if (!value) return "no number";
    return valueText(std::span(value->at).first(contract.size()), contract.returns);
}

std::string placeText(const OwnElement& element, std::size_t number, int width) {
    switch (element.kind) {
        case OwnPlace::Vertex: return fmt::format("vertex {}", element.place);
        case OwnPlace::Polygon: return fmt::format("polygon {}", element.place);
        case OwnPlace::Pixel:
            return fmt::format("pixel {}, {}", element.place % std::size_t(width), element.place / std::size_t(width));
        case OwnPlace::Unknown: break;
    }
    return fmt::format("call {}", number + 1);
}

std::string shapeText(const OwnContract& contract) {
    std::string text;
    for (const OwnParameter& one : contract.taken())
        text += fmt::format("{}{} ", sizeOf(one.kind), isList(one.kind) ? "*" : "");
    return text + "> " + (contract.returns == OwnKind::Truth ? "t" : std::to_string(contract.size()));
}

std::vector<std::string> argumentTexts(const OwnContract& contract, const OwnElement& element) {
    std::vector<std::string> texts;
    const auto arguments = OwnArguments::read(contract.taken(), element.in);
    for (std::size_t i = 0; arguments && i < contract.taken().size(); ++i) {
        const OwnParameter& one = contract.taken()[i];
        const std::size_t size = sizeOf(one.kind), count = isList(one.kind) ? arguments->count(i) : 1;
        std::string text;
        for (std::size_t k = 0; k < count; ++k) {
            OwnValue value;
            for (std::size_t c = 0; c < size; ++c) value.at[c] = arguments->n(i, k * size + c);
            text += fmt::format("{}{}", k ? ", " : "", valueText(std::span(value.at).first(size), one.kind));
        }
        texts.push_back(fmt::format("{} = {}", one.name, isList(one.kind) ? "[" + text + "]" : text));
    }
    return texts;
}

}  // namespace pipeline
