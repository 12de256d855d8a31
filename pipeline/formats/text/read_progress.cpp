#include "pipeline/formats/text/read_progress.h"

#include <algorithm>
#include <utility>

namespace pipeline {

Error readingStopped(std::string file) { return {{std::move(file), 0, 0}, "reading was stopped"}; }

bool ReadMeter::tell(std::size_t at, Errors& errors) {
    const bool stopped = m_check.stopped(at - std::exchange(m_looked, at));
    if (stopped || (at >= m_nextTold && m_progress.stop.stop_requested())) {
        m_next = 0;
        if (errors.size() < kMaxErrors) errors.push_back(readingStopped(m_file));
        return false;
    }
    if (at >= m_nextTold) {
        if (m_progress.tell) m_progress.tell(double(at) / double(std::max<std::size_t>(m_size, 1)), m_file);
        m_nextTold = at < m_size ? std::min(at + m_size / 200 + 1, m_size) : at + 1;  // the end is told of too
    }
    m_next = std::min(m_nextTold, at + StopCheck::kItemsPerLook);
    return true;
}

}  // namespace pipeline
