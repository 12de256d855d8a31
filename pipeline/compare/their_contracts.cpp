#include "pipeline/compare/their_contracts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/buffers/verdict.h"
#include "pipeline/contracts/contract.h"

namespace pipeline::foreign {

namespace {

constexpr double kShareBroken = 0.01;
// A renderer in float rounds at every step of what leads to a number, and contracts bound the last of them.
constexpr double kRoundingInFloat = 2e-5;

double roundingOf(const NumberFile& file) {
    if (file.kind == NumberKind::Levels8) return 1.0 / 255;
    if (file.kind == NumberKind::Levels16) return 1.0 / 65535;
    return std::max(kRoundingInFloat, std::ldexp(1.0, -file.digits));
}

AnyBuffer bufferOf(const BufferName& name, const Values& values) {
    auto numbers = std::make_shared<std::vector<double>>(values.numbers);
    for (std::size_t i = 0; i < values.count(); ++i) {
        double* const v = numbers->data() + i * std::size_t(values.channels);
        if (name.id == BufferId::PolygonsVerdict) v[0] = double(v[0] != 0 ? Verdict::Kept : Verdict::BackFacing);
        if (name.id == BufferId::ZView && !values.there[i]) v[0] = std::numeric_limits<double>::infinity();
        if ((name.id == BufferId::PolygonId || name.id == BufferId::ObjectId) && !values.there[i]) v[0] = -1;
    }
    const BufferInfo& info = bufferInfo(name.id);
    std::vector<std::size_t> shape{values.rows};
    if (info.domain == Domain::Pixel) shape.push_back(values.columns);
    if (values.channels > 1) shape.push_back(std::size_t(values.channels));
    return {name, &info, shape, std::span<const double>(*numbers), numbers};
}

}  // namespace

ContractInput theirInput(const Conventions& conventions, const Reference& reference) {
    ContractInput input{reference.frame->scene(), reference.frame->topology(), {}, {}};
    for (const ReadFile& file : conventions.files) {
        // Its depth is left to the z-buffer here, and counts of fragments depend on who is clipped where.
        if (file.file->name.buffer.id == BufferId::VerticesScreen) continue;
        input.buffers.push_back({bufferOf(file.file->name.buffer, file.mine), roundingOf(file.file->numbers)});
    }
    for (const std::uint8_t covered : reference.context.covered) input.drawn.push_back(covered != 0);
    return input;
}

std::vector<BrokenContract> brokenContracts(const Conventions& conventions, const Reference& reference,
                                            const Stop& stop) {
    const ContractInput input = theirInput(conventions, reference);
    std::vector<BrokenContract> out;
    for (const ContractResult& result : checkContracts(input, stop)) {
        const std::size_t broken = result.checked - result.hold;
        if (double(broken) <= kShareBroken * double(result.checked)) continue;
        BufferName buffer{*result.contract->reads.begin(), result.light};
        if (!bufferInfo(buffer.id).perLight) buffer.light = -1;
        out.push_back({std::string(result.contract->claim), std::string(result.contract->formula), buffer.text(),
                       result.checked, broken, contractWorst(result, input)});
    }
    return out;
}

std::string contractText(const BrokenContract& contract) {
    const double holds = 100 * double(contract.checked - contract.broken) / double(contract.checked);
    return fmt::format("{} It holds in {:.0f} % of {}: {}", contract.claim, holds, contract.buffer, contract.worst);
}

}  // namespace pipeline::foreign
