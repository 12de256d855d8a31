#include "pipeline/export/buffers/exr_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <vector>

#include "pipeline/export/buffers/byte_file.h"

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
    for (std::size_t i = 0; i < numbers.size() && !WriterWatch::stopped(1); ++i)
        numbers[i] = static_cast<float>(buffer.flat(i));

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
        constexpr int kRows = 16;  // which ZIP packs together
        const int rows = static_cast<int>(buffer.rows());
        for (int row = 0; row < rows && !WriterWatch::stopped(kRows * buffer.columns()); row += kRows)
            out.writePixels(std::min(kRows, rows - row));
    } catch (const std::exception& problem) {  // OpenEXR reports no other way
        return Error{{file.string()}, std::string("could not write: ") + problem.what(), {}};
    }
    ByteFile out(file);
    out.write(stream.bytes());
    return out.close();
}

Result<AnyBuffer> readExr(const std::filesystem::path& file, const AnyBuffer& like) {
    const auto wrong = [&](std::string found, std::string expected) {
        return Error{{file.string()}, std::move(found), std::move(expected)};
    };
    try {
        Imf::InputFile in(file.c_str());
        const Imath::Box2i window = in.header().dataWindow();
        const auto width = std::size_t(window.max.x - window.min.x + 1),
                   height = std::size_t(window.max.y - window.min.y + 1);
        constexpr std::size_t kMostPixels = std::size_t{1} << 30;  // a header can announce anything
        if (width > kMostPixels / height) return wrong(fmt::format("{} × {} pixels", width, height), "at most 2^30");
        std::string has, wanted;
        for (auto it = in.header().channels().begin(); it != in.header().channels().end(); ++it)
            has += std::string(has.empty() ? "" : " ") + it.name();
        const std::vector<const char*> names = channelNames(*like.info);
        const std::size_t channels = names.size();
        for (const char* name : names) wanted += std::string(wanted.empty() ? "" : " ") + name;
        for (const char* name : names)
            if (!in.header().channels().findChannel(name))
                return wrong("its channels are " + has, fmt::format("{}, as for {}", wanted, like.name.text()));
        auto numbers = std::make_shared<std::vector<float>>(width * height * channels);
        Imf::FrameBuffer pixels;
        const std::size_t step = sizeof(float) * channels, line = step * width;
        for (std::size_t c = 0; c < channels; ++c) {
            // The library counts from the window's origin, which need not be 0, 0.
            char* first = reinterpret_cast<char*>(numbers->data() + c);
            first -= std::ptrdiff_t(step) * window.min.x + std::ptrdiff_t(line) * window.min.y;
            pixels.insert(names[c], Imf::Slice(Imf::FLOAT, first, step, line));
        }
        in.setFrameBuffer(pixels);
        in.readPixels(window.min.y, window.max.y);
        AnyBuffer read{like.name, like.info, {height, width}, std::span<const float>(*numbers), numbers};
        if (channels > 1) read.shape.push_back(channels);
        return read;
    } catch (const std::exception& problem) {  // OpenEXR reports no other way
        return wrong(std::string("could not read: ") + problem.what(), {});
    }
}

}  // namespace pipeline
