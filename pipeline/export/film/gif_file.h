#pragma once
#include <filesystem>
#include <memory>

#include "pipeline/buffers/buffer2d.h"
#include "pipeline/core/real.h"
#include "pipeline/core/result.h"

namespace pipeline {

// An animated GIF that begins again when it ends. Pictures are added one by one; each has colours of its own, 256 of
// them at most: exact where it has no more, else by the median cut of giflib. The first failure is kept; close() tells
// it, so that a writer can go on without looking.
class GifFile {
public:
    GifFile(const std::filesystem::path& path, glm::ivec2 size);
    ~GifFile();
    GifFile(const GifFile&) = delete;
    GifFile& operator=(const GifFile&) = delete;

    // picture: of the file's size. milliseconds: how long it stays, rounded to hundredths of a second.
    void add(const Buffer2D<Color8>& picture, int milliseconds);
    // The size of the file in bytes.
    Result<std::uint64_t> close();

private:
    struct Inside;
    std::unique_ptr<Inside> m_inside;
};

}  // namespace pipeline
