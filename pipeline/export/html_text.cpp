#include "pipeline/export/html_text.h"

#include <fmt/format.h>
#include <openssl/evp.h>

namespace pipeline {

std::string escapedHtml(std::string_view text) {
    std::string html;
    for (const char c : text) {
        switch (c) {
            case '&': html += "&amp;"; break;
            case '<': html += "&lt;"; break;
            case '>': html += "&gt;"; break;
            case '"': html += "&quot;"; break;
            case '\'': html += "&#39;"; break;
            default: html += c;
        }
    }
    return html;
}

std::string element(std::string_view tag, std::string_view text) {
    return fmt::format("<{}>{}</{}>", tag, escapedHtml(text), tag.substr(0, tag.find(' ')));
}

std::string base64(std::string_view bytes) {
    std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0');  // and the terminating 0 that is written
    EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), reinterpret_cast<const unsigned char*>(bytes.data()),
                    static_cast<int>(bytes.size()));
    text.pop_back();
    return text;
}

std::string imageSource(std::string_view type, std::string_view bytes) {
    return fmt::format("data:image/{};base64,{}", type, base64(bytes));
}

}  // namespace pipeline
