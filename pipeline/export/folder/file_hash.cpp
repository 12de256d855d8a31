#include "pipeline/export/folder/file_hash.h"

// The functions of OpenSSL 1.1, which allocate nothing: those of 3.0 look their algorithm up in a library that ends the
// program where it gets no memory.
#define OPENSSL_API_COMPAT 0x10101000L
#include <openssl/sha.h>

#include <array>
#include <fstream>

namespace pipeline {

namespace {

class Hash {
public:
    Hash() { SHA256_Init(&m_state); }
    void add(std::string_view bytes) { SHA256_Update(&m_state, bytes.data(), bytes.size()); }
    std::string text() {
        std::array<unsigned char, SHA256_DIGEST_LENGTH> digest;
        SHA256_Final(digest.data(), &m_state);
        constexpr std::string_view kDigits = "0123456789abcdef";
        std::string text;
        for (const unsigned char byte : digest) {
            text += kDigits[byte >> 4];
            text += kDigits[byte & 15];
        }
        return text;
    }

private:
    SHA256_CTX m_state;
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

std::string sha256Of(std::string_view bytes) {
    Hash hash;
    hash.add(bytes);
    return hash.text();
}

}  // namespace pipeline
