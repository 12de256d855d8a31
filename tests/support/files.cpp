#include "tests/support/files.h"

#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "shadescope-test-XXXXXX").string();
    m_path = ::mkdtemp(pattern.data());
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
}

std::vector<std::string> TemporaryFolder::names() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(m_path))
        names.push_back(fs::relative(entry.path(), m_path).string());
    std::ranges::sort(names);
    return names;
}

FullDisk::FullDisk(std::size_t bytes) : m_handler(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &m_before);
    const rlimit tight{bytes, m_before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &tight);
}

FullDisk::~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &m_before);
    std::signal(SIGXFSZ, m_handler);
}

std::string readText(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void writeText(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

namespace {

template <class T>
std::vector<double> numbers(std::string_view bytes) {
    std::vector<double> values(bytes.size() / sizeof(T));
    for (std::size_t i = 0; i < values.size(); ++i) {
        T number;
        std::memcpy(&number, bytes.data() + i * sizeof(T), sizeof(T));
        values[i] = static_cast<double>(number);
    }
    return values;
}

std::size_t bigEndian(std::string_view bytes) {
    std::size_t value = 0;
    for (const char c : bytes) value = value << 8 | static_cast<unsigned char>(c);
    return value;
}

}  // namespace

Npy readNpy(const fs::path& file) {
    Npy npy;
    const std::string bytes = readText(file);
    if (bytes.size() < 10 || bytes.substr(0, 8) != std::string("\x93NUMPY\x01\x00", 8)) return npy;
    const std::size_t length = static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
    const std::string header = bytes.substr(10, length);
    // {'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), } and spaces up to a line end.
    const auto between = [&](const std::string& before, const std::string& after) {
        const auto from = header.find(before);
        const auto to = from == header.npos ? from : header.find(after, from + before.size());
        return to == header.npos ? std::string() : header.substr(from + before.size(), to - from - before.size());
    };
    if (!header.ends_with('\n') || between("'fortran_order': ", ",") != "False") return npy;
    npy.descr = between("{'descr': '", "', ");
    std::istringstream lengths(between("'shape': (", "), }"));
    for (std::string number; std::getline(lengths, number, ',');)
        if (number.find_first_not_of(' ') != number.npos) npy.shape.push_back(std::stoul(number));
    npy.dataOffset = 10 + length;
    const std::string_view data = std::string_view(bytes).substr(npy.dataOffset);
    if (npy.descr == "<f4") npy.values = numbers<float>(data);
    if (npy.descr == "<f8") npy.values = numbers<double>(data);
    if (npy.descr == "<i4") npy.values = numbers<std::int32_t>(data);
    if (npy.descr == "|u1") npy.values = numbers<std::uint8_t>(data);
    return npy;
}

Png readPng(const fs::path& file) {
    Png png;
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&image, file.c_str()) == 0) return png;
    image.format = PNG_FORMAT_RGB;
    png.rgb.resize(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, png.rgb.data(), 0, nullptr) == 0) return png;
    png.width = static_cast<int>(image.width);
    png.height = static_cast<int>(image.height);
    // Chunks after the 8 bytes of signature: length, type, data, checksum.
    const std::string bytes = readText(file);
    for (std::size_t at = 8; at + 12 <= bytes.size();) {
        const std::size_t length = bigEndian(std::string_view(bytes).substr(at, 4));
        const std::string data = bytes.substr(at + 8, length);
        if (bytes.substr(at + 4, 4) == "tEXt") png.texts[data.c_str()] = data.substr(data.find('\0') + 1);
        at += 12 + length;
    }
    return png;
}

}  // namespace test
