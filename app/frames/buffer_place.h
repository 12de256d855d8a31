#pragma once
#include "pipeline/buffers/any_buffer.h"

namespace app {

// Where its numbers stand. Buffers are immutable: while one is kept, its place holds one content.
inline const void* placeOf(const pipeline::AnyBuffer& buffer) {
    return std::visit([](const auto& numbers) { return static_cast<const void*>(numbers.data()); }, buffer.data);
}

}  // namespace app
