#include "pipeline/contracts/contract_data.h"

namespace pipeline {

std::span<const Contract> contractTable() {
    static const std::vector<Contract> all = [] {
        std::vector<Contract> rows;
        for (const auto& part : {geometryContracts(), drawingContracts(), vectorContracts(), termContracts()})
            rows.insert(rows.end(), part.begin(), part.end());
        return rows;
    }();
    return all;
}

const Contract* findContract(std::string_view id) {
    for (const Contract& contract : contractTable())
        if (contract.id == id) return &contract;
    return nullptr;
}

}  // namespace pipeline
