#include "pipeline/formats/gltf/gltf_value.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/core/index_words.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/lecture/lecture_values.h"
#include "pipeline/formats/model_formats.h"
#include "pipeline/formats/text/bytes.h"
#include "pipeline/formats/text/json_error.h"
#include "pipeline/formats/text/stoppable_text.h"

namespace pipeline {
namespace {

using GltfJson = nlohmann::json;

constexpr std::size_t kMaxDepth = 64, kMaxValues = std::size_t{1} << 22;
constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinChunk = 0x004E4942;  // "glTF", "JSON", "BIN"
constexpr std::size_t kFileHeader = 12, kChunkHeader = 8;                                      // bytes

// `offset`: where the JSON stands in a .glb, whose lines mean nothing.
Error notJson(const SourceText& source, std::string_view json, std::size_t byte, std::string found,
              std::string expected = {}) {
    if (json.size() == source.text.size()) {
        const TextPosition place = positionOf(json, byte);
        return {{source.name, place.line, place.column}, std::move(found), std::move(expected)};
    }
    const std::size_t offset = static_cast<std::size_t>(json.data() - source.text.data());
    return {
        {source.name, 0, 0}, fmt::format("{} at byte {}", found, groupedDigits(offset + byte)), std::move(expected)};
}

// Brackets and commas outside of strings tell the depth and the number of values.
std::optional<Error> checkNesting(const SourceText& source, std::string_view json) {
    std::size_t depth = 0, values = 1;
    bool inString = false;
    StopCheck check(source.progress.stop);
    for (std::size_t i = 0; i < json.size() && !check.stopped(); ++i) {
        const char c = json[i];
        if (inString) {
            if (c == '\\') ++i;
            if (c == '"') inString = false;
        } else if (c == '"') {
            inString = true;
        } else if (c == '[' || c == '{') {
            ++values;
            if (++depth > kMaxDepth)
                return notJson(source, json, i, fmt::format("JSON nests more than {} deep", kMaxDepth));
        } else if (c == ']' || c == '}') {
            if (depth > 0) --depth;
        } else if (c == ',' && ++values > kMaxValues) {
            return notJson(source, json, i, fmt::format("JSON has more than {} values", groupedDigits(kMaxValues)));
        }
    }
    return {};
}

struct Chunks {
    std::string_view json;
    std::optional<std::string_view> binary;
};

Result<Chunks> chunksOf(const SourceText& source) {
    const auto wrong = [&](std::string found, std::string expected = {}) {
        return Error{{source.name, 0, 0}, std::move(found), std::move(expected)};
    };
    const std::string_view bytes = source.text;
    if (!hasBytes(bytes, 0, kFileHeader)) return wrong(fmt::format("the file ends after {} bytes", bytes.size()));
    if (const auto version = numberAt<std::uint32_t>(bytes, 4); version != 2)
        return wrong(fmt::format("the file is of version {} of binary glTF", version), "version 2");
    const std::size_t length = numberAt<std::uint32_t>(bytes, 8);
    if (length > bytes.size())
        return wrong(fmt::format("{} bytes announced, the file ends after {}", groupedDigits(length),
                                 groupedDigits(bytes.size())));
    Chunks chunks;
    std::size_t at = kFileHeader;
    for (int count = 0; length - std::min(at, length) >= kChunkHeader && count < 2; ++count) {
        const std::size_t size = numberAt<std::uint32_t>(bytes, at);
        const auto type = numberAt<std::uint32_t>(bytes, at + 4);
        at += kChunkHeader;
        if (size > length - at)
            return wrong(fmt::format("a chunk of {} bytes announced at byte {}, the file ends after {}",
                                     groupedDigits(size), groupedDigits(at - kChunkHeader), groupedDigits(length)));
        if (count == 0 && type != kJsonChunk) break;
        if (count == 0) chunks.json = bytes.substr(at, size);
        if (count == 1 && type == kBinChunk) chunks.binary = bytes.substr(at, size);
        at += size;
    }
    while (chunks.json.ends_with('\0')) chunks.json.remove_suffix(1);  // padding that should be spaces
    if (!chunks.json.data()) return wrong("the file's first chunk is not JSON", "a JSON chunk");
    return chunks;
}

// A whole number, however it is written: JSON has no integers, and 12, 12.0 and 1.2e1 are the same number (RFC 8259,
// section 6).
std::optional<std::uint64_t> wholeNumber(const GltfJson& value) {
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    if (!value.is_number()) return {};
    const double number = value.get<double>();
    constexpr double kEnd = 18446744073709551616.0;  // 2^64
    if (!(number >= 0 && number < kEnd) || number != std::floor(number)) return {};
    return static_cast<std::uint64_t>(number);
}

// A value for a message, short whatever it is.
std::string shown(const GltfJson& value) {
    if (value.is_string()) return quotedInput(value.get_ref<const std::string&>());
    if (value.is_object()) return "an object";
    if (value.is_array()) return fmt::format("an array of {}", value.size());
    if (value.is_number_float()) return shortestText(value.get<double>());
    return value.dump();
}

}  // namespace

Result<GltfFile> parseGltf(const SourceText& source) {
    Chunks chunks{source.text, {}};
    if (hasBytes(source.text, 0, 4) && numberAt<std::uint32_t>(source.text, 0) == kMagic) {
        const Result<Chunks> found = chunksOf(source);
        if (!found) return found.errors();
        chunks = *found;
    }
    if (const auto error = checkNesting(source, chunks.json)) return *error;
    StopCheck check(source.progress.stop);
    const char* const begin = chunks.json.data();
    GltfFile file{source.name, meshFileOf(source),
                  GltfJson::parse(StoppableIterator(begin, &check),
                                  StoppableIterator(begin + chunks.json.size(), &check), nullptr, false),
                  chunks.binary};
    if (source.progress.stop.stop_requested()) return readingStopped(source.name);
    file.check = check;
    if (file.json.is_discarded()) {
        const std::size_t byte = jsonErrorAt(chunks.json, source.progress.stop);
        const bool atEnd = byte == chunks.json.size();
        return notJson(source, chunks.json, byte, atEnd ? "the JSON ends too early" : "this is not JSON",
                       "a glTF file");
    }
    if (!file.json.is_object())
        return notJson(source, chunks.json, 0, fmt::format("the JSON is {}", shown(file.json)), "an object");
    return file;
}

void remark(GltfFile& file, std::string text, std::string_view noun) {
    const auto known = std::ranges::find(file.remarks, text, &GltfRemark::text);
    if (known == file.remarks.end())
        file.remarks.push_back({std::move(text), noun, 1});
    else
        ++known->count;
}

std::vector<Remark> remarksOf(const GltfFile& file) {
    std::vector<Remark> remarks;
    for (const GltfRemark& said : file.remarks) {
        std::string text = said.text.substr(0, said.text.find_last_not_of('.') + 1);
        if (!said.noun.empty()) text += fmt::format(" ({})", plural(std::int64_t(said.count), said.noun));
        remarks.push_back({file.name, text + '.'});
    }
    return remarks;
}

void dropErrors(GltfFile& file, std::size_t from, std::string_view consequence, std::string_view noun) {
    if (file.errors.size() <= from) return;
    const Error& first = file.errors[from];
    const std::string why =
        first.expected.empty() ? first.found : fmt::format("{}, expected {}", first.found, first.expected);
    file.errors.resize(from);
    const auto known = std::ranges::find(file.remarks, consequence, &GltfRemark::consequence);
    if (known == file.remarks.end())
        file.remarks.push_back({fmt::format("{}: {}.", why, consequence), noun, 1, std::string(consequence)});
    else
        ++known->count;
}

GltfValue GltfValue::operator[](std::string_view key) const {
    std::string pointer = fmt::format("{}/{}", m_pointer, key);
    if (!m_json) return {*m_file, nullptr, std::move(pointer)};
    if (!m_json->is_object()) {
        refuse("an object");
        return {*m_file, nullptr, std::move(pointer)};
    }
    const auto found = m_json->find(key);
    return {*m_file, found == m_json->end() ? nullptr : &*found, std::move(pointer)};
}

std::size_t GltfValue::size() const {
    if (!m_json) return 0;
    if (m_json->is_array()) return m_json->size();
    refuse("an array");
    return 0;
}

GltfValue GltfValue::at(std::size_t index) const {
    return {*m_file, &(*m_json)[index], fmt::format("{}/{}", m_pointer, index)};
}

std::optional<std::uint64_t> GltfValue::whole(std::uint64_t min, std::uint64_t max) const {
    if (!m_json) return {};
    if (const auto value = wholeNumber(*m_json); value && *value >= min && *value <= max) return value;
    refuse(fmt::format("a whole number from {} to {}", groupedDigits(min), groupedDigits(max)));
    return {};
}

std::optional<double> GltfValue::number(double min, double max) const {
    if (!m_json) return {};
    if (m_json->is_number())
        if (const auto value = m_json->get<double>(); value >= min && value <= max) return value;
    refuse(numberFrom(min, max));
    return {};
}

bool GltfValue::numbers(std::span<double> values, double min, double max) const {
    if (!m_json) return true;
    if (!m_json->is_array() || m_json->size() != values.size()) {
        refuse(fmt::format("an array of {} numbers", values.size()));
        return false;
    }
    std::vector<double> read;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::optional<double> value = at(i).number(min, max);
        if (!value) return false;
        read.push_back(*value);
    }
    std::ranges::copy(read, values.begin());
    return true;
}

std::optional<std::string_view> GltfValue::text() const {
    if (!m_json) return {};
    if (m_json->is_string()) return std::string_view(m_json->get_ref<const std::string&>());
    refuse("a string");
    return {};
}

std::optional<bool> GltfValue::truth() const {
    if (!m_json) return {};
    if (m_json->is_boolean()) return m_json->get<bool>();
    refuse("true or false");
    return {};
}

std::optional<GltfValue> GltfValue::element(std::string_view list) const {
    if (!m_json) return {};
    const GltfValue elements = GltfValue(*m_file)[list];
    const std::size_t count = elements.size();
    if (const auto value = wholeNumber(*m_json); value && *value < count)
        return elements.at(static_cast<std::size_t>(*value));
    refuse(count == 0 ? fmt::format("no index: there are no {}", list)
                      : fmt::format("an index of {}, {}", list, indexWords(count, "")));
    return {};
}

void GltfValue::refuse(std::string expected) const {
    fail(m_json ? fmt::format("{} is {}", m_pointer.empty() ? "the JSON" : m_pointer.c_str(), shown(*m_json))
                : fmt::format("{} is missing", m_pointer),
         std::move(expected));
}

void GltfValue::fail(std::string found, std::string expected) const {
    Error error{{m_file->name, 0, 0}, std::move(found), std::move(expected)};
    Errors& errors = m_file->errors;
    // What several places look at is reported once.
    if (errors.size() < kMaxErrors && std::ranges::find(errors, error) == errors.end())
        errors.push_back(std::move(error));
}

}  // namespace pipeline
