#pragma once
#include <span>

#include "pipeline/contracts/contract.h"
#include "pipeline/export/json/json_value.h"

namespace pipeline {

// An array of objects: "contract" and "light", "stage", "formula", "checked", "hold" and the "worst" with its place, value,
// error and bound; of a contract that says nothing "why" in place of these. everything false: those alone that were checked.
Json toJson(std::span<const ContractResult> results, const ContractInput& input, bool everything);

}  // namespace pipeline
