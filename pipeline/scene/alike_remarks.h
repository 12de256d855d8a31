#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/scene/remark.h"

namespace pipeline {

// Remarks that may hold for many objects, or many lights. Those of one kind become one: the first, word by word, and how
// many others it holds for, with the first of their names.
class AlikeRemarks {
public:
    static constexpr std::size_t kNames = 3;  // that are given

    // kind: the same for remarks that differ in names and numbers alone. name: as a sentence calls it.
    void add(std::string_view kind, std::string name, Remark remark);
    // In the order in which the kinds came. Leaves none behind.
    void moveTo(std::vector<Remark>& remarks);

private:
    struct Kind {
        std::string kind;
        Remark first;
        std::vector<std::string> names{};  // of the others, at most kNames
        std::size_t others = 0;
    };
    std::vector<Kind> m_kinds;
};

}  // namespace pipeline
