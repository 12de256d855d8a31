#include "pipeline/export/buffers/exporter.h"

#include <algorithm>

#include "pipeline/export/buffers/byte_file.h"
#include "pipeline/export/buffers/png_file.h"
#include "pipeline/formats/toml/toml_writer.h"

namespace pipeline {

std::string_view holdsAll(const BufferInfo&) { return {}; }
std::string anyScene(const Scene&) { return {}; }

Result<std::uint64_t> writeSceneFile(const Frame& frame, const std::filesystem::path& file) {
    const Result<std::string> text = toTomlScene(frame.scene());
    if (!text) return text.errors();
    ByteFile out(file);
    out.write(*text);
    return out.close();
}

const Exporter* findExporter(std::string_view name) {
    const auto table = exporterTable();
    const auto found = std::ranges::find(table, name, &Exporter::name);
    return found == table.end() ? nullptr : &*found;
}

const FrameExporter* findFrameExporter(std::string_view name) {
    const auto table = frameExporterTable();
    const auto found = std::ranges::find(table, name, &FrameExporter::name);
    return found == table.end() ? nullptr : &*found;
}

std::string sceneFileName(const std::string& scene, const FrameExporter& exporter) {
    std::string file = scene.substr(scene.rfind('/') + 1);
    if (const std::size_t dot = file.rfind('.'); dot != file.npos && dot > 0 && file != "..") file.resize(dot);
    constexpr std::size_t kLongest = 200;  // bytes; file systems allow 255, the endings too
    if (file.size() > kLongest) {
        std::size_t end = kLongest;
        while ((static_cast<unsigned char>(file[end]) & 0xC0) == 0x80) --end;  // no half of a UTF-8 character
        file.resize(end);
    }
    if (file.empty()) file = "scene";
    return file.append(exporter.ending);
}

std::string_view paletteName(Palette palette) {
    switch (palette) {
        case Palette::Sequential: return "ember";
        case Palette::Diverging: return "slope";
        case Palette::Categorical: return "eight";
        case Palette::Verdict: return "verdict";
        case Palette::ShadowVerdict: return "shadow verdict";
        case Palette::Truth: return "truth";
        case Palette::Direction: return "direction";
        case Palette::Color: return "color";
    }
    return {};
}

}  // namespace pipeline
