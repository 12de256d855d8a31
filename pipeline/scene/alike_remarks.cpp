#include "pipeline/scene/alike_remarks.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace pipeline {

void AlikeRemarks::add(std::string_view kind, std::string name, Remark remark) {
    const auto known = std::ranges::find(m_kinds, kind, &Kind::kind);
    if (known == m_kinds.end()) {
        m_kinds.push_back({std::string(kind), std::move(remark)});
        return;
    }
    if (known->others++ < kNames) known->names.push_back(std::move(name));
}

void AlikeRemarks::moveTo(std::vector<Remark>& remarks) {
    for (Kind& kind : std::exchange(m_kinds, {})) {
        remarks.push_back(std::move(kind.first));
        if (kind.others == 0) continue;
        remarks.back().text += fmt::format(" The same holds for {} more ({}{}).", kind.others,
                                           fmt::join(kind.names, ", "), kind.others > kNames ? ", …" : "");
    }
}

}  // namespace pipeline
