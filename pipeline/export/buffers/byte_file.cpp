#include "pipeline/export/buffers/byte_file.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "pipeline/export/buffers/exporter.h"

namespace pipeline {

ByteFile::ByteFile(const std::filesystem::path& path) : m_path(path), m_file(std::fopen(path.c_str(), "wbx")) {
    if (!m_file) m_error = errno;
}

void ByteFile::write(std::span<const std::byte> bytes) {
    while (m_error == 0 && !bytes.empty()) {
        const auto part = bytes.first(std::min(bytes.size(), WriterWatch::kItems));
        if (WriterWatch::stopped(part.size()))
            m_error = ECANCELED;
        else if (std::fwrite(part.data(), 1, part.size(), m_file.get()) != part.size())
            m_error = errno;
        else
            m_size += part.size();
        bytes = bytes.subspan(part.size());
    }
}

Result<std::uint64_t> ByteFile::close() {
    if (m_error == 0 && (std::fflush(m_file.get()) != 0 || ::fsync(::fileno(m_file.get())) != 0)) m_error = errno;
    m_file.reset();
    if (m_error != 0) return writeError(m_path, m_error);
    return m_size;
}

}  // namespace pipeline
