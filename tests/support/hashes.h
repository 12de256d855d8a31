#pragma once
#include <string>
#include <variant>

#include "pipeline/buffers/any_buffer.h"
#include "pipeline/export/folder/file_hash.h"

namespace test {

// 16 digits of the SHA-256 of a buffer's type, shape and numbers.
inline std::string hashOf(const pipeline::AnyBuffer& buffer) {
    std::string bytes = buffer.dtype();
    for (const std::size_t size : buffer.shape) bytes += ' ' + std::to_string(size);
    std::visit([&](auto data) { bytes.append(reinterpret_cast<const char*>(data.data()), data.size_bytes()); },
               buffer.data);
    return pipeline::sha256Of(bytes).substr(0, 16);
}

}  // namespace test
