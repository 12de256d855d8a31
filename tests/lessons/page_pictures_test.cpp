// The bits of every buffer that a page of a lesson shows as a picture, against those that page_pictures.txt holds. Nobody
// pastes a picture into a lesson, so a change of a scene or of the pipeline changes what its pages show: whoever makes one
// writes the file anew in the same commit, looks at the pages that it names, and asks whether their text is still true:
//   SHADESCOPE_WRITE_HASHES=1 build/headless/tests/lessons/lessons_tests --gtest_filter='PagePictures.*'
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "lessons/derived_buffer.h"
#include "lessons/library.h"
#include "lessons/pages/handout_figure.h"
#include "tests/support/hashes.h"

namespace lessons {
namespace {

// By "LESSON PAGE HALF BUFFER", pages from 1.
using Hashes = std::map<std::string, std::string>;

void add(const PageState& state, const pipeline::FramePtr& whole, const std::string& half, Hashes& hashes) {
    const pipeline::FramePtr frame = frameShown(state, whole, {});
    ASSERT_TRUE(frame) << half;
    // As a handout does, derived buffers included: the frame does not hold those.
    const pipeline::Tile part = partToShow(*frame, shownBuffers(state), pickedPixel(state));
    EXPECT_LT(part.min.x, part.max.x) << half;
    for (const pipeline::BufferName& name : shownBuffers(state)) {
        if (pipeline::bufferInfo(name.id).domain != pipeline::Domain::Pixel || pipeline::isDerived(name.id)) continue;
        const auto buffer = frame->buffer(name);
        hashes[half + ' ' + name.text()] = buffer ? test::hashOf(*buffer) : "absent";
    }
}

Hashes stored() {
    Hashes hashes;
    std::ifstream in(PAGE_PICTURES);
    for (std::string line; std::getline(in, line);)
        if (const auto space = line.rfind(' '); !line.empty() && line[0] != '#' && space != line.npos)
            hashes[line.substr(0, space)] = line.substr(space + 1);
    return hashes;
}

void write(const Hashes& hashes) {
    std::ofstream out(PAGE_PICTURES);
    out << "# Hashes of the buffers that the lessons' pages show: lesson, page, half, buffer, hash.\n"
           "# page_pictures_test.cpp says how to write this file anew.\n";
    for (const auto& [what, hash] : hashes) out << what << ' ' << hash << '\n';
    ASSERT_TRUE(out.flush()) << PAGE_PICTURES << " cannot be written";
}

TEST(PagePictures, AreThoseThatTheirTextWasWrittenFor) {
    Hashes hashes;
    for (const Lesson& lesson : allLessons().lessons)
        runPages(lesson, {}, [&](const Page& page, std::size_t number, const PageFrames& frames) {
            if (page.from) return;  // shown in its own lesson
            const std::string name = lesson.name + ' ' + pageName(lesson, number);
            add(page.first.state, frames.first, name + " first", hashes);
            if (page.then) add(page.then->state, frames.then, name + " then", hashes);
        });
    if (std::getenv("SHADESCOPE_WRITE_HASHES")) return write(hashes);
    const Hashes before = stored();
    for (const auto& [what, hash] : hashes) {
        const auto found = before.find(what);
        EXPECT_EQ(found == before.end() ? "nothing" : found->second, hash) << what;
    }
    EXPECT_EQ(before.size(), hashes.size()) << PAGE_PICTURES << " holds pages that there are not";
}

}  // namespace
}  // namespace lessons
