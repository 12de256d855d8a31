#pragma once
#include "pipeline/defects/defect_table.h"

// The parts of the table; defect_table.cpp alone reads it.
namespace pipeline {

std::span<const DefectRow> defectsOfDrawing();    // up to NearSmall
std::span<const DefectRow> defectsOfShading();    // from LRaw
std::span<const DefectRow> defectsOfRenderers();  // from NormalSpace on

inline constexpr std::string_view kOwnJudgement = "own judgement";

constexpr bool areInOrder(std::span<const DefectRow> rows, Defect first) {
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (index(rows[i].id) != index(first) + i) return false;
    return true;
}

}  // namespace pipeline
