#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "pipeline/formats/scene_folder.h"

namespace pipeline {

// A file as a reader goes through it from its beginning to its end: of a large one only a piece from where the reader
// has got to on is in memory.
class ByteWindow {
public:
    // `source` must outlive the window.
    explicit ByteWindow(const SourceText& source)
        : m_view(source.text),
          m_tail(source.tail.get()),
          m_size(source.text.size() + (source.tail ? source.tail->size() : 0)) {}
    ByteWindow(const ByteWindow&) = delete;
    ByteWindow& operator=(const ByteWindow&) = delete;

    // The piece, until the next call of anything that reads on.
    std::string_view view() const { return m_view; }
    // Bytes of the file before the piece.
    std::size_t begin() const { return m_begin; }
    // Whether the file ends with the piece.
    bool atEnd() const { return m_tail == nullptr; }
    // Of the file: what the file system said of it, or, where it ended elsewhere, what there was.
    std::size_t size() const { return m_size; }

    // Forgets all before byte `from` of the file, which is in the piece or its end, and reads on. False where nothing
    // follows, and where the piece would be larger than kMaxFileBytes: then it stays what it is.
    bool readOn(std::size_t from);
    // Whether `count` bytes from `at` on are there, at most kMaxFileBytes; then all of them are in the piece. What is
    // before `at` may be forgotten. at: in the piece or after it.
    bool has(std::size_t at, std::size_t count) { return isHere(at, count) || fetch(at, count); }

private:
    bool isHere(std::size_t at, std::size_t count) const {
        return at - m_begin <= m_view.size() && count <= m_view.size() - (at - m_begin);
    }
    bool fetch(std::size_t at, std::size_t count);

    std::string_view m_view;
    FileTail* m_tail;  // null once all has been read
    std::size_t m_begin = 0, m_size;
    std::string m_buffer;
};

}  // namespace pipeline
