// The illumination equation of a pixel: symbols, numbers, result.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/core/elementary.h"
#include "pipeline/inspect/equation_terms.h"
#include "pipeline/inspect/formula_parts.h"

namespace pipeline {
namespace {

struct Writer : EquationTerms {
    std::vector<EquationLine> lines{};

    // Under layers it is the opaque surface's, which has no buffer; C is what the layers make of it.
    Formula intensity() const { return sub("I", channel(), report.layers.empty() ? "intensity" : ""); }
    // What the frame buffer scales.
    Formula shown() const { return report.antialiased ? sub("A", channel(), "antialiased") : composed(); }
    Formula composed() const { return report.layers.empty() ? intensity() : sub("C", channel(), "intensity"); }

    void add(std::string role, std::vector<Formula> parts, std::string remark = {}) {
        lines.push_back({std::move(role), row(std::move(parts)), std::move(remark)});
    }

    void symbols(std::string remark);
    void numbers(const Evaluation& e);
    void result(const Evaluation& e);
    void rows(const Evaluation& e);
    void layers();
    void samples();
    void frameBuffer();
    void weighted();
};

// Phong:        I_b = k_b I_a + S_0 I_0 [ k_b (N·L) + k_s (R·V)^n ]
// Blinn-Phong:  I_b = k_a I_a + S_0 I_0 [ k_b (N·L) + k_s (N·H)^n ]
// OpenGL:       I_b = k_e + k_a I_a + F_0 [ k_a a_0 + S_0 ( d_0 k_b (N·L) + s_0 k_s (N·H)^n ) ]
void Writer::symbols(std::string remark) {
    std::vector<Formula> parts{intensity(), text("=")};
    EquationTerms::symbols(parts);
    add("symbols", std::move(parts), std::move(remark));
}

// = 0.9·50 + 1·100 [ 0.9·0.7746 + 0.4·0.3974^8 ]
void Writer::numbers(const Evaluation& e) {
    std::vector<Formula> parts{text("=")};
    EquationTerms::numbers(e, parts);
    add("numbers", std::move(parts));
}

// = 45.000 + 69.714 + 0.025 = 114.739
void Writer::result(const Evaluation& e) {
    std::vector<Formula> parts{text("=")};
    if (model().found.emission) parts.insert(parts.end(), {number(e.emission[c], 3, "emission"), text("+")});
    parts.push_back(number(e.ambient[c], 3, "ambient"));
    for (const LightReport& light : e.lights) {
        parts.insert(parts.end(), {text("+"), number(light.diffuse[c], 3, fmt::format("diffuse.{}", light.light))});
        parts.insert(parts.end(), {text("+"), number(light.specular[c], 3, fmt::format("specular.{}", light.light))});
    }
    parts.insert(parts.end(), {text("="), number(e.intensity[c], 3, "intensity")});
    add("result", std::move(parts), e.clamped ? "clamped to [0, 1] before it is interpolated" : "");
}

// An angle is read, not stored: it has its one decimal in every form.
std::string degrees(double cosine) {
    return fixed(acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi, 1) + "°";
}

void Writer::rows(const Evaluation& e) {
    for (const LightReport& light : e.lights) {
        const int k = light.light;
        add("row",
            {N(), text("·"), L(k), text("="), components(e.N), text("·"), components(light.L), text("="),
             number(light.nDotL, 4)},
            degrees(light.nDotL));
        const bool shining = material().specular[c] != 0 || !model().dullWithoutKs;
        const VectorsRead& specular = model().specularReads(halfway());
        const auto isRead = [&](bool VectorsRead::*vector) {
            return model().found.diffuse.*vector || (shining && specular.*vector);
        };
        if (light.nDotL > 0 && isRead(&VectorsRead::R)) {
            add("row",
                {R(k), text("="), text("2"), dot(N(), L(k)), N(), text("−"), L(k), text("="), components(light.R)});
            add("row",
                {R(k), text("·"), V(), text("="), components(light.R), text("·"), components(e.V), text("="),
                 number(light.rDotV, 4)},
                degrees(light.rDotV));
        }
        if (light.nDotL > 0 && isRead(&VectorsRead::H)) {
            add("row", {H(k), text("="),
                        fraction(row({L(k), text("+"), V()}), row({text("|"), L(k), text("+"), V(), text("|")})),
                        text("="), components(light.H)});
            add("row",
                {N(), text("·"), H(k), text("="), components(e.N), text("·"), components(light.H), text("="),
                 number(light.nDotH, 4)},
                degrees(light.nDotH));
        }
        for (std::size_t i = 0; light.nDotL > 0 && i < model().factors.size(); ++i) {
            const ModelFactor& factor = model().factors[i];
            const Term of{Term::Kind::Leaf, Quantity::Factor, double(i)};
            add("row",
                {symbolsOf(of, k), text("="), symbolsOf(factor.definition, k), text("="), numbersOf(of, e, &light)},
                std::string(factor.meaning));
        }
        if (!light.note.empty()) add("note", {text(light.note)});
    }
}

// C = 0.25·114.739 + 20.000 = 48.685
void Writer::layers() {
    if (report.layers.empty()) return;
    const std::size_t count = report.layers.size();
    add("symbols",
        {composed(), text("="), sub("t", "layers", "transmittance"), intensity(), text("+"),
         sub("C", "layers", "translucent")},
        fmt::format("{} translucent {} over the surface", count, count == 1 ? "layer" : "layers"));
    add("result",
        {text("="), number(report.transmittance, 4), text("·"), number(report.intensity[c], 3), text("+"),
         number(report.translucent[c], 3, "translucent"), text("="), number(report.composed[c], 3, "intensity")});
}

// A = mean of 16 samples = 48.1
void Writer::samples() {
    if (!report.antialiased) return;
    add("samples", {shown(), text("="), number((*report.antialiased)[c], 3, "antialiased")},
        fmt::format("mean of {} samples over the pixel; at its centre {}", report.samples * report.samples,
                    toText(number(report.composed[c], 3))));
}

void Writer::frameBuffer() {
    if (!report.isShaded) return add("note", {text("This pixel is not shaded yet.")});
    layers();
    samples();
    const Formula value = text(std::to_string(int(report.color[c])), "color");
    Formula name = script(text("FB"), text(channel()), row({}), "color");
    if (!(report.iMax > 0)) {
        add("frame buffer", {std::move(name), text("="), value}, "I_max is 0: the picture is black");
        return;
    }
    const auto rounded = [](Formula top, Formula bottom) {
        return row({text("round("), text("255"), text("·"), fraction(std::move(top), std::move(bottom)), text(")")});
    };
    const double scaled = report.antialiased.value_or(report.composed)[c];
    const double share = scaled / report.iMax;
    const std::string remark = share > 1 ? "above I_max: clamped to 1" : share < 0 ? "below 0: clamped to 0" : "";
    add("frame buffer",
        {std::move(name), text("="), rounded(shown(), sub("I", "max", "i_max")), text("="),
         rounded(number(scaled, 3), text(withMinus(fmt::format("{:.12g}", report.iMax)), "i_max")), text("="), value},
        remark);
}

// Gouraud: the pixel's intensity from those at the vertices.
void Writer::weighted() {
    const bool perspective = scene.settings.interpolation == Interpolation::Perspective;
    std::vector<Formula> symbols{intensity(), text("=")}, numbers{text("=")}, result{text("=")};
    for (std::size_t i = 0; i < report.evaluations.size(); ++i) {
        const Evaluation& e = report.evaluations[i];
        if (i > 0)
            for (auto* parts : {&symbols, &numbers, &result}) parts->push_back(text("+"));
        symbols.push_back(sub("λ", std::to_string(i), perspective ? "barycentric" : ""));
        symbols.push_back(script(symbol("I"), text(std::to_string(e.vertex)), row({}), "vertices.intensity"));
        numbers.insert(numbers.end(), {number(e.weight, 4), text("·"), number(e.intensity[c], 3)});
        result.push_back(number(e.weight * e.intensity[c], 3));
    }
    result.insert(result.end(), {text("="), number(report.intensity[c], 3, "intensity")});
    add("symbols", std::move(symbols),
        "Gouraud: evaluated at the vertices, then interpolated" +
            (perspective ? std::string() : ", " + report.interpolation));
    add("numbers", std::move(numbers));
    add("result", std::move(result));
}

}  // namespace

std::vector<EquationLine> equation(const Scene& scene, const PixelReport& report, int channel,
                                   const NumberText& chosen) {
    Writer writer{{scene, report, channel, chosen}};
    if (report.evaluations.empty()) {
        if (!report.layers.empty()) writer.frameBuffer();  // of the layers alone
        return writer.lines;
    }
    const bool single = scene.settings.shading != Shading::Gouraud;
    if (!single) {
        writer.weighted();
        writer.frameBuffer();
    }
    for (const Evaluation& e : report.evaluations) {
        const bool flat = scene.settings.shading == Shading::Flat;
        writer.symbols(!single ? e.where
                       : flat  ? "Flat: evaluated once, " + e.where
                               : "Phong shading: evaluated " + e.where);
        writer.numbers(e);
        writer.result(e);
        if (single) writer.frameBuffer();
        writer.rows(e);
    }
    return writer.lines;
}

}  // namespace pipeline
