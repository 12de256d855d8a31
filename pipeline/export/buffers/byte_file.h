#pragma once
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

#include "pipeline/core/result.h"

namespace pipeline {

// While one lives, writers of files in this thread ask it whether to go on: exporters are rows of a table and get a buffer
// alone. Who has said no is not asked again.
class WriterWatch {
public:
    explicit WriterWatch(std::function<bool()> goesOn) : m_outer(s_innermost), m_goesOn(std::move(goesOn)) {
        s_innermost = this;
    }
    ~WriterWatch() { s_innermost = m_outer; }
    WriterWatch(const WriterWatch&) = delete;
    WriterWatch& operator=(const WriterWatch&) = delete;

    // Whether the innermost one asks to give up; asked after every kItems items: bytes or pixels.
    static bool stopped(std::size_t items) {
        WriterWatch* const watch = s_innermost;
        if (!watch || watch->m_stopped) return watch != nullptr;
        watch->m_items += items;
        if (watch->m_items < kItems) return false;
        watch->m_items = 0;
        return watch->m_stopped = !watch->m_goesOn();
    }
    static constexpr std::size_t kItems = std::size_t{1} << 18;

private:
    static inline thread_local WriterWatch* s_innermost = nullptr;

    WriterWatch* m_outer;
    std::function<bool()> m_goesOn;
    std::size_t m_items = 0;
    bool m_stopped = false;
};

// A new file that bytes are appended to. The first failure is kept; close() tells it, so that a
// writer can go on without looking. ECANCELED where a WriterWatch asks to give up.
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
