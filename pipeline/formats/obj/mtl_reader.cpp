#include "pipeline/formats/obj/mtl_reader.h"

#include <cmath>
#include <optional>

#include "pipeline/formats/lecture/lecture_values.h"
#include "pipeline/formats/text/line_scanner.h"
#include "pipeline/formats/text/text_scanner.h"

namespace pipeline {
namespace {

// A material as it is written.
struct Written {
    bool ambient = false;  // Ka is given
    bool picture = false;  // of the diffuse colour
    std::optional<double> d, tr;
    int line = 0, trLine = 0;  // of newmtl and Tr
};

class MtlReader {
public:
    MtlReader(const SourceText& source, std::vector<NamedMaterial>& materials, MtlTallies& tallies, Errors& errors)
        : m_window(source),
          m_file(source.name),
          m_scanner(m_window, source.name, errors, source.progress),
          m_materials(materials),
          m_first(materials.size()),
          m_tallies(tallies) {}

    void read() {
        while (m_scanner.nextLine()) {
            const std::string_view word = m_scanner.next();
            if (word == "newmtl")
                begin();
            else if (isRead(word))
                readStatement(word);
        }
        finish();
    }

private:
    static bool isPicture(std::string_view word) {
        return word.starts_with("map_") || word == "bump" || word == "disp" || word == "decal" || word == "refl" ||
               word == "norm";
    }
    static bool isRead(std::string_view word) {
        return word == "Kd" || word == "Ka" || word == "Ks" || word == "Ke" || word == "Ns" || word == "d" ||
               word == "Tr" || isPicture(word);
    }
    void count(CaseTally& tally) { tally.add(m_file, m_scanner.line()); }

    void begin() {
        m_materials.push_back({std::string(m_scanner.rest()), Material{}});
        m_written.emplace_back().line = m_scanner.line();
    }

    void readStatement(std::string_view word) {
        if (m_written.empty()) return count(m_tallies.beforeFirst);
        Material& material = m_materials.back().material;
        Written& written = m_written.back();
        if (isPicture(word)) {
            count(m_tallies.pictures);
            written.picture = written.picture || word == "map_Kd";
        }
        if (word == "Kd") readColor(material.diffuse);
        if (word == "Ka") written.ambient = readColor(material.ambient) || written.ambient;
        if (word == "Ks") readColor(material.specular);
        if (word == "Ke") readColor(material.emission);
        if (word == "Ns") material.exponent = coefficient("material.#.n").value_or(material.exponent);
        if (word == "d") readOpacity(written.d);
        if (word == "Tr") written.trLine = m_scanner.line(), readOpacity(written.tr);
    }

    // What a file may say is what the setting may be.
    std::optional<double> coefficient(std::string_view setting) {
        const Setting& row = settingRow(setting);
        const std::optional<double> value = parseNumber(m_scanner.next());
        if (value && *value >= row.min && *value <= row.max) return value;
        count(m_tallies.wrongNumbers);
        return {};
    }

    // One number stands for all three. "spectral" and "xyz" say a colour in a way that few programs write.
    bool readColor(Vec3d& color) {
        const std::string_view word = m_scanner.peek();
        if (word == "spectral" || word == "xyz") return count(m_tallies.otherColors), false;
        const std::optional<double> red = coefficient("material.#.kr");
        if (!red) return false;
        if (m_scanner.peek().empty()) return color = Vec3d(*red), true;
        const std::optional<double> green = coefficient("material.#.kg");
        const std::optional<double> blue = green ? coefficient("material.#.kb") : std::nullopt;
        if (blue) color = Vec3d(*red, *green, *blue);
        return blue.has_value();
    }

    // "-halo" makes a surface clearer where it is seen from the front, which few programs write.
    void readOpacity(std::optional<double>& value) {
        if (m_scanner.peek() == "-halo") return count(m_tallies.halos);
        if (const auto given = coefficient("material.#.alpha")) value = given;
    }

    void finish() {
        const bool opacityTr = trIsOpacity();
        for (std::size_t i = 0; i < m_written.size(); ++i) {
            const Written& written = m_written[i];
            Material& material = m_materials[m_first + i].material;
            // A picture that is left out would be multiplied by this: the file's colour stood in the picture.
            if (written.picture && material.diffuse == Vec3d(0)) {
                material.diffuse = Material{}.diffuse;
                m_tallies.blackPictures.add(m_file, written.line);
            }
            if (!written.ambient) material.ambient = material.diffuse;
            if (written.tr && opacityTr) m_tallies.opacityTr.add(m_file, written.trLine);
            if (written.d)
                material.alpha = *written.d;
            else if (written.tr)
                material.alpha = opacityTr ? *written.tr : 1 - *written.tr;
        }
    }

    bool trIsOpacity() const {
        bool complements = false, equals = false, givesD = false, someOne = false, someZero = false;
        for (const Written& written : m_written) {
            givesD = givesD || written.d;
            if (!written.tr) continue;
            someOne = someOne || *written.tr == 1;
            someZero = someZero || *written.tr == 0;
            if (!written.d) continue;
            constexpr double kWritten = 1e-3;  // files write three digits or more
            complements = complements || std::abs(*written.d + *written.tr - 1) < kWritten;
            equals = equals || std::abs(*written.d - *written.tr) < kWritten;
        }
        return givesD ? equals && !complements : someOne && !someZero;
    }

    ByteWindow m_window;
    const std::string& m_file;
    LineScanner m_scanner;
    std::vector<NamedMaterial>& m_materials;
    std::size_t m_first;  // of this file's
    std::vector<Written> m_written;
    MtlTallies& m_tallies;
};

}  // namespace

void readMtl(const SourceText& source, std::vector<NamedMaterial>& materials, MtlTallies& tallies, Errors& errors) {
    MtlReader(source, materials, tallies, errors).read();
}

void MtlTallies::say(std::vector<Remark>& remarks) const {
    beforeFirst.say("coefficient", "before the first newmtl", "left out", remarks);
    wrongNumbers.say("coefficient", "without a number in its range", "left out; the default stays", remarks);
    otherColors.say("colour", "given as spectral or xyz", "left out", remarks);
    halos.say("opacity", "given as -halo", "left out", remarks);
    pictures.say("picture", "on surfaces", "left out", remarks);
    blackPictures.say("material", "with a picture and Kd 0", "shown with Kd 0.7 instead of black", remarks);
    opacityTr.say("material", "with Tr",
                  "shown with Tr as opacity, for as transparency it would hide surfaces; material.#.alpha changes it",
                  remarks);
}

}  // namespace pipeline
