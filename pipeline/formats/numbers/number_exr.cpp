#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfTileDescription.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <filesystem>

#include "pipeline/core/text.h"
#include "pipeline/formats/numbers/number_file.h"

namespace pipeline {

namespace {

class BytesStream : public Imf::IStream {
public:
    BytesStream(std::string_view bytes, const std::string& name) : IStream(name.c_str()), m_bytes(bytes) {}
    bool read(char to[], int count) override {
        if (count < 0 || m_at > m_bytes.size() || std::size_t(count) > m_bytes.size() - m_at)
            throw std::runtime_error("the end of the file");
        std::memcpy(to, m_bytes.data() + m_at, std::size_t(count));
        m_at += std::size_t(count);
        return m_at < m_bytes.size();
    }
    std::uint64_t tellg() override { return m_at; }
    void seekg(std::uint64_t position) override { m_at = position; }

private:
    std::string_view m_bytes;
    std::uint64_t m_at = 0;
};

// "normal." of "normal.X": the layers of a file, that of its own name first; none is a layer too.
std::vector<std::string> layersOf(const Imf::ChannelList& list, const std::string& file) {
    std::vector<std::string> layers{""};
    const std::string stem = std::filesystem::path(file).stem().string();
    for (auto channel = list.begin(); channel != list.end(); ++channel) {
        const std::string name = channel.name();
        const std::string layer = name.substr(0, name.rfind('.') + 1);  // empty where there is no dot
        if (std::ranges::find(layers, layer) == layers.end()) layers.push_back(layer);
    }
    std::stable_partition(layers.begin() + 1, layers.end(), [&](const std::string& layer) {
        const std::string whole = layer.substr(0, layer.size() - 1);
        return sameLetters(whole.substr(whole.rfind('.') + 1), stem) && !stem.empty();
    });
    return layers;
}

std::vector<std::string> channelsOf(const Imf::ChannelList& list, const std::vector<std::string>& layers) {
    for (const std::string& layer : layers) {
        for (const std::vector<std::string>& wanted :
             {std::vector<std::string>{"R", "G", "B"}, std::vector<std::string>{"X", "Y", "Z"}}) {
            std::vector<std::string> names;
            for (const std::string& name : wanted)
                if (list.findChannel(layer + name)) names.push_back(layer + name);
            if (names.size() == wanted.size()) return names;
        }
        for (const char* name : {"Z", "Y"})
            if (list.findChannel(layer + name)) return {layer + name};
    }
    return list.begin() == list.end() ? std::vector<std::string>() : std::vector<std::string>{list.begin().name()};
}

constexpr const char* kDepthAlone = "Z";                   // a channel without a layer
constexpr int kMostSide = 1 << 16;                         // of a picture or a tile
constexpr std::size_t kMostBlock = std::size_t{64} << 20;  // bytes of the lines that are stored together

// How many lines are stored together: of a header's size alone OpenEXR allocates them.
std::size_t linesTogether(const Imf::Header& header) {
    if (header.hasTileDescription()) return header.tileDescription().ySize;
    switch (header.compression()) {
        case Imf::NO_COMPRESSION:
        case Imf::RLE_COMPRESSION:
        case Imf::ZIPS_COMPRESSION: return 1;
        case Imf::ZIP_COMPRESSION:
        case Imf::PXR24_COMPRESSION: return 16;
        case Imf::DWAB_COMPRESSION: return 256;
        default: return 32;
    }
}

std::size_t bytesOfPixel(const Imf::ChannelList& list) {
    std::size_t bytes = 0;
    for (auto channel = list.begin(); channel != list.end(); ++channel)
        bytes += channel.channel().type == Imf::HALF ? 2 : 4;
    return bytes;
}

std::pair<std::int64_t, std::int64_t> sizeOf(const Imath::Box2i& window) {
    return {std::int64_t(window.max.x) - window.min.x + 1, std::int64_t(window.max.y) - window.min.y + 1};
}

void limitHeaders() {
    Imf::Header::setMaxImageSize(kMostSide, kMostSide);  // of the table of lines, before it is made
    Imf::Header::setMaxTileSize(kMostSide, kMostSide);
}

template <class Choose>
Result<NumberFile> readExr(std::string_view bytes, const std::string& name, std::size_t most, const Choose& choose) {
    constexpr std::string_view kMagic("\x76\x2f\x31\x01", 4);
    if (!bytes.starts_with(kMagic)) return wrongAt(name, 0, "no OpenEXR file", "its magic number");
    try {
        limitHeaders();
        BytesStream stream(bytes, name);
        Imf::InputFile in(stream);
        const Imath::Box2i window = in.header().dataWindow(), shown = in.header().displayWindow();
        for (const auto& [width, height] : {sizeOf(window), sizeOf(shown)})
            if (width < 1 || height < 1 || std::size_t(width) > most / 4 / std::size_t(height))
                return wrongAt(name, 0, fmt::format("a picture of {} × {}", width, height),
                               fmt::format("at most {} pixels", most / 4));
        const std::vector<std::string> names = choose(in.header().channels());
        if (names.empty()) return wrongAt(name, 0, "a picture without channels", "R G B, X Y Z, or one");
        const std::size_t channels = names.size(), columns = std::size_t(sizeOf(window).first),
                          rows = std::size_t(sizeOf(window).second), wide = std::size_t(sizeOf(shown).first);
        const std::size_t together = std::min(linesTogether(in.header()), rows);
        if (columns * together * bytesOfPixel(in.header().channels()) > kMostBlock)
            return wrongAt(name, 0, fmt::format("{} lines of {} pixels stored together", together, columns),
                           fmt::format("at most {} bytes of them", kMostBlock));
        // Block by block: a file that ends early has taken no memory for what it announces.
        NumberFile file{name, {std::size_t(sizeOf(shown).second), wide}, {}};
        std::vector<float> numbers(columns * together * channels);
        const std::size_t step = sizeof(float) * channels, line = step * columns;
        const int left = std::max(window.min.x, shown.min.x), right = std::min(window.max.x, shown.max.x);
        for (std::size_t done = 0; done < rows; done += together) {
            const int y = window.min.y + int(done), last = window.min.y + int(std::min(rows, done + together)) - 1;
            Imf::FrameBuffer pixels;
            for (std::size_t c = 0; c < channels; ++c) {
                char* first = reinterpret_cast<char*>(numbers.data() + c);
                first -= std::ptrdiff_t(step) * window.min.x + std::ptrdiff_t(line) * y;
                pixels.insert(names[c], Imf::Slice(Imf::FLOAT, first, step, line));
            }
            in.setFrameBuffer(pixels);
            in.readPixels(y, last);
            for (int row = std::max(y, shown.min.y); row <= std::min(last, shown.max.y) && left <= right; ++row) {
                const std::size_t end = (std::size_t(row - shown.min.y) + 1) * wide * channels;
                if (file.values.size() < end) file.values.resize(end);
                const auto from = numbers.begin() + (row - y) * std::ptrdiff_t(columns * channels);
                std::copy(from + (left - window.min.x) * std::ptrdiff_t(channels),
                          from + (right - window.min.x + 1) * std::ptrdiff_t(channels),
                          file.values.begin() + std::ptrdiff_t(end - wide * channels) +
                              (left - shown.min.x) * std::ptrdiff_t(channels));
            }
        }
        file.values.resize(file.shape[0] * wide * channels);
        if (channels > 1) file.shape.push_back(channels);
        const Imf::Channel* const first = in.header().channels().findChannel(names[0]);
        file.digits = first && first->type == Imf::HALF ? 11 : 24;
        return file;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& problem) {  // OpenEXR reports no other way
        return wrongAt(name, 0, std::string("a file that cannot be read: ") + problem.what(), {});
    }
}

}  // namespace

Result<NumberFile> readExrNumbers(std::string_view bytes, const std::string& name, std::size_t most) {
    return readExr(bytes, name, most,
                   [&](const Imf::ChannelList& list) { return channelsOf(list, layersOf(list, name)); });
}

Result<NumberFile> readExrNumbers(std::string_view bytes, const std::string& name, std::size_t most,
                                  const std::string& layer) {
    return readExr(bytes, name, most, [&](const Imf::ChannelList& list) {
        return layer == kDepthAlone ? std::vector<std::string>{layer} : channelsOf(list, {layer});
    });
}

std::vector<std::string> exrLayers(std::string_view bytes) {
    try {
        limitHeaders();
        BytesStream stream(bytes, "exr");
        const Imf::InputFile in(stream);
        const Imf::ChannelList& list = in.header().channels();
        std::vector<std::string> layers = layersOf(list, "");
        if (!list.findChannel("R")) layers.erase(layers.begin());
        if (list.findChannel(kDepthAlone) && !list.findChannel("X")) layers.emplace_back(kDepthAlone);
        return layers;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {
        return {};
    }
}

}  // namespace pipeline
