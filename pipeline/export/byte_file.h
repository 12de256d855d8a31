#pragma once
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

#include "pipeline/core/result.h"

namespace pipeline {

// A new file that bytes are appended to. The first failure is kept; close() tells it, so that a
// writer can go on without looking.
class ByteFile {
public:
    explicit ByteFile(const std::filesystem::path& path);

    void write(std::span<const std::byte> bytes);
    void write(std::string_view text) { write(std::as_bytes(std::span(text))); }
    bool good() const { return m_error == 0; }
    // Brings everything to the disk; gives the number of bytes written.
    Result<std::uint64_t> close();

private:
    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::filesystem::path m_path;
    std::unique_ptr<std::FILE, Closer> m_file;
    std::uint64_t m_size = 0;
    int m_error = 0;  // errno of the first failure
};

}  // namespace pipeline
