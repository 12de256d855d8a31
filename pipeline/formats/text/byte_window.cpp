#include "pipeline/formats/text/byte_window.h"

#include <algorithm>

namespace pipeline {

bool ByteWindow::readOn(std::size_t from) {
    const std::size_t left = m_view.size() - (from - m_begin);
    if (!m_tail || left >= kMaxFileBytes) return false;
    std::string next;
    // As much again as there is, so that a long line is copied a few times only.
    const bool more = m_tail->read(next, std::min(std::max(m_tail->piece(), left), kMaxFileBytes - left));
    if (!more) m_tail = nullptr, m_size = m_begin + m_view.size() + next.size();
    if (next.empty()) return false;
    next.insert(0, m_view.substr(from - m_begin));
    m_buffer = std::move(next);
    m_begin = from, m_view = m_buffer;
    return true;
}

bool ByteWindow::fetch(std::size_t at, std::size_t count) {
    while (!isHere(at, count))
        if (!readOn(std::min(at, m_begin + m_view.size()))) return false;
    return true;
}

}  // namespace pipeline
