#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "pipeline/scene/rules.h"

namespace pipeline {

// What a stage carries out of the parts that it declares: all of them by default. The plan leaves parts out, which changes
// nothing that is asked for. A part that the stage leaves out element by element is here only where it is not to.
struct Parts {
    PartSet whole = PartSet::all();
    std::vector<PartSet> lights{};  // per light; empty: as `whole`

    bool operator[](Part part) const { return whole[part]; }
    bool of(Part part, std::size_t light) const { return lights.empty() ? whole[part] : lights[light][part]; }
    std::ptrdiff_t count(Part part) const {  // of the lights
        return std::ranges::count_if(lights, [part](PartSet one) { return one[part]; });
    }
    bool operator==(const Parts&) const = default;
};

}  // namespace pipeline
