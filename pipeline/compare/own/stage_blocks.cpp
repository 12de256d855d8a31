#include "pipeline/compare/own/stage_blocks.h"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/compare/reference.h"
#include "pipeline/export/json/json.h"
#include "pipeline/run/frame_data.h"
#include "pipeline/run/runner.h"

namespace pipeline::foreign {
namespace {

constexpr std::array kBlocks{
    StageBlocks{StageId::Transform, {"mesh.vertices", "scene"}, {"vertices.world", "vertices.view", "vertices.screen"}},
    StageBlocks{StageId::Cull, {"vertices.view", "vertices.screen", "polygons", "scene"}, {"polygons.visible"}},
    StageBlocks{StageId::Normals, {"vertices.world", "polygons"}, {"polygons.normal", "vertices.normal"}},
    StageBlocks{StageId::ZBuffer,
                {"vertices.view", "vertices.screen", "polygons", "polygons.visible"},
                {"z_view", "polygon_id"}},
    StageBlocks{StageId::Shading,
                {"position", "normal", "view_vector", "shadow", "object_id", "scene"},
                {"ambient", "diffuse", "specular", "intensity", "color"}},
};

// The program's own conventions: a contract states them, so that nothing has to be found out.
constexpr const char* kConventions =
    "rows = \"top-down\"\ncolumns = \"left-to-right\"\nchannels = \"rgb\"\nencoding = \"own\"\ndepth = \"own\"\n"
    "normals = \"own\"\nids = \"own\"\nview_z = \"own\"\nscreen = \"own\"\ndot_products = \"own\"\nshadow = \"own\"\n";

// The names of a list, with a number for each light where a buffer has one for each.
std::vector<std::string> namesOf(const std::array<std::string_view, 8>& list, std::size_t lights) {
    std::vector<std::string> names;
    for (const std::string_view name : list) {
        if (name.empty()) break;
        const auto first = findBuffer(std::string(name) + ".0");
        if (!first || !bufferInfo(first->id).perLight) {
            names.emplace_back(name);
            continue;
        }
        for (std::size_t k = 0; k < lights; ++k) names.push_back(fmt::format("{}.{}", name, k));
    }
    return names;
}

std::size_t columnsOf(const HandedName& name) { return std::size_t(bufferInfo(name.buffer.id).channels); }

// A buffer's numbers, as a file of them would have; verdicts as 1 and 0.
std::optional<NumberFile> fileOf(const Frame& frame, const std::string& name) {
    const auto handed = findHanded(name, frame.scene().lights.size());
    const auto buffer = handed ? frame.buffer(handed->buffer) : std::nullopt;
    if (!buffer) return {};
    NumberFile file;
    file.name = name, file.shape = {buffer->rows()};
    if (buffer->info->domain == Domain::Pixel) file.shape.push_back(buffer->columns());
    if (buffer->channels() > 1) file.shape.push_back(std::size_t(buffer->channels()));
    for (std::size_t y = 0; y < buffer->rows(); ++y)
        for (std::size_t x = 0; x < buffer->columns(); ++x)
            for (int c = 0; c < buffer->channels(); ++c) {
                const double value = buffer->value(x, y, c);
                const bool isVerdict = handed->form == Form::Visible;
                file.values.push_back(isVerdict ? (goesOn(Verdict(int(value))) ? 1 : 0) : value);
            }
    countStrange(file);
    return file;
}

std::string rowsText(std::string_view name, const NumberFile& file, std::size_t columns) {
    std::string text = fmt::format("{} {} {}\n", name, file.values.size() / columns, columns);
    for (std::size_t i = 0; i < file.values.size(); ++i)
        text += numberText(file.values[i]) + ((i + 1) % columns == 0 ? '\n' : ' ');
    return text;
}

std::string sceneText(const Scene& scene) {
    constexpr std::array<std::string_view, 8> kKeys{"camera.", "light.", "ambient.", "material.",
                                                    "object.", "width",  "height",   "exponent_factor"};
    std::string rows;
    std::size_t count = 0;
    const Json settings = settingsToJson(scene);  // items() refers to it
    for (const Json::Item& item : settings.items()) {
        if (std::ranges::none_of(kKeys, [&](std::string_view key) { return item.key.starts_with(key); })) continue;
        const bool isText = item.value.is(Json::kString);
        const std::string value = isText ? item.value.text() : item.value.dump();
        // A name may hold spaces, which would end the value.
        if (value.empty() || value.find_first_of(" \t\r\n") != value.npos) continue;
        rows += fmt::format("{} {}\n", item.key, value), ++count;
    }
    return fmt::format("scene {} 2\n", count) + rows;
}

std::string polygonsText(const Topology& topology) {
    std::string text = fmt::format("polygons {} 0\n", topology.polygonCount());
    for (std::size_t p = 0; p < topology.polygonCount(); ++p) {
        const Topology::Corners corners = topology.corners(p);
        text += std::to_string(corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i) text += fmt::format(" {}", corners[i]);
        text += '\n';
    }
    return text;
}

std::string meshText(const Topology& topology) {
    std::string text = fmt::format("mesh.vertices {} 4\n", topology.vertexCount());
    for (std::size_t o = 0; o < topology.meshes.size(); ++o)
        for (std::size_t i = 0; i < topology.meshes[o]->positions.size(); ++i) {
            const Vec3d p = topology.meshes[o]->positions[i];
            text += fmt::format("{} {} {} {}\n", o, numberText(p.x), numberText(p.y), numberText(p.z));
        }
    return text;
}

}  // namespace

const StageBlocks* stageBlocks(StageId stage) {
    const auto* const found = std::ranges::find(kBlocks, stage, &StageBlocks::stage);
    return found == kBlocks.end() ? nullptr : found;
}

FramePtr stageFrame(const Scene& scene, const StageBlocks& blocks, const Stop& stop) {
    BufferSet wanted = setOf({BufferId::Color});
    for (const auto* const list : {&blocks.gets, &blocks.gives})
        for (const std::string& name : namesOf(*list, scene.lights.size()))
            if (const auto handed = findHanded(name, scene.lights.size())) wanted.set(index(handed->buffer.id));
    return runFrame(referenceScene(scene), {wanted, StageId::Shading, 0, stop}, nullptr);
}

std::string stageText(const Frame& frame, const StageBlocks& blocks) {
    const Settings& settings = frame.scene().settings;
    std::string text = fmt::format("picture {} {}\n", settings.width, settings.height);
    for (const std::string& name : namesOf(blocks.gets, frame.scene().lights.size())) {
        if (name == "polygons")
            text += polygonsText(frame.topology());
        else if (name == "mesh.vertices")
            text += meshText(frame.topology());
        else if (name == "scene")
            text += sceneText(frame.scene());
        else if (const auto file = fileOf(frame, name))
            text += rowsText(name, *file, columnsOf(*findHanded(name, frame.scene().lights.size())));
    }
    return text;
}

Result<HandedIn> readStage(const Frame& frame, const StageBlocks& blocks, std::string_view text) {
    HandedIn in;
    in.conventions = kConventions, in.conventionsName = "the contract of the stage";
    const std::size_t lights = frame.scene().lights.size();
    const std::vector<std::string> gives = namesOf(blocks.gives, lights);
    BlockWords words(text);
    for (std::string_view name = words.next(); !name.empty(); name = words.next()) {
        if (std::ranges::find(gives, name) == gives.end())
            return wrongWord(name, fmt::format("one of {}", fmt::join(gives, ", ")));
        const auto handed = *findHanded(name, lights);
        if (std::ranges::find(in.files, handed, &HandedFile::name) != in.files.end())
            return wrongWord(name, "each block once");
        auto file = fileOf(frame, std::string(name));
        if (!file) return wrongWord(name, "a block that this scene has");
        const std::size_t columns = columnsOf(handed);
        for (const std::size_t size : {file->values.size() / columns, columns}) {
            const std::string_view word = words.next();
            if (const auto there = numberIn(word); !there || *there != double(size))
                return wrongWord(word, fmt::format("{} {} of {}", size, size == columns ? "columns" : "rows", name));
        }
        for (std::size_t i = 0; i < file->values.size(); ++i) {
            const std::string_view word = words.next();
            const auto number = numberIn(word);
            if (!number) return wrongWord(word, fmt::format("a number, in row {} of {}", i / columns + 1, name));
            file->values[i] = *number;
        }
        countStrange(*file);
        in.files.push_back({handed, std::string(name), std::move(*file)});
    }
    if (in.files.empty()) return wrongWord("", fmt::format("one of {}", fmt::join(gives, ", ")));
    // With what it was handed the comparison can say that it is this stage.
    for (const std::string& name : namesOf(blocks.gets, lights))
        if (const auto handed = findHanded(name, lights); handed && toleranceOf(handed->buffer.id))
            if (auto file = fileOf(frame, name)) in.files.push_back({*handed, name, std::move(*file)});
    std::ranges::stable_sort(in.files, {}, [](const HandedFile& file) { return index(file.name.buffer.id); });
    return in;
}

}  // namespace pipeline::foreign
