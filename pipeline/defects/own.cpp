#include "pipeline/defects/own.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/defects/own_rows.h"

namespace pipeline {

std::size_t sizeOf(OwnKind kind) {
    switch (kind) {
        case OwnKind::None: return 0;
        case OwnKind::Truth:
        case OwnKind::Number:
        case OwnKind::Numbers: return 1;
        case OwnKind::Point:
        case OwnKind::Points: return 2;
        case OwnKind::Vector:
        case OwnKind::Bytes:
        case OwnKind::Vectors: return 3;
    }
    return 0;
}

std::optional<OwnArguments> OwnArguments::read(std::span<const OwnParameter> parameters, std::span<const double> in) {
    OwnArguments a;
    a.m_in = in;
    std::size_t at = 0;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        std::size_t count = 1;
        if (isList(parameters[i].kind)) {
            if (at >= in.size() || !(in[at] >= 0 && in[at] <= double(in.size()))) return {};
            count = std::size_t(in[at++]);
        }
        a.m_first[i] = at;
        at += count * sizeOf(parameters[i].kind);
        if (at > in.size()) return {};
    }
    if (at != in.size()) return {};
    return a;
}

std::span<const OwnParameter> OwnContract::taken() const {
    const auto end = std::ranges::find(parameters, OwnKind::None, &OwnParameter::kind);
    return {parameters.data(), std::size_t(end - parameters.begin())};
}

const OwnContract& ownContract(OwnFunction function) {
    const std::size_t at = index(function), first = ownOfGeometry().size(), second = first + ownOfDrawing().size();
    return at < first ? ownOfGeometry()[at] : at < second ? ownOfDrawing()[at - first] : ownOfShading()[at - second];
}

std::optional<OwnFunction> findOwn(std::string_view name) {
    for (std::size_t i = 0; i < kOwnCount; ++i)
        if (ownContract(OwnFunction(i)).name == name) return OwnFunction(i);
    return {};
}

OwnValue valueOf(const OwnContract& contract, OwnFormula formula, std::span<const double> in) {
    const auto arguments = OwnArguments::read(contract.taken(), in);
    return arguments ? formula(*arguments) : OwnValue();
}

std::string signatureOf(const OwnContract& contract) {
    std::string names;
    for (const OwnParameter& parameter : contract.taken())
        names += (names.empty() ? "" : ", ") + std::string(parameter.name);
    return fmt::format("{}({})", contract.name, names);
}

}  // namespace pipeline
