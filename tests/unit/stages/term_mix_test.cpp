// Mixing the terms of the illumination.
#include "pipeline/inspect/term_mix.h"

#include <gtest/gtest.h>

#include "pipeline/inspect/pixel_report.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

FramePtr frameToMix(const Scene& scene) { return test::frameOf(scene, mixBuffers()); }

std::vector<std::uint8_t> bytes(const AnyBuffer& buffer) {
    const auto data = std::get<std::span<const std::uint8_t>>(buffer.data);
    return {data.begin(), data.end()};
}

MixedPicture mixed(const Frame& frame, const TermMix& mix) {
    auto picture = mixTerms(frame, mix);
    EXPECT_TRUE(picture) << picture.errors().front().found;
    return std::move(picture).value();
}

TermMix alone(const Frame& frame, const char* name) {
    TermMix mix = plainMix(frame.scene().lights.size());
    for (TermStrip& strip : mix) strip.solo = strip.name() == name;
    return mix;
}

}  // namespace

// Of every model, shading and precision, with several lights, shadows and translucent layers: with every gain 1 the
// picture is the frame buffer to the last bit.
TEST(TermMix, EveryTermAsItIsGivesTheFrameBuffer) {
    for (int seed = 1; seed <= 12; ++seed) {
        Scene scene = test::randomScene(std::uint32_t(seed));
        scene.settings.model = Model(seed % 3);
        scene.settings.shading = Shading(seed / 3 % 3);
        const FramePtr frame = frameToMix(scene);
        if (!whyNoMix(scene).empty() || scene.settings.antialiasing != 1) continue;
        EXPECT_EQ(bytes(mixed(*frame, plainMix(scene.lights.size())).color), bytes(*frame->buffer({BufferId::Color})))
            << seed;
    }
}

// Pixel (268, 281) in blue: 45 + 69.714 + 0.025 of I_max = 175; round(255·x/175) of 45, 69.714, 2·69.714 + 45.025.
TEST(TermMix, GainsMultiplyTheTerms) {
    const FramePtr frame = frameToMix(test::pyramid());
    const auto blue = [&](const TermMix& mix) { return int(mixed(*frame, mix).color.value(268, 281, 2)); };
    EXPECT_EQ(blue(plainMix(1)), 167);
    EXPECT_EQ(blue(alone(*frame, "ambient")), 66);
    EXPECT_EQ(blue(alone(*frame, "diffuse 0")), 102);
    EXPECT_EQ(blue(alone(*frame, "emission")), 0);
    EXPECT_EQ(blue(*parseMix("diffuse.0=2", 1)), 255) << "184.453 is above I_max: clamped";
    EXPECT_GT(mixed(*frame, *parseMix("diffuse.0=2", 1)).clamped, 0u);
    EXPECT_EQ(mixed(*frame, plainMix(1)).clamped, 0u) << "I_max is what no pixel exceeds";
}

TEST(TermMix, SoloSilencesTheOthersAndMuteWins) {
    TermMix mix = plainMix(1);
    mix[1].solo = mix[2].solo = true;
    mix[2].gain = 3;
    EXPECT_EQ(weight(mix, 0), 0);
    EXPECT_EQ(weight(mix, 1), 1);
    EXPECT_EQ(weight(mix, 2), 3);
    EXPECT_EQ(describe(mix), "ambient, diffuse 0 × 3 alone");
    mix[1].muted = true;
    EXPECT_EQ(weight(mix, 1), 0);
    EXPECT_EQ(describe(plainMix(2)), "every term");
    EXPECT_EQ(describe(*parseMix("ambient=0,specular.0=2.5", 1)), "no ambient, specular 0 × 2.5");
}

TEST(TermMix, IsWrittenAsItIsRead) {
    EXPECT_EQ(mixText(plainMix(2)), "");
    for (const char* text : {"ambient=solo", "diffuse.0=2,specular.0=muted", "emission=0.25,emission=solo,ambient=0"})
        EXPECT_EQ(mixText(*parseMix(text, 1)), text);
    const auto twice = parseMix("ambient=0,diffuse.0=2,ambient=1", 1);
    ASSERT_FALSE(twice);
    EXPECT_EQ(twice.errors().front().found, "the gain of ambient is given twice");
    EXPECT_TRUE((*parseMix("ambient=solo", 1))[1].solo);
    EXPECT_EQ(mixed(*frameToMix(test::pyramid()), *parseMix("ambient=solo", 1)).color.name, BufferName{BufferId::Mix});
}

TEST(TermMix, NamesWhatIsWrong) {
    EXPECT_EQ(parseMix("diffuse.1=2", 1).errors()[0].expected, "emission, ambient, diffuse.0, specular.0");
    for (const char* wrong : {"ambient=5", "ambient=-1", "ambient", "ambient=nan", "ambient=1x"})
        EXPECT_EQ(parseMix(wrong, 1).errors()[0].expected, "ambient=GAIN, from 0 to 4, =solo or =muted") << wrong;
    // A frame of which nobody wanted the terms lacks them.
    const auto picture = mixTerms(*runFrame(std::make_shared<const Scene>(test::pyramid()), {}, nullptr), plainMix(1));
    ASSERT_FALSE(picture);
    EXPECT_NE(picture.errors()[0].found.find("emission"), std::string::npos) << picture.errors()[0].found;
}

}  // namespace pipeline
