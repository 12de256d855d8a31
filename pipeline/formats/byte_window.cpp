#include "pipeline/formats/byte_window.h"

#include <algorithm>

namespace pipeline {

bool ByteWindow::readOn(std::size_t from) {
    constexpr std::size_t kPiece = std::size_t{1} << 20;
    const std::size_t left = m_view.size() - (from - m_begin);
    if (!m_tail || left >= kMaxFileBytes) return false;
    if (m_buffer.empty())
        m_buffer = m_view.substr(from - m_begin);
    else
        m_buffer.erase(0, from - m_begin);
    m_begin = from;
    // As much again as there is, so that a long line is copied a few times only.
    const bool more = m_tail->read(m_buffer, std::min(std::max(kPiece, left), kMaxFileBytes - left));
    m_view = m_buffer;
    if (!more) m_tail = nullptr, m_size = m_begin + m_view.size();
    return m_view.size() > left;
}

bool ByteWindow::fetch(std::size_t at, std::size_t count) {
    while (!isHere(at, count))
        if (!readOn(std::min(at, m_begin + m_view.size()))) return false;
    return true;
}

}  // namespace pipeline
