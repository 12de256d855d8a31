#pragma once
#include <istream>
#include <memory>
#include <string>
#include <string_view>

namespace pipeline {

// Text in UTF-16, as some editors and shells of Windows write it (R. Yergeau and P. Hoffman, "UTF-16, an encoding of ISO
// 10646", RFC 2781, 2000).

// Whether it begins with a byte order mark and four characters of ASCII, as every text that is read here does.
bool isUtf16(std::string_view start);

// The same text in UTF-8 without its mark; U+FFFD stands for what is no character. text: isUtf16.
std::string utf8Of(std::string_view text);
// Of a stream at its beginning; read piece by piece.
std::unique_ptr<std::istream> utf8Of(std::unique_ptr<std::istream> stream);

}  // namespace pipeline
