// Files that appear in a folder together or not at all.
#include "pipeline/export/staging.h"

#include <gtest/gtest.h>

#include <mutex>
#include <thread>

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

}  // namespace
}  // namespace pipeline
