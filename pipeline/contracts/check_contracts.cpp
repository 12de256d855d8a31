#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "pipeline/contracts/contract_data.h"
#include "pipeline/core/number.h"

namespace pipeline {

namespace {

// What the frame drew: only where a contract about pixels has all that it reads.
std::vector<bool> drawnOf(const Frame& frame, const std::vector<ContractBuffer>& buffers) {
    const auto isThere = [&](BufferId id) {
        return std::ranges::any_of(buffers, [&](const ContractBuffer& b) { return b.numbers.name.id == id; });
    };
    const auto isAsked = [&](const Contract& contract) {
        return bufferInfo(contract.reads.ids[0]).domain == Domain::Pixel &&
               std::ranges::all_of(contract.reads, isThere);
    };
    if (std::ranges::none_of(contractTable(), isAsked)) return {};
    const auto seen = frame.buffer({BufferId::PolygonId});
    std::vector<bool> drawn(seen ? seen->count() : 0);
    for (std::size_t i = 0; i < drawn.size(); ++i) drawn[i] = seen->flat(i) >= 0;
    return drawn;
}

}  // namespace

ContractInput contractInput(const Frame& frame) {
    std::vector<BufferName> names;
    for (const AnyBuffer& buffer : frame.buffers()) names.push_back(buffer.name);
    return contractInput(frame, names);
}

ContractInput contractInput(const Frame& frame, std::span<const BufferName> buffers) {
    ContractInput input{frame.scene(), frame.topology(), {}};
    for (const BufferName& name : buffers) {
        if (isDerived(name.id)) continue;
        if (auto buffer = frame.buffer(name)) input.buffers.push_back({*buffer, roundingOf(*buffer)});
    }
    input.drawn = drawnOf(frame, input.buffers);
    return input;
}

BufferSet contractBuffers() {
    BufferSet all;
    for (const Contract& contract : contractTable())
        for (const BufferId id : contract.reads) all.set(index(id));
    return all;
}

bool Contract::perLight() const {
    return !readsAllLights && std::ranges::any_of(reads, [](BufferId buffer) { return bufferInfo(buffer).perLight; });
}

std::string ContractResult::name() const {
    return light < 0 ? std::string(contract->id) : fmt::format("{}.{}", contract->id, light);
}

namespace {

// The first buffer that the contract reads and that is not there.
std::string missing(const Contract& contract, const ContractData& data, std::size_t lights) {
    for (const BufferId id : contract.reads) {
        if (!bufferInfo(id).perLight) {
            if (!data.has(id)) return BufferName{id}.text();
            continue;
        }
        if (!contract.readsAllLights) {
            if (!data.has(id)) return BufferName{id, data.light()}.text();
            continue;
        }
        for (int k = 0; k < int(lights); ++k)
            if (!data.has(id, k)) return BufferName{id, k}.text();
    }
    return {};
}

// Beyond the bound first by how much; NaN before everything.
double excess(const ContractFinding& finding) {
    const double beyond = finding.error - finding.bound;
    return beyond == beyond ? beyond : std::numeric_limits<double>::infinity();
}

}  // namespace

ContractResult checkContract(const Contract& contract, const ContractInput& input, int light, const GoOn& goOn) {
    ContractResult result{&contract, light};
    if (contract.whyNot) result.why = contract.whyNot(input.scene, std::size_t(std::max(light, 0)));
    if (!result.why.empty()) return result;
    ContractData data(input, light);
    if (const std::string name = missing(contract, data, input.scene.lights.size()); !name.empty()) {
        result.why = fmt::format("{} is not there.", name);
        return result;
    }
    data.setRounding(data.rounding(contract));
    const std::size_t count = data.count(contract.reads.ids[0]);
    constexpr std::size_t kBetweenLooks = 1 << 16;
    for (std::size_t i = 0; i < count; ++i) {
        if (i % kBetweenLooks == 0 && goOn && !goOn()) return result;
        const std::optional<ContractFinding> finding = contract.check(data, i);
        if (!finding) continue;
        if (!finding->canFail()) {
            ++result.undecided;
            continue;
        }
        ++result.checked;
        if (finding->holds()) {
            ++result.hold;
        } else {
            if (result.violators.empty()) result.violators.assign(count, false);
            result.violators[i] = true;
        }
        if (!result.worst || excess(*finding) > excess(result.worst->finding)) result.worst = {i, *finding};
    }
    if (result.checked == 0)
        result.why = result.undecided > 0
                         ? fmt::format("Rounding decides at all {} places: no value could be wrong.", result.undecided)
                         : "Nothing that it is about is there.";
    return result;
}

std::vector<ContractResult> checkContracts(const ContractInput& input, const GoOn& goOn) {
    std::vector<ContractResult> results;
    for (const Contract& contract : contractTable()) {
        const int lights = contract.perLight() ? int(input.scene.lights.size()) : 0;
        for (int k = contract.perLight() ? 0 : -1; k < lights; ++k) {
            ContractResult result = checkContract(contract, input, k, goOn);
            if (goOn && !goOn()) return results;
            results.push_back(std::move(result));
        }
    }
    return results;
}

std::string contractPlace(const ContractResult& result, const ContractInput& input, std::size_t element) {
    const BufferId id = result.contract->reads.ids[0];
    switch (bufferInfo(id).domain) {
        case Domain::Vertex: return fmt::format("vertex {}", element);
        case Domain::Polygon: return fmt::format("polygon {}", element);
        case Domain::Texel: return fmt::format("texel {}", element);
        case Domain::Pixel: break;
    }
    const auto width = std::size_t(std::max(1, input.scene.settings.width));
    return fmt::format("pixel {}, {}", element % width, element / width);
}

std::string contractWorst(const ContractResult& result, const ContractInput& input) {
    if (!result.worst) return {};
    const ContractFinding& found = result.worst->finding;
    const std::string_view unit = result.contract->unit;
    return fmt::format("{:.6g}{}{} at {}, off by {:.2g}, bound {:.2g}", found.value, unit.empty() ? "" : " ", unit,
                       contractPlace(result, input, result.worst->element), found.error, found.bound);
}

std::string contractsText(std::span<const ContractResult> results, const ContractInput& input) {
    const auto says = [](const ContractResult& result) { return result.why.empty(); };
    const auto hold = std::ranges::count_if(results, [&](const auto& r) { return says(r) && r.holds(); });
    std::string text = fmt::format("{} of {} contracts hold\n", hold, std::ranges::count_if(results, says));
    const auto line = [&](const ContractResult& result) {
        text += fmt::format("{:<14}{:<28}{:>9} of {:<9} {}{}\n", stageInfo(result.contract->stage).name, result.name(),
                            result.hold, result.checked, result.contract->formula,
                            result.undecided > 0 ? fmt::format("; rounding decides at {} more", result.undecided) : "");
    };
    for (const ContractResult& result : results) {
        if (!says(result) || result.holds()) continue;
        line(result);
        text += fmt::format("    worst: {}; {}\n", contractWorst(result, input), result.contract->claim);
    }
    for (const ContractResult& result : results)
        if (says(result) && result.holds()) line(result);
    for (const ContractResult& result : results)
        if (!says(result))
            text += fmt::format("{:<14}{:<28}{:>9}    {:<9} {}\n", stageInfo(result.contract->stage).name,
                                result.name(), "–", "", result.why);
    return text;
}

}  // namespace pipeline
