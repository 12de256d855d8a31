#pragma once
#include <sys/resource.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

// Reading back what the program writes, without any of its code.
namespace test {

// An empty folder of its own; gone with its contents at the end of the test.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return m_path; }
    std::filesystem::path operator/(const std::string& name) const { return m_path / name; }
    std::vector<std::string> names() const;  // of everything in it, hidden files included, sorted

private:
    std::filesystem::path m_path;
};

// Until its end no file grows beyond so many bytes: that fails the same calls as a full disk.
class FullDisk {
public:
    explicit FullDisk(std::size_t bytes);
    ~FullDisk();
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit m_before{};
    void (*m_handler)(int);
};

std::string readText(const std::filesystem::path& file);
void writeText(const std::filesystem::path& file, const std::string& text);

// NumPy's format 1.0, little-endian, C order.
struct Npy {
    std::string descr;  // "<f4"; empty when the file is not one
    std::vector<std::size_t> shape;
    std::vector<double> values;
    std::size_t dataOffset = 0;  // bytes
};
Npy readNpy(const std::filesystem::path& file);

struct Png {
    int width = 0, height = 0;                 // 0 when the file is not one
    std::vector<std::uint8_t> rgb;             // row by row from the top
    std::map<std::string, std::string> texts;  // tEXt chunks
    int at(int x, int y, int channel) const { return rgb[std::size_t((y * width + x) * 3 + channel)]; }
};
Png readPng(const std::filesystem::path& file);

}  // namespace test
