#include "app/canvas/shadow_overlay.h"

#include <gtest/gtest.h>

#include <QMenu>
#include <QTest>

#include "app/buffer_view/buffer_overlays.h"
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "pipeline/scene/settings_table.h"
#include "tests/support/scenes.h"

namespace {

using app::BufferView;
using app::Document;

// Lit aslant, with a coarse shadow buffer.
pipeline::Scene hoveringBox() {
    pipeline::Scene scene = test::boxOverGround();
    scene.lights[0].position = {1, -0.5, 1};
    scene.settings.width = 160, scene.settings.height = 120;
    scene.settings.shadowSize = 64;
    scene.settings.shadowBias = pipeline::ShadowBias::Constant;
    return scene;
}

struct ShadowOverlayTest : testing::Test {
    Document document;
    BufferView view{document};

    ShadowOverlayTest() {
        view.resize(600, 500);
        view.show();
        document.setScene(hoveringBox());
        EXPECT_TRUE(QTest::qWaitFor([&] { return document.frames().shown() != nullptr; }, 10000));
    }
};

TEST_F(ShadowOverlayTest, LaysTheVerdictsOverThePictureAndFollowsTheBias) {
    view.features().overlays->shadows().setLight(0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.features().overlays->shadows().verdicts() != nullptr; }, 20000));
    EXPECT_GT(view.features().overlays->shadows().verdicts()->counts[std::size_t(pipeline::ShadowVerdict::Acne)], 100u)
        << "no bias";
    ASSERT_FALSE(view.canvas()->content().overlays.empty());
    EXPECT_EQ(view.canvas()->content().overlays[0].size(), QSize(160, 120));
    EXPECT_TRUE(view.shown()->notice.contains("acne"));
    document.change(*pipeline::findSetting(document.scene(), "shadow.bias_value"), 50);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            return view.features().overlays->shadows().verdicts() &&
                   view.features().overlays->shadows().verdicts()->counts[std::size_t(pipeline::ShadowVerdict::Leak)] >
                       100;
        },
        20000))
        << "a bias larger than the scene lets all light through";
    view.features().overlays->shadows().setLight(std::nullopt);
    EXPECT_TRUE(view.canvas()->content().overlays.empty());
}

TEST_F(ShadowOverlayTest, AMenuOffersEveryLightOrSaysWhyNot) {
    QMenu menu;
    view.features().overlays->shadows().fillMenu(menu, {});
    ASSERT_EQ(menu.actions().size(), 1);
    EXPECT_TRUE(menu.actions()[0]->isEnabled());
    document.change(*pipeline::findSetting(document.scene(), "light.0.shadow"), 0);
    QMenu other;
    view.features().overlays->shadows().fillMenu(other, {});
    EXPECT_FALSE(other.actions()[0]->isEnabled());
    EXPECT_EQ(other.actions()[0]->toolTip(), "Light 0 casts no shadow.");
}

}  // namespace
