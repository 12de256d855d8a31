#include "pipeline/defects/defect_table.h"

#include <algorithm>
#include <vector>

#include "pipeline/defects/defect_rows.h"

namespace pipeline {

std::span<const DefectRow> defectTable() {
    static const std::vector<DefectRow> kTable = [] {
        std::vector<DefectRow> rows;
        for (const std::span<const DefectRow> part : {defectsOfDrawing(), defectsOfShading(), defectsOfRenderers()})
            rows.insert(rows.end(), part.begin(), part.end());
        return rows;
    }();
    return kTable;
}

const DefectRow& defectInfo(Defect defect) { return defectTable()[index(defect) - 1]; }

std::optional<Defect> findDefect(std::string_view id) {
    const auto found = std::ranges::find(kDefectIds, id);
    if (found == kDefectIds.end() || found == kDefectIds.begin()) return std::nullopt;
    return static_cast<Defect>(found - kDefectIds.begin());
}

Scene plant(Scene scene, Defect defect, int way) {
    scene.settings.defect = defect;
    scene.settings.defectWay = way;
    return scene;
}

}  // namespace pipeline
