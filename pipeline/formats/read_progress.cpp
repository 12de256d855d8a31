#include "pipeline/formats/read_progress.h"

#include <algorithm>

namespace pipeline {

bool ReadMeter::tell(std::size_t at, Errors& errors) {
    if (!m_progress) return true;
    if (m_progress(double(at) / double(std::max<std::size_t>(m_size, 1)), m_file)) {
        m_next = at < m_size ? std::min(at + m_size / 200 + 1, m_size) : at + 1;  // the end is told of too
        return true;
    }
    m_next = 0;
    if (errors.size() < kMaxErrors) errors.push_back({{m_file, 0, 0}, "reading was given up"});
    return false;
}

}  // namespace pipeline
