// Files that appear in a folder together or not at all.
#include "pipeline/export/folder/staging.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <mutex>
#include <thread>

#include "pipeline/export/folder/owner.h"
#include "tests/support/files.h"

namespace pipeline {
namespace {

namespace fs = std::filesystem;

TEST(Staging, MakesAFolderThatWasNotThere) {
    const test::TemporaryFolder folder;
    auto staging = Staging::begin(folder / "a/b/out");
    ASSERT_TRUE(staging);
    test::writeText(staging->folder() / "x", "1");
    EXPECT_FALSE(fs::exists(folder / "a/b/out"));
    ASSERT_TRUE(std::move(staging).value().publish());
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a", "a/b", "a/b/out", "a/b/out/x"}));
}

TEST(Staging, LeavesNoTraceUnlessPublished) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "there");
    test::writeText(folder / "there/old", "old");
    for (const char* target : {"a/b/out", "out", "there"}) {
        const auto staging = Staging::begin(folder / target);
        ASSERT_TRUE(staging) << target;
        test::writeText(staging->folder() / "old", "new");
    }
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"there", "there/old"}));
    EXPECT_EQ(test::readText(folder / "there/old"), "old");
}

TEST(Staging, ReplacesFilesOfTheSameNameAlone) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "old", "old");
    test::writeText(folder / "other", "other");
    auto staging = Staging::begin(folder.path() / "");  // a folder's name may end in a slash
    ASSERT_TRUE(staging);
    test::writeText(staging->folder() / "old", "new");
    ASSERT_TRUE(std::move(staging).value().publish());
    EXPECT_EQ(test::readText(folder / "old"), "new");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"old", "other"}));
}

TEST(Staging, RefusesAFileInPlaceOfTheFolder) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "out", "");
    const auto staging = Staging::begin(folder / "out");
    ASSERT_FALSE(staging);
    EXPECT_EQ(format(staging.errors()[0]), (folder / "out").string() + ": could not write: Not a directory");
    EXPECT_FALSE(Staging::begin(folder / "out/deeper"));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"out"});
}

// Shards of one study at the same time: who has made the parents removes them where nothing is published, as after trying
// whether a folder can be written into, just when another has seen them there; and each finds the folder of the others
// there all of a sudden. Four of them with 100 tries each met within a few of 20 rounds.
TEST(Staging, OfManyAtOnceNoneTakesTheFolderFromAnother) {
    for (int round = 0; round < 20; ++round) {
        const test::TemporaryFolder folder;
        std::mutex mutex;
        std::vector<std::string> refused;
        const auto tell = [&](const auto& result) {
            const std::scoped_lock lock(mutex);
            if (!result) refused.push_back(format(result.errors()));
        };
        std::vector<std::jthread> shards;
        for (int shard = 0; shard < 4; ++shard)
            shards.emplace_back([&, shard] {
                for (int i = 0; i < 100; ++i) tell(Staging::begin(folder / "a/b/out"));
                auto staging = Staging::begin(folder / "a/b/out");
                tell(staging);
                if (!staging) return;
                test::writeText(staging->folder() / std::to_string(shard), "");
                tell(std::move(staging).value().publish());
            });
        shards.clear();  // waits
        EXPECT_EQ(refused, std::vector<std::string>{});
        EXPECT_EQ(folder.names(), (std::vector<std::string>{"a", "a/b", "a/b/out", "a/b/out/0", "a/b/out/1",
                                                            "a/b/out/2", "a/b/out/3"}));
        if (HasFailure()) return;
    }
}

TEST(Staging, MovesNothingWhenOneFileCannotMove) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "a", "old");
    fs::create_directory(folder / "b");  // stands where a file is to go
    {
        auto begun = Staging::begin(folder.path());
        ASSERT_TRUE(begun);
        Staging staging = std::move(begun).value();
        test::writeText(staging.folder() / "a", "new");
        test::writeText(staging.folder() / "b", "new");
        EXPECT_FALSE(staging.publish());
    }
    EXPECT_EQ(test::readText(folder / "a"), "old");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a", "b"}));
}

TEST(Staging, BringsBackWhatIsToGoWhenOneFileCannotMove) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "stale", "old");
    for (const bool fails : {true, false}) {
        auto begun = Staging::begin(folder.path());
        ASSERT_TRUE(begun);
        Staging staging = std::move(begun).value();
        test::writeText(staging.folder() / "a", "new");
        // A name that is not there any more fails after the first has been put aside.
        const auto published =
            staging.publish(fails ? std::vector<std::string>{"stale", "missing"} : std::vector<std::string>{"stale"});
        EXPECT_EQ(bool(published), !fails);
        EXPECT_EQ(fs::exists(folder / "stale"), fails);
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a"});
}

// A shared folder may hold what processes of other machines write; the host's name tells them from this one's.
TEST(Staging, RemovesWhatGoneProcessesOfThisMachineLeftAndNothingElse) {
    const test::TemporaryFolder folder;
    const pid_t gone = ::fork();
    if (gone == 0) ::_exit(0);
    int status = 0;
    ASSERT_EQ(::waitpid(gone, &status, 0), gone);

    const std::string ours = hiddenName(7);  // ".shadescope.part-HOST-PID-START-7"
    const std::string start = ".shadescope.part-",
                      host = ours.substr(start.size(), ours.find('-', start.size() + 1) - start.size());
    const std::string self = std::to_string(::getpid()), other = std::to_string(gone);
    const auto named = [&](const std::string& of, const std::string& process, const std::string& began) {
        return start + of + '-' + process + '-' + began + "-0";
    };
    const std::vector<std::string> stay{ours,                            // of this process, which lives
                                        named(host + "x", other, "5"),   // of another machine
                                        named(host, other, "5") + "-1",  // of another form
                                        start + host + "-" + other,      //
                                        named(host, "-1", "5"),
                                        named(host, "x", "5"),  //
                                        ".part-" + other,
                                        "out.part"};
    for (const std::string& name : stay) fs::create_directory(folder / name);
    // Of a process that is gone, and of one before this one that had its number.
    for (const std::string& name : {named(host, other, "5"), named(host, self, "5")}) {
        fs::create_directory(folder / name);
        test::writeText(folder / (name + "/file"), "left");
        fs::create_directory_symlink("/", folder / (name + "/link"));
    }
    test::writeText(folder / named(host, other, "6"), "a file");
    ASSERT_TRUE(Staging::begin(folder.path()));
    std::vector<std::string> expected = stay;
    std::ranges::sort(expected);
    EXPECT_EQ(folder.names(), expected);
    ASSERT_TRUE(writeWhole(folder / "notes.txt", "text"));  // next to files too
}

// A container has numbers of its own: where somebody holds the folder it is in use, whatever its name says.
TEST(Staging, LeavesAFolderThatSomebodyHolds) {
    const test::TemporaryFolder folder;
    const pid_t gone = ::fork();
    if (gone == 0) ::_exit(0);
    int status = 0;
    ASSERT_EQ(::waitpid(gone, &status, 0), gone);
    std::string name = hiddenName(0);
    const std::string self = '-' + std::to_string(::getpid()) + '-';
    name.replace(name.find(self), self.size(), '-' + std::to_string(gone) + '-');
    fs::create_directory(folder / name);
    const int held = ::open((folder / name).c_str(), O_RDONLY | O_DIRECTORY);
    ASSERT_EQ(::flock(held, LOCK_EX), 0);
    ASSERT_TRUE(Staging::begin(folder.path()));
    EXPECT_TRUE(fs::exists(folder / name));
    ::close(held);
    ASSERT_TRUE(Staging::begin(folder.path()));
    EXPECT_FALSE(fs::exists(folder / name));
}

TEST(Staging, BringsTheOldFilesBackWhenOneOfSeveralCannotMove) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a", "b", "index"}) test::writeText(folder / name, "old");
    auto begun = Staging::begin(folder.path());
    ASSERT_TRUE(begun);
    {
        Staging staging = std::move(begun).value();
        for (const char* name : {"a", "b", "index"}) test::writeText(staging.folder() / name, "new");
        EXPECT_FALSE(staging.publish({"missing"}, "index"));
    }
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a", "b", "index"}));
    for (const char* name : {"a", "b", "index"}) EXPECT_EQ(test::readText(folder / name), "old");
}

TEST(WriteWhole, KeepsPermissionsAndFollowsLinks) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "file", "old");
    fs::permissions(folder / "file", fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("file", folder / "link");
    ASSERT_TRUE(writeWhole(folder / "link", "new"));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(test::readText(folder / "file"), "new");
    EXPECT_EQ(fs::status(folder / "file").permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(folder.names().size(), 2u);
}

TEST(WriteWhole, LeavesWhatIsThereWhereItCannotWrite) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "file", "old");
    {
        const test::FullDisk full(2);
        const auto written = writeWhole(folder / "file", "newer");
        ASSERT_FALSE(written);
        EXPECT_EQ(format(written.errors()[0]), (folder / "file").string() + ": could not write: File too large");
    }
    EXPECT_FALSE(writeWhole(folder / "file/below", "new"));
    const auto missing = writeWhole(folder / "missing/file", "new");
    ASSERT_FALSE(missing);
    EXPECT_EQ(format(missing.errors()[0]),
              (folder / "missing/file").string() + ": could not write: No such file or directory");
    EXPECT_FALSE(writeWhole(folder.path(), "new"));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"file"});
    EXPECT_EQ(test::readText(folder / "file"), "old");
}

}  // namespace
}  // namespace pipeline
