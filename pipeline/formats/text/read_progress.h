#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "pipeline/core/result.h"
#include "pipeline/core/stop.h"

namespace pipeline {

// For whoever waits for a file.
struct ReadProgress {
    std::function<void(double share, std::string_view file)> tell = {};  // how far it has been read, 0 to 1
    Stop stop = {};  // ends the reading and all that makes meshes of what was read; then there is no result
};

// What a stopped reading says instead of a result.
Error readingStopped(std::string file);

// Tells of a loop over a file's bytes some hundred times, whatever its length, and knows whether to go on.
class ReadMeter {
public:
    ReadMeter(std::size_t size, std::string file, ReadProgress progress)
        : m_size(size), m_file(std::move(file)), m_progress(std::move(progress)) {}

    // False once reading was stopped: reported to `errors`, so that nothing half read is taken for a file.
    // at: up to the size; there once, when all has been read.
    bool goesOn(std::size_t at, Errors& errors) { return at < m_next || tell(at, errors); }

private:
    bool tell(std::size_t at, Errors& errors);

    std::size_t m_size, m_next = 0, m_nextTold = 0, m_looked = 0;
    std::string m_file;
    ReadProgress m_progress;
    StopCheck m_check{m_progress.stop};
};

}  // namespace pipeline
