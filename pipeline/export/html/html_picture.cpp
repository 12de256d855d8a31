#include <fmt/format.h>

#include <cstdint>

#include "pipeline/export/html/html_text.h"

namespace pipeline {

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        std::uint32_t three = 0;
        for (std::size_t i = 0; i < 3; ++i)
            three = three << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0u);
        for (std::size_t i = 0; i < 4; ++i) text += at + i <= bytes.size() ? kDigits[three >> (18 - 6 * i) & 63] : '=';
    }
    return text;
}

std::string base85(std::string_view bytes) {
    constexpr std::string_view kNoDigits = "\"$&'<>@\\`";
    std::string digits, text;
    for (char c = '!'; c <= '~'; ++c)
        if (kNoDigits.find(c) == kNoDigits.npos) digits += c;
    for (std::size_t at = 0; at < bytes.size(); at += 4) {
        std::uint32_t four = 0;
        for (std::size_t i = 0; i < 4; ++i)
            four = four << 8 | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0u);
        std::string group(5, ' ');
        for (std::size_t i = 5; i-- > 0; four /= 85) group[i] = digits[four % 85];
        text.append(group, 0, bytes.size() - at + 1);
    }
    return text;
}

std::string imageSource(std::string_view type, std::string_view bytes) {
    return fmt::format("data:image/{};base64,{}", type, base64(bytes));
}

}  // namespace pipeline
