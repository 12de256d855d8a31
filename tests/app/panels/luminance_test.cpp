#include "app/look/luminance.h"

#include <gtest/gtest.h>

#include <QTest>

#include "app/buffer_view/buffer_channels.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "pipeline/buffers/palette.h"
#include "tests/support/scenes.h"

// The luminance of colours: the numbers, and a real view on lecture 1's pyramid that shows them.
namespace app {
namespace {

using pipeline::BufferId;

struct LuminanceTest : testing::Test {
    Document document;
    BufferView view{document};

    LuminanceTest() {
        view.resize(640, 560);
        view.show();
        document.setScene(test::pyramid());
    }
    void show(const pipeline::BufferName& name) {
        view.setBuffer(name);
        EXPECT_TRUE(QTest::qWaitFor(
            [&] { return !document.frames().busy() && view.shown() && view.shown()->buffer.name == name; }, 10000))
            << name.text();
    }
    pipeline::AnyBuffer buffer() { return *document.frames().shown()->buffer(view.buffer()); }
};

// Lecture 1's pyramid is blue: k is (0.2, 0.5, 0.9) for diffuse light, so of N·L x the luminance is
// (0.2126 · 0.2 + 0.7152 · 0.5 + 0.0722 · 0.9) x = 0.4651 x, of 100 x in red, green and blue.
TEST_F(LuminanceTest, LuminanceIsOneNumberInPlaceOfThree) {
    show({BufferId::Diffuse, 0});
    const auto diffuse = buffer();
    QTest::keyClick(view.canvas(), Qt::Key_L);
    const auto& shown = view.shown()->buffer;
    ASSERT_EQ(shown.shape, (std::vector<std::size_t>{480, 640}));
    const double x = diffuse.value(268, 281, 0) / 20;
    EXPECT_NEAR(shown.value(268, 281), 46.51 * x, 46.51 * 1e-6);
    EXPECT_EQ(view.shown()->source.shape, diffuse.shape);
    document.pointing().pick(glm::ivec2(268, 281));
    EXPECT_FALSE(view.shown()->scale.histogram.empty()) << "it has a range and a histogram";
    EXPECT_EQ(qAlpha(view.canvas()->content().image.pixel(QPoint(5, 5))), 0);
    EXPECT_EQ(view.state().channel, lessons::ShownChannel::Luminance);

    QTest::keyClick(view.canvas(), Qt::Key_C);
    EXPECT_EQ(view.shown()->buffer.shape, diffuse.shape);
    show({BufferId::Normal});
    QTest::keyClick(view.canvas(), Qt::Key_L);
    EXPECT_EQ(view.features().channel->channel(), lessons::ShownChannel::All) << "a direction has no luminance";
}

TEST_F(LuminanceTest, EveryPixelOfLightHasTheColourThatAnExportGivesIt) {
    show({BufferId::Intensity});
    const auto light = buffer();
    const auto range = view.shown()->look.range;
    int shaded = 0;
    for (std::size_t y = 0; y < 480; ++y)
        for (std::size_t x = 0; x < 640; ++x) {
            const QRgb shown = view.canvas()->content().image.pixel(int(x), int(y));
            if (qAlpha(shown) == 0) continue;
            const auto expected = elementColor(light, x, y, range);
            ASSERT_EQ(shown, qRgb(expected.r, expected.g, expected.b)) << x << ", " << y;
            shaded += light.value(x, y, 0) > 0;
        }
    EXPECT_GT(shaded, 1000);
}

// IEC 61966-2-1: the byte 188 is (188/255 + 0.055)/1.055 to the power of 2.4 = 0.5029 of white.
TEST(Luminance, OfBytesIsThatOfTheirLight) {
    EXPECT_EQ(linearLight(0), 0);
    EXPECT_EQ(linearLight(255), 1);
    EXPECT_NEAR(linearLight(188), 0.5029, 0.00005);
    EXPECT_DOUBLE_EQ(luminance(1, 1, 1), 1);
    const auto bytes = std::make_shared<std::vector<std::uint8_t>>(std::vector<std::uint8_t>{188, 188, 188, 0, 255, 0});
    const pipeline::AnyBuffer color{
        {BufferId::Color}, &bufferInfo(BufferId::Color), {1, 2, 3}, std::span<const std::uint8_t>(*bytes), bytes};
    const auto made = luminanceOf(color);
    EXPECT_NEAR(made.value(0, 0), 0.5029, 0.00005);
    EXPECT_DOUBLE_EQ(made.value(1, 0), 0.7152);
}

}  // namespace
}  // namespace app
