#include "pipeline/formats/text/line_scanner.h"

#include <algorithm>

#include "pipeline/formats/text/text_scanner.h"

namespace pipeline {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// Of most characters the first comparison is the only one. Files that were copied in blocks end with bytes of 0, files of
// old editors with 26.
bool isSpace(char c) {
    return static_cast<unsigned char>(c) <= ' ' &&
           (c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0' || c == '\x1A');
}

}  // namespace

LineScanner::LineScanner(std::string_view text, std::string file, Errors& errors, ReadProgress progress)
    : m_text(text), m_file(std::move(file)), m_errors(errors), m_meter(text.size(), m_file, std::move(progress)) {
    if (text.starts_with(kByteOrderMark)) m_next = kByteOrderMark.size();
}

LineScanner::LineScanner(ByteWindow& window, std::string file, Errors& errors, ReadProgress progress)
    : LineScanner(window.view(), std::move(file), errors, {}) {
    m_window = &window;
    m_before = window.begin();
    m_meter = ReadMeter(window.size(), m_file, std::move(progress));
}

// This line stays, for an error may name a place in it still.
bool LineScanner::readOn() {
    const std::size_t gone = m_lineBegin;
    if (!m_window || !m_window->readOn(m_before + gone)) return false;
    for (std::size_t* place : {&m_next, &m_begin, &m_end, &m_lineEnd, &m_lineBegin, &m_countedTo}) *place -= gone;
    m_before = m_window->begin(), m_text = m_window->view();
    m_newline = 0;
    return true;
}

bool LineScanner::nextLine() {
    if (m_errors.size() >= kMaxErrors) return false;
    if (!m_meter.goesOn(m_before + std::min(m_next, m_text.size()), m_errors)) return false;
    std::size_t end = 0;
    do {
        // A text whose lines all end with CR is searched for LF once.
        if (m_newline < m_next || m_newline == 0) m_newline = std::min(m_text.find('\n', m_next), m_text.size());
        const std::string_view line = m_text.substr(std::min(m_next, m_text.size()), m_newline - m_next);
        end = m_next + std::min(line.find('\r'), line.size());
        // A line that ends with the piece may go on in the next one; so may CR LF.
    } while (end + 1 >= m_text.size() && readOn());
    if (m_next >= m_text.size()) return false;
    m_lineBegin = m_begin = m_end = m_next, m_lineEnd = end;
    m_countedTo = m_lineBegin, m_counted = 0;
    m_line = m_nextLine++;
    if (end == m_text.size() && m_window && !m_window->atEnd()) {
        fail("found a line of more than " + groupedDigits(kMaxFileBytes) + " bytes");
        return false;
    }
    m_next = m_lineEnd + (m_text.substr(m_lineEnd, 2) == "\r\n" ? 2 : 1);
    return true;
}

std::string_view LineScanner::peek() const {
    LineScanner ahead(*this);
    ahead.m_window = nullptr;
    return ahead.next();
}

std::string_view LineScanner::next() {
    if (!m_meter.goesOn(at(), m_errors)) {
        m_begin = m_end = m_lineEnd;
        return {};
    }
    while (true) {
        while (m_end < m_lineEnd && isSpace(m_text[m_end])) ++m_end;
        const bool continued = m_end + 1 == m_lineEnd && m_text[m_end] == '\\';
        if (!continued) break;
        if (!nextLine()) {
            m_begin = m_end = m_lineEnd;
            return {};
        }
    }
    if (m_end < m_lineEnd && m_text[m_end] == '#') m_end = m_lineEnd;
    const std::string_view line = m_text.substr(0, m_lineEnd);
    std::size_t end = m_begin = m_end;
    while (end < line.size() && !isSpace(line[end])) ++end;
    if (end == line.size() && end > m_begin && line[end - 1] == '\\') --end;  // it continues the line
    m_end = end;
    return line.substr(m_begin, end - m_begin);
}

std::string_view LineScanner::rest() {
    m_begin = m_end;
    while (m_begin < m_lineEnd && isSpace(m_text[m_begin])) ++m_begin;
    m_end = m_lineEnd;
    while (m_end > m_begin && isSpace(m_text[m_end - 1])) --m_end;
    return m_text.substr(m_begin, m_end - m_begin);
}

TextPosition LineScanner::place() const {
    if (m_begin < m_countedTo) m_countedTo = m_lineBegin, m_counted = 0;
    const std::string_view between = m_text.substr(m_countedTo, m_begin - m_countedTo);
    m_counted += static_cast<std::size_t>(
        std::ranges::count_if(between, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
    m_countedTo = m_begin;
    return {m_line, static_cast<int>(m_counted) + 1};
}

void LineScanner::refuse(std::string expected) {
    const std::string_view word = m_text.substr(m_begin, m_end - m_begin);
    fail(word.empty()             ? "found the end of the line"
         : word.size() > kMaxWord ? "found a word of " + groupedDigits(word.size()) + " bytes"
                                  : "found " + quotedInput(word),
         std::move(expected));
}

void LineScanner::fail(std::string found, std::string expected) {
    if (m_errors.size() >= kMaxErrors) return;
    const TextPosition at = place();
    m_errors.push_back({{m_file, at.line, at.column}, std::move(found), std::move(expected)});
}

}  // namespace pipeline
