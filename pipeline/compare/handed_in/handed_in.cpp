#include "pipeline/compare/handed_in/handed_in.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pipeline/compare/handed_in/values.h"
#include "pipeline/core/text.h"
#include "pipeline/formats/scene_folder.h"

namespace pipeline::foreign {

namespace {

struct Alias {
    std::string_view name, buffer;
    Form form = Form::AsTable;
};
// What others call a buffer.
constexpr std::array kAliases{
    Alias{"colour", "color"},
    Alias{"image", "color"},
    Alias{"picture", "color"},
    Alias{"combined", "color"},
    Alias{"framebuffer", "color"},
    Alias{"depth", "z_view"},
    Alias{"z", "z_view"},
    Alias{"normals", "normal"},
    Alias{"vertices.clip", "vertices.screen", Form::Clip},
    Alias{"clip", "vertices.screen", Form::Clip},
    Alias{"vertices.ndc", "vertices.screen", Form::Ndc},
    Alias{"ndc", "vertices.screen", Form::Ndc},
    Alias{"polygons.visible", "polygons.verdict", Form::Visible},
    Alias{"visible", "polygons.verdict", Form::Visible},
};

std::vector<std::string> handedNames() {
    std::vector<std::string> names;
    for (const BufferName& name : allBuffers(1))
        if (toleranceOf(name.id)) names.push_back(name.text());
    for (const Alias& alias : kAliases) names.emplace_back(alias.name);
    return names;
}

// What makes a picture of another shape the right one; nothing where none of the usual ways does.
std::string_view whatMayHelp(const std::vector<std::size_t>& found, const std::vector<std::size_t>& expected) {
    const std::size_t height = expected[0], width = expected[1];
    if (found.size() >= 2 && found[0] == width && found[1] == height) return "; rows come before columns: transpose it";
    if (found.size() == 3 && found[1] == height && found[2] == width) return "; a pixel's channels come last";
    if (found.size() >= 2) return "; --size compares at another size";
    return {};
}

std::string stemOf(const std::string& file) { return file.substr(0, file.rfind('.')); }

// Why an array cannot be this buffer, or empty.
std::optional<Error> wrongSize(const HandedFile& file, const Frame& reference) {
    const auto right = reference.buffer(file.name.buffer);
    if (!right) return Error{{file.path}, "a buffer that the scene has not", reference.whyAbsent(file.name.buffer)};
    std::vector<std::size_t> expected{right->rows()};
    const bool picture = right->info->domain == Domain::Pixel || right->info->domain == Domain::Texel;
    if (picture) expected.push_back(right->columns());
    int channels = file.name.form == Form::Clip ? 4 : right->channels();
    if (right->info->domain == Domain::Texel) expected = file.numbers.shape, channels = 1;  // any resolution
    if (channels > 1) expected.push_back(std::size_t(channels));
    std::vector<std::size_t> found = file.numbers.shape;
    if (found.empty()) found.push_back(1);
    while (found.size() > expected.size() && found.back() == 1) found.pop_back();
    if (found == expected) return {};
    // Pictures with one channel written as colours, normals of a picture; x and y without a depth.
    const bool grey = picture && channels == 1 && found.size() == 3 && found[2] == 3;
    const bool plane = file.name.buffer.id == BufferId::VerticesScreen && found.size() == 2 && found[1] == 2;
    const bool four = channels == 3 && found.size() == expected.size() && found.back() == 4;
    if (found[0] == expected[0] && (plane || four || (grey && found[1] == expected[1]))) return {};
    NumberFile wanted;
    wanted.shape = expected;
    return Error{{file.path},
                 "found an array of " + file.numbers.sizeText(),
                 fmt::format("{} as {} of this scene has{}", wanted.sizeText(), stemOf(file.fileName()),
                             picture ? whatMayHelp(found, expected) : "")};
}

// How exactly a file can hold a buffer.
int rank(const HandedFile& file) {
    switch (file.numbers.kind) {
        case NumberKind::Real: return file.numbers.digits;
        case NumberKind::Whole: return 60;
        case NumberKind::Levels16: return 16;
        case NumberKind::Levels8: return 8;
    }
    return 0;
}

class Gathering {
public:
    Gathering(const Frame& reference, HandedIn& in) : m_reference(reference), m_in(in) {}

    void add(const OfferedFile& offered) {
        const std::string &path = offered.path, file = path.substr(path.rfind('/') + 1);
        const auto dot = file.rfind('.');
        if (dot == file.npos || dot == 0) return;
        const std::string stem = file.substr(0, dot), ending = file.substr(dot + 1);
        if (file == "mine.toml") {
            auto text = offered.read(1u << 16);
            if (!text) return report(text.errors());
            m_in.conventions = std::move(text).value(), m_in.conventionsName = path;
            return;
        }
        const std::size_t lights = m_reference.scene().lights.size();
        const auto name = findHanded(stem, lights);
        if (!readsNumbers(ending)) {
            if (offered.asked) report({{{path}, "the ending is none of a file of numbers", numberFormats()}});
            if (!offered.asked && name)
                m_in.others.push_back(
                    fmt::format("{} is not read: its ending is none of {}", inQuotes(file), numberFormats()));
            return;
        }
        const bool mayHaveLayers = sameLetters(ending, "exr");
        if (!name && !mayHaveLayers) return notKnown(file, stem);
        auto bytes = offered.read(kMaxFileBytes);
        if (!bytes) return report(bytes.errors());
        if (name) keep({*name, path, {}}, readNumbers(*bytes, path, mostNumbersOf(*name)));
        // Passes of one file: those of which there is no file.
        bool isKnown = name.has_value();
        for (const std::string& layer : mayHaveLayers ? exrLayers(*bytes) : std::vector<std::string>()) {
            const auto pass = nameOfLayer(layer, lights);
            if (!pass || pass == name || (name && layer.empty())) continue;
            isKnown = true;
            m_passes.push_back({{*pass, path, {}}, readExrNumbers(*bytes, path, mostNumbersOf(*pass), layer)});
        }
        if (!isKnown) notKnown(file, stem);
    }
    // Layers count where no file of their own is handed in.
    void addPasses() {
        for (auto& [handed, numbers] : m_passes)
            if (std::ranges::find(m_in.files, handed.name, &HandedFile::name) == m_in.files.end())
                keep(std::move(handed), std::move(numbers));
    }

private:
    // "ViewLayer.Depth." is a depth; colours without a layer are the picture, Z without one is the depth.
    static std::optional<HandedName> nameOfLayer(const std::string& layer, std::size_t lights) {
        if (layer.empty()) return findHanded("color", lights);
        const std::string whole = layer.ends_with('.') ? layer.substr(0, layer.size() - 1) : layer;
        if (const auto name = findHanded(whole, lights)) return name;
        return findHanded(std::string_view(whole).substr(whole.rfind('.') + 1), lights);
    }
    void notKnown(const std::string& file, const std::string& stem) {
        m_in.others.push_back(fmt::format("{} is not known; {}", inQuotes(file), insteadOfHanded(stem)));
    }
    void keep(HandedFile handed, Result<NumberFile> numbers) {
        if (!numbers) return report(numbers.errors());
        handed.numbers = std::move(numbers).value();
        if (const auto wrong = wrongSize(handed, m_reference)) return report({*wrong});
        const auto before = std::ranges::find(m_in.files, handed.name, &HandedFile::name);
        if (before == m_in.files.end()) {
            m_in.files.push_back(std::move(handed));
            return;
        }
        if (rank(*before) < rank(handed)) std::swap(*before, handed);
        m_in.others.push_back(fmt::format("{} is not read: {} holds more digits", inQuotes(handed.fileName()),
                                          inQuotes(before->fileName())));
    }
    void report(const Errors& errors) { m_in.errors.insert(m_in.errors.end(), errors.begin(), errors.end()); }
    // What such a buffer of the scene holds, with room for a fourth channel; one of twice the size is still read, to say so.
    std::size_t mostNumbersOf(const HandedName& name) const {
        const auto& settings = m_reference.scene().settings;
        std::size_t places = 1024;
        for (const Object& object : m_reference.scene().objects)
            places += object.mesh->positions.size() + object.mesh->polygonCount() + object.mesh->triangles.size();
        const Domain domain = bufferInfo(name.buffer.id).domain;
        if (domain == Domain::Texel)
            places = std::max(places, std::size_t(settings.shadowSize) * std::size_t(settings.shadowSize) * 6);
        return 16 * std::max(places, std::size_t(settings.width) * std::size_t(settings.height));
    }

    const Frame& m_reference;
    HandedIn& m_in;
    std::vector<std::pair<HandedFile, Result<NumberFile>>> m_passes;
};

}  // namespace

std::string HandedName::text() const {
    switch (form) {
        case Form::AsTable: return buffer.text();
        case Form::Visible: return "polygons.visible";
        case Form::Clip: return "vertices.clip";
        case Form::Ndc: return "vertices.ndc";
    }
    return {};
}

std::optional<HandedName> findHanded(std::string_view stem, std::size_t lights) {
    HandedName found;
    std::string_view name = stem;
    for (const Alias& alias : kAliases)
        if (sameLetters(stem, alias.name)) name = alias.buffer, found.form = alias.form;
    auto buffer = findBuffer(name);
    if (!buffer && lights == 1) buffer = findBuffer(std::string(name) + ".0");  // of the only light
    if (!buffer || !toleranceOf(buffer->id)) return {};
    if (buffer->light >= int(lights)) return {};
    found.buffer = *buffer;
    return found;
}

std::string insteadOfHanded(std::string_view stem) {
    const std::vector<std::string> names = handedNames();
    return fmt::format("the nearest name is {}", nearest(stem, names));
}

Error noSuchFile(const std::string& path) { return {{path}, "there is no such file or folder", {}}; }

HandedIn takeHandedIn(std::span<const OfferedFile> files, const Frame& reference, const Stop& stop) {
    HandedIn in;
    Gathering gathering(reference, in);
    for (const OfferedFile& file : files)
        if (!stop.stop_requested()) gathering.add(file);
    gathering.addPasses();
    std::ranges::stable_sort(in.files, {}, [](const HandedFile& file) { return index(file.name.buffer.id); });
    return in;
}

HandedIn readHandedIn(const std::map<std::string, std::string_view>& files, const Frame& reference) {
    std::vector<OfferedFile> offered;
    for (const auto& [name, bytes] : files)
        offered.push_back(
            {name, true, [held = bytes](std::size_t) -> Result<std::string> { return std::string(held); }});
    return takeHandedIn(offered, reference, {});
}

}  // namespace pipeline::foreign
