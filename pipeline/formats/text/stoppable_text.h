#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <streambuf>
#include <string_view>

#include "pipeline/core/stop.h"

// A text for the parsers of libraries, which know no stop: once it is asked for, the text ends.
namespace pipeline {

class StoppableBuffer : public std::streambuf {
public:
    StoppableBuffer(std::string_view text, const Stop& stop) : m_text(text), m_check(stop) {}

protected:
    int_type underflow() override {
        m_at += static_cast<std::size_t>(egptr() - eback());
        const std::size_t size = std::min(StopCheck::kItemsPerLook, m_text.size() - m_at);
        if (m_check.stopped(size) || size == 0) return traits_type::eof();
        // Copied, for a streambuf wants bytes that may be written to.
        std::copy_n(m_text.begin() + static_cast<std::ptrdiff_t>(m_at), size, m_piece.begin());
        setg(m_piece.data(), m_piece.data(), m_piece.data() + size);
        return traits_type::to_int_type(m_piece[0]);
    }
    pos_type seekoff(off_type off, std::ios_base::seekdir from, std::ios_base::openmode mode) override {
        const auto here = static_cast<off_type>(m_at) + (gptr() - eback());
        const auto size = static_cast<off_type>(m_text.size());
        return seekpos(off + (from == std::ios_base::cur ? here : from == std::ios_base::end ? size : 0), mode);
    }
    pos_type seekpos(pos_type to, std::ios_base::openmode) override {
        if (off_type(to) < 0 || off_type(to) > static_cast<off_type>(m_text.size())) return off_type(-1);
        m_at = static_cast<std::size_t>(off_type(to));
        setg(nullptr, nullptr, nullptr);
        return to;
    }

private:
    std::string_view m_text;
    StopCheck m_check;
    std::array<char, StopCheck::kItemsPerLook> m_piece{};
    std::size_t m_at = 0;  // of the text, where the bytes at hand begin
};

// Two of them are a range of bytes; it ends where the check says so.
class StoppableIterator {
public:
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;
    using iterator_category = std::input_iterator_tag;

    StoppableIterator(const char* at, StopCheck* check) : m_at(at), m_check(check) {}
    reference operator*() const { return *m_at; }
    StoppableIterator& operator++() { return ++m_at, *this; }
    StoppableIterator operator++(int) {
        StoppableIterator before = *this;
        ++m_at;
        return before;
    }
    friend bool operator==(const StoppableIterator& a, const StoppableIterator& b) {
        return a.m_at == b.m_at || a.m_check->stopped();
    }

private:
    const char* m_at;
    StopCheck* m_check;
};

}  // namespace pipeline
