// shadescope compare: another renderer's files beside this program's frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace fs = std::filesystem;
using Json = nlohmann::json;

// Of resources/starter/writer.cpp.
void writeNpy(const std::string& name, const std::vector<std::size_t>& shape, const std::vector<float>& numbers);
void writePpm(const std::string& name, int width, int height, const std::vector<std::uint8_t>& numbers);

namespace {

// Nothing in it is symmetrical. A quarter of its pixels: every known error is drawn.
const std::string kScene = SHADESCOPE_STARTER "/check_me.toml";
const std::vector<std::string> kSize{"--size", "160x100"};

// The buffers of a scene as another renderer could have written them.
class Handed {
public:
    explicit Handed(const std::vector<std::string>& set = {}) {
        std::vector<std::string> arguments{"export", kScene, "--format", "npy", "-o", (m_folder / "all").string()};
        arguments.insert(arguments.end(), kSize.begin(), kSize.end());
        for (const std::string& one : set) arguments.insert(arguments.end(), {"--set", one});
        const auto done = test::run(arguments);
        EXPECT_EQ(done.status, 0) << done.err;
        fs::create_directory(m_folder / "mine");
    }
    test::Npy all(const std::string& name) const { return test::readNpy(m_folder / ("all/" + name + ".npy")); }
    // As PFM, PPM and NPY would be many formats here: a CSV file has every number, and NPY is written by hand.
    void give(const std::string& name, test::Npy array) const {
        std::string shape;
        for (const std::size_t side : array.shape) shape += std::to_string(side) + ", ";
        std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + shape + "), }";
        header.append(63 - (10 + header.size()) % 64, ' ') += '\n';
        std::string bytes("\x93NUMPY\x01\x00", 8);
        bytes += char(header.size() & 255), bytes += char(header.size() >> 8);
        bytes += header;
        bytes.append(reinterpret_cast<const char*>(array.values.data()), array.values.size() * sizeof(double));
        test::writeText(m_folder / ("mine/" + name + ".npy"), bytes);
    }
    std::string mine() const { return (m_folder / "mine").string(); }
    fs::path file(const std::string& name) const { return m_folder / ("mine/" + name); }
    test::Finished compare(std::vector<std::string> more = {}) const {
        more.insert(more.begin(), kSize.begin(), kSize.end());
        more.insert(more.begin(), {"compare", kScene, mine()});
        return test::run(more);
    }
    Json json(std::vector<std::string> more = {}) const {
        more.emplace_back("--json");
        const auto done = compare(more);
        return Json::parse(done.out, nullptr, false);
    }

private:
    test::TemporaryFolder m_folder;
};

test::Npy turned(test::Npy picture) {
    const std::size_t line = picture.values.size() / picture.shape[0];
    for (std::size_t y = 0; y < picture.shape[0] / 2; ++y)
        std::swap_ranges(picture.values.begin() + std::ptrdiff_t(y * line),
                         picture.values.begin() + std::ptrdiff_t((y + 1) * line),
                         picture.values.begin() + std::ptrdiff_t((picture.shape[0] - 1 - y) * line));
    return picture;
}
test::Npy blueFirst(test::Npy picture) {
    for (std::size_t i = 0; i + 2 < picture.values.size(); i += 3) std::swap(picture.values[i], picture.values[i + 2]);
    return picture;
}
// d = f (z − n) / (z (f − n)): what glDepthRange(0, 1) stores; near 8.2 and far 30 stand in the scene. 1 where nothing is.
test::Npy window(test::Npy z) {
    for (double& v : z.values) v = std::isfinite(v) ? 30 * (v - 8.2) / (v * (30 - 8.2)) : 1;
    return z;
}

std::string conventionOf(const Json& report, const std::string& buffer, const std::string& key) {
    for (const Json& one : report["conventions"])
        if (one["buffer"] == buffer && one["key"] == key) return one["value"];
    return "";
}

TEST(Compare, itsOwnBuffersAgree) {
    const Handed handed;
    for (const char* name :
         {"color", "z_view", "normal", "polygon_id", "object_id", "overdraw", "n_dot_l.0", "shadow.0", "ambient",
          "diffuse.1", "specular.1", "intensity", "vertices.world", "vertices.view", "vertices.screen",
          "polygons.normal", "vertices.normal", "polygons.verdict"})
        handed.give(name, handed.all(name));
    const auto done = handed.compare();
    EXPECT_EQ(done.status, 0) << done.out << done.err;
    EXPECT_TRUE(test::has(done.out, "Everything handed in agrees.")) << done.out;
}

TEST(Compare, readsWhatTheStarterWrites) {
    const test::TemporaryFolder folder;
    for (const char* language : {"cpp", "python", "c", "java", "js"})
        EXPECT_EQ(test::run({"compare", "--starter", language, "-o", folder.path().string()}).status, 0) << language;
    EXPECT_EQ(folder.names(),
              (std::vector<std::string>{"Writer.java", "check_me.mtl", "check_me.obj", "check_me.toml", "check_me.txt",
                                        "writer.c", "writer.cpp", "writer.js", "writer.py"}));
    const Handed handed;
    const test::Npy color = handed.all("color"), z = handed.all("z_view");
    writePpm(handed.file("color.ppm").string(), int(color.shape[1]), int(color.shape[0]),
             {color.values.begin(), color.values.end()});
    writeNpy(handed.file("depth.npy").string(), z.shape, {z.values.begin(), z.values.end()});
    EXPECT_EQ(handed.json()["exit"], 0);
    EXPECT_EQ(test::run({"compare", "--starter", "cobol", "-o", folder.path().string()}).status, 2);
    EXPECT_EQ(test::run({"compare", "--starter", "c"}).status, 2);
}

// With x = c_x + s_x x_v / z_v and y = c_y − s_y y_v / z_v the vertices of the OBJ file, seen by the numbers of the text, are
// those of the program, which writes floats: to a thousandth of a pixel.
TEST(Compare, theStartersObjAndCameraAreTheScene) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(test::run({"compare", "--starter", "c", "-o", folder.path().string()}).status, 0);
    ASSERT_EQ(
        test::run({"export", kScene, "--format", "npy", "--buffers", "vertices.screen", "-o", folder / "all"}).status,
        0);
    const test::Npy screen = test::readNpy(folder / "all/vertices.screen.npy");
    std::map<std::string, std::array<double, 3>> camera;
    double scaleX = 0, scaleY = 0, centreX = 0, centreY = 0;
    std::istringstream text(test::readText(folder / "check_me.txt"));
    for (std::string line, key; std::getline(text, line);) {
        std::istringstream words(line);
        std::array<double, 3> numbers{};
        words >> key;
        if (key == "#")
            std::sscanf(line.c_str(), "# x = %lf + %lf x_v / z_v, y = %lf - %lf", &centreX, &scaleX, &centreY, &scaleY);
        for (double& number : numbers) words >> number;
        camera.try_emplace(key, numbers);
    }
    std::istringstream obj(test::readText(folder / "check_me.obj"));
    std::size_t vertex = 0;
    for (std::string line; std::getline(obj, line);) {
        std::array<double, 3> p{}, v{};
        if (std::sscanf(line.c_str(), "v %lf %lf %lf", &p[0], &p[1], &p[2]) != 3) continue;
        const std::array axes{"right", "up", "forward"};
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t c = 0; c < 3; ++c) v[a] += camera.at(axes[a])[c] * (p[c] - camera.at("eye")[c]);
        ASSERT_LT(vertex, screen.shape[0]);
        EXPECT_NEAR(centreX + scaleX * v[0] / v[2], screen.values[3 * vertex], 1e-3) << vertex;
        EXPECT_NEAR(centreY - scaleY * v[1] / v[2], screen.values[3 * vertex + 1], 1e-3) << vertex;
        ++vertex;
    }
    EXPECT_EQ(vertex, screen.shape[0]);
    const double fov = 2 * std::atan(100 / scaleY) * 180 / std::acos(-1.0);
    EXPECT_NEAR(camera.at("fov_y")[0], fov, 1e-9);
}

TEST(Compare, conventionsAreNoErrors) {
    const Handed handed;
    handed.give("color", blueFirst(turned(handed.all("color"))));
    handed.give("depth", window(turned(handed.all("z_view"))));
    handed.give("normal", turned(handed.all("normal")));
    const Json report = handed.json();
    EXPECT_EQ(report["exit"], 0);
    for (const char* name : {"color", "z_view", "normal"})
        EXPECT_EQ(conventionOf(report, name, "rows"), "bottom-up") << name;
    EXPECT_EQ(conventionOf(report, "color", "channels"), "bgr");
    EXPECT_EQ(conventionOf(report, "z_view", "depth"), "window");
    EXPECT_EQ(handed.json({"--strict"})["exit"], 1);
}

TEST(Compare, idsFromOneSignsOfZAndDotProductsCutOffAreNoErrors) {
    const Handed handed;
    const auto changed = [&](const char* name, auto change) {
        test::Npy array = handed.all(name);
        for (std::size_t i = 0; i < array.values.size(); ++i) array.values[i] = change(array.values[i], i);
        handed.give(name, array);
    };
    changed("polygon_id", [](double id, std::size_t) { return id + 1; });  // nothing, -1, is 0 then
    changed("vertices.view", [](double v, std::size_t i) { return i % 3 == 2 ? -v : v; });
    changed("n_dot_l.0", [](double v, std::size_t) { return std::max(0.0, v); });
    handed.give("color", handed.all("color"));
    const Json report = handed.json();
    EXPECT_EQ(report["exit"], 0) << report["headline"];
    EXPECT_EQ(conventionOf(report, "polygon_id", "ids"), "from-1");
    EXPECT_EQ(conventionOf(report, "vertices.view", "view_z"), "towards-viewer");
    EXPECT_EQ(conventionOf(report, "n_dot_l.0", "dot_products"), "cut-at-0");
}

TEST(Compare, aBackgroundThatIsNotBlackAndYUpwardsWithTheRowsAreNoErrors) {
    const Handed handed;
    test::Npy color = handed.all("color"), ids = handed.all("polygon_id"), screen = handed.all("vertices.screen");
    for (std::size_t i = 0; i < ids.values.size(); ++i)
        for (std::size_t c = 0; c < 3 && ids.values[i] < 0; ++c) color.values[3 * i + c] = c == 2 ? 77 : 51;
    for (std::size_t i = 1; i < screen.values.size(); i += 3)
        screen.values[i] = double(color.shape[0]) - screen.values[i];
    handed.give("color", turned(color));
    handed.give("vertices.screen", screen);
    const Json report = handed.json();
    EXPECT_EQ(report["exit"], 0) << report["headline"];
    EXPECT_EQ(conventionOf(report, "vertices.screen", "screen"), "y-up");
}

TEST(Compare, aShadowThatIsMissingIsNoEdgeThatHasMoved) {
    const Handed right, wrong({"light.0.shadow=off", "light.1.shadow=off"});
    right.give("color", wrong.all("color"));
    EXPECT_EQ(right.json({"--no-known"})["exit"], 1);
}

TEST(Compare, aShadowBufferIsComparedInItsOwnFrameOrNotAtAll) {
    const Handed handed;
    test::Npy buffer = handed.all("shadow_buffer.0"), other = buffer;
    const std::size_t side = buffer.shape[0];
    ASSERT_EQ(buffer.shape, (std::vector<std::size_t>{side, side}));
    for (std::size_t y = 0; y < side; ++y)  // x and y exchanged, and depth counted from elsewhere in another unit
        for (std::size_t x = 0; x < side; ++x) other.values[x * side + y] = 2.5 * buffer.values[y * side + x] - 7;
    handed.give("shadow_buffer.0", other);
    handed.give("color", handed.all("color"));
    EXPECT_EQ(handed.json()["exit"], 0);
    for (std::size_t i = 0; i < other.values.size(); ++i) other.values[i] = double(i * 7919 % 1009);
    handed.give("shadow_buffer.0", other);
    const auto done = handed.compare();
    EXPECT_EQ(done.status, 0);
    EXPECT_TRUE(test::has(done.out, "is not compared")) << done.out;
}

// The stages of a wrong picture with shadows, in the size that most renderers draw. 43 MB of it are the program itself
// with its libraries, measured with --version.
TEST(Compare, takesAtMost600MB) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer takes more than what it looks at";
#endif
    const test::TemporaryFolder folder;
    ASSERT_EQ(test::run({"export", kScene, "--size", "640x480", "--set", "shading=gouraud", "--format", "npy",
                         "--buffers", "color", "-o", folder / "mine"})
                  .status,
              0);
    const auto done = test::run({"compare", kScene, folder / "mine", "--size", "640x480", "--no-known"});
    EXPECT_EQ(done.status, 1) << done.out << done.err;
    EXPECT_LE(done.peakBytes, 600'000'000u);
}

// OpenGL's term is k_s s (N·H)^n fade spot, and all but the power is that of n = 0: the term of n = 150, which OpenGL refuses,
// is the square of that of 75 over that of 0.
TEST(Compare, exponentsAboveOpenGlsLimitAreCompared) {
    const std::vector<std::string> model{"model=opengl", "shading=phong"};
    const auto with = [&](const char* n) {
        std::vector<std::string> set = model;
        for (int i = 0; i < 6; ++i) set.push_back("material." + std::to_string(i) + ".n=" + n);
        return set;
    };
    const Handed half(with("75")), none(with("0"));
    test::Npy term = half.all("specular.0");
    const test::Npy whole = none.all("specular.0");
    bool shines = false;
    for (std::size_t i = 0; i < term.values.size(); ++i) {
        term.values[i] = whole.values[i] > 0 ? term.values[i] * term.values[i] / whole.values[i] : 0;
        shines = shines || term.values[i] > 0.1;
    }
    EXPECT_TRUE(shines);
    half.give("specular.0", term);
    const auto compared = [&](const char* n) {
        std::vector<std::string> more{"--no-known"};
        for (const std::string& one : with(n)) more.insert(more.end(), {"--set", one});
        return half.compare(more);
    };
    EXPECT_EQ(compared("150").status, 0) << compared("150").out << compared("150").err;
    EXPECT_EQ(compared("120").status, 1);
}

TEST(Compare, aBufferThatAgreesTakesNoNameAway) {
    const Handed right, wrong({"shading=gouraud"});
    for (const char* name : {"overdraw", "object_id", "position", "shadow_buffer.0"}) right.give(name, right.all(name));
    right.give("color", wrong.all("color"));
    const Json report = right.json();
    ASSERT_EQ(report["known"].size(), 1u) << report.dump(1);
    EXPECT_EQ(report["known"][0]["id"], "gouraud-for-phong");
}

TEST(Compare, mineTomlOverridesWhatIsFound) {
    const Handed handed;
    handed.give("color", turned(handed.all("color")));
    test::writeText(handed.file("mine.toml"), "rows = \"top-down\"\n");
    EXPECT_EQ(handed.json({"--no-known"})["exit"], 1);
    test::writeText(handed.file("mine.toml"), "rows = \"upside-down\"\n");
    const auto done = handed.compare();
    EXPECT_EQ(done.status, 3);
    EXPECT_TRUE(test::has(done.err, "mine.toml:1:8")) << done.err;
}

TEST(Compare, mineTomlSpeaksOfOneFileToo) {
    const Handed handed;
    handed.give("color", turned(handed.all("color")));
    handed.give("normal", handed.all("normal"));
    test::writeText(handed.file("mine.toml"), "rows = \"bottom-up\"\n[normal]\nrows = \"top-down\"\n");
    EXPECT_EQ(handed.json({"--no-known"})["exit"], 0);
    test::writeText(handed.file("mine.toml"), "rows = \"bottom-up\"\n");
    EXPECT_EQ(handed.json({"--no-known"})["exit"], 1);
    test::writeText(handed.file("mine.toml"), "[normals_of_mine]\nrows = \"top-down\"\n");
    EXPECT_EQ(handed.compare().status, 3);
}

TEST(Compare, namesAnErrorThatExplainsTheFiles) {
    const Handed right, wrong({"shading=gouraud"});
    right.give("depth", right.all("z_view"));
    right.give("color", wrong.all("color"));
    const Json report = right.json();
    EXPECT_EQ(report["exit"], 1);
    EXPECT_EQ(report["first_wrong"]["stage"], "shading");
    ASSERT_EQ(report["known"].size(), 1u) << report.dump(1);
    EXPECT_EQ(report["known"][0]["id"], "gouraud-for-phong");
    EXPECT_TRUE(right.json({"--no-known"})["known"].empty());
    EXPECT_TRUE(right.json({"--hints", "1"})["known"].empty());
}

TEST(Compare, neverGuessesAnErrorThatIsNotKnown) {
    const Handed handed;
    test::Npy color = handed.all("color");
    for (std::size_t i = 0; i < color.values.size(); ++i) color.values[i] = std::floor(color.values[i] / 64) * 64;
    handed.give("color", color);
    const Json report = handed.json();
    EXPECT_EQ(report["exit"], 1);
    EXPECT_TRUE(report["known"].empty()) << report["known"].dump(1);
}

TEST(Compare, aFileOfAnotherSizeIsToldAndTheOthersAreCompared) {
    const Handed handed;
    handed.give("color", handed.all("color"));
    test::Npy z = handed.all("z_view");
    z.shape = {50, 160};
    handed.give("depth", z);
    test::writeText(handed.file("normal.npy"), "no array");
    const auto done = handed.compare();
    EXPECT_EQ(done.status, 3);
    EXPECT_TRUE(test::has(done.out, "160 × 50")) << done.out;
    EXPECT_TRUE(test::has(done.out, "normal.npy:0")) << done.out;
    EXPECT_TRUE(test::has(done.out, "color")) << done.out;
}

TEST(Compare, whatAFileLacksIsSaidWithItsCure) {
    const Handed handed;
    handed.give("color", handed.all("color"));
    test::Npy z = handed.all("z_view"), normal = handed.all("normal");
    std::swap(z.shape[0], z.shape[1]);
    handed.give("depth", z);
    normal.shape = {3, normal.shape[0], normal.shape[1]};
    handed.give("normal", normal);
    test::writeText(handed.file("object_id.jpg"), "");
    const auto done = handed.compare();
    EXPECT_EQ(done.status, 3);
    EXPECT_TRUE(test::has(done.out, "as depth of this scene has; rows come before columns")) << done.out;
    EXPECT_TRUE(test::has(done.out, "(NumPy's shape 3, 100, 160)")) << done.out;
    EXPECT_TRUE(test::has(done.out, "channels come last")) << done.out;
    EXPECT_TRUE(test::has(done.out, "\"object_id.jpg\" is not read: its ending is none of npy")) << done.out;
    EXPECT_TRUE(test::has(handed.compare({"--tolerance", "colr=2"}).err, "the nearest name is color"));
    EXPECT_TRUE(test::has(handed.compare({"--stage", "zbuffer"}).err, "the stages are transform, cull"));
}

TEST(Compare, aFolderThatIsNoRenderersSaysWhatToHandIn) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "final.png", "");
    const auto done = test::run({"compare", kScene, folder.path().string()});
    EXPECT_EQ(done.status, 3);
    EXPECT_TRUE(test::has(done.err, "no file here has a known name")) << done.err;
    EXPECT_EQ(test::run({"compare", kScene, (folder / "missing").string()}).status, 3);
    EXPECT_EQ(test::run({"compare", kScene, folder.path().string(), "--tolerance", "colour=2x"}).status, 2);
}

TEST(Compare, thePageNeedsNothingElse) {
    const Handed handed;
    test::Npy color = handed.all("color");
    for (double& v : color.values) v *= 0.5;
    handed.give("color", color);
    handed.give("<b>", color);
    const std::string page = handed.file("report.html").string();
    EXPECT_EQ(handed.compare({"-o", page}).status, 1);
    const std::string html = test::readText(page);
    EXPECT_TRUE(html.starts_with("<!DOCTYPE html>"));
    EXPECT_EQ(html.find("http"), html.npos);
    EXPECT_EQ(html.find("<b>.npy"), html.npos);  // a file's name is text
    EXPECT_TRUE(test::has(html, "&lt;b&gt;.npy"));
    EXPECT_TRUE(test::has(html, "Hint 3"));
    // One mends, compares again and looks at the same page.
    handed.give("color", handed.all("color"));
    EXPECT_EQ(handed.compare({"-o", page}).status, 0);
    EXPECT_NE(test::readText(page), html);
    EXPECT_EQ(handed.compare({"-o", handed.file("color.npy/report.html").string()}).status, 4);
}

}  // namespace
