#include "pipeline/export/file_hash.h"

#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>

namespace pipeline {

namespace {

class Hash {
public:
    Hash() : m_context(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
        m_good = m_context && EVP_DigestInit_ex(m_context.get(), EVP_sha256(), nullptr) == 1;
    }
    void add(std::string_view bytes) {
        m_good = m_good && EVP_DigestUpdate(m_context.get(), bytes.data(), bytes.size()) == 1;
    }
    std::optional<std::string> text() {
        std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
        unsigned size = 0;
        if (!m_good || EVP_DigestFinal_ex(m_context.get(), digest.data(), &size) != 1) return std::nullopt;
        constexpr std::string_view kDigits = "0123456789abcdef";
        std::string text;
        for (unsigned i = 0; i < size; ++i) {
            text += kDigits[digest[i] >> 4];
            text += kDigits[digest[i] & 15];
        }
        return text;
    }

private:
    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> m_context;
    bool m_good = false;
};

}  // namespace

std::optional<std::string> sha256(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) return std::nullopt;
    Hash hash;
    std::array<char, 1 << 16> block;
    while (in) {
        in.read(block.data(), block.size());
        hash.add({block.data(), static_cast<std::size_t>(in.gcount())});
    }
    if (!in.eof()) return std::nullopt;
    return hash.text();
}

std::optional<std::string> sha256Of(std::string_view bytes) {
    Hash hash;
    hash.add(bytes);
    return hash.text();
}

}  // namespace pipeline
