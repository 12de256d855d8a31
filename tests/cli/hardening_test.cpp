// What the linker does for a program that reads files of strangers.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string>

#include "tests/cli/run_program.h"

namespace {

std::string readelf() {
    const std::unique_ptr<FILE, int (*)(FILE*)> out(popen("readelf -hdlW '" SHADESCOPE_PROGRAM "'", "r"), pclose);
    std::string text;
    std::array<char, 4096> block;
    while (const std::size_t size = out ? std::fread(block.data(), 1, block.size(), out.get()) : 0)
        text.append(block.data(), size);
    return text;
}

TEST(Hardening, TheProgramIsLoadedAnywhereAndItsTablesAreReadOnly) {
    const std::string text = readelf();
    ASSERT_FALSE(text.empty());
    EXPECT_TRUE(test::has(text, "(Position-Independent Executable file)"));
    EXPECT_TRUE(test::has(text, "GNU_RELRO"));  // together with the next one all of the table of functions
    EXPECT_TRUE(test::has(text, "BIND_NOW") || test::has(text, "Flags: NOW"));
    EXPECT_FALSE(test::has(text, "RWE")) << "a segment that can be written and run";
}

}  // namespace
