#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/scene/remark.h"

namespace pipeline {

// The cases of one kind that a reader met beside the geometry and went on: how many, and where the first is.
class CaseTally {
public:
    // line: from 1.
    void add(std::string_view file, int line, std::size_t count = 1) {
        if (m_count == 0) m_file = file, m_line = line;
        m_count += count;
    }
    std::size_t count() const { return m_count; }
    std::string about() const;  // "FILE:LINE" of the first

    // Adds "3 NOUNs WHICH are FATE." where there is a case; of a single one "1 NOUN WHICH is FATE.".
    void say(std::string_view noun, std::string_view which, std::string_view fate, std::vector<Remark>& remarks) const;

private:
    std::size_t m_count = 0;
    std::string m_file;
    int m_line = 0;
};

}  // namespace pipeline
