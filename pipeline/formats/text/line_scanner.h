#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "pipeline/core/result.h"
#include "pipeline/formats/text/byte_window.h"
#include "pipeline/formats/text/read_progress.h"
#include "pipeline/scene/mesh/mesh.h"

namespace pipeline {

// Splits a text into lines, and lines into words, as the model formats in text form are written:
// white space stands between words, # at the start of a word begins a comment, a backslash at the
// end of a line continues it. Lines end with LF, CR LF or CR; a byte order mark is skipped.
class LineScanner {
public:
    // Errors are appended to `errors` until there are kMaxErrors. `text` must outlive the scanner.
    LineScanner(std::string_view text, std::string file, Errors& errors, ReadProgress progress = {});
    // Of a file's text from the window's beginning on. It reads on there, so that what next and rest gave is gone once
    // nextLine is called, or next at the end of a line that is continued.
    LineScanner(ByteWindow& window, std::string file, Errors& errors, ReadProgress progress = {});

    // Goes to the next line; false at the end of the text, when there are enough errors, or when reading was given up.
    bool nextLine();
    // The next word of this line; empty at its end.
    std::string_view next();
    // The same without going there. A continued line ends where the piece of a window does.
    std::string_view peek() const;
    // The rest of this line without white space at its ends: names may hold spaces.
    std::string_view rest();
    // The next word is the first of `text`, an end of what rest has just given.
    void goBackTo(std::string_view text) { m_end = static_cast<std::size_t>(text.data() - m_text.data()); }

    // Of the word read last.
    TextPosition place() const;
    int line() const { return m_line; }
    // Bytes of the text before what follows the word read last, and before the next line.
    std::size_t at() const { return m_before + m_end; }
    std::size_t nextLineAt() const { return m_before + m_next; }

    // Reports the word read last, or the end of the line: found "x4", expected what.
    void refuse(std::string expected);
    void fail(std::string found, std::string expected = {});

private:
    LineScanner(const LineScanner&) = default;
    bool readOn();

    ByteWindow* m_window = nullptr;  // null: all of the text is here
    std::string_view m_text;         // places count from its beginning
    std::size_t m_before = 0;        // bytes before it
    std::string m_file;
    Errors& m_errors;
    ReadMeter m_meter;
    std::size_t m_next = 0;              // where the next line begins
    std::size_t m_newline = 0;           // the first LF from there on
    std::size_t m_begin = 0, m_end = 0;  // the word read last
    std::size_t m_lineEnd = 0;           // of this line as written, without its end mark
    std::size_t m_lineBegin = 0;
    // A place of this line that was asked for, and the characters before it: all of a file may stand on one line, and
    // counting from its beginning for each of its polygons would take the time of its square.
    mutable std::size_t m_countedTo = 0, m_counted = 0;
    int m_line = 0;      // of the word read last
    int m_nextLine = 1;  // number of the line at m_next
};

}  // namespace pipeline
