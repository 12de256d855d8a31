#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

#include "pipeline/check/case.h"
#include "pipeline/check/readings.h"
#include "pipeline/check/scenes.h"
#include "pipeline/formats/scene_reader.h"

// What files can hold that no formula should ever see: every reader refuses it, and says where.
namespace pipeline::check {
namespace {

// One coordinate that is `word`, in every format that is text.
std::vector<Text> withNumber(const std::string& word) {
    return {
        {"a.des", fmt::format("3 1\n0 0 {} 1 0 0 0 1 0\n3 0 1 2\n0.2 0.5 0.9 0.4 8", word)},
        {"a.obj", fmt::format("v 0 0 0\nv 1 0 {}\nv 0 1 0\nf 1 2 3\n", word)},
        {"a.ply", fmt::format("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
                              "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 "
                              "{} 0\n0 1 0\n3 0 1 2\n",
                              word)},
        {"a.stl", fmt::format("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 {} 0\nvertex 0 1 "
                              "0\nendloop\nendfacet\nendsolid a\n",
                              word)},
        {"a.scene", fmt::format("200 1000 45 {}\n0\n0\n50\n", word)},
        {"a.toml", fmt::format("[camera]\neye = [0, {}, 1]\n", word)}};
}
double acceptedByStrtod(std::initializer_list<const char*> words) {
    double count = 0;
    for (const char* word : words) {
        char* end = nullptr;
        const double value = std::strtod(word, &end);
        count += *end == '\0' && !std::isfinite(value);
    }
    return count;
}
std::string stlWith(float value) {
    return std::string(80, ' ') + bytesOf<std::uint32_t>({1}) +
           bytesOf<float>({0, 0, 1, 0, 0, 0, 1, 0, value, 0, 1, 0}) + std::string(2, '\0');
}
std::string plyWith(float value) {
    return "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
           "z\nelement face "
           "1\nproperty list uchar uchar vertex_indices\nend_header\n" +
           bytesOf<float>({0, 0, 0, 1, 0, value, 0, 1, 0}) + bytesOf<std::uint8_t>({3, 0, 1, 2});
}
Finding runNotANumber(Trial& trial) {
    std::vector<Text> texts{{"a.stl", stlWith(std::nanf("")), false}, {"a.ply", plyWith(std::nanf("")), false}};
    for (const char* word : {"nan", "NaN", "-nan", "nan(0)"})
        for (Text& text : withNumber(word)) texts.push_back(std::move(text));
    return refusing(trial, acceptedByStrtod({"nan", "NaN", "-nan", "nan(0)"}), texts, "strtod takes it");
}
Finding runInfinite(Trial& trial) {
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    std::vector<Text> texts{{"a.stl", stlWith(kInfinite), false}, {"a.ply", plyWith(-kInfinite), false}};
    for (const char* word : {"inf", "-inf", "infinity", "1e999", "-1e999"})
        for (Text& text : withNumber(word)) texts.push_back(std::move(text));
    return refusing(trial, acceptedByStrtod({"inf", "-inf", "infinity", "1e999", "-1e999"}), texts, "strtod takes it");
}

Finding runFewCorners(Trial& trial) {
    std::vector<Text> texts;
    for (const char* polygon : {"0", "1 0", "2 0 1"})
        texts.push_back({"a.des", fmt::format("3 1\n0 0 0 1 0 0 0 1 0\n{}\n0.2 0.5 0.9 0.4 8", polygon)});
    // In OBJ a face is left out, and the others stay.
    for (const char* face : {"f 1", "f 1 2"}) {
        const Reading rest = read("a.obj", fmt::format("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n{}\n", face));
        trial.demand(rest.errors.empty() && rest.objects.size() == 1 && rest.objects[0].mesh->polygonCount() == 1,
                     fmt::format("\"{}\" is not left out of an OBJ file", face));
    }
    const std::uint32_t corners = 1;  // a fan has corners − 2 triangles
    return refusing(trial, double(corners - 2), texts, fmt::format("{} triangles", corners - 2));
}

Finding runIndices(Trial& trial) {
    std::vector<Text> texts;
    for (const char* index :
         {"3", "-1", "4", "2147483648", "4294967296", "9223372036854775808", "99999999999999999999"})
        texts.push_back({"a.des", fmt::format("3 1\n0 0 0 1 0 0 0 1 0\n3 0 1 {}\n0.2 0.5 0.9 0.4 8", index)});
    for (const char* index :
         {"0", "4", "-4", "2147483648", "4294967297", "9223372036854775808", "-9223372036854775808"})
        texts.push_back({"a.obj", fmt::format("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 {}\n", index)});
    const Reading last = read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n");
    trial.demand(
        last.errors.empty() && last.objects.size() == 1 && last.objects[0].mesh->positions[2] == Vec3d(0, 1, 0),
        "−1 is not the last vertex");
    const std::int64_t naive = std::int32_t(std::uint32_t(std::strtoll("4294967297", nullptr, 10)));
    return refusing(trial, 1, texts, fmt::format("4294967297 is vertex {}", naive));
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}
Finding runLineEnds(Trial& trial) {
    double wrong = 0;
    const auto same = [&](const std::string& text) {
        const Reading r = read("a.obj", text);
        return r.errors.empty() && r.objects.size() == 1 && r.objects[0].mesh->positions.size() == 4 &&
               r.objects[0].mesh->polygonCount() == 1;
    };
    wrong += !same(kSquare.substr(0, kSquare.size() - 1));       // no line end at the end
    wrong += !same(replaced(kSquare, "\n", "\r\n"));             // lines of another system
    wrong += !same("\xEF\xBB\xBF" + kSquare);                    // a byte order mark
    wrong += !same(kSquare + "# " + std::string(1 << 20, 'x'));  // a line of a megabyte
    wrong += !same(replaced(kSquare, " ", "  \t "));
    // What is left answers with objects or with an error, and never reads past the end.
    for (const std::string ending : {".obj", ".ply", ".stl", ".off", ".des", ".scene", ".toml", ".gltf", ".glb"})
        for (const std::string& text : {std::string(), std::string("\n"), std::string(64, '\0'), std::string("f"),
                                        std::string(1 << 16, '('), std::string("\xFF\xFE")}) {
            const Reading r = read("a" + ending, text);
            wrong += !r.errors.empty() && !r.objects.empty();
        }
    trial.demand(read("a.des", "").errors.size() == 1, "an empty description is not refused once");
    const std::string mark = "\xEF\xBB\xBFv";
    return {double(mark.substr(0, 1) != "v"), wrong, "first word is not v", ""};
}

Finding runNormalIndices(Trial&) {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    double wrong = 0;
    // An index beyond the list, one without a list, and a normal without length.
    for (const char* rest :
         {"vn 0 0 1\nf 1//1 2//2 3//1\n", "f 1//1 2//1 3//1\n", "vn 0 0 1\nvn 0 0 0\nf 1//1 2//1 3//2\n"}) {
        const Reading r = read("a.obj", corners + rest);
        wrong += !r.errors.empty() || r.objects.size() != 1 || !r.objects[0].mesh->normals.empty();
    }
    const std::array<int, 1> normals{0};
    return {double(2 > normals.size()), wrong, "reads normal 2 of 1", ""};
}

Finding runCounts(Trial& trial) {
    const std::uint64_t count = 4294967295;
    const std::vector<Text> texts{
        {"a.des", "4294967295 1\n0 0 0\n"},
        {"a.des", "3 4294967295\n0 0 0 1 0 0 0 1 0\n"},
        {"a.ply",
         "ply\nformat ascii 1.0\nelement vertex 4294967295\nproperty float x\nproperty float y\nproperty float "
         "z\nend_header\n0 0 0\n",
         false},
        {"a.stl", std::string(80, ' ') + bytesOf<std::uint32_t>({4294967295u}) + "12345678901234567890", false},
        {"a.gltf",
         R"({"asset": {"version": "2.0"}, "accessors": [{"componentType": 5126, "count": 4294967295, "type": "VEC3", "bufferView": 0}],
          "bufferViews": [{"buffer": 0, "byteLength": 12}], "buffers": [{"byteLength": 12, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAA"}],
          "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}]})",
         false}};
    return refusing(trial, double(count) * 24, texts, fmt::format("{:.0f} GB asked", double(count) * 24 / 1e9));
}

Finding runCoefficients(Trial& trial) {
    std::vector<Text> texts;
    for (const char* word : {"nan", "inf", "1e999", "1e6"}) {
        texts.push_back({"a.des", fmt::format("3 1\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n0.2 {} 0.9 0.4 8", word)});
        texts.push_back(
            {"a.toml",
             fmt::format("[[object]]\nshape = \"box\"\n[object.material]\ndiffuse = [0.2, {}, 0.9]\n", word)});
    }
    // More or less than nature has is computed as written.
    Scene scene = frontScene(4, {boxMesh(-1, 1)});
    scene.objects[0].material.diffuse = {-0.5, 1.5, 2};
    trial.frame(scene);
    return refusing(trial, acceptedByStrtod({"nan", "inf", "1e999"}), texts, "strtod takes it");
}

Finding runPlanes(Trial& trial) {
    std::vector<Text> texts;
    for (const char* planes : {"near = -1", "near = 2\nfar = 2", "near = 3\nfar = 2", "far = -5"})
        texts.push_back({"a.toml", fmt::format("[camera]\n{}\n", planes), false});
    const float n = 2, f = 2;
    return refusing(trial, double(f / (f - n)), texts, fmt::format("f / (f − n) = {}", f / (f - n)));
}

std::string gltfNodes(const std::string& nodes) {
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": )" + nodes +
           R"(, "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
}
Finding runQuaternions(Trial& trial) {
    const auto turned = [&](const std::string& q) {
        const Reading r = read("a.gltf", gltfNodes(fmt::format(R"([{{"mesh": 0, "rotation": [{}]}}])", q)));
        trial.demand(r.errors.empty() && r.objects.size() == 1, fmt::format("a rotation of {} is not read", q));
        return r.objects.empty() ? std::vector<Vec3d>(3, Vec3d(std::nan(""))) : r.objects[0].mesh->positions.copy();
    };
    const auto largest = [](const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) {
        double worst = 0;
        for (std::size_t i = 0; i < 3; ++i)
            for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(a[i][c] - b[i][c]));
        return worst;
    };
    const Reading none = read("a.gltf", gltfNodes(R"([{"mesh": 0, "rotation": [0, 0, 0, 0]}])"));
    trial.demand(!none.errors.empty(), "a rotation of 0, 0, 0, 0 is not refused");
    const double ours = std::max(largest(turned("0.5, -0.5, 0.5, 0.5"), turned("-0.5, 0.5, -0.5, -0.5")),
                                 largest(turned("0.1, 0, 0, 0.1"), turned("0.5, 0, 0, 0.5")));
    const double zero = 0;
    return {zero / std::sqrt(zero), ours};
}
Finding runNodes(Trial& trial) {
    const auto chain = [](int levels) {
        std::string nodes = "[";
        for (int i = 0; i + 1 < levels; ++i)
            nodes += fmt::format(R"({{"children": [{}], "translation": [0.001, 0, 0]}}, )", i + 1);
        return gltfNodes(nodes + R"({"mesh": 0}])");
    };
    const Reading deep = read("a.gltf", chain(1000));
    trial.demand(deep.errors.empty() && deep.objects.size() == 1, "a thousand levels are not read");
    const std::vector<Text> texts{
        {"a.gltf", chain(100000), false},
        {"a.gltf", gltfNodes(R"([{"children": [1]}, {"children": [0]}])"), false},
        {"a.gltf", gltfNodes(R"([{"mesh": 0}, {"children": [2]}, {"children": [1]}])"), false}};
    const double naive = 100000;
    return refusing(trial, naive, texts, "100 000 calls deep");
}
Finding runNesting(Trial& trial) {
    const std::string open(100000, '['), close(100000, ']');
    const std::vector<Text> texts{{"a.toml", "x = " + open + close, false},
                                  {"a.gltf", R"({"asset": )" + open + close + "}", false}};
    return refusing(trial, 100000, texts, "100 000 calls deep");
}
Finding runNames(Trial&) {
    double wrong = 0;
    const auto oneLine = [&](const Errors& errors) {
        const std::string text = errors.empty() ? "" : format(errors[0]);
        return !text.empty() && text.find('\n') == std::string::npos && text.find('\x1b') == std::string::npos &&
               text.size() < 8192;
    };
    for (const std::string& name : {std::string(4096, 'n'), std::string("a\\nb"), std::string("../../secret"),
                                    std::string("/etc/hosts"), std::string("\xFF\xFE\x80")}) {
        wrong +=
            !oneLine(read("a.scene", fmt::format("200 1000 45 60\n1\n{} 1 1 1 0 0 0 0 0 0\n0\n50\n", name)).errors);
        wrong += !oneLine(read("a.obj", fmt::format("mtllib {}\nv 0 0 0\n", name)).errors);
    }
    wrong += bool(readScene(std::string(4096, 'n')));
    const std::string path = "a\nb";
    return {double(path.find('\n') != std::string::npos), wrong, "a message of two lines", ""};
}

}  // namespace

std::span<const Case> readerCases() {
    static const Case cases[]{
        {.id = "G13",
         .group = Group::Geometry,
         .title = "Coordinate NaN",
         .input = "four spellings in six formats; in binary",
         .naive = "strtod",
         .stable = "refused with its line and column",
         .measure = "files not refused",
         .reference = "an error with its place",
         .bound = 0,
         .outcome = Outcome::Error,
         .run = runNotANumber},
        {.id = "G14",
         .group = Group::Geometry,
         .title = "Coordinate infinite",
         .input = "inf, 1e999 in six formats; in binary",
         .naive = "strtod",
         .stable = "refused with its line and column",
         .measure = "files not refused",
         .reference = "an error with its place",
         .bound = 0,
         .outcome = Outcome::Error,
         .run = runInfinite},
        {.id = "G10",
         .group = Group::Geometry,
         .title = "Polygon of 0, 1, 2 corners",
         .input = "two formats",
         .naive = "corners − 2 triangles",
         .stable = "refused with its line and column; in OBJ left out",
         .measure = "files not refused",
         .reference = "an error with its place",
         .bound = 0,
         .outcome = Outcome::Error,
         .run = runFewCorners},
        {.id = "G21",
         .group = Group::Geometry,
         .title = "Index 0, −1, 2³¹, 2⁶³",
         .input = "two formats",
         .naive = "32 bits of strtoll",
         .stable = "refused with its line and column; in OBJ −1 is the last",
         .measure = "files not refused",
         .reference = "an error with its place",
         .bound = 0,
         .outcome = Outcome::Error,
         .run = runIndices},
        {.id = "G22",
         .group = Group::Geometry,
         .title = "Empty file, line ends, byte order mark",
         .input = "eight formats",
         .naive = "the first bytes as they are",
         .stable = "read, or refused",
         .measure = "wrong answers",
         .reference = "the plain file",
         .bound = 0,
         .run = runLineEnds},
        {.id = "G23",
         .group = Group::Geometry,
         .title = "Normals that are not there",
         .input = "OBJ",
         .naive = "normals[i]",
         .stable = "they count as missing: normals are computed",
         .measure = "meshes with other normals",
         .reference = "computed normals",
         .bound = 0,
         .run = runNormalIndices},
        {.id = "G24",
         .group = Group::Geometry,
         .title = "Count of 4 294 967 295 in 20 bytes",
         .input = "five files",
         .naive = "allocates what is announced",
         .stable = "refused before anything is allocated",
         .measure = "files not refused",
         .reference = "an error",
         .bound = 0,
         .outcome = Outcome::Error,
         .run = runCounts},
        {.id = "T14",
         .group = Group::Camera,
         .title = "Near plane below 0, at, beyond the far plane",
         .input = "four scenes",
         .naive = "f / (f − n)",
         .stable = "refused",
         .measure = "files not refused",
         .reference = "an error",
         .bound = 0,
         .outcome = Outcome::Error,
         .run = runPlanes},
        {.id = "T18",
         .group = Group::Camera,
         .title = "Quaternion of length 0; q and −q",
         .input = "rotations of glTF nodes",
         .naive = "q / |q|",
         .stable = "length 0 is refused, with its place",
         .measure = "largest difference",
         .reference = "the same rotation",
         // An entry is 1 − 2 (y² + z²) of parts within a unit each: two units of 2^-52.
         .bound = 4.5e-16,
         .run = runQuaternions},
        {.id = "T19",
         .group = Group::Camera,
         .title = "Nodes 100 000 deep, and in a ring",
         .input = "glTF",
         .naive = "a call a level",
         .stable = "1024 levels without recursion; rings are refused",
         .measure = "files not refused",
         .reference = "an error",
         .bound = 0,
         .outcome = Outcome::Error,
         .run = runNodes},
        {.id = "S16",
         .group = Group::Shading,
         .title = "Coefficients NaN, infinite, below 0, above 1",
         .input = "two formats",
         .naive = "strtod",
         .stable = "no number is refused; any other is computed as written",
         .measure = "files not refused",
         .reference = "an error with its place",
         .bound = 0,
         .outcome = Outcome::Error,
         .run = runCoefficients},
        {.id = "L6",
         .group = Group::Limits,
         .title = "Brackets 100 000 deep",
         .input = "TOML and JSON",
         .naive = "a call a bracket",
         .stable = "a limit",
         .measure = "files not refused",
         .reference = "an error",
         .bound = 0,
         .outcome = Outcome::Error,
         .run = runNesting},
        {.id = "L7",
         .group = Group::Limits,
         .title = "Names of 4096 bytes, of no characters, out of the folder",
         .input = "files that a file names",
         .naive = "printed as they are",
         .stable = "an error of one line, escaped",
         .measure = "wrong answers",
         .reference = "an error of one line",
         .bound = 0,
         .outcome = Outcome::Error,
         .run = runNames},
    };
    return cases;
}

}  // namespace pipeline::check
