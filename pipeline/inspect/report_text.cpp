// What `inspect` prints.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pipeline/inspect/formula_parts.h"
#include "pipeline/inspect/pixel_report.h"
#include "pipeline/scene/mesh/topology.h"

namespace pipeline {
namespace {

std::string triple(Vec3d v, int digits = 6) {
    return fmt::format("({:.{}g}, {:.{}g}, {:.{}g})", v.x, digits, v.y, digits, v.z, digits);
}

void addWhy(std::string& out, const Frame& frame, const PixelReport& r) {
    const Frame::PolygonPlace place = frame.placeOf(r.polygon);
    const Object& object = frame.scene().objects[place.object];
    out += fmt::format("  polygon      {} ({} of {})\n", r.polygon, place.polygon, object.name);
    if (const auto at = definedAt(frame, r.polygon))
        out += fmt::format("  defined at   {}:{}:{}\n", at->file, at->line, at->column);
    if (r.outline) out += "  seen         its outline, drawn in white and not shaded\n";
    out += fmt::format("  triangle     vertices {}, {}, {}\n", r.vertices[0], r.vertices[1], r.vertices[2]);
    out += fmt::format("  barycentric  {}\n", triple(r.barycentric));
    if (!r.interpolation.empty() && r.interpolation != "perspective-correct") {
        out += fmt::format("  weights      {}:", r.interpolation);
        for (const auto& [vertex, weight] : r.weights) out += fmt::format(" {:.4f} of vertex {}", weight, vertex);
        out += '\n';
    }
    out += fmt::format("  position     {} world\n", triple(r.position, 7));
    out += fmt::format("  z_view       {}\n", depthText(r.zView));
    if (r.depth != r.zView) out += fmt::format("  depth        {:.9g}\n", r.depth);
    for (std::size_t k = 0; k < r.shadowPlaces.size(); ++k)
        out += fmt::format("  light {:<7}{}\n", k, r.shadowPlaces[k]);
}

void addEquations(std::string& out, const Frame& frame, const PixelReport& r) {
    // Vectors and dot products are the same for every channel: they stand in the first that reads most of them.
    const auto isShared = [](const EquationLine& line) { return line.role == "row" || line.role == "note"; };
    std::array<std::vector<EquationLine>, 3> channels;
    for (std::size_t c = 0; c < 3; ++c) channels[c] = equation(frame.scene(), r, int(c));
    const auto most = std::ranges::max_element(
        channels, {}, [&](const std::vector<EquationLine>& lines) { return std::ranges::count_if(lines, isShared); });
    for (auto lines = channels.begin(); lines != channels.end(); ++lines) {
        if (lines->empty()) continue;
        constexpr std::array kChannelNames{"red", "green", "blue"};
        out += fmt::format("\n{}\n", kChannelNames[std::size_t(lines - channels.begin())]);
        for (const EquationLine& line : *lines) {
            if (lines != most && isShared(line)) continue;
            const bool continues = line.role == "numbers" || line.role == "result";
            out += fmt::format("  {}{}", continues ? "    " : "", toText(line.formula));
            if (!line.remark.empty()) out += "   (" + line.remark + ")";
            out += '\n';
        }
    }
}

// What was there, then each layer and what there is afterwards.
void addLayers(std::string& out, const PixelReport& r) {
    if (r.layers.empty()) return;
    out += fmt::format("\nlayers: {} laid over {}\n", r.layers.size(), triple(r.intensity));
    for (std::size_t i = 0; i < r.layers.size(); ++i) {
        const LayerReport& layer = r.layers[i];
        out +=
            fmt::format("  {}  polygon {}  z_view {}  α = {:.6g}  I = {}  α I + (1 − α) C = {}\n", i + 1, layer.polygon,
                        depthText(layer.zView), layer.alpha, triple(layer.intensity), triple(layer.composed));
    }
    out += fmt::format("  intensity = {:.6g} · {} + {} = {}\n", r.transmittance, triple(r.intensity),
                       triple(r.translucent), triple(r.composed));
}

void addSamples(std::string& out, const PixelReport& r) {
    if (!r.antialiased) return;
    out += fmt::format("\nantialiased: mean of {} samples {}, at the centre {}\n", r.samples * r.samples,
                       triple(*r.antialiased), triple(r.composed));
}

void addFragments(std::string& out, const PixelReport& r) {
    out += fmt::format("\nfragments: {}\n", r.fragments.size());
    for (std::size_t i = 0; i < r.fragments.size(); ++i) {
        const FragmentReport& fragment = r.fragments[i];
        out += fmt::format("  {}  polygon {}  {}  {}\n", i + 1, fragment.polygon, comparisonText(fragment).whole(),
                           name(fragment.verdict));
        for (const std::string& shadow : fragment.shadows) out += fmt::format("       {}\n", shadow);
    }
    for (const CulledReport& culled : r.culled)
        out +=
            fmt::format("  {}  polygon {}  would cover the pixel; {}\n", culled.letter, culled.polygon, culled.reason);
}

}  // namespace

std::optional<SourceLocation> definedAt(const Frame& frame, int polygon) {
    const Frame::PolygonPlace place = frame.placeOf(polygon);
    const Mesh& mesh = *frame.scene().objects[place.object].mesh;
    const std::string& file = mesh.file.empty() ? frame.scene().file : mesh.file;
    if (file.empty() || place.polygon >= mesh.polygonPlaces.size()) return std::nullopt;
    return SourceLocation{file, mesh.polygonPlaces[place.polygon].line, mesh.polygonPlaces[place.polygon].column};
}

std::string toText(const Frame& frame, const PixelReport& r) {
    std::string out = fmt::format("pixel {}, {}: color {} {} {}\n", r.pixel.x, r.pixel.y, int(r.color.r),
                                  int(r.color.g), int(r.color.b));
    if (!r.covered) {
        out +=
            r.layers.empty() ? "  background: nothing was drawn here\n" : "  background, behind translucent surfaces\n";
    } else {
        addWhy(out, frame, r);
    }
    addEquations(out, frame, r);
    addLayers(out, r);
    addSamples(out, r);
    addFragments(out, r);
    return out;
}

}  // namespace pipeline
