// The illumination equation of a pixel: symbols, numbers, result.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/core/elementary.h"
#include "pipeline/inspect/formula_parts.h"
#include "pipeline/inspect/pixel_report.h"

namespace pipeline {
namespace {

constexpr const char* kChannels[]{"r", "g", "b"};
constexpr const char* kColors[]{"red", "green", "blue"};

struct Writer {
    const Scene& scene;
    const PixelReport& report;
    int c;
    const NumberText& chosen;
    std::vector<EquationLine> lines;

    const Material& material() const {
        const Object& object = scene.objects[std::size_t(report.object)];
        return report.back && object.backMaterial ? *object.backMaterial : object.material;
    }
    Model model() const { return scene.settings.model; }
    bool halfway() const { return usesHalfway(model(), material()); }  // (N·H)^n, not (R·V)^n
    double exponent() const {
        return material().exponent * (halfway() && model() != Model::OpenGl ? scene.settings.exponentFactor : 1);
    }
    double ambientCoefficient() const {
        return model() == Model::Phong ? material().diffuse[c] : material().ambient[c];
    }
    double specularIntensity(std::size_t k) const {
        const Light& light = scene.lights[k];
        return light.intensity * light.gl.specular[c];
    }
    std::string materialKey(std::string_view name) const { return fmt::format("material.{}.{}", report.object, name); }
    // What was computed, as chosen, else with so many decimals.
    Formula number(double value, int decimals, std::string refers = {}) const {
        const auto own = chosen ? chosen(value) : std::nullopt;
        return own ? numeral(*own, std::move(refers)) : text(fixed(value, decimals), std::move(refers));
    }
    // The lecture writes exact 0, 1 and −1 without decimals.
    Formula wholeOr(double value, int decimals) const {
        return number(value, value == 0 || value == 1 || value == -1 ? 0 : decimals);
    }
    Formula components(Vec3d v) const {
        return row({text("("), wholeOr(v.x, 3), text(","), wholeOr(v.y, 3), text(","), wholeOr(v.z, 3), text(")")});
    }
    // L, R, N·L carry the light's index only where there are several.
    Formula indexed(VectorCode code, std::string_view buffer, int light) const {
        Formula v = vector(code, fmt::format("{}.{}", buffer, light));
        return scene.lights.size() > 1 ? script(std::move(v), text(std::to_string(light)), row({})) : v;
    }
    Formula dot(Formula a, Formula b) const {
        return row({text("("), std::move(a), text("·"), std::move(b), text(")")});
    }
    Formula L(int k) const { return indexed(VectorCode::L, "light_vector", k); }
    Formula R(int k) const { return indexed(VectorCode::R, "reflection_vector", k); }
    Formula H(int k) const { return indexed(VectorCode::H, "halfway_vector", k); }
    Formula N() const { return vector(VectorCode::N, "normal"); }
    Formula V() const { return vector(VectorCode::V, "view_vector"); }
    // Under layers it is the opaque surface's, which has no buffer; C is what the layers make of it.
    Formula intensity() const { return sub("I", kChannels[c], report.layers.empty() ? "intensity" : ""); }
    // What the frame buffer scales.
    Formula shown() const { return report.antialiased ? sub("A", kChannels[c], "antialiased") : composed(); }
    Formula composed() const { return report.layers.empty() ? intensity() : sub("C", kChannels[c], "intensity"); }

    void add(std::string role, std::vector<Formula> parts, std::string remark = {}) {
        lines.push_back({std::move(role), row(std::move(parts)), std::move(remark)});
    }

    double lightIntensity(std::size_t k) const { return scene.lights[k].intensity * scene.lights[k].color[c]; }
    double ambientIntensity() const { return scene.ambient.lightIn(model())[c]; }
    bool hasSpecular() const { return material().specular[c] != 0; }

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
    const std::string channel = kChannels[c], kd = materialKey("k" + channel);
    const bool phong = model() == Model::Phong, gl = model() == Model::OpenGl;
    const Formula ka = phong ? sub("k", channel, kd) : sub("k", "a", materialKey("ka" + channel));
    std::vector<Formula> parts{intensity(), text("=")};
    if (gl) parts.insert(parts.end(), {sub("k", "e", "emission"), text("+")});
    parts.insert(parts.end(), {ka, sub("I", "a", "ambient.intensity")});
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        const std::string index = std::to_string(k), light = "light." + index + ".";
        const Formula highlight =
            power(halfway() ? dot(N(), H(int(k))) : dot(R(int(k)), V()), symbol("n", materialKey("n")));
        const Formula ks = sub("k", "s", materialKey(phong ? "ks" : "ks" + channel));
        parts.push_back(text("+"));
        if (gl) {
            parts.insert(parts.end(),
                         {sub("F", index), text("["), ka, sub("a", index, light + "ambient_" + kColors[c]), text("+"),
                          sub("S", index, "shadow." + index), text("("), sub("d", index, light + "intensity"),
                          sub("k", channel, kd), dot(N(), L(int(k))), text("+"),
                          sub("s", index, light + "specular_" + kColors[c]), ks, highlight, text(")"), text("]")});
            continue;
        }
        parts.insert(parts.end(), {sub("S", index, "shadow." + index), sub("I", index, light + "intensity"), text("["),
                                   sub("k", channel, kd), dot(N(), L(int(k))), text("+"), ks, highlight, text("]")});
    }
    add("symbols", std::move(parts), std::move(remark));
}

// = 0.9·50 + 1·100 [ 0.9·0.7746 + 0.4·0.3974^8 ]; what a clamp or a factor 0 removes is struck.
void Writer::numbers(const Evaluation& e) {
    const std::string kd = shortest(material().diffuse[c]), ks = shortest(material().specular[c]);
    const bool gl = model() == Model::OpenGl;
    const std::string ka = shortest(ambientCoefficient());
    std::vector<Formula> parts{text("=")};
    if (gl) parts.insert(parts.end(), {text(shortest(material().emission[c])), text("+")});
    parts.push_back(text(ka + "·" + shortest(ambientIntensity())));
    for (const LightReport& light : e.lights) {
        const auto k = std::size_t(light.light);
        // Lit or not is no measure; a share of texels or samples is, with as many digits as the dot products.
        const bool isShare = light.shadow != 0 && light.shadow != 1;
        const std::string factor = fmt::format("shadow.{}", k);
        Formula shadow = isShare ? number(light.shadow, 4, factor) : text(shortest(light.shadow), factor);
        if (light.shadow == 0) shadow = struck(shadow);
        parts.push_back(text("+"));
        if (gl) {
            const double own = scene.lights[k].intensity * scene.lights[k].gl.ambient[c];
            parts.insert(parts.end(),
                         {number(light.fading, 4), text("["), text(ka + "·" + shortest(own)), text("+"),
                          std::move(shadow), text("("), text(shortest(lightIntensity(k)) + "·" + kd + "·")});
        } else {
            parts.insert(parts.end(),
                         {std::move(shadow), text("·" + shortest(lightIntensity(k))), text("["), text(kd + "·")});
        }
        Formula cosine = number(light.nDotL, 4, fmt::format("n_dot_l.{}", k));
        if (light.nDotL > 0)
            parts.push_back(cosine);
        else
            parts.insert(parts.end(), {struck(cosine), text("0")});
        parts.push_back(text("+"));
        parts.push_back(text(gl ? shortest(specularIntensity(k)) + "·" + ks + "·" : ks + "·"));
        const double lobe = halfway() ? light.nDotH : light.rDotV;
        Formula mirror = number(lobe, 4, fmt::format("{}.{}", halfway() ? "n_dot_h" : "r_dot_v", k));
        if (light.nDotL > 0 && (lobe > 0 || (gl && exponent() == 0)))
            parts.push_back(power(std::move(mirror), text(shortest(exponent()), materialKey("n"))));
        else
            parts.insert(parts.end(), {struck(mirror), text("0")});
        if (gl) parts.push_back(text(")"));
        parts.push_back(text("]"));
    }
    add("numbers", std::move(parts));
}

// = 45.000 + 69.714 + 0.025 = 114.739
void Writer::result(const Evaluation& e) {
    std::vector<Formula> parts{text("=")};
    if (model() == Model::OpenGl) parts.insert(parts.end(), {number(e.emission[c], 3, "emission"), text("+")});
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
        if (!hasSpecular() || !(light.nDotL > 0)) {
            if (!light.note.empty()) add("note", {text(light.note)});
            continue;
        }
        if (halfway()) {
            add("row", {H(k), text("="),
                        fraction(row({L(k), text("+"), V()}), row({text("|"), L(k), text("+"), V(), text("|")})),
                        text("="), components(light.H)});
            add("row",
                {N(), text("·"), H(k), text("="), components(e.N), text("·"), components(light.H), text("="),
                 number(light.nDotH, 4)},
                degrees(light.nDotH));
            if (!light.note.empty()) add("note", {text(light.note)});
            continue;
        }
        add("row", {R(k), text("="), text("2"), dot(N(), L(k)), N(), text("−"), L(k), text("="), components(light.R)});
        add("row",
            {R(k), text("·"), V(), text("="), components(light.R), text("·"), components(e.V), text("="),
             number(light.rDotV, 4)},
            degrees(light.rDotV));
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
    Formula name = script(text("FB"), text(kChannels[c]), row({}), "color");
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
    Writer writer{scene, report, channel, chosen, {}};
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
