// shadescope compare: the headline, on files of renderers that nobody of this program has written (tests/student/cases), and
// on files that hold nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path kHandedIn = SHADESCOPE_CASES;

Json verdictOf(const std::string& folder, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"compare", (kHandedIn / "scene.toml").string(), folder, "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Json::parse(test::run(arguments).out, nullptr, false);
}
Json verdictOfCase(const std::string& name) { return verdictOf((kHandedIn / name).string()); }

std::vector<std::string> named(const Json& report) {
    std::vector<std::string> ids;
    for (const Json& one : report["known"]) ids.push_back(one["id"]);
    return ids;
}
using Ids = std::vector<std::string>;

TEST(Verdict, namesWhatStudentsDo) {
    const Json untouched = verdictOfCase("c50_normals_untouched");
    EXPECT_EQ(untouched["first_wrong"]["stage"], "normals") << untouched["headline"];
    EXPECT_EQ(named(untouched), Ids{"normals-untouched"}) << untouched["headline"];
    const Json times = verdictOfCase("c52_times_n");
    EXPECT_EQ(named(times), Ids{"times-n"}) << times["headline"];
    EXPECT_EQ(times["first_wrong"]["stage"], "shading");
    const Json brackets = verdictOfCase("c53_r_parenthesis");
    EXPECT_EQ(named(brackets), Ids{"r-parenthesis"}) << brackets["headline"];
    EXPECT_EQ(brackets["first_wrong"]["stage"], "shading");
    const Json column = verdictOfCase("c55_one_column_over");
    EXPECT_EQ(named(column), Ids{"column"}) << column["headline"];
}

// Without its name the files of an error are not those of another: a wrong name is worse than none.
TEST(Verdict, aKnownErrorMayBeLeftOut) {
    const std::string folder = (kHandedIn / "c52_times_n").string();
    EXPECT_TRUE(named(verdictOf(folder, {"--without", "times-n"})).empty());
    const auto wrong = test::run({"compare", (kHandedIn / "scene.toml").string(), folder, "--without", "time-n"});
    EXPECT_EQ(wrong.status, 2);
    EXPECT_TRUE(test::has(wrong.err, "the nearest is times-n")) << wrong.err;
}

TEST(Verdict, oneMayStandForDrawnWhateverTheShadeIs) {
    const Json report = verdictOfCase("c59_verdict_one_is_drawn");
    EXPECT_NE(report["first_wrong"]["stage"], "cull");
    bool isSaid = false;
    for (const Json& one : report["conventions"])
        isSaid = isSaid || (one["buffer"] == "polygons.verdict" && one["value"] == "kept-is-1");
    EXPECT_TRUE(isSaid) << report["conventions"].dump(1);
    EXPECT_EQ(named(report), Ids{"times-n"}) << report["headline"];
}

TEST(Verdict, aLayerOfAnExrIsItsNormal) {
    const Json report = verdictOfCase("c60_exr_layer_names");
    EXPECT_EQ(report["exit"], 0) << report["headline"];
    EXPECT_EQ(report["stages"][5]["buffers"].size(), 2u);
}

TEST(Verdict, visibilityIsJudgedBeforeShading) {
    const Json report = verdictOfCase("c64_depth_wrong_three_files");
    EXPECT_EQ(report["first_wrong"]["stage"], "z-buffer") << report["headline"];
    EXPECT_EQ(report["first_wrong"]["certain"], false);
    EXPECT_EQ(named(report), Ids{"z-flip"});
    EXPECT_NE(report["stages"][5]["verdict"], "wrong here");
}

// Right files of the cases' scene, to be spoilt. more: options of the export.
class Right {
public:
    explicit Right(const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{"export",    (kHandedIn / "scene.toml").string(),
                                           "--format",  "npy",
                                           "--buffers", "color,z_view,normal,polygon_id,polygons.verdict",
                                           "-o",        (m_folder / "all").string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto done = test::run(arguments);
        EXPECT_EQ(done.status, 0) << done.err;
        fs::create_directory(m_folder / "mine");
    }
    test::Npy all(const std::string& name) const { return test::readNpy(m_folder / ("all/" + name + ".npy")); }
    void give(const std::string& name, const test::Npy& array) const {
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
    std::string folder() const { return m_folder / "mine"; }
    std::string said() const {
        return test::run({"compare", (kHandedIn / "scene.toml").string(), folder(), "--no-known"}).out;
    }

private:
    test::TemporaryFolder m_folder;
};

TEST(Verdict, whatHoldsNothingAccusesNobody) {
    const Right right;
    test::Npy color = right.all("color"), depth = right.all("z_view");
    right.give("z_view", depth);
    for (double& v : color.values) v = 0;
    right.give("color", color);
    const Json empty = verdictOf(right.folder());
    EXPECT_EQ(empty["headline"], "Nothing is drawn.");
    EXPECT_TRUE(empty["known"].empty());
    EXPECT_EQ(empty["exit"], 1);
    // One depth, as who writes 0.5 for every fragment has it: the picture alone is judged.
    right.give("color", right.all("color"));
    for (double& v : depth.values) v = std::isfinite(v) ? 0.5 : 1;
    right.give("z_view", depth);
    const Json one = verdictOf(right.folder());
    EXPECT_EQ(one["exit"], 0) << one["headline"];
    EXPECT_TRUE(test::has(right.said(), "\"z_view.npy\" holds one depth everywhere: it is left out.")) << right.said();
}

// A silhouette, as of a renderer whose light never arrives: right depths beside it accuse nobody either.
TEST(Verdict, aPictureInOneColourAccusesNobody) {
    const Right right;
    test::Npy color = right.all("color");
    const test::Npy ids = right.all("polygon_id");
    for (std::size_t i = 0; i < ids.values.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) color.values[3 * i + c] = ids.values[i] < 0 ? 0 : 40 + 10 * double(c);
    right.give("color", color);
    right.give("z_view", right.all("z_view"));
    const Json report = verdictOf(right.folder());
    EXPECT_EQ(report["headline"], "The picture has one colour.");
    EXPECT_EQ(report["exit"], 1);
    EXPECT_TRUE(report["known"].empty()) << report["known"].dump(1);
    EXPECT_TRUE(report["first_wrong"]["stages"].empty()) << report["first_wrong"].dump(1);
    // Two colours are what a renderer shades.
    for (std::size_t i = 0; i < ids.values.size(); ++i)
        if (ids.values[i] == 3) color.values[3 * i] += 20;
    right.give("color", color);
    EXPECT_NE(verdictOf(right.folder(), {"--no-known"})["headline"], "The picture has one colour.");
}

// Rows and columns of a square picture are told apart by what it shows.
TEST(Verdict, aSquarePictureWithRowsForColumnsIsRefused) {
    const Right right({"--size", "60x60"});
    test::Npy depth = right.all("z_view");
    const test::Npy before = depth;
    for (std::size_t y = 0; y < 60; ++y)
        for (std::size_t x = 0; x < 60; ++x) depth.values[x * 60 + y] = before.values[y * 60 + x];
    right.give("z_view", depth);
    right.give("color", right.all("color"));
    const Json report = verdictOf(right.folder(), {"--size", "60x60"});
    EXPECT_EQ(report["exit"], 3);
    EXPECT_EQ(report["headline"], "z_view.npy could not be compared; the other files agree.");
    EXPECT_TRUE(test::has(report["problems"].dump(), "rows and columns exchanged")) << report["problems"].dump(1);
}

// Ids and depth are right, so culling was: a table that no known convention explains is not to blame for the picture.
TEST(Verdict, aTableIsNotAccusedWhereTheRightPolygonsAreSeen) {
    const Right right;
    test::Npy color = right.all("color"), verdicts = right.all("polygons.verdict");
    for (double& v : color.values) v = std::floor(v / 2);
    for (std::size_t p = 0; p < verdicts.values.size(); ++p) verdicts.values[p] = double(p % 2);
    right.give("color", color);
    right.give("polygons.verdict", verdicts);
    for (const char* name : {"z_view", "polygon_id"}) right.give(name, right.all(name));
    const Json report = verdictOf(right.folder(), {"--no-known"});
    EXPECT_EQ(report["stages"][1]["verdict"], "cannot tell");
    for (const Json& stage : report["first_wrong"]["stages"]) EXPECT_NE(stage, "cull") << report["headline"];
    EXPECT_FALSE(report["first_wrong"]["stages"].empty());
    EXPECT_EQ(report["first_wrong"]["buffer"], "color");
    // Where it is all that differs it is named, and nobody is sure.
    right.give("color", right.all("color"));
    const Json alone = verdictOf(right.folder(), {"--no-known"});
    EXPECT_EQ(alone["first_wrong"]["stage"], "cull") << alone["headline"];
    EXPECT_EQ(alone["first_wrong"]["certain"], false);
}

// Depths that no error explains, of the stages before shading: the picture alone has a name, and says that it is alone.
TEST(Verdict, thePictureHasANameWhereTheDepthHasNone) {
    const Right spoilt({"--set", "defect=half-angle"});
    test::Npy depth = spoilt.all("z_view");
    for (std::size_t i = 0; i < depth.values.size(); ++i) depth.values[i] *= i / 8 % 2 ? 1.01 : 1.02;
    const Right mine;
    mine.give("color", spoilt.all("color"));
    mine.give("z_view", depth);
    const Json report = verdictOf(mine.folder());
    EXPECT_EQ(named(report), Ids{"half-angle"}) << report["headline"];
    EXPECT_EQ(report["likely"], "Your color is that of a renderer with this error.");
    EXPECT_EQ(report["first_wrong"]["stage"], "transform");
    EXPECT_EQ(report["first_wrong"]["certain"], false);
    // Of depths that agree it is none: who shades the right polygons has not mistaken the angle.
    mine.give("z_view", mine.all("z_view"));
    EXPECT_TRUE(named(verdictOf(mine.folder())).empty());
}

// A wrong picture is nearest to something; what goes into mine.toml counts for all files.
TEST(Verdict, aWrongFileAloneGivesNoAdviceForTheFolder) {
    const Right right;
    const auto turned = [](test::Npy picture, double factor) {
        const test::Npy before = picture;
        const std::size_t line = picture.values.size() / picture.shape[0];
        for (std::size_t i = 0; i < picture.values.size(); ++i)
            picture.values[i] = std::floor(factor * before.values[(picture.shape[0] - 1 - i / line) * line + i % line]);
        return picture;
    };
    const std::string advice = "write into mine.toml:  rows = \"bottom-up\"";
    right.give("color", turned(right.all("color"), 0.8));
    EXPECT_TRUE(test::has(right.said(), "rows bottom-up")) << right.said();
    EXPECT_FALSE(test::has(right.said(), "mine.toml")) << right.said();
    test::Npy depth = right.all("z_view"), other = depth;
    for (std::size_t y = 0; y < 60; ++y)
        for (std::size_t x = 0; x < 96; ++x) other.values[(59 - y) * 96 + x] = depth.values[y * 96 + x];
    right.give("z_view", other);
    EXPECT_TRUE(test::has(right.said(), advice)) << right.said();
    // Of two orders of rows neither counts for the folder, though each file is right in its own.
    right.give("z_view", depth);
    right.give("color", turned(right.all("color"), 1));
    EXPECT_FALSE(test::has(right.said(), "mine.toml")) << right.said();
}

TEST(Verdict, aRefusedFileIsNamedInTheHeadline) {
    const Right right;
    right.give("color", right.all("color"));
    test::Npy normal = right.all("normal");
    normal.shape = {2, 3}, normal.values.resize(6);
    right.give("polygons.normal", normal);
    const Json report = verdictOf(right.folder());
    EXPECT_EQ(report["exit"], 3);
    EXPECT_EQ(report["headline"], "polygons.normal.npy could not be compared; the other files agree.");
}

TEST(Verdict, oneWrongBufferIsNotTurnedRoundToMakeItFit) {
    const Right right;
    right.give("z_view", right.all("z_view"));
    right.give("normal", right.all("normal"));
    // Upside down and darker: were it read bottom-up, it would be nearer.
    test::Npy color = right.all("color");
    const std::size_t line = color.values.size() / color.shape[0];
    test::Npy turned = color;
    for (std::size_t y = 0; y < color.shape[0]; ++y)
        for (std::size_t i = 0; i < line; ++i)
            turned.values[y * line + i] = 0.8 * color.values[(color.shape[0] - 1 - y) * line + i];
    right.give("color", turned);
    const Json report = verdictOf(right.folder(), {"--no-known"});
    for (const Json& one : report["conventions"]) EXPECT_NE(one["value"], "bottom-up") << report["conventions"].dump(1);
    // If nothing else is wrong with it, all files agree, and it is said.
    for (double& v : turned.values) v /= 0.8;
    right.give("color", turned);
    EXPECT_EQ(verdictOf(right.folder())["exit"], 0);
}

TEST(Verdict, aMirroredPictureIsSaidInTheFirstLines) {
    const Right right;
    for (const char* name : {"color", "z_view"}) {
        test::Npy picture = right.all(name);
        const std::size_t channels = picture.values.size() / picture.shape[0] / picture.shape[1];
        const test::Npy before = picture;
        for (std::size_t i = 0; i < picture.values.size(); ++i) {
            const std::size_t c = i % channels, x = i / channels % picture.shape[1],
                              y = i / channels / picture.shape[1];
            picture.values[i] = before.values[(y * picture.shape[1] + picture.shape[1] - 1 - x) * channels + c];
        }
        right.give(name, picture);
    }
    const std::string said = right.said();
    EXPECT_LT(said.find("Your picture is mirrored."), said.find("transform")) << said;
}

TEST(Verdict, theWorstPixelShowsTheFilesOwnNumber) {
    const Right right;
    test::Npy color = right.all("color"), ids = right.all("polygon_id");
    for (std::size_t i = 0; i < ids.values.size(); ++i)
        for (std::size_t c = 0; c < 3 && ids.values[i] < 0; ++c) color.values[3 * i + c] = c == 2 ? 77 : 51;
    // A hole in the middle of the house shows the background.
    for (std::size_t i = 0; i < ids.values.size(); ++i)
        if (ids.values[i] == 3)
            for (std::size_t c = 0; c < 3; ++c) color.values[3 * i + c] = c == 2 ? 77 : 51;
    right.give("color", color);
    EXPECT_TRUE(test::has(right.said(), "mine 51 51 77")) << right.said();
    EXPECT_EQ(verdictOf(right.folder(), {"--no-known"})["first_wrong"]["mine"], Json({51, 51, 77}));
}

// A picture that cuts off what is brighter than white, of a scene whose I_max is above it: by hand from the intensities.
TEST(Verdict, whatIsBrighterThanWhiteMayBeCutOff) {
    const test::TemporaryFolder folder;
    const std::string scene = (kHandedIn / "scene.toml").string();
    ASSERT_EQ(
        test::run({"export", scene, "--format", "npy", "--buffers", "color,intensity,z_view", "-o", folder / "all"})
            .status,
        0);
    const Right right;
    right.give("z_view", right.all("z_view"));
    test::Npy color = test::readNpy(folder / "all/intensity.npy");
    std::size_t cut = 0;
    for (double& v : color.values) {
        cut += v > 100;
        v = std::floor(std::clamp(v / 100, 0.0, 1.0) * 255 + 0.5);
    }
    EXPECT_GT(cut, 50u) << "else nothing is tried";
    right.give("color", color);
    const Json report = verdictOf(right.folder());
    EXPECT_EQ(report["exit"], 0) << report["headline"];
    bool isSaid = false;
    for (const Json& one : report["conventions"]) isSaid = isSaid || one["value"] == "white-is-100";
    EXPECT_TRUE(isSaid) << report["conventions"].dump(1);
    // Half as bright all over is no such picture.
    for (double& v : color.values) v = std::floor(v / 2);
    right.give("color", color);
    EXPECT_EQ(verdictOf(right.folder(), {"--no-known"})["exit"], 1);
}

// The frames of known errors are not kept, and of the reference's buffers those are read that somebody asks for: all of
// them were 4.8 GB at half this size.
TEST(Verdict, namesTakeAtMost600MB) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer takes memory of its own";
#endif
    const test::TemporaryFolder folder;
    const std::string scene = (kHandedIn / "scene.toml").string();
    const auto done = test::run({"export", scene, "--size", "640x480", "--set", "defect=no-max", "--format", "npy",
                                 "--buffers", "color,z_view,normal", "-o", folder / "mine"});
    ASSERT_EQ(done.status, 0) << done.err;
    const auto compared = test::run({"compare", scene, folder / "mine", "--size", "640x480"});
    EXPECT_EQ(compared.status, 1) << compared.err;
    EXPECT_LE(compared.peakBytes, std::size_t{600} * 1000 * 1000);
}

// Eleven files of two lights took 800 MB while the values of every buffer were kept.
TEST(Verdict, namesOfElevenFilesTakeAtMost700MB) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer takes memory of its own";
#endif
    const test::TemporaryFolder folder;
    const std::string scene = (kHandedIn / "scene.toml").string();
    const auto done =
        test::run({"export", scene, "--size", "640x480", "--set", "defect=no-max", "--format", "npy", "--buffers",
                   "color,z_view,normal,polygon_id,n_dot_l.0,shadow.0,ambient,diffuse.0,specular.0,"
                   "intensity,r_dot_v.0",
                   "-o", folder / "mine"});
    ASSERT_EQ(done.status, 0) << done.err;
    const auto compared = test::run({"compare", scene, folder / "mine", "--size", "640x480"});
    EXPECT_EQ(compared.status, 1) << compared.err;
    EXPECT_LE(compared.peakBytes, std::size_t{700} * 1000 * 1000);
}

}  // namespace
