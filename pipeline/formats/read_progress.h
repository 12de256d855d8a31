#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "pipeline/core/result.h"

namespace pipeline {

// How far a file has been read, 0 to 1, for who waits. False: give up; then there is no result.
using ReadProgress = std::function<bool(double share, std::string_view file)>;

// Tells of a loop over a file's bytes some hundred times, whatever its length, and knows whether to go on.
class ReadMeter {
public:
    ReadMeter(std::size_t size, std::string file, ReadProgress progress)
        : m_size(size), m_file(std::move(file)), m_progress(std::move(progress)) {
        if (!m_progress) m_next = size + 1;
    }

    // False once reading was given up: reported to `errors`, so that nothing half read is taken for a file.
    // at: up to the size; there once, when all has been read.
    bool goesOn(std::size_t at, Errors& errors) { return at < m_next || tell(at, errors); }

private:
    bool tell(std::size_t at, Errors& errors);

    std::size_t m_size, m_next = 0;
    std::string m_file;
    ReadProgress m_progress;
};

}  // namespace pipeline
