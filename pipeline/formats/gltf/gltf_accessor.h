#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/real.h"
#include "pipeline/formats/gltf/gltf_value.h"

namespace pipeline {

// The bytes of a file's buffers, each loaded when it is first asked for: the BIN chunk, base64 in
// a data: URI, or a file in the model's folder. Any other URI is refused.
class GltfBuffers {
public:
    explicit GltfBuffers(const FileLoader& load) : m_load(load) {}

    // At least as many bytes as the buffer announces. Nothing where there are none; that is reported.
    std::optional<std::string_view> bytes(const GltfValue& buffer);

    // Counts elements that no byte of the file stands for: false, and reported, beyond 2^22 of them.
    bool hasRoomFor(const GltfValue& accessor, std::size_t elements);

    // Of the files that buffers were loaded from.
    std::size_t bytesRead() const { return m_bytesRead; }

private:
    std::optional<std::string_view> load(const GltfValue& buffer);

    const FileLoader& m_load;
    std::size_t m_withoutBytes = 0, m_bytesRead = 0;
    std::map<std::string, std::string> m_contents;                   // by the buffer's pointer
    std::map<std::string, std::optional<std::string_view>> m_bytes;  // likewise
};

// An accessor all of whose elements lie within their buffers.
struct GltfAccessor {
    std::string pointer;     // "/accessors/3"
    std::string_view bytes;  // from the first element on; empty: all elements are 0
    std::size_t count = 0, stride = 0;
    std::uint64_t componentType = 0;  // 5120 to 5126
    bool normalized = false;
    // Elements that have other values than those, and these values, one after the other.
    std::vector<std::uint32_t> replaced{};  // rising
    std::string_view replacements{};
    std::size_t elementBytes = 0;

    // glTF 2.0, section 3.11: integers stand for themselves, normalised ones for c / largest.
    double component(std::size_t element, std::size_t index) const;
};

// The accessor that `index` names, with so many components an element. Nothing where it is not as
// it must be; that is reported.
std::optional<GltfAccessor> accessorAt(const GltfValue& index, std::string_view type, GltfBuffers& buffers);

// Whole numbers below `end`; an element that is not one is reported.
std::optional<std::vector<std::uint32_t>> readIndices(GltfFile& file, const GltfAccessor& accessor, std::size_t end);
// Three components an element, each of them a model's coordinate.
std::optional<std::vector<Vec3d>> readVectors(GltfFile& file, const GltfAccessor& accessor);

}  // namespace pipeline
