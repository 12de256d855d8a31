#include <fmt/format.h>
#include <openssl/evp.h>

#include "pipeline/export/html_text.h"

namespace pipeline {

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
