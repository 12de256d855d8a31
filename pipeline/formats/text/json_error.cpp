#include "pipeline/formats/text/json_error.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "pipeline/formats/text/stoppable_text.h"

namespace pipeline {
namespace {

using GltfJson = nlohmann::json;

// Where the parser stops; it has no other way to say so without an exception.
class PlaceOfError : public nlohmann::json_sax<GltfJson> {
public:
    std::size_t bytesRead = 0;

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_object(std::size_t) override { return true; }
    bool key(string_t&) override { return true; }
    bool end_object() override { return true; }
    bool start_array(std::size_t) override { return true; }
    bool end_array() override { return true; }
    bool parse_error(std::size_t position, const std::string&, const GltfJson::exception&) override {
        bytesRead = position;
        return false;
    }
};

}  // namespace

std::size_t jsonErrorAt(std::string_view text, const Stop& stop) {
    PlaceOfError place;
    StopCheck check(stop);
    GltfJson::sax_parse(StoppableIterator(text.data(), &check), StoppableIterator(text.data() + text.size(), &check),
                        &place);
    return place.bytesRead == 0 ? text.size() : std::min(place.bytesRead - 1, text.size());
}

TextPosition positionOf(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, byte);
    const std::size_t lineBegin = before.rfind('\n') == before.npos ? 0 : before.rfind('\n') + 1;
    const auto isCharacter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
    return {1 + static_cast<int>(std::ranges::count(before, '\n')),
            1 + static_cast<int>(std::ranges::count_if(before.substr(lineBegin), isCharacter))};
}

}  // namespace pipeline
