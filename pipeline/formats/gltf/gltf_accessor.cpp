#include "pipeline/formats/gltf/gltf_accessor.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "pipeline/core/text.h"
#include "pipeline/formats/lecture/lecture_values.h"
#include "pipeline/formats/model_formats.h"
#include "pipeline/formats/text/bytes.h"

namespace pipeline {
namespace {

constexpr std::string_view kData = "data:", kBase64 = ";base64,";

// Ends early where the reading is stopped.
std::optional<std::string> decodeBase64(std::string_view text, StopCheck& check) {
    while (text.ends_with('=')) text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (check.stopped()) break;
        constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        const std::size_t digit = kDigits.find(c);
        if (digit == kDigits.npos) return {};
        bits = (bits << 6 | static_cast<std::uint32_t>(digit)) & 0xFFFFFF;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 0xFF);
    }
    return bytes;
}

// "%20" is a space (RFC 3986, section 2.1). Nothing for a % without two digits.
std::optional<std::string> decodePercent(std::string_view uri) {
    const auto digit = [&](std::size_t i) {
        constexpr std::string_view kDigits = "0123456789ABCDEF0123456789abcdef";
        return i < uri.size() ? kDigits.find(uri[i]) : kDigits.npos;
    };
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            text += uri[i];
            continue;
        }
        const std::size_t high = digit(i + 1), low = digit(i + 2);
        if (high == std::string_view::npos || low == std::string_view::npos) return {};
        text += static_cast<char>(high % 16 * 16 + low % 16);
        i += 2;
    }
    return text;
}

// A path in the model's folder. No scheme, as in http: and file:, nor a drive.
bool isRelativePath(std::string_view name) {
    if (name.empty() || name.find_first_of(":\\") != name.npos || name.starts_with('/')) return false;
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find('/', begin), name.size());
        if (name.substr(begin, end - begin) == "..") return false;
        begin = end + 1;
    }
    return true;
}

struct ComponentType {
    std::uint64_t number;
    std::size_t bytes;
    double largest;  // what stands for 1 when normalised
};
constexpr auto kComponentTypes = std::to_array<ComponentType>(
    {{5120, 1, 127}, {5121, 1, 255}, {5122, 2, 32767}, {5123, 2, 65535}, {5125, 4, 4294967295.0}, {5126, 4, 1}});

const ComponentType* findType(std::uint64_t number) {
    const auto found = std::ranges::find(kComponentTypes, number, &ComponentType::number);
    return found == kComponentTypes.end() ? nullptr : &*found;
}

}  // namespace

std::optional<std::string_view> GltfBuffers::bytes(const GltfValue& buffer) {
    const auto known = m_bytes.find(buffer.pointer());
    if (known != m_bytes.end()) return known->second;
    const auto loaded = load(buffer);
    m_bytes[buffer.pointer()] = loaded;
    return loaded;
}

std::optional<std::string_view> GltfBuffers::load(const GltfValue& buffer) {
    const GltfValue lengthValue = buffer["byteLength"], uriValue = buffer["uri"];
    if (!lengthValue.isThere()) lengthValue.refuse("a number of bytes");
    const auto length = lengthValue.whole(1, kMaxFileBytes);
    if (!length) return {};
    std::string_view bytes;
    if (!uriValue.isThere()) {
        if (!buffer.file().binary || buffer.pointer() != "/buffers/0") {
            uriValue.refuse("a URI; only the first buffer of a .glb has none");
            return {};
        }
        bytes = *buffer.file().binary;
    } else {
        const auto uri = uriValue.text();
        if (!uri) return {};
        std::string& content = m_contents[buffer.pointer()];
        if (uri->starts_with(kData)) {
            const std::size_t base64 = uri->find(kBase64);
            StopCheck& check = buffer.file().check;
            auto decoded =
                base64 == uri->npos ? std::nullopt : decodeBase64(uri->substr(base64 + kBase64.size()), check);
            if (!decoded) {
                uriValue.fail(fmt::format("{} is a data: URI that is not base64", uriValue.pointer()),
                              "data:application/octet-stream;base64,…");
                return {};
            }
            content = std::move(*decoded);
        } else {
            const auto name = decodePercent(*uri);
            if (!name || !isRelativePath(*name)) {
                uriValue.refuse("a file in the model's folder, or a data: URI");
                return {};
            }
            Result<NamedFile> file = m_load(*name);
            if (!file) {
                uriValue.fail(fmt::format("{}: {}", uriValue.pointer(), file.errors()[0].found),
                              file.errors()[0].expected);
                return {};
            }
            content = std::move(std::move(file).value().text);
            m_bytesRead += content.size();
        }
        bytes = content;
    }
    if (bytes.size() < *length) {
        buffer.fail(fmt::format("{} is {}, its data end after {} bytes", lengthValue.pointer(), groupedDigits(*length),
                                groupedDigits(bytes.size())));
        return {};
    }
    return bytes.substr(0, *length);
}

bool GltfBuffers::hasRoomFor(const GltfValue& accessor, std::size_t elements) {
    constexpr std::size_t kMost = std::size_t{1} << 22;
    m_withoutBytes += elements;
    if (m_withoutBytes <= kMost) return true;
    accessor.fail(fmt::format("up to {} the file has {} elements without bytes", accessor.pointer(),
                              groupedDigits(m_withoutBytes)),
                  fmt::format("at most {}", groupedDigits(kMost)));
    return false;
}

double GltfAccessor::component(std::size_t element, std::size_t index) const {
    const ComponentType& type = *findType(componentType);
    std::string_view from = bytes;
    std::size_t at = element * stride;
    if (!replaced.empty()) {
        const auto found = std::ranges::lower_bound(replaced, element);
        if (found != replaced.end() && *found == element) {
            from = replacements;
            at = static_cast<std::size_t>(found - replaced.begin()) * elementBytes;
        }
    }
    if (from.empty()) return 0;
    at += index * type.bytes;
    double value = 0;
    switch (componentType) {
        case 5120: value = numberAt<std::int8_t>(from, at); break;
        case 5121: value = numberAt<std::uint8_t>(from, at); break;
        case 5122: value = numberAt<std::int16_t>(from, at); break;
        case 5123: value = numberAt<std::uint16_t>(from, at); break;
        case 5125: value = numberAt<std::uint32_t>(from, at); break;
        default: return numberAt<float>(from, at);
    }
    return normalized ? std::max(value / type.largest, -1.0) : value;
}

namespace {

// Where elements stand in a buffer.
struct Elements {
    std::string_view bytes;
    std::size_t stride = 0;
};

// `count` elements of so many bytes, from the byteOffset of `of` on in the bufferView that it names. What says so many
// is `countValue`.
std::optional<Elements> elementsOf(const GltfValue& of, const GltfValue& countValue, std::uint64_t count,
                                   std::size_t elementBytes, GltfBuffers& buffers) {
    const GltfValue viewIndex = of["bufferView"];
    if (!viewIndex.isThere()) viewIndex.refuse("a value");
    const auto view = viewIndex.element("bufferViews");
    if (!view) return {};
    const GltfValue bufferIndex = (*view)["buffer"], viewLength = (*view)["byteLength"];
    if (!bufferIndex.isThere()) bufferIndex.refuse("the index of a buffer");
    if (!viewLength.isThere()) viewLength.refuse("a number of bytes");
    const auto buffer = bufferIndex.element("buffers");
    const auto bytes = buffer ? buffers.bytes(*buffer) : std::nullopt;
    const auto length = viewLength.whole(1, kMaxFileBytes);
    // A value that is there and wrong has been reported, and stops here.
    const auto offsetOf = [](const GltfValue& offset) {
        return offset.isThere() ? offset.whole(0, kMaxFileBytes) : std::optional<std::uint64_t>(0);
    };
    const auto viewOffset = offsetOf((*view)["byteOffset"]), offset = offsetOf(of["byteOffset"]);
    const GltfValue strideValue = (*view)["byteStride"];
    // Some write 0 where elements stand one after the other, or the size of an index.
    auto stride = strideValue.isThere() ? strideValue.whole(0, 252) : elementBytes;
    if (!bytes || !length || !viewOffset || !offset || !stride) return {};
    if (*stride == 0) stride = elementBytes;
    if (*stride < elementBytes) {
        strideValue.refuse(fmt::format("at least {}, the bytes of an element of {}", elementBytes, of.pointer()));
        return {};
    }
    if (!hasBytes(*bytes, *viewOffset, *length)) {
        view->fail(fmt::format("{} ends beyond its buffer of {} bytes", view->pointer(), groupedDigits(bytes->size())));
        return {};
    }
    // No sum or product overflows: each factor is below 2^28.
    if (*offset + *stride * (count - 1) + elementBytes > *length) {
        countValue.fail(fmt::format("{} is {}, {} of {} bytes has no room for as many", countValue.pointer(),
                                    groupedDigits(count), view->pointer(), groupedDigits(*length)));
        return {};
    }
    return Elements{bytes->substr(*viewOffset + *offset), static_cast<std::size_t>(*stride)};
}

// Section 3.6.2.3. False where it is not as it must be; that is reported.
bool readSparse(const GltfValue& sparse, GltfAccessor& accessor, GltfBuffers& buffers) {
    const GltfValue countValue = sparse["count"], indices = sparse["indices"], values = sparse["values"];
    const GltfValue typeValue = indices["componentType"];
    for (const GltfValue& needed : {countValue, typeValue, values})
        if (!needed.isThere()) needed.refuse("a value");
    const auto count = countValue.whole(1, accessor.count);
    const auto components = typeValue.whole(0, UINT32_MAX);
    if (!count || !components || !values.isThere()) return false;
    const ComponentType* const type = findType(*components);
    if (!type || (*components != 5121 && *components != 5123 && *components != 5125)) {
        typeValue.refuse("5121, 5123 or 5125 for indices");
        return false;
    }
    const auto at = elementsOf(indices, countValue, *count, type->bytes, buffers);
    const auto with = elementsOf(values, countValue, *count, accessor.elementBytes, buffers);
    if (!at || !with) return false;
    const GltfAccessor list{indices.pointer(), at->bytes, static_cast<std::size_t>(*count), at->stride, *components};
    accessor.replaced.reserve(list.count);
    for (std::size_t i = 0; i < list.count; ++i) {
        const double element = list.component(i, 0);
        if (element >= double(accessor.count) || (i > 0 && element <= accessor.replaced.back())) {
            indices.fail(fmt::format("element {} of {} is {}", i, indices.pointer(), shortestText(element)),
                         fmt::format("numbers that rise, below {}", groupedDigits(accessor.count)));
            return false;
        }
        accessor.replaced.push_back(static_cast<std::uint32_t>(element));
    }
    accessor.replacements = with->bytes;
    return true;
}

}  // namespace

std::optional<GltfAccessor> accessorAt(const GltfValue& index, std::string_view type, GltfBuffers& buffers) {
    const auto value = index.element("accessors");
    if (!value) return {};
    const GltfValue countValue = (*value)["count"], sparse = (*value)["sparse"];
    const GltfValue typeValue = (*value)["type"], componentValue = (*value)["componentType"];
    for (const GltfValue& needed : {countValue, typeValue, componentValue})
        if (!needed.isThere()) needed.refuse("a value");
    const auto count = countValue.whole(1, kMaxVertices);
    const auto components = componentValue.whole(0, UINT32_MAX);
    const auto given = typeValue.text();
    if (!count || !components || !given) return {};

    GltfAccessor accessor;
    accessor.pointer = value->pointer();
    accessor.count = *count;
    accessor.componentType = *components;
    accessor.normalized = (*value)["normalized"].truth().value_or(false);
    const ComponentType* const component = findType(accessor.componentType);
    if (!component) componentValue.refuse("5120, 5121, 5122, 5123, 5125 or 5126");
    if (*given != type) typeValue.refuse(fmt::format("\"{}\" for {}", type, index.pointer()));
    if (!component || *given != type) return {};
    accessor.elementBytes = component->bytes * (type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4);

    // Section 5.1.1, accessor.bufferView: without one all elements are 0.
    if ((*value)["bufferView"].isThere()) {
        const auto elements = elementsOf(*value, countValue, *count, accessor.elementBytes, buffers);
        if (!elements) return {};
        accessor.bytes = elements->bytes;
        accessor.stride = elements->stride;
    } else if (!buffers.hasRoomFor(*value, accessor.count)) {
        return {};
    }
    if (sparse.isThere() && !readSparse(sparse, accessor, buffers)) return {};
    return accessor;
}

std::optional<std::vector<std::uint32_t>> readIndices(GltfFile& file, const GltfAccessor& accessor, std::size_t end) {
    if (accessor.componentType != 5121 && accessor.componentType != 5123 && accessor.componentType != 5125) {
        GltfValue(file).fail(fmt::format("{}/componentType is {}", accessor.pointer, accessor.componentType),
                             "5121, 5123 or 5125 for indices");
        return {};
    }
    std::vector<std::uint32_t> indices;
    indices.reserve(accessor.count);
    for (std::size_t i = 0; i < accessor.count; ++i) {
        if (file.check.stopped()) return {};
        const double value = accessor.normalized ? -1 : accessor.component(i, 0);
        if (!(value >= 0 && value < double(end))) {
            GltfValue(file).fail(fmt::format("element {} of {} is {}", i, accessor.pointer, shortestText(value)),
                                 fmt::format("a vertex index from 0 to {}", end - 1));
            return {};
        }
        indices.push_back(static_cast<std::uint32_t>(value));
    }
    return indices;
}

std::optional<std::vector<Vec3d>> readVectors(GltfFile& file, const GltfAccessor& accessor) {
    std::vector<Vec3d> vectors;
    vectors.reserve(accessor.count);
    for (std::size_t i = 0; i < accessor.count; ++i) {
        if (file.check.stopped()) return {};
        Vec3d& vector = vectors.emplace_back(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            vector[axis] = accessor.component(i, static_cast<std::size_t>(axis));
            if (isCoordinate(vector[axis])) continue;
            GltfValue(file).fail(fmt::format("{} of element {} of {} is {}", "xyz"[axis], i, accessor.pointer,
                                             shortestText(vector[axis])),
                                 numberFrom(-kFarthestVertex, kFarthestVertex));
            return {};
        }
    }
    return vectors;
}

}  // namespace pipeline
