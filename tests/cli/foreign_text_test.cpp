// Files of strangers on the command line: nothing that they hold reaches a terminal as a command, a message stays a line.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using test::has;
using test::run;

// A title of the terminal's window, red, red by C1, a line turned round, an invisible space, half a character.
constexpr std::string_view kHostile = "<b>x\x1b]0;P\x07\x1b[31m\xc2\x9b\x33\x31m\xe2\x80\xae\xe2\x80\x8b\xff";

// What of a text could command a terminal: bytes below space but for line and tabulator, 0x7f, C1 (U+0080 to U+009F),
// marks of direction (U+202A to U+202E, U+2066 to U+2069). Looked for byte by byte.
std::string commandsIn(const std::string& text) {
    std::string found;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = [&](std::size_t k) {
            return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0u;
        };
        const bool control = (byte(0) < 0x20 && text[i] != '\n' && text[i] != '\t') || byte(0) == 0x7f;
        const bool c1 = byte(0) == 0xc2 && byte(1) >= 0x80 && byte(1) <= 0x9f;
        const bool turns = byte(0) == 0xe2 && ((byte(1) == 0x80 && byte(2) >= 0xaa && byte(2) <= 0xae) ||
                                               (byte(1) == 0x81 && byte(2) >= 0xa6 && byte(2) <= 0xa9));
        if (control || c1 || turns) found += fmt::format("{:02x} at {}, ", byte(0), i);
    }
    return found;
}

void expectHarmless(const test::Finished& done, const std::string& what) {
    EXPECT_EQ(commandsIn(done.out), "") << what << "\n" << done.out;
    EXPECT_EQ(commandsIn(done.err), "") << what << "\n" << done.err;
    EXPECT_LT(done.status, 128) << what;
}

std::string replaced(std::string text, std::string_view with) {
    for (auto at = text.find('@'); at != text.npos; at = text.find('@', at + with.size())) text.replace(at, 1, with);
    return text;
}

// As JSON and TOML spell it: these readers take no raw control character, but this one.
constexpr std::string_view kSpelled = R"(<b>x\u001b]0;P\u0007\u001b[31m\u009b31m\u202e\u200b\n)";

constexpr std::string_view kTriangle = "v 0 0 0\nv 1 0 0\nv 0 0 1\n";

class ForeignFiles : public testing::Test {
protected:
    std::string file(const std::string& name, const std::string& text) {
        test::writeText(folder / name, text);
        return folder / name;
    }
    std::string toml(const std::string& lines, const std::string& object = "") {
        return lines +
               "\n[camera]\nkind=\"look-at\"\neye=[0,-3,0]\n[[light]]\nposition=[0,-5,1]\nintensity=100\n[[object]]\n" +
               (object.empty() ? "shape=\"box\"" : object) + "\n";
    }

    test::TemporaryFolder folder;
};

// Every text field of every format, raw and spelled.
TEST_F(ForeignFiles, AreReadOrRefusedWithoutACommandForTheTerminal) {
    std::vector<std::string> files;
    int number = 0;
    const auto add = [&](const std::string& ending, const std::string& pattern) {
        for (const std::string_view text : {kHostile, kSpelled})
            files.push_back(file(fmt::format("f{}.{}", number++, ending), replaced(pattern, text)));
    };
    for (const char* line : {"title = \"@\"", "look = \"@\"", "title = '@'", "model = \"@\"", "\"@\" = 1", "@ = 1",
                             "model = @", "set = [\"@\"]", "width = \"@\"", "# @", "title = \"\"\"@\n@\"\"\""})
        add("toml", toml(line));
    for (const char* object :
         {"name=\"@\"\nshape=\"box\"", "mesh=\"@\"", "shape=\"@\"", "shape=\"box\"\nmaterial={\"@\"=1}"})
        add("toml", toml("", object));
    add("scene", "200, 1000, 45, 60\n1\n@\n1, 1, 1\n0, 0, 0\n0, 0, 0\n1\n1, 1, 1, 100\n50\n");
    add("scene", "200, @\n");
    add("des", "@");
    add("obj", "o @\ng @\n" + std::string(kTriangle) + "f 1 2 3\n");
    add("obj", "mtllib @\nusemtl @\n" + std::string(kTriangle) + "f 1 2 3\n");
    add("obj", std::string(kTriangle) + "f 1 2 @\n@\n");
    const std::string mtl = file("m.mtl", replaced("newmtl @\nKd 1 0 @\nmap_Kd @\n@ 1\n", kHostile));
    files.push_back(
        file("withmtl.obj", replaced("mtllib m.mtl\nusemtl @\n", kHostile) + std::string(kTriangle) + "f 1 2 3\n"));
    add("ply", "ply\nformat ascii 1.0\ncomment @\nobj_info @\nelement @ 3\nproperty float @\nend_header\n");
    add("stl", "solid @\nfacet normal 0 0 @\n");
    add("gltf", R"({"asset":{"version":"2.0","generator":"@"},"scene":0,"scenes":[{"name":"@","nodes":[0]}],
        "nodes":[{"name":"@","mesh":0}],"meshes":[{"name":"@","primitives":[{"attributes":{"@":0}}]}],
        "materials":[{"name":"@","alphaMode":"@"}],"extensionsRequired":["@"],"buffers":[{"uri":"@"}]})");
    add("gltf", "@");
    add("png", "\x89PNG\r\n\x1a\n@");
    add("xyz", "@");
    for (const std::string& one : files)
        for (const std::vector<std::string>& command :
             {std::vector<std::string>{"plan", one}, {"plan", one, "--json"}, {"inspect", one, "--pixel", "320,240"}})
            expectHarmless(run(command), command[0] + ' ' + one + ": " + test::readText(one).substr(0, 200));
}

TEST_F(ForeignFiles, OfTheProgramsOwnAreReadOrRefusedWithoutACommandForTheTerminal) {
    for (const std::string_view text : {kHostile, kSpelled}) {
        const std::string cues =
            file("c.cues", replaced("title = \"@\"\nminutes = 10\n[[cue]]\nname = \"@\"\ncaption = \"@\"\n"
                                    "note = \"@\"\nask = \"@\"\nchoices = [\"@\"]\nright = \"@\"\nscene = \"@\"\nstage "
                                    "= \"@\"\n\"@\" = 1\n",
                                    text));
        for (const std::string& named : {cues, cues + ":" + std::string(text)})
            expectHarmless(run({"present", named}), named);
        expectHarmless(run({"present", "--check", cues}), "check");
        const std::string study = file("s.json", replaced(R"({"format":"@","format_version":1})", text));
        expectHarmless(run({"study", "merge", study, "-o", folder / "out"}), "study");
        const std::string own = file(
            "s2.json", replaced(R"({"format":"shadescope study","format_version":1,"@":"@","scene":["@"]})", text));
        expectHarmless(run({"study", "merge", own, "-o", folder / "out"}), "study");
        fs::create_directories(folder / "lesson");
        file("lesson/lesson.md",
             replaced("title: @\nlecture: @\nsummary: @\nscene: pyramid\n\n# H @\nstage: shading\n\n"
                      "@ ![@](@)\n\nquestion: @?\nanswer: 1\nhint: @\n",
                      text == kHostile ? kHostile : "\\u001b"));
        for (const std::vector<std::string>& command :
             {std::vector<std::string>{"lesson", "show", folder / "lesson"},
              {"lesson", "show", folder / "lesson", "--json"},
              {"lesson", "export", folder / "lesson", "-o", folder / "handout"}})
            expectHarmless(run(command), command[1]);
        // A page of HTML obeys no control character; marks of direction belong to its languages.
        const std::string handout = test::readText(folder / "handout" / "lesson.html");
        for (const char* one : {"\x1b", "\x07", "\xc2\x9b", "\xff"}) EXPECT_FALSE(has(handout, one)) << one;
        file("lesson/lesson.md",
             replaced("title: t\n@: @\nscene: @\n# H\nstage: @\nbuffers: @\nset: @\npixel: @\n{@}\n", text));
        expectHarmless(run({"lesson", "show", folder / "lesson"}), "a broken lesson");
    }
}

TEST_F(ForeignFiles, NamesAndArgumentsAreEscapedToo) {
    const std::string odd = "a\nb\x1b[31m\xe2\x80\xae.toml";
    const std::string here = file(odd, toml("title = \"t\"\nwidth = 0"));
    const auto refused = run({"plan", here});
    EXPECT_EQ(refused.status, 3);
    EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1) << refused.err;
    EXPECT_TRUE(has(refused.err, "a\\x0ab\\x1b[31m\\u202e.toml:2")) << refused.err;
    const std::string text(kHostile);
    for (const std::vector<std::string>& command : {std::vector<std::string>{text},
                                                    {"plan", text},
                                                    {"plan", "pyramid", text},
                                                    {"plan", "pyramid", "--set", text},
                                                    {"plan", "pyramid", "--" + text},
                                                    {"inspect", "pyramid", "--pixel", text},
                                                    {"inspect", "pyramid", "--where", text},
                                                    {"export", "pyramid", "--buffers", text, "-o", folder / "o"},
                                                    {"export", "pyramid", "-o", folder / text},
                                                    {"lesson", "show", text},
                                                    {"lesson", "export", "pyramid", "-o", folder / text},
                                                    {"check", text},
                                                    {"present", text},
                                                    {"study", "pyramid", "--sweep", text, "-o", folder / "o"}})
        expectHarmless(run(command), command.back());
}

// toml++ puts what it found into its message, with its line's end.
TEST_F(ForeignFiles, AMessageOfALibraryIsALine) {
    const auto broken = run({"plan", file("b.toml", "model = \"opengl\"\ntwo_sided = tr\nucmea[eraa]\n")});
    EXPECT_EQ(broken.status, 3);
    EXPECT_EQ(std::ranges::count(broken.err, '\n'), 1) << broken.err;
    EXPECT_TRUE(has(broken.err, "b.toml:2:")) << broken.err;
    EXPECT_TRUE(has(broken.err, "tr\\x0a")) << broken.err;
    const auto title = run({"plan", file("e.toml", "two_sided = tr\x1b]0;PWNED\x07\n")});
    EXPECT_EQ(title.status, 3);
    EXPECT_TRUE(has(title.err, "tr\\x1b]0;PWNED\\x07") || !has(title.err, "PWNED")) << title.err;
    EXPECT_EQ(commandsIn(title.err), "");
}

// Markup and quotes are no control characters: they stay, and each format escapes them as it does.
TEST_F(ForeignFiles, MarkupInNamesIsTextInEveryFileThatIsWritten) {
    const std::string name = R"(a<b>"x"</b>,'y'&\ $z_$%#*/ =1+1|`w`)";
    std::string quoted;
    for (const char c : name) quoted += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    const std::string scene =
        file("s.toml", toml("title = \"" + quoted + "\"", "name = \"" + quoted + "\"\nshape=\"box\""));
    const fs::path out = folder / "out";
    const auto done = run({"export", scene, "-o", out, "--format", "png,csv,npy,exr,vtk,scene"});
    ASSERT_EQ(done.status, 0) << done.err;
    std::size_t read = 0;
    for (const auto& entry : fs::recursive_directory_iterator(out)) {
        const std::string text = test::readText(entry.path());
        const std::string ending = entry.path().extension();
        if (ending == ".json") {
            const Json json = Json::parse(text, nullptr, false);
            ASSERT_FALSE(json.is_discarded()) << entry.path();
            ++read;
        }
        if (ending == ".toml") {
            const auto again = run({"plan", entry.path()});
            EXPECT_TRUE(again.out.starts_with(name + ", ")) << again.out.substr(0, 100) << again.err;
            ++read;
        }
        if (ending == ".csv" || ending == ".json" || ending == ".toml") {
            EXPECT_EQ(commandsIn(text), "") << entry.path();
        }
    }
    EXPECT_GE(read, 2u);
}

}  // namespace
