#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/buffers/any_buffer.h"
#include "pipeline/core/stage.h"
#include "pipeline/core/stop.h"
#include "pipeline/run/frame.h"

// What must hold of the stages' output, whoever has computed it: one row a contract, evaluated on buffers of a frame or of
// a foreign renderer.
namespace pipeline {

// A buffer and how exact its numbers are: what an error of rounding in the last step of computing or writing them is at
// most, in relation to the number, or for directions and other numbers up to 1 absolutely. Half a step of the file where
// that is coarser than the arithmetic: 1/255 for a direction in 8 bits.
struct ContractBuffer {
    AnyBuffer numbers;
    double rounding = 0;
};
// 2^-24 for float32, 2^-53 for float64, 0 for whole numbers.
double roundingOf(const AnyBuffer& buffer);

// What contracts are evaluated on. Buffers that are not there leave the contracts that read them out. polygon_id and
// object_id number the scene's polygons and objects from 0, rows run down, directions are in world space: a foreign
// renderer's conventions are undone before.
struct ContractInput {
    const Scene& scene;
    const Topology& topology;  // of the scene's meshes
    std::vector<ContractBuffer> buffers;
    // Per pixel whether something was drawn there. Empty: as polygon_id, object_id or z_view say, whichever is there; without
    // them a direction of (0, 0, 0) counts as nothing.
    std::vector<bool> drawn{};
};
ContractInput contractInput(const Frame& frame);                                       // all buffers that it holds
ContractInput contractInput(const Frame& frame, std::span<const BufferName> buffers);  // these alone
// The buffers that a frame has to make for all contracts.
BufferSet contractBuffers();

// How one element stands to a contract.
struct ContractFinding {
    double value = 0;  // what the contract speaks of: |N|, Σ λ
    double error = 0;  // how far that is from holding, in its unit; NaN is a violation
    double bound = 0;  // what rounding may make of it
    double room = std::numeric_limits<double>::infinity();  // the largest error there can be
    bool holds() const { return error <= bound; }
    bool canFail() const { return bound < room || !(error <= bound); }
};

class ContractData;  // pipeline/contracts/contract_data.h

struct Contract {
    static constexpr std::size_t kMostReads = 8;
    struct Reads {
        std::array<BufferId, kMostReads> ids{};
        std::size_t count = 0;
        constexpr Reads(std::initializer_list<BufferId> list) {
            for (const BufferId id : list) ids[count++] = id;
        }
        constexpr const BufferId* begin() const { return ids.data(); }
        constexpr const BufferId* end() const { return ids.data() + count; }
    };

    std::string_view id;       // "unit-normals"
    StageId stage;             // whose output it is about
    std::string_view claim;    // "Normals have length 1."
    std::string_view formula;  // in the lecture's notation: "|N| = 1"
    Reads reads;               // the first has the elements that are checked: vertices, polygons, pixels
    std::string_view space;    // "world"; empty where none applies
    std::string_view unit;     // of value, error and bound; empty for a pure number
    std::string_view range;    // of the value
    std::string_view bound;    // and why it is that; u is the unit of rounding of the least exact buffer read
    std::string_view source;
    // Nothing where the element is not concerned.
    std::optional<ContractFinding> (*check)(const ContractData& data, std::size_t element);
    // Why the contract says nothing of a scene (of light k), one sentence; null or empty where it does.
    std::string (*whyNot)(const Scene& scene, std::size_t k) = nullptr;

    bool perLight() const;        // checked once for each light: a buffer it reads is per light
    bool readsAllLights = false;  // at once, all of them
};
std::span<const Contract> contractTable();  // in the order of the stages
const Contract* findContract(std::string_view id);

struct ContractResult {
    const Contract* contract = nullptr;
    int light = -1;     // where the contract is per light
    std::string why{};  // why nothing was checked, one sentence; else empty
    std::size_t checked = 0, hold = 0;
    std::size_t undecided = 0;  // elements at which rounding decides: their bound cannot fail, and counts as no check
    // The element that is farthest beyond its bound, or nearest to it where all hold; the first of equals.
    struct Worst {
        std::size_t element = 0;
        ContractFinding finding{};
    };
    std::optional<Worst> worst{};
    std::vector<bool> violators{};  // per element; empty where all hold

    bool holds() const { return hold == checked; }
    std::string name() const;  // "unit-lights.0"
};

// Every contract for every light, in the table's order. goOn is asked before each and every 65 536 elements; where it says
// no, what there is so far is given, without the contract that was begun.
using GoOn = std::function<bool()>;
std::vector<ContractResult> checkContracts(const ContractInput& input, const GoOn& goOn = {});
inline std::vector<ContractResult> checkContracts(const ContractInput& input, const Stop& stop) {
    return checkContracts(input, [&stop] { return !stop.stop_requested(); });
}
ContractResult checkContract(const Contract& contract, const ContractInput& input, int light = -1,
                             const GoOn& goOn = {});

// "pixel 12, 40", "vertex 3", "polygon 2": where an element of a contract's first buffer is.
std::string contractPlace(const ContractResult& result, const ContractInput& input, std::size_t element);
// "0.83 at pixel 12, 40, off by 0.17, bound 2.4e-07": the worst; empty where nothing was checked.
std::string contractWorst(const ContractResult& result, const ContractInput& input);
// "37 of 38 contracts hold", and a line for each: those that do not hold first, those that say nothing last.
std::string contractsText(std::span<const ContractResult> results, const ContractInput& input);

}  // namespace pipeline
