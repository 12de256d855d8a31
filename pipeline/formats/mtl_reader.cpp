#include <fmt/format.h>

#include "pipeline/formats/lecture_values.h"
#include "pipeline/formats/line_scanner.h"
#include "pipeline/formats/model_formats.h"
#include "pipeline/formats/text_scanner.h"

namespace pipeline {
namespace {

// What a file may say is what the setting may be.
std::optional<double> coefficient(LineScanner& scanner, std::string_view what) {
    const Setting& row = settingRow(what == "Ns"                  ? "material.#.n"
                                    : what == "d" || what == "Tr" ? "material.#.alpha"
                                                                  : "material.#.kr");
    const std::optional<double> value = parseNumber(scanner.next());
    if (value && *value >= row.min && *value <= row.max) return value;
    scanner.refuse(fmt::format("{}, {}", what, numberFrom(row.min, row.max)));
    return {};
}

// One number stands for all three. "spectral" and "xyz" say a colour in a way that few programs
// write; it is left as it was.
void readColor(LineScanner& scanner, std::string_view what, Vec3d& color) {
    const std::string_view word = scanner.peek();
    if (word == "spectral" || word == "xyz") return;
    const std::optional<double> red = coefficient(scanner, what);
    if (!red) return;
    color = Vec3d(*red);
    if (scanner.peek().empty()) return;
    const std::optional<double> green = coefficient(scanner, what), blue = coefficient(scanner, what);
    if (green && blue) color = Vec3d(*red, *green, *blue);
}

// d is the opacity, Tr what it lacks to 1. Writers disagree on Tr: where a file gives both, d counts.
// "-halo" makes a surface clearer where it is seen from the front, which few programs write; it is left as it was.
void readOpacity(LineScanner& scanner, std::string_view what, double& alpha, bool& given) {
    if (scanner.peek() == "-halo") return;
    const std::optional<double> value = coefficient(scanner, what);
    if (!value || (what == "Tr" && given)) return;
    alpha = what == "d" ? *value : 1 - *value;
    given = given || what == "d";
}

}  // namespace

void readMtl(const SourceText& source, std::vector<NamedMaterial>& materials, Errors& errors) {
    ByteWindow window(source);
    LineScanner scanner(window, source.name, errors, source.progress);
    NamedMaterial* current = nullptr;
    bool ambientGiven = false, opacityGiven = false;
    while (scanner.nextLine()) {
        const std::string_view word = scanner.next();
        if (word == "newmtl") {
            const std::string_view name = scanner.rest();
            if (name.empty()) scanner.refuse("the material's name");
            materials.push_back({std::string(name), Material{}});
            current = &materials.back();
            ambientGiven = opacityGiven = false;
            continue;
        }
        const bool known =
            word == "Kd" || word == "Ka" || word == "Ks" || word == "Ke" || word == "Ns" || word == "d" || word == "Tr";
        if (!known) continue;
        if (!current) {
            scanner.refuse("newmtl and a name before the first coefficient");
            continue;
        }
        Material& material = current->material;
        if (word == "Kd") readColor(scanner, "Kd", material.diffuse);
        if (word == "Ka") readColor(scanner, "Ka", material.ambient), ambientGiven = true;
        if (word == "Ks") readColor(scanner, "Ks", material.specular);
        if (word == "Ke") readColor(scanner, "Ke", material.emission);
        if (word == "Ns") material.exponent = coefficient(scanner, "Ns").value_or(material.exponent);
        if (word == "d" || word == "Tr") readOpacity(scanner, word, material.alpha, opacityGiven);
        if (!ambientGiven) material.ambient = material.diffuse;
    }
}

}  // namespace pipeline
