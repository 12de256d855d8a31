// What someone has written into a cue list by hand stays when the program writes it.
#include "lessons/state/cue_text.h"

#include <gtest/gtest.h>

#include "lessons/state/toml_lines.h"

namespace lessons {
namespace {

// No program writes a list like this.
constexpr const char* kByHand = R"(# Lecture 1, second half
title = "Lecture 1"   # as in the timetable
minutes = 50

# Ask the back rows first.
[[cue]]
name    = "Why no highlight?"  # the question
note = '''
Wait. # this is no comment
'''
scene = "pyramid"
set = [
  "camera.theta=50",  # from the left
  "shading=flat",
]
stage = "shading"
# here R is far from V
pixel = [268, 281]
[[cue.view]]
buffer = "color"  # the frame
[cue.view3d]
space = "point"   # with the hemisphere

[[cue]]   # the second
name = "z-buffer"
scene = "two_pyramids"
# nothing follows
)";

CueList read(std::string_view text) {
    const auto list = readCues(text, "a.cues");
    EXPECT_TRUE(list) << format(list.errors()) << text;
    return list ? *list : CueList();
}
std::string write(const CueList& list) {
    const std::string text = cueText(list, kByHand, read(kByHand));
    EXPECT_TRUE(read(text) == list) << text;
    return text;
}
// By hand, with one part in place of another.
std::string with(std::string_view part, std::string_view by) {
    std::string text = kByHand;
    const auto at = text.find(part);
    EXPECT_NE(at, text.npos) << part;
    return text.replace(at, part.size(), by);
}

TEST(CueText, ItemsPutTogetherAreTheFile) {
    std::string all;
    for (const TomlItem& item : tomlItems(kByHand)) all += item.text;
    EXPECT_EQ(all, kByHand);
    for (const char* odd : {"", "a", "[", "a = \"", "a = '''", "a = [[", "\n\n#", "= 1", "[[\"a]\" . b]] # c"})
        for (const TomlItem& item : tomlItems(odd)) EXPECT_FALSE(item.text.empty()) << odd;
}

TEST(CueText, WhatHasNotChangedIsTheSameFile) { EXPECT_EQ(write(read(kByHand)), kByHand); }

TEST(CueText, AChangedNoteChangesNothingElse) {
    CueList list = read(kByHand);
    list.cues[0].note = "Wait longer.";
    EXPECT_EQ(write(list), with("note = '''\nWait. # this is no comment\n'''", "note = \"Wait longer.\""));
}

TEST(CueText, ANewNoteStandsWithTheCuesKeys) {
    CueList list = read(kByHand);
    list.cues[1].note = "Twice.";
    EXPECT_EQ(write(list), with("scene = \"two_pyramids\"\n", "scene = \"two_pyramids\"\nnote = \"Twice.\"\n"));
}

TEST(CueText, ATitleAndANameKeepTheirRemarks) {
    CueList list = read(kByHand);
    list.title = "Lecture 2";
    list.cues[0].name = "Where is R?";
    std::string expected = with("\"Lecture 1\"   #", "\"Lecture 2\"  #");
    expected.replace(expected.find("\"Why no highlight?\""), 19, "\"Where is R?\"");
    EXPECT_EQ(write(list), expected);
}

// The state has become another one: what is the same in both keeps its place, and every comment stays.
TEST(CueText, AnotherStateKeepsEveryComment) {
    CueList list = read(kByHand);
    WindowState& state = list.cues[0].state;
    state.pixel.reset();
    state.set = {"camera.theta=20"};
    state.views[0].buffer = "z_view";
    state.views.push_back({"overdraw"});
    state.arrangement = "buffer / buffer / 3d";
    state.spaces[0].space = "eye";
    const std::string text = write(list);
    for (const char* comment :
         {"# Lecture 1, second half\n", "# as in the timetable\n", "\n# Ask the back rows first.\n", "# the question\n",
          "# from the left\n", "# here R is far from V\n", "# the frame\n", "# with the hemisphere\n",
          "[[cue]]   # the second\n", "# nothing follows\n"})
        EXPECT_NE(text.find(comment), text.npos) << comment << text;
    EXPECT_NE(text.find("buffer = \"z_view\"  # the frame\n"), text.npos) << text;
    EXPECT_EQ(text.find("equation"), text.npos) << "what went without saying still does\n" << text;
}

TEST(CueText, FewerViewsLeaveTheirComments) {
    const std::string two = with("[cue.view3d]", "[[cue.view]] # beside it\nbuffer = \"normal\"\n[cue.view3d]");
    CueList list = read(two);
    list.cues[0].state.views.pop_back();
    list.cues[0].state.arrangement = "one";  // it went without saying that there were two
    const std::string text = cueText(list, two, read(two));
    EXPECT_TRUE(read(text) == list) << text;
    EXPECT_NE(text.find("# beside it\n[cue.view3d]"), text.npos) << text;
    EXPECT_NE(text.find("arrangement = \"one\""), text.npos) << text;
    EXPECT_NE(text.find("# from the left"), text.npos) << text;
}

TEST(CueText, CuesMoveWithTheirCommentsAndGoWithThem) {
    CueList list = read(kByHand);
    std::swap(list.cues[0], list.cues[1]);
    std::string text = write(list);
    EXPECT_LT(text.find("# the second"), text.find("# Ask the back rows first."));
    list.cues.pop_back();
    text = write(list);
    EXPECT_EQ(text.find("back rows"), text.npos);
    EXPECT_NE(text.find("# Lecture 1, second half"), text.npos);
    list.cues.push_back({"New", {}, {}, list.cues[0].state});
    EXPECT_NE(write(list).find("# nothing follows"), text.npos);
}

TEST(CueText, WhatIsWrittenInAnotherWayStaysRight) {
    const std::string odd = with("[cue.view3d]\nspace = \"point\"   # with the hemisphere\n",
                                 "[cue.view3d]\noptions = { boxes = 1 } # all of them\n");
    CueList list = read(odd);
    list.cues[0].state.spaces[0].options["boxes"] = 0;
    const std::string text = cueText(list, odd, read(odd));
    EXPECT_TRUE(read(text) == list) << text;
    EXPECT_NE(text.find("# all of them"), text.npos) << text;
    EXPECT_NE(text.find("# the frame"), text.npos) << text;
}

}  // namespace
}  // namespace lessons
