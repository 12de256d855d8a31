#include "pipeline/export/exr_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <vector>

#include "pipeline/export/byte_file.h"

namespace pipeline {

namespace {

// OpenEXR goes back to fill in where each line begins, so the file is put together in memory.
class MemoryStream : public Imf::OStream {
public:
    MemoryStream() : OStream("memory") {}
    void write(const char bytes[], int count) override {
        if (m_at + std::size_t(count) > m_bytes.size()) m_bytes.resize(m_at + std::size_t(count));
        std::copy_n(bytes, count, m_bytes.begin() + std::ptrdiff_t(m_at));
        m_at += std::size_t(count);
    }
    std::uint64_t tellp() override { return m_at; }
    void seekp(std::uint64_t position) override { m_at = position; }
    std::string_view bytes() const { return {m_bytes.data(), m_bytes.size()}; }

private:
    std::vector<char> m_bytes;
    std::size_t m_at = 0;
};

std::vector<const char*> channelNames(const BufferInfo& info) {
    if (info.channels == 1) return {std::isinf(info.neutral) ? "Z" : "Y"};
    return info.palette == Palette::Color ? std::vector{"R", "G", "B"} : std::vector{"X", "Y", "Z"};
}

}  // namespace

std::uint64_t exrEstimate(const AnyBuffer& buffer) { return 500 + buffer.count() * 2; }

Result<std::uint64_t> writeExr(const ExportItem& item, const std::filesystem::path& file) {
    const AnyBuffer& buffer = item.buffer;
    std::vector<float> numbers(buffer.count());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<float>(buffer.flat(i));

    MemoryStream stream;
    try {
        Imf::Header header(static_cast<int>(buffer.columns()), static_cast<int>(buffer.rows()));
        header.compression() = Imf::ZIP_COMPRESSION;
        header.insert("name", Imf::StringAttribute(buffer.name.text()));
        header.insert("unit", Imf::StringAttribute(std::string(buffer.info->unit)));
        header.insert("space", Imf::StringAttribute(std::string(buffer.info->space)));
        Imf::FrameBuffer pixels;
        const std::size_t step = sizeof(float) * std::size_t(buffer.channels());
        float* first = numbers.data();
        for (const char* name : channelNames(*buffer.info)) {
            header.channels().insert(name, Imf::Channel(Imf::FLOAT));
            pixels.insert(name,
                          Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(first++), step, step * buffer.columns()));
        }
        Imf::OutputFile out(stream, header);
        out.setFrameBuffer(pixels);
        out.writePixels(static_cast<int>(buffer.rows()));
    } catch (const std::exception& problem) {  // OpenEXR reports no other way
        return Error{{file.string()}, std::string("could not write: ") + problem.what(), {}};
    }
    ByteFile out(file);
    out.write(stream.bytes());
    return out.close();
}

}  // namespace pipeline
