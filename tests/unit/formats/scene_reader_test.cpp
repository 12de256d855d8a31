// What a bad scene description gets, and which files a scene may name.
#include "pipeline/formats/scene_reader.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "pipeline/core/text.h"
#include "pipeline/formats/format_table.h"
#include "tests/support/looks.h"

namespace pipeline {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kTriangle = "3 1\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n0.2 0.5 0.9 0.4 8\n";

// A scene with one object, in lines like the lecture's.
std::string sceneOf(std::string_view object) {
    return "200 1000 45 60\n1\n" + std::string(object) + "\n1 1 1\n0 0 0\n0 0 0\n1\n5 5 5 100\n50\n";
}

// As a message writes 1e-9.
const std::string kSmallest = shortestText(1e-9);

// A folder of its own for each test.
class SceneReader : public testing::Test {
protected:
    void SetUp() override {
        const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
        m_root = fs::temp_directory_path() / ("scene_reader_" + std::to_string(getpid()) + "_" + test->name());
        fs::create_directories(folder());
        write("t.des", kTriangle);
    }
    void TearDown() override { fs::remove_all(m_root); }

    fs::path folder() const { return m_root / "scenes"; }
    fs::path write(const fs::path& name, std::string_view text) const {
        std::ofstream(folder() / name, std::ios::binary) << text;
        return folder() / name;
    }
    Result<Scene> read(std::string_view text) const { return readScene(write("s.scene", text)); }

    // Messages with the folder taken out of them.
    std::string errorsOf(const Result<Scene>& scene) const {
        if (scene) return "";
        std::string text = format(scene.errors());
        const std::string prefix = folder().string() + '/';
        for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
            text.erase(at, prefix.size());
        return text;
    }
    std::string errorsIn(std::string_view text) const { return errorsOf(read(text)); }

private:
    fs::path m_root;
};

TEST_F(SceneReader, SceneWithATriangle) { EXPECT_EQ(errorsIn(sceneOf("t.des")), ""); }

TEST_F(SceneReader, NoSuchScene) { EXPECT_EQ(errorsOf(readScene(folder() / "no.scene")), "no.scene: no such file\n"); }

TEST_F(SceneReader, MissingObjectFile) {
    EXPECT_EQ(errorsIn(sceneOf("pyramid.des")), "s.scene:3:1: \"pyramid.des\": no such file\n");
}

TEST_F(SceneReader, MissingFileIsReportedOnce) {
    EXPECT_EQ(errorsIn("200 1000 45 60\n2\na.des 1 1 1 0 0 0 0 0 0\na.des 1 1 1 0 0 0 0 0 0\n0\n50"),
              "s.scene:3:1: \"a.des\": no such file\n");
}

TEST_F(SceneReader, ObjectFileInAFolderBelow) {
    fs::create_directory(folder() / "below");
    write("below/b.des", kTriangle);
    EXPECT_EQ(errorsIn(sceneOf("below/b.des")), "");
    EXPECT_EQ(errorsIn(sceneOf("below/../t.des")), "");
}

TEST_F(SceneReader, FileOutsideTheFolder) {
    write("../a.des", kTriangle);
    fs::create_directory(folder() / "../scenes2");  // its name begins like the folder's
    write("../scenes2/a.des", kTriangle);
    const std::string absolute = (folder() / "t.des").string();
    for (const std::string& name :
         {std::string("../a.des"), std::string("../scenes2/a.des"), std::string("x/../../a.des"),
          std::string("/etc/passwd"), std::string("//etc/passwd").substr(1)})
        EXPECT_EQ(errorsIn(sceneOf(name)),
                  "s.scene:3:1: \"" + name + "\" leaves the scene's folder; put the file beside the scene\n");
    EXPECT_FALSE(read(sceneOf(absolute)));
}

TEST_F(SceneReader, SymbolicLinkThatLeavesTheFolder) {
    write("../a.des", kTriangle);
    fs::create_symlink("../a.des", folder() / "link.des");
    fs::create_directory_symlink("..", folder() / "up");
    fs::create_symlink("t.des", folder() / "inside.des");
    EXPECT_EQ(errorsIn(sceneOf("link.des")),
              "s.scene:3:1: \"link.des\" leaves the scene's folder; put the file beside the scene\n");
    EXPECT_EQ(errorsIn(sceneOf("up/a.des")),
              "s.scene:3:1: \"up/a.des\" leaves the scene's folder; put the file beside the scene\n");
    EXPECT_EQ(errorsIn(sceneOf("inside.des")), "");
}

TEST_F(SceneReader, SymbolicLinkToItself) {
    fs::create_symlink("loop.des", folder() / "loop.des");
    EXPECT_EQ(errorsIn(sceneOf("loop.des")), "s.scene:3:1: \"loop.des\" cannot be read\n");
}

TEST_F(SceneReader, FolderAndDeviceInsteadOfAFile) {
    fs::create_directory(folder() / "d.des");
    EXPECT_EQ(errorsIn(sceneOf("d.des")), "s.scene:3:1: \"d.des\": this is a folder, expected a file\n");
    EXPECT_EQ(errorsOf(readScene(folder() / "d.des")), "d.des: this is a folder, expected a file\n");
    EXPECT_EQ(errorsOf(readScene("/dev/zero")), "/dev/zero: this is not a regular file, expected a file\n");
}

TEST_F(SceneReader, ControlCharactersInAFileName) {
    EXPECT_EQ(errorsIn(sceneOf("t\x1B.des")),
              "s.scene:3:1: found \"t\\x1B.des\", expected a file name without control characters\n");
    EXPECT_EQ(errorsIn(sceneOf(std::string_view("t.des\0x", 7))),
              "s.scene:3:1: found \"t.des\\x00x\", expected a file name without control characters\n");
}

TEST_F(SceneReader, FileNameWithoutEnd) {
    EXPECT_EQ(errorsIn(sceneOf(std::string(300, 'n'))).substr(0, 53), "s.scene:3:1: \"" + std::string(39, 'n'));
    EXPECT_EQ(errorsIn(sceneOf(std::string(5000, 'n'))),
              "s.scene:3:1: found a word of 5 000 bytes, expected the file name of object 0\n");
}

TEST_F(SceneReader, FileThatCannotBeRead) {
    // A regular file whose first byte gives an input error, for the super-user as well.
    if (!fs::is_regular_file("/proc/self/mem")) GTEST_SKIP() << "no /proc here";
    EXPECT_EQ(errorsOf(readScene("/proc/self/mem")), "/proc/self/mem: the file cannot be read\n");
}

TEST_F(SceneReader, FileWithoutPermission) {
    if (geteuid() == 0) GTEST_SKIP() << "the super-user may read everything";
    fs::permissions(folder() / "t.des", fs::perms::none);
    EXPECT_EQ(errorsIn(sceneOf("t.des")), "s.scene:3:1: \"t.des\": the file cannot be read\n");
}

TEST_F(SceneReader, ErrorsOfAllFilesTogetherInOrder) {
    write("bad.des", "3 1\n0 0 x 1 0 0 0 1 0\n3 0 1 9\n0.2 0.5 0.9 0.4 8\n");
    EXPECT_EQ(
        errorsIn("0 1000 45 60\n2\nbad.des 1 1 1 0 0 0 0 0 0\nmissing.des 1 1 1 0 0 0 0 0 y\n1\n5 5 5 -1e10\n50\n"),
        "s.scene:1:1: found \"0\", expected d screen, a number from " + kSmallest +
            " to 1e9\n"
            "bad.des:2:5: found \"x\", expected z of vertex 0, a number from -1e9 to 1e9\n"
            "bad.des:3:7: found \"9\", expected a vertex index from 0 to 2\n"
            "s.scene:4:1: \"missing.des\": no such file\n"
            "s.scene:4:29: found \"y\", expected translation z, a number from -1e9 to 1e9\n"
            "s.scene:6:7: found \"-1e10\", expected I_p intensity, a number from -1e9 to 1e9\n");
}

// Of a file with a model's ending no more than the beginning is read at first.
TEST_F(SceneReader, AnObjectFileMayEndAsAModelDoes) {
    const fs::path pyramid = resourceFolder() / "scenes" / "pyramid.des";
    const std::string text = *readFile(pyramid) + std::string(100'000, ' ') + "\n";
    write("long.ply", text), write("long.des", text);
    for (const char* name : {"long.ply", "long.des"})
        EXPECT_EQ(errorsOf(readScene(write("t.toml", std::string("[[object]]\nmesh = \"") + name + "\"\n"))), "")
            << name;
}

TEST_F(SceneReader, OneObjectTooManyAnnounced) {
    EXPECT_EQ(errorsIn("200 1000 45 60\n2\nt.des 1 1 1 0 0 0 0 0 0\n1\n5 5 5 100\n50\n   // and more\n"),
              "s.scene:4:1: found \"1\", expected the file name of object 1\n");
}

TEST_F(SceneReader, OneObjectTooFewAnnounced) {
    EXPECT_EQ(errorsIn("200 1000 45 60\n1\nt.des 1 1 1 0 0 0 0 0 0\nt.des 1 1 1 0 0 0 0 0 0\n1\n5 5 5 100\n50\n"),
              "s.scene:4:1: found \"t.des\", expected the number of light sources, from 0 to 4 096\n");
}

TEST_F(SceneReader, OneLightTooManyAnnounced) {
    EXPECT_EQ(errorsIn("200 1000 45 60\n1\nt.des 1 1 1 0 0 0 0 0 0\n2\n5 5 5 100\n50 // I_a\n"),
              "s.scene:7:1: found the end of the file, expected L y, a number from -1e9 to 1e9\n");
}

TEST_F(SceneReader, OneLightTooFewAnnounced) {
    EXPECT_EQ(errorsIn("200 1000 45 60\n1\nt.des 1 1 1 0 0 0 0 0 0\n1\n5 5 5 100\n9 9 9 100\n50\n"),
              "s.scene:6:3: found \"9\", expected the end of the file\n");
}

TEST_F(SceneReader, FarTooManyAnnounced) {
    EXPECT_EQ(errorsIn("1 1 1 1\n4294967295\nt"),
              "s.scene:2:1: 4 294 967 295 objects announced, the file ends after 20 bytes\n");
    EXPECT_EQ(errorsIn("200 1000 45 60\n1\nt.des 1 1 1 0 0 0 0 0 0\n4294967295\n5 5 5 100\n50\n"),
              "s.scene:4:1: 4 294 967 295 light sources announced, the file ends after 65 bytes\n");
}

TEST_F(SceneReader, NothingInIt) {
    EXPECT_EQ(errorsIn(""),
              "s.scene:1:1: found the end of the file, expected d screen, a number from " + kSmallest + " to 1e9\n");
    EXPECT_EQ(errorsIn("// a\n// b\n"),
              "s.scene:3:1: found the end of the file, expected d screen, a number from " + kSmallest + " to 1e9\n");
}

TEST_F(SceneReader, TextAfterTheEnd) {
    EXPECT_EQ(errorsIn(sceneOf("t.des") + "50"), "s.scene:10:1: found \"50\", expected the end of the file\n");
}

TEST_F(SceneReader, WhatTheSettingsTableRefusesTogether) {
    EXPECT_EQ(
        errorsIn("200 1000 45 60\n1\nt.des 1 1 1 0 0 0 0 0 0\n1\n0 0 0 100\n50\n"),
        "s.scene:5:1: light 0 is at infinity in the direction (0, 0, 0), expected a direction that is not zero\n");
}

TEST_F(SceneReader, NamesOfObjectsAreDistinct) {
    write("t 2.des", "");
    const std::string object = "t.des 1 1 1 0 0 0 0 0 0\n";
    const Result<Scene> scene = read("200 1000 45 60\n3\n" + object + object + object + "0\n50\n");
    ASSERT_TRUE(scene) << errorsOf(scene);
    EXPECT_EQ(scene->objects[0].name, "t");
    EXPECT_EQ(scene->objects[1].name, "t 2");
    EXPECT_EQ(scene->objects[2].name, "t 3");
}

TEST_F(SceneReader, ContentsDecideTheFormatAndTheExtensionWhereTheyDoNot) {
    const std::string scene = "200 1000 45 60 1 t.des 1 1 1";
    EXPECT_EQ(findFormat(scene, ".des")->extension, ".scene");
    EXPECT_EQ(findFormat(kTriangle, ".txt")->extension, ".des");
    EXPECT_EQ(findFormat("x y z", ".SCENE")->extension, ".scene");
    EXPECT_EQ(findFormat("x y z", ".txt"), nullptr);
    const fs::path file = write("a.txt", "x y z");
    EXPECT_EQ(errorsOf(readScene(file)), "a.txt: found no scene, expected " + knownFormats() + "\n");
}

TEST_F(SceneReader, AScenesBeginningIsNotTakenForAnObject) {
    const std::string whole = sceneOf("t.des");
    ASSERT_TRUE(findFormat(whole, ".scene"));
    for (std::size_t end = whole.find_first_of(" \n"); end != whole.npos; end = whole.find_first_of(" \n", end + 1)) {
        const std::string begun = whole.substr(0, end);
        EXPECT_EQ(findFormat(begun, ".scene")->extension, ".scene") << begun;
        EXPECT_EQ(errorsIn(begun).find("vertices"), std::string::npos) << errorsIn(begun);
    }
    EXPECT_EQ(errorsIn("200 1000 45\n"),
              "s.scene:2:1: found the end of the file, expected φ from z, a number from -1000000 to 1000000\n");
    // An object stays one, whatever it is called.
    EXPECT_EQ(findFormat("3 1\n0 0 5 1 0 0 0 1 0\n3 0 1 2\n0.2 0.5 0.9 0.4 8\n", ".scene")->extension, ".des");
}

TEST_F(SceneReader, ASceneMayHaveNoObject) {
    const Result<Scene> dark = read("200, 1000, 45, 60\n0\n0\n50\n");
    ASSERT_TRUE(dark) << errorsOf(dark);
    EXPECT_EQ(dark->objects.size() + dark->lights.size(), 0u);
    const Result<Scene> lit = read("200, 1000, 45, 60\n0\n1\n5 5 5 100\n50\n");
    ASSERT_TRUE(lit) << errorsOf(lit);
    EXPECT_EQ(lit->lights.size(), 1u);
}

TEST_F(SceneReader, ModelOpensAsAScene) {
    // A box of 2, 4 and 4 around (1, 2, 2): half its diagonal is 3, the eye is four times as far. OBJ is y-up: (x, y, z) of
    // the file is (x, -z, y) here, and the middle (1, -2, 2).
    const std::string square = "v 0 0 0\nv 2 0 0\nv 2 4 0\nv 0 4 4\n";
    const Result<Scene> scene = readScene(write("m.OBJ", square + "o a\nf 1 2 3\no b\nf 1 3 4\n"));
    ASSERT_TRUE(scene) << format(scene.errors());
    ASSERT_EQ(scene->objects.size(), 2u);
    for (const Object& object : scene->objects) EXPECT_EQ(object.transform.translation, Vec3d(-1, 2, -2));
    EXPECT_DOUBLE_EQ(scene->camera.rho, 12);
    EXPECT_EQ(scene->lights.size(), 1u);
    EXPECT_EQ(scene->settings.shading, Shading::Flat);

    const Result<Scene> smooth = readScene(write("n.obj", square + "vn 0 0 1\nf 1//1 2//1 3//1\n"));
    ASSERT_TRUE(smooth) << format(smooth.errors());
    EXPECT_EQ(smooth->settings.shading, Shading::Phong);
}

TEST_F(SceneReader, ModelMayBeginWithAnyBytes) {
    // The header of a binary STL file is free: here as an object description, and as one endless word.
    for (const std::string& start : {std::string(kTriangle), std::string(80, 'x')}) {
        std::string stl = start;
        stl.resize(84, ' ');
        stl.replace(80, 4, std::string("\0\x02\0\0", 4));  // 512 facets, all zero
        stl.resize(84 + 50 * 512, '\0');
        EXPECT_EQ(
            errorsOf(readScene(write("m.stl", stl))),
            "m.stl: found no polygon; 512 polygons have fewer than three different corners, and so no area; they are "
            "left out, expected a model with polygons\n");
    }
}

TEST_F(SceneReader, ModelNamesFilesBesideIt) {
    const auto read = [&](const std::string& named) {
        return readScene(write("m.obj", "mtllib " + named + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"));
    };
    const auto outside = read("../x.mtl");
    ASSERT_TRUE(outside) << "its materials are not worth the geometry";
    EXPECT_NE(outside->remarks.at(0).text.find("\"../x.mtl\" leaves the scene's folder"), std::string::npos);
    EXPECT_EQ(outside->objects[0].material, Material());
    // Written on another machine: the same file, its letters in another case, with a path that is no more.
    write("Paint.mtl", "newmtl a\nKd 1 0 0\n");
    for (const std::string named : {"Paint.mtl", "paint.MTL", "C:\\models\\paint.mtl", "/models/of/1998/Paint.mtl",
                                    "..\\Paint.mtl", "textures/paint.mtl"}) {
        const auto scene = read(named);
        ASSERT_TRUE(scene) << named;
        EXPECT_EQ(scene->objects[0].material.diffuse, Vec3d(1, 0, 0)) << named;
        const bool said = std::ranges::any_of(scene->remarks, [](const Remark& remark) {
            return remark.text.find("\"Paint.mtl\" is read in its place") != std::string::npos;
        });
        EXPECT_EQ(said, named != "Paint.mtl") << named;
    }
}

// Kilobytes that this process has held at most.
long peakMemory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

// By this process, from files of any kind.
std::size_t bytesRead() {
    std::size_t bytes = 0;
    std::string name;
    std::ifstream("/proc/self/io") >> name >> bytes;  // "rchar: 123"
    return bytes;
}

constexpr std::size_t kHundredMegabytes = 100'000'000;

// In small pieces, so that writing does not raise the peak.
void writeHundredMegabytes(const fs::path& file, std::string_view start, std::string_view pattern) {
    std::ofstream stream(file, std::ios::binary);
    stream << start;
    for (std::size_t size = start.size(); size < kHundredMegabytes; size += pattern.size()) stream << pattern;
}

TEST_F(SceneReader, HundredMegabytesOfDigitsAreNotEvenRead) {
    const fs::path digits = folder() / "digits.scene";
    writeHundredMegabytes(digits, "", "1234567890");
    const long before = peakMemory();
    const std::size_t readBefore = bytesRead();
    EXPECT_EQ(errorsOf(readScene(digits)),
              "digits.scene:1:1: found a word of more than 4 096 bytes, expected " + knownFormats() + "\n");
    EXPECT_LT(bytesRead() - readBefore, 200'000u) << "the beginning, and what a count itself reads";
    EXPECT_LT(peakMemory() - before, 10'000);
}

// Each byte is read once, and looked at a few times at most.
TEST_F(SceneReader, HundredMegabytesOfDigitsInsideAFileAreReadOnce) {
    writeHundredMegabytes(folder() / "t.des", "3 1\n0 0 ", "1234567890");
    const fs::path scene = write("s.scene", sceneOf("t.des"));
    const std::size_t readBefore = bytesRead();
    const test::Looks looks;
    EXPECT_EQ(errorsOf(readScene(scene, {{}, test::Looks::stop()})),
              "t.des:2:5: found a word of 100 000 000 bytes, expected z of vertex 0, a number from -1e9 to 1e9\n"
              "t.des:2:100000005: found the end of the file, expected x of vertex 1, a number from -1e9 to 1e9\n");
    EXPECT_LT(bytesRead() - readBefore, kHundredMegabytes + 200'000);
    EXPECT_LT(test::Looks::items(), 3 * kHundredMegabytes);
}

TEST_F(SceneReader, HundredMegabytesOfNumbersAreReadOnce) {
    writeHundredMegabytes(folder() / "t.des", "4294967295 1\n", "1 2 3 4 5 ");
    const fs::path scene = write("s.scene", sceneOf("t.des"));
    const std::size_t readBefore = bytesRead();
    const test::Looks looks;
    EXPECT_EQ(errorsOf(readScene(scene, {{}, test::Looks::stop()})),
              "t.des:1:1: 4 294 967 295 vertices announced, the file ends after 100 000 003 bytes\n");
    EXPECT_LT(bytesRead() - readBefore, kHundredMegabytes + 200'000);
    EXPECT_LT(test::Looks::items(), 3 * kHundredMegabytes);
}

TEST_F(SceneReader, FileAboveTheLimit) {
    // A sparse file: 256 MiB and a byte of zeros.
    const fs::path file = write("big.scene", "200 1000 45 60 1 t.des");
    fs::resize_file(file, (std::uintmax_t{256} << 20) + 1);
    EXPECT_EQ(errorsOf(readScene(file)),
              "big.scene: the file is larger than 268 435 456 bytes, expected a smaller file\n");
}

}  // namespace
}  // namespace pipeline
