#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "app/buffer_view/buffer_view.h"
#include "app/frames/stage_buffer.h"
#include "app/inspector/equation_section.h"
#include "app/stages/stage_card.h"
#include "app/stages/stage_strip.h"
#include "app/view3d/scene_view.h"
#include "app/view3d/view3d_panel.h"
#include "app/views/view_area.h"
#include "app/widgets/fitting_font.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

using WindowStages = WindowTest;

TEST_F(WindowStages, EveryStageShowsItsMainBufferAndBackIsTheSamePicture) {
    openPyramid();
    for (std::size_t i = 1; i < pipeline::kStageCount; ++i) press("Ctrl+Left");
    std::vector<QImage> forth;
    for (const pipeline::StageId stage : pipeline::kStages) {
        ASSERT_TRUE(waitForFrame());
        EXPECT_EQ(document().stage(), stage);
        EXPECT_EQ(window.views().first().buffer(), mainBuffer(stage, document().scene()));
        forth.push_back(pictureOnScreen());
        press("Ctrl+Right");
    }
    EXPECT_EQ(document().stage(), pipeline::StageId::Shading);  // the last key had no stage to go to
    for (std::size_t i = pipeline::kStageCount; i-- > 0;) {
        ASSERT_TRUE(waitForFrame());
        EXPECT_EQ(document().stage(), pipeline::kStages[i]);
        EXPECT_EQ(pictureOnScreen(), forth[i]) << stageInfo(pipeline::kStages[i]).name;
        press("Ctrl+Left");
    }
    for (std::size_t i = 1; i < forth.size(); ++i) EXPECT_NE(forth[i], forth[i - 1]);
}

// The 3D view has the frame's colours only once they have been computed, and the inspector its equation.
TEST_F(WindowStages, KeysTakeEveryViewToTheEndOfAStage) {
    openPyramid();
    document().pointing().pick(glm::ivec2(268, 281));
    ASSERT_TRUE(waitForFrame());
    const auto colour = [this] {
        const ViewMesh& mesh = *window.views().view3d().view().space().content()->mesh;
        if (!mesh.polygonColors.empty()) return mesh.polygonColors[2];
        return mesh.vertexColors[std::ranges::find(mesh.faces, 2, &Face::polygon)->vertices[0]];
    };
    const auto* equation = window.findChild<EquationSection*>();
    const glm::vec3 lit = colour(), plain(document().scene().objects[0].material.diffuse);
    ASSERT_NE(lit, plain);
    ASSERT_TRUE(QTest::qWaitFor([&] { return equation->isVisible(); }, 10000));
    press("Ctrl+Left");
    EXPECT_EQ(document().stage(), pipeline::StageId::ZBuffer);
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return document().frames().shown()->until() == pipeline::StageId::ZBuffer; }, 10000));
    EXPECT_TRUE(QTest::qWaitFor([&] { return colour() == plain && !equation->isVisible(); }, 10000));
    press("Ctrl+Right");
    EXPECT_EQ(document().frames().shown(), document().frames().whole());
    EXPECT_TRUE(QTest::qWaitFor([&] { return colour() == lit && equation->isVisible(); }, 10000));
}

// The pyramid is convex and alone, so it has no shadow buffer.
TEST_F(WindowStages, KeysStopAtAStageThatIsLeftOutWhichSaysWhy) {
    openPyramid();
    document().setStage(pipeline::StageId::Normals);
    ASSERT_TRUE(waitForFrame());
    const QString why = "The only object is convex: it cannot shadow itself.";
    QSignalSpy said(&document(), &Document::said);
    press("Ctrl+Right");
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(document().stage(), pipeline::StageId::ShadowBuffer);
    EXPECT_TRUE(window.views().first().message().contains(why));
    ASSERT_FALSE(said.isEmpty());
    EXPECT_EQ(said.takeLast().front().toString(), "Shadow buffer, left out: " + why);
    EXPECT_EQ(document().stepper().words(), "Shadow buffer, left out");
    // What there is at that moment: the normals, and nothing drawn.
    EXPECT_EQ(document().frames().shown()->until(), pipeline::StageId::Normals);
    EXPECT_TRUE(document().frames().shown()->buffer({pipeline::BufferId::PolygonsNormal}));
    press("Ctrl+Right");
    EXPECT_EQ(document().stage(), pipeline::StageId::ZBuffer);
    press("Ctrl+Left");
    press("Ctrl+Left");
    EXPECT_EQ(document().stage(), pipeline::StageId::Normals);
    EXPECT_EQ(text(*document().stepper().place()), "normals");
}

TEST_F(WindowStages, AKeyWithoutAStageToGoToSaysWhereOthersAre) {
    openPyramid();
    QSignalSpy said(&document(), &Document::said);
    press("Ctrl+Right");
    ASSERT_FALSE(said.isEmpty());
    EXPECT_EQ(said.takeLast().front().toString(), "Already at the last stage; Ctrl+← goes back.");
    document().setStage(pipeline::StageId::Transform);
    press("Ctrl+Left");
    EXPECT_EQ(said.takeLast().front().toString(), "Already at the first stage; Ctrl+→ goes on.");
}

TEST_F(WindowStages, KeysGoToAStageFromATextFieldToo) {
    openPyramid();
    auto* field = window.findChild<QLineEdit*>("material.0.kr");
    ASSERT_NE(field, nullptr);
    field->setFocus();
    press("Ctrl+Left");
    EXPECT_EQ(document().stage(), pipeline::StageId::ZBuffer);
}

TEST_F(WindowStages, ClickOnACardGoesToItsStage) {
    openPyramid();
    StageCard& card = find<StageStrip>("stageStrip")->card(pipeline::StageId::ZBuffer);
    QTest::mouseClick(&card, Qt::LeftButton);
    EXPECT_EQ(document().stage(), pipeline::StageId::ZBuffer);
    EXPECT_TRUE(card.isOnShow());
}

// Letters as wide as the room, or of the least size where even these are wider.
TEST(FittingFont, IsTheLargestThatFitsAndNoSmallerThanAsked) {
    QFont large;
    large.setPixelSize(26);
    const QStringList texts{QStringLiteral("Cull"), QStringLiteral("Shadow buffer")};
    const auto width = [&](QFont font, int pixels) {
        font.setPixelSize(pixels);
        return QFontMetrics(font).horizontalAdvance(texts[1]);
    };
    for (const int pixels : {26, 22, 20, 13}) {
        const int fitting = fittingFont(large, texts, width(large, pixels), 20).pixelSize();
        EXPECT_LE(fitting, std::max(20, pixels));
        EXPECT_GE(fitting, 20);
        if (pixels < 20) continue;
        EXPECT_LE(width(large, fitting), width(large, pixels));
        if (fitting < 26) {
            EXPECT_GT(width(large, fitting + 1), width(large, pixels));
        }
    }
}

TEST(StageCardWords, EndAtASignWhereTheyDoNotFit) {
    const QString counts = "2 686 fragments, 2 686 won; 2 parts left out";
    const auto within = [&](qsizetype letters) {
        return fitting(counts, [letters](const QString& part) { return part.size() <= letters; });
    };
    EXPECT_EQ(within(44), counts);
    EXPECT_EQ(within(43), "2 686 fragments, 2 686 won");
    EXPECT_EQ(within(20), "2 686 fragments");
    EXPECT_EQ(within(10), "");
}

TEST(StageCardWords, CountsThatDoNotFitAreGivenInThreeDigits) {
    const QChar space(0x2009);
    const auto grouped = [&](QString text) { return text.replace('_', space); };
    EXPECT_EQ(withShortNumbers(grouped("2_686 of 9_999 won")), grouped("2_686 of 9_999 won"));
    EXPECT_EQ(withShortNumbers(grouped("10_000, 99_949, 99_950, 999_499, 999_500, 12_345_678")),
              "10.0k, 99.9k, 100k, 999k, 1.00M, 12.3M");
    const QString counts = grouped("498_321 of 1_002_528 polygons kept");
    const auto within = [&](qsizetype letters) {
        return fittingCounts(counts, [letters](const QString& part) { return part.size() <= letters; });
    };
    EXPECT_EQ(within(34), counts);
    EXPECT_EQ(within(33), "498k of 1.00M polygons kept");
    EXPECT_EQ(within(26), "498k of 1.00M kept");
    EXPECT_EQ(within(17), "");
}

TEST(StageCardWords, AnErrorKeepsItsUnitWhereThereIsRoom) {
    const auto within = [](int letters) {
        return fittingError("7.3e-5 px, 3 polygons", [letters](const QString& part) { return part.size() <= letters; });
    };
    EXPECT_EQ(within(21), "7.3e-5 px, 3 polygons");
    EXPECT_EQ(within(20), "7.3e-5 px");
    EXPECT_EQ(within(9), "7.3e-5 px");
    EXPECT_EQ(within(8), "7.3e-5");
    EXPECT_EQ(within(2), "7.3e-5") << "which is then not written";
}

// The pyramid is one convex object: no shadow buffer is needed, and the flat shading needs no
// vertex normals. Everything else ran.
TEST_F(WindowStages, CardsTellWhatRanAndWhatWasLeftOut) {
    openPyramid();
    StageStrip& strip = *find<StageStrip>("stageStrip");
    const StageStatus& shadow = strip.card(pipeline::StageId::ShadowBuffer).status();
    EXPECT_EQ(shadow.state, StageState::LeftOut);
    EXPECT_TRUE(shadow.reason.contains("convex"));
    EXPECT_TRUE(shadow.time.isEmpty());
    EXPECT_EQ(strip.card(pipeline::StageId::Cull).status().counts, "3 of 5 polygons kept");

    const auto exponent = findSetting(document().scene(), "material.0.n");
    ASSERT_TRUE(exponent);
    document().change(*exponent, 4);
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(strip.card(pipeline::StageId::ZBuffer).status().state, StageState::Reused);
    EXPECT_EQ(strip.card(pipeline::StageId::Shading).status().state, StageState::Ran);
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return strip.card(pipeline::StageId::Transform).status().error.endsWith("px"); }, 10000));
}

}  // namespace
}  // namespace app
