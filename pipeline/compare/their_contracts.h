#pragma once
#include "pipeline/compare/handed_in/conventions.h"
#include "pipeline/compare/reference.h"
#include "pipeline/contracts/contract.h"

namespace pipeline::foreign {

// What must hold of any renderer's buffers and does not hold of theirs: the first thing to say of them, as it needs no
// reference.
struct BrokenContract {
    std::string claim, formula;  // "Normals have length 1.", "|N| = 1"
    std::string buffer;          // of theirs, in which it is broken
    std::size_t checked = 0, broken = 0;
    std::string worst;  // "0.83 at pixel 12, 40, off by 0.17"
};
// Their buffers as contracts are evaluated on them, each as exact as its file. It reads the reference's frame.
ContractInput theirInput(const Conventions& conventions, const Reference& reference);

// Of the buffers that were handed in, those that more than one element in a hundred breaks.
std::vector<BrokenContract> brokenContracts(const Conventions& conventions, const Reference& reference,
                                            const Stop& stop);
// "Normals have length 1.: holds in 63 % of normal; 0.83 at pixel 12, 40"
std::string contractText(const BrokenContract& contract);

}  // namespace pipeline::foreign
