// Runs that are ended by force while they write a folder, at every change that they make of it.
#include <gtest/gtest.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/cli/run_program.h"
#include "tests/support/files.h"
#include "tests/support/sweep.h"

namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;
using Files = std::map<std::string, std::string>;  // name, bytes

std::string sha256(const std::string& bytes) {
    std::array<unsigned char, 32> digest{};
    unsigned size = 0;
    EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr);
    std::string text;
    for (const unsigned char byte : digest) {
        constexpr const char* kDigits = "0123456789abcdef";
        text += kDigits[byte / 16], text += kDigits[byte % 16];
    }
    return text;
}

// Of what stands in a folder, hidden or not, the files that can be seen, and whether there is anything hidden.
struct Found {
    Files files;
    bool hidden = false;
};
Found filesIn(const fs::path& folder) {
    Found found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().lexically_relative(folder).string();
        if (name.starts_with('.'))
            found.hidden = true;
        else if (entry.is_regular_file())
            found.files[name] = test::readText(entry.path());
    }
    return found;
}

// Something that writes several files into a folder.
struct Writer {
    const char* name;
    std::string index;
    Arguments before, after;  // what is there, and what replaces it; without the folder
    // The files that the index names, with size and hash as it says: "123 0abc…".
    Files (*named)(const std::string& index);
};

Files namedInJson(const std::string& index) {
    Files named;
    for (const auto& entry : nlohmann::json::parse(index)["contents"])
        named[entry["file"]] =
            std::to_string(entry["bytes"].get<std::size_t>()) + ' ' + entry["sha256"].get<std::string>();
    return named;
}

Files namedInSheets(const std::string& index) {
    Files named;
    for (const auto& entry : nlohmann::json::parse(index)["files"])
        named[entry["file"]] =
            std::to_string(entry["bytes"].get<std::size_t>()) + ' ' + entry["sha256"].get<std::string>();
    return named;
}

// "<!-- Answers to a handout of 123 bytes, SHA-256 0abc… -->"
Files namedInAnswers(const std::string& index) {
    const std::string before = "<!-- Answers to a handout of ", between = " bytes, SHA-256 ";
    const auto at = index.rfind(before) + before.size(), comma = index.find(between, at);
    return {{"pyramid.html", index.substr(at, comma - at) + ' ' + index.substr(comma + between.size(), 64)}};
}

const std::string kSheets = std::string(SHADESCOPE_SCENES) + "/../sheets/light";

const std::array<Writer, 5> kWriters{{
    {"export",
     "manifest.json",
     {"export", "pyramid", "--size", "16x12", "--buffers", "depth,color,normal,z_view", "--format", "npy"},
     {"export", "pyramid", "--size", "20x12", "--buffers", "depth,color,overdraw", "--format", "npy,scene"},
     namedInJson},
    {"film",
     "film.json",
     {"film", "pyramid", "--size", "16x12", "--pictures", "5"},
     {"film", "pyramid", "--size", "20x12", "--pictures", "3"},
     namedInJson},
    {"study", "study.json", {"study", "merge", "16x12"}, {"study", "merge", "20x12"}, namedInJson},
    {"lesson",
     "pyramid-answers.html",
     {"lesson", "export", "pyramid"},
     {"lesson", "export", "pyramid"},
     namedInAnswers},
    {"sheet",
     "keys/sheets.json",
     {"sheet", kSheets, "--variants", "2", "--seed", "1"},
     {"sheet", kSheets, "--variants", "1", "--seed", "2"},
     namedInSheets},
}};

class EndedByForce : public testing::TestWithParam<Writer> {
protected:
    void SetUp() override {
        if (!test::kHasFaults) GTEST_SKIP() << "a sanitizer cannot be preloaded";
    }
    // A study that is merged alone writes the same files as one that has been measured, and at once.
    Arguments into(Arguments arguments, const fs::path& folder) {
        if (arguments[0] == "study") arguments[2] = studyOf(arguments[2]);
        arguments.insert(arguments.end(), {"-o", folder.string()});
        return arguments;
    }
    // Whether all that the index names is there as it says.
    static bool isWhole(const Files& files) {
        const auto index = files.find(GetParam().index);
        if (index == files.end()) return false;
        for (const auto& [name, sum] : GetParam().named(index->second)) {
            const auto file = files.find(name);
            if (file == files.end() || sum != std::to_string(file->second.size()) + ' ' + sha256(file->second))
                return false;
        }
        return true;
    }
    std::string studyOf(const std::string& size) {
        const fs::path made = m_studies / size;
        if (!fs::exists(made)) {
            const auto done = test::run({"study", "pyramid", "--size", size, "--set", "camera.scale=0.03", "--sweep",
                                         "shading=flat,phong", "--repeat", "1", "--warm-up", "0", "--processes", "1",
                                         "-o", made.string()});
            EXPECT_EQ(done.status, 0) << done.err;
        }
        return made / "study.json";
    }

    test::TemporaryFolder m_studies;

    static std::set<std::string> names(const Files& files) {
        std::set<std::string> all;
        for (const auto& [name, bytes] : files) all.insert(name);
        return all;
    }
};

// Either the folder is the one before or the new one, as its index says file by file, or it has no index and says so.
TEST_P(EndedByForce, LeavesTheOldFolderOrTheNewOneOrSaysThatItIsNeither) {
    const Writer& writer = GetParam();
    const std::string mark = fs::path(writer.index).filename().string() + ".unfinished";
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "old");
    test::writeText(folder / "old/notes.txt", "mine");
    const auto first = test::run(into(writer.before, folder / "old"));
    ASSERT_EQ(first.status, 0) << first.err;
    if (writer.before == writer.after) {  // of an older lesson, then
        const std::string sum = sha256("old");
        test::writeText(folder / "old/pyramid.html", "old");
        test::writeText(folder / "old/pyramid-answers.html", "<!-- Answers to a handout of 3 bytes, SHA-256 " + sum +
                                                                 " -->\n<footer>Shadescope 0</footer>\n");
    }
    const Files old = filesIn(folder / "old").files;
    ASSERT_TRUE(isWhole(old));

    fs::copy(folder / "old", folder / "new", fs::copy_options::recursive);
    const auto counts = test::countFaults(into(writer.after, folder / "new"));
    const Files fresh = filesIn(folder / "new").files;
    ASSERT_TRUE(isWhole(fresh));
    ASSERT_GT(counts.changes, 2 * fresh.size() - 3);  // each of them moves, and what was there before it

    std::map<std::string, int> seen;
    for (const std::size_t i : test::sweep(counts.changes)) {
        SCOPED_TRACE(testing::Message() << writer.name << ", change " << i + 1);
        const fs::path out = folder / "out";
        fs::copy(folder / "old", out, fs::copy_options::recursive);
        const auto ended = test::runWithFaults({{"KILL_AT", i + 1}}, into(writer.after, out));
        ASSERT_TRUE(ended.status == 128 + SIGKILL || i + 1 == counts.changes) << ended.status << ended.err;
        const Found found = filesIn(out);
        Files files = found.files;
        const bool isMarked = files.erase(mark) > 0;
        const bool isWritten = isWhole(files);
        const bool isOld = isWritten && files == old;
        const bool isNew = isWritten && names(files) == names(fresh) && files != old;
        ++seen[isOld ? "old" : isNew ? "new" : "neither"];
        if (!isOld && !isNew) {
            EXPECT_FALSE(files.contains(writer.index));
            EXPECT_TRUE(isMarked);
        }
        EXPECT_EQ(files["notes.txt"], "mine");

        const auto again = test::run(into(writer.after, out));
        EXPECT_EQ(again.status, 0) << again.err;
        // Handouts and sheets are always written whole, so that there is nothing to say.
        EXPECT_TRUE(isOld || isNew || writer.name == std::string("lesson") || writer.name == std::string("sheet") ||
                    test::has(again.err, writer.index + " is missing"))
            << again.err;
        const Found after = filesIn(out);
        EXPECT_FALSE(after.hidden);
        EXPECT_TRUE(isWhole(after.files));
        EXPECT_EQ(names(after.files), names(fresh));
        fs::remove_all(out);
        if (HasFailure()) return;
    }
    EXPECT_GT(seen["old"], 0);
    EXPECT_GT(seen["new"], 0);
    EXPECT_GT(seen["neither"], 0);
    for (const auto& [what, count] : seen) RecordProperty(what, count);
}

// A part of the process is done beside the folder then.
TEST_P(EndedByForce, LeavesNoFolderOrAWholeOneWhereThereWasNone) {
    const Writer& writer = GetParam();
    const test::TemporaryFolder folder;
    const auto counts = test::countFaults(into(writer.after, folder / "first/out"));
    const Files fresh = filesIn(folder / "first/out").files;
    ASSERT_TRUE(isWhole(fresh));
    for (const std::size_t i : test::sweep(counts.changes)) {
        SCOPED_TRACE(testing::Message() << writer.name << ", change " << i + 1);
        const fs::path out = folder / "a/out";
        test::runWithFaults({{"KILL_AT", i + 1}}, into(writer.after, out));
        EXPECT_TRUE(!fs::exists(out) || isWhole(filesIn(out).files));
        const auto again = test::run(into(writer.after, out));
        EXPECT_EQ(again.status, 0) << again.err;
        EXPECT_TRUE(isWhole(filesIn(out).files));
        EXPECT_EQ(names(filesIn(out).files), names(fresh));
        EXPECT_FALSE(filesIn(out).hidden);
        EXPECT_FALSE(filesIn(folder / "a").hidden);
        fs::remove_all(folder / "a");
        if (HasFailure()) return;
    }
}

INSTANTIATE_TEST_SUITE_P(Every, EndedByForce, testing::ValuesIn(kWriters),
                         [](const auto& writer) { return std::string(writer.param.name); });

}  // namespace
