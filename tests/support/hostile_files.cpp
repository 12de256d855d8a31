#include "tests/support/hostile_files.h"

#include <fmt/format.h>

#include "lessons/lesson.h"
#include "lessons/state/cue_list.h"
#include "pipeline/export/json/study_json.h"
#include "pipeline/formats/lecture/lecture_formats.h"
#include "pipeline/formats/model_reader.h"
#include "pipeline/formats/obj/mtl_reader.h"
#include "pipeline/formats/png_scene.h"
#include "pipeline/formats/toml/toml_scene.h"
#include "tests/support/gltf_files.h"
#include "tests/support/studies.h"

namespace test {
namespace {

using namespace pipeline;

const FileLoader kNoFiles = [](std::string_view) -> Result<NamedFile> { return Error{{}, "no file", {}}; };

// each(i) for every i below n, one after the other.
template <class Each>
std::string repeated(std::size_t n, Each each) {
    std::string text;
    for (std::size_t i = 0; i < n; ++i) text += each(i);
    return text;
}

const char* const kCorners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string objNames(std::size_t n) {
    return kCorners + repeated(n, [](std::size_t) { return std::string("o same\nf 1 2 3\n"); });
}
std::string objMaterials(std::size_t n) {
    return kCorners + repeated(n, [](std::size_t i) { return fmt::format("usemtl m{}\nf 1 2 3\n", i); });
}
std::string objLibraries(std::size_t n) {
    return repeated(n, [](std::size_t i) { return fmt::format("mtllib m{}.mtl\n", i); }) + kCorners + "f 1 2 3\n";
}
// One outline, concave at every second corner.
std::string comb(std::size_t n, std::string_view vertex, std::string_view face) {
    std::string text, corners;
    for (std::size_t i = 0; i < n; ++i)
        text += fmt::format("{}{} 1 0\n{}{} {} 0\n", vertex, i, vertex, double(i) + 0.5, i % 2 == 0 ? 0.5 : 0.25);
    text += fmt::format("{}{} -1 0\n{}0 -1 0\n", vertex, n, vertex);
    const std::size_t first = face == "f" ? 1 : 0;
    for (std::size_t i = 2 * n + 2; i > 0; --i) corners += fmt::format(" {}", i - 1 + first);
    return fmt::format("{}{}{}\n", text, face, corners);
}
std::string objComb(std::size_t n) { return comb(n, "v ", "f"); }
// Fans that share a vertex, in smoothing groups of their own.
std::string objSmoothing(std::size_t n) {
    return kCorners + repeated(n, [](std::size_t i) { return fmt::format("s {}\nf 1 2 3\n", i + 1); });
}

std::string mtl(std::size_t n) {
    return repeated(n, [](std::size_t i) { return fmt::format("newmtl m{}\nKd 1 0 0\nmap_Kd p{}\n", i, i); });
}

std::string plyComb(std::size_t n) {
    return fmt::format(
               "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 1\nproperty list int int vertex_indices\nend_header\n",
               2 * n + 2) +
           comb(n, "", std::to_string(2 * n + 2));
}
std::string plyHeader(std::size_t n) {
    return "ply\nformat ascii 1.0\n" +
           repeated(n, [](std::size_t i) { return fmt::format("element e{} 0\nproperty float p{}\n", i, i); }) +
           "end_header\n";
}

std::string stlNames(std::size_t n) {
    return repeated(n, [](std::size_t) {
        return std::string(
            "solid same\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
            "endloop\nendfacet\nendsolid same\n");
    });
}

std::string gltfExtensions(std::size_t n) {
    Parts parts = squareParts();
    parts["extensionsUsed"] =
        "[" + repeated(n, [](std::size_t i) { return fmt::format("{}\"EXT_{}\"", i > 0 ? "," : "", i); }) + "]";
    return fileOf(parts);
}
std::string gltfNodes(std::size_t n) {
    Parts parts = squareParts();
    parts["nodes"] =
        "[" +
        repeated(n, [](std::size_t i) { return fmt::format("{}{{\"mesh\":0,\"name\":\"same\"}}", i > 0 ? "," : ""); }) +
        "]";
    parts["scenes"] =
        "[{\"nodes\":[" + repeated(n, [](std::size_t i) { return fmt::format("{}{}", i > 0 ? "," : "", i); }) + "]}]";
    return fileOf(parts);
}

std::string lectureObject(std::size_t n) {
    return fmt::format("{} 1\n", 2 * n + 2) + comb(n, "", std::to_string(2 * n + 2)) + "1 1 1 0.5 10\n";
}

std::string tomlNames(std::size_t n) {
    return repeated(n, [](std::size_t) { return std::string("[[object]]\nname = \"same\"\nshape = \"box\"\n"); });
}
std::string tomlKeys(std::size_t n) {
    return repeated(n, [](std::size_t i) { return fmt::format("k{} = 1\n", i); });
}
std::string tomlLights(std::size_t n) {
    return repeated(n, [](std::size_t i) { return fmt::format("[[light]]\nposition = [{}, 0, 1]\n", i); }) +
           "[[object]]\nshape = \"box\"\n";
}

std::string cues(std::size_t n) {
    return repeated(n, [](std::size_t i) { return fmt::format("[[cue]]\nname = \"c{}\"\nscene = \"pyramid\"\n", i); });
}
std::string study(std::size_t n) {
    StudyReport report = sphereStudy();
    report.axes.resize(1);
    report.axes[0].key = "exponent", report.axes[0].values.clear();
    report.points.clear();
    for (std::size_t i = 0; i < n; ++i) {
        report.axes[0].values.push_back(std::to_string(i + 1));
        report.points.push_back(studyPoint(i, {std::to_string(i + 1)}, 1, 0.01));
    }
    return studyFileText(report);
}
std::string png(std::size_t n) {
    const auto number = [](std::size_t value) {
        return std::string{char(value >> 24), char(value >> 16), char(value >> 8), char(value)};
    };
    return "\x89PNG\r\n\x1a\n" + number(13) + "IHDR" + number(1) + number(1) + std::string("\x08\0\0\0\0", 5) +
           "\x3a\x7e\x9b\x55" + repeated(n, [&](std::size_t) {
               return number(40) + "tEXtTitle" + std::string(1, '\0') + std::string(34, 'a') + number(0);
           });
}
std::string lessonPages(std::size_t n) {
    return "title: T\nlecture: L\nsummary: S\nscene: small\n\n" + repeated(n, [](std::size_t i) {
               return fmt::format("# Page {}\nstage: cull\nbuffers: polygon_id\n\nText *one* `two` [three](#x).\n\n",
                                  i);
           });
}
// What a Markdown reader may look for an end of, each to the end of the text.
std::string lessonMarks(std::size_t n) {
    return "title: T\nlecture: L\nsummary: S\nscene: small\n\n# Page\nstage: cull\nbuffers: polygon_id\n\n" +
           repeated(n, [](std::size_t) { return std::string("[a](<b **c `d "); }) + "\n";
}

template <const char* kEnding>
void readModelText(const std::string& text) {
    [[maybe_unused]] const auto model = readModel({text, "f"}, kEnding, kNoFiles);
}
constexpr char kObj[] = ".obj", kPly[] = ".ply", kStl[] = ".stl", kGltf[] = ".gltf";
void readMtlText(const std::string& text) {
    std::vector<NamedMaterial> materials;
    MtlTallies tallies;
    Errors errors;
    readMtl({text, "f"}, materials, tallies, errors);
}
void readObjectText(const std::string& text) {
    [[maybe_unused]] const auto scene = readLectureObject({text, "f"}, kNoFiles);
}
void readTomlText(const std::string& text) { [[maybe_unused]] const auto scene = readTomlScene({text, "f"}, kNoFiles); }
void readCueText(const std::string& text) { [[maybe_unused]] const auto list = lessons::readCues(text, "f"); }
void readStudyText(const std::string& text) { [[maybe_unused]] const auto report = studyFromJson(text, "f"); }
void readPngText(const std::string& text) { [[maybe_unused]] const auto scene = readPngScene({text, "f"}, kNoFiles); }
void readLessonText(const std::string& text) {
    [[maybe_unused]] const auto lesson = lessons::parseLesson(text, "f", [](std::string_view) {
        return readTomlScene({"[[object]]\nshape = \"box\"\n", "small"}, kNoFiles);
    });
}

}  // namespace

std::span<const HostileFile> hostileFiles() {
    static const HostileFile files[]{
        {"objNames", objNames, readModelText<kObj>},
        {"objMaterials", objMaterials, readModelText<kObj>},
        {"objLibraries", objLibraries, readModelText<kObj>},
        {"objComb", objComb, readModelText<kObj>, 1.5},
        {"objSmoothing", objSmoothing, readModelText<kObj>},
        {"mtl", mtl, readMtlText},
        {"plyComb", plyComb, readModelText<kPly>, 1.5},
        {"plyHeader", plyHeader, readModelText<kPly>},
        {"stlNames", stlNames, readModelText<kStl>},
        {"gltfExtensions", gltfExtensions, readModelText<kGltf>},
        {"gltfNodes", gltfNodes, readModelText<kGltf>},
        {"lectureObject", lectureObject, readObjectText, 1.5},
        {"tomlNames", tomlNames, readTomlText},
        {"tomlKeys", tomlKeys, readTomlText},
        {"tomlLights", tomlLights, readTomlText},
        {"cues", cues, readCueText},
        {"study", study, readStudyText},
        {"png", png, readPngText},
        {"lessonPages", lessonPages, readLessonText},
        {"lessonMarks", lessonMarks, readLessonText},
    };
    return files;
}

}  // namespace test
