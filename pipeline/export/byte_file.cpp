#include "pipeline/export/byte_file.h"

#include <unistd.h>

#include <cerrno>

#include "pipeline/export/exporter.h"

namespace pipeline {

ByteFile::ByteFile(const std::filesystem::path& path) : m_path(path), m_file(std::fopen(path.c_str(), "wbx")) {
    if (!m_file) m_error = errno;
}

void ByteFile::write(std::span<const std::byte> bytes) {
    if (m_error != 0 || bytes.empty()) return;
    if (std::fwrite(bytes.data(), 1, bytes.size(), m_file.get()) == bytes.size())
        m_size += bytes.size();
    else
        m_error = errno;
}

Result<std::uint64_t> ByteFile::close() {
    if (m_error == 0 && (std::fflush(m_file.get()) != 0 || ::fsync(::fileno(m_file.get())) != 0)) m_error = errno;
    m_file.reset();
    if (m_error != 0) return writeError(m_path, m_error);
    return m_size;
}

}  // namespace pipeline
