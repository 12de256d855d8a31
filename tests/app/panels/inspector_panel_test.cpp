#include "app/inspector/inspector_panel.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QTest>
#include <QTextBlock>
#include <QToolButton>
#include <algorithm>

#include "app/frames/derived_buffers.h"
#include "app/frames/equation_symbols.h"
#include "app/frames/mix_model.h"
#include "app/inspector/equation_section.h"
#include "app/inspector/fragments_section.h"
#include "app/inspector/layers_section.h"
#include "app/inspector/math_view.h"
#include "app/inspector/source_view.h"
#include "app/inspector/terms_section.h"
#include "app/inspector/why_section.h"
#include "app/look/number_format.h"
#include "pipeline/inspect/shadow_blocker.h"
#include "pipeline/scene/settings_table.h"
#include "tests/support/scenes.h"

namespace {

using app::Document;
using app::InspectorPanel;
using app::Pointing;

struct InspectorPanelTest : testing::Test {
    Document document;
    InspectorPanel panel{document};

    InspectorPanelTest() {
        panel.resize(456, 900);
        panel.show();
        document.setScene(test::pyramid());
        document.pointing().pick(glm::ivec2(268, 281));
        EXPECT_TRUE(QTest::qWaitFor([&] { return panel.report() != nullptr; }, 10000));
    }
    QString equation() { return panel.equation().math()->asText(); }
    bool shows(const QString& words) {
        for (const auto* label : panel.findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(words)) return true;
        return false;
    }
};

}  // namespace

// Lecture 1's pyramid, face "Right": N = (0, 0.894, 0.447), L = (1, 1, 1)/sqrt 3, N·L = 0.7746;
// diffuse blue 0.9·100·0.7746 = 69.714, ambient 0.9·50 = 45. FB = round(255·114.739/175) = 167.
TEST_F(InspectorPanelTest, ShowsTheEquationOfThePickedPixelWithItsNumbers) {
    EXPECT_TRUE(equation().contains("45.000 + 69.714 + 0.025 = 114.739")) << equation().toStdString();
    EXPECT_TRUE(equation().contains("= 167"));
    EXPECT_TRUE(shows("37 93 167"));
    EXPECT_TRUE(shows("Polygon 2"));
}

// Half of 114.739 over a background of 0: FB = round(255·57.369/175) = 84.
TEST_F(InspectorPanelTest, OverTheBackgroundItShowsWhatTranslucentSurfacesMakeOfIt) {
    pipeline::Scene scene = test::pyramid();
    scene.objects[0].material.alpha = 0.5;
    document.setScene(scene);
    document.pointing().pick(glm::ivec2(268, 281));
    EXPECT_TRUE(QTest::qWaitFor([&] { return shows("Background, behind translucent surfaces."); }, 10000));
    EXPECT_TRUE(panel.equation().math()->isVisible());
    EXPECT_TRUE(equation().contains("= 84")) << equation().toStdString();
    EXPECT_FALSE(panel.findChild<app::TermsSection*>()->isVisible()) << "no surface was lit here";
}

// As it is in a scene that a picture or a session carries.
TEST_F(InspectorPanelTest, NamesNoFileWhereTheMeshComesFromNone) {
    pipeline::Scene scene = test::pyramid();
    auto mesh = std::make_shared<pipeline::Mesh>(*scene.objects[0].mesh);
    mesh->file.clear();
    mesh->polygonPlaces.assign(5, {22, 3});
    scene.objects[0].mesh = mesh;
    document.setScene(scene);
    document.pointing().pick(glm::ivec2(268, 281));
    const auto rows = panel.findChild<app::WhySection*>()->findChildren<QLabel*>();
    const auto names = [](const QLabel* label) { return label->isVisible() && label->text() == "pyramid"; };
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::any_of(rows.begin(), rows.end(), names); }, 10000));
}

TEST_F(InspectorPanelTest, SaysThatAPixelIsNotDrawnYet) {
    for (const char* place : {"transform", "cull/polygon=2", "normals"}) {
        document.stepper().goTo(*pipeline::parsePlace(place));
        EXPECT_TRUE(QTest::qWaitFor([&] { return shows("not drawn yet"); }, 10000)) << place;
        EXPECT_TRUE(shows("Nothing is drawn here yet."));
    }
    // Of a pixel of the background.
    document.pointing().pick(glm::ivec2(10, 10));
    document.stepper().goTo(*pipeline::parsePlace("z-buffer/start"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return shows("0 fragments, 0 passed"); }, 10000));
    document.stepper().goTo(*pipeline::parsePlace("shading/start"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return shows("Background: nothing was drawn here."); }, 10000));
}

// Red: k_r = 0.2, so 0.2·50 + 0.2·77.46 + 0.025 = 25.517.
TEST_F(InspectorPanelTest, FollowsTheChannel) {
    document.pointing().setChannel(0);
    EXPECT_TRUE(equation().contains("25.517")) << equation().toStdString();
}

TEST_F(InspectorPanelTest, TheTermsAddUpToTheIntensity) {
    auto* terms = panel.findChild<app::TermsSection*>();
    ASSERT_NE(terms, nullptr);
    EXPECT_NEAR(terms->sum(), 114.739, 5e-4);
    EXPECT_NEAR(terms->residual(), 0, 1e-4);
}

// With n = 4 the specular term is 0.4·100·0.3974^4 = 0.998.
TEST_F(InspectorPanelTest, TellsWhatTheNumbersWereBeforeAChange) {
    const auto setting = pipeline::findSetting(document.scene(), "material.0.n");
    ASSERT_TRUE(setting);
    document.change(*setting, 4);
    ASSERT_TRUE(QTest::qWaitFor([&] { return equation().contains("0.998"); }, 10000));
    EXPECT_TRUE(equation().contains("was 45.000 + 69.714 + 0.025 = 114.739")) << equation().toStdString();
    EXPECT_TRUE(equation().contains("= 8")) << "the exponent's value before";
    document.pointing().pick(glm::ivec2(269, 281));  // another pixel: nothing was changed there
    EXPECT_FALSE(equation().contains("was "));
}

// With n = 4, then 2. A kept line stays for all changes, the other one is that of the newest.
TEST_F(InspectorPanelTest, KeepsAResultAcrossChanges) {
    const auto setting = pipeline::findSetting(document.scene(), "material.0.n");
    EXPECT_FALSE(panel.equation().canKeep()) << "nothing has changed";
    document.change(*setting, 4);
    ASSERT_TRUE(QTest::qWaitFor([&] { return equation().contains("was 45.000 + 69.714 + 0.025"); }, 10000));
    panel.equation().setKept(true);
    EXPECT_TRUE(equation().contains("kept 45.000 + 69.714 + 0.025 = 114.739, with n = 8")) << equation().toStdString();
    document.change(*setting, 2);
    ASSERT_TRUE(QTest::qWaitFor([&] { return equation().contains("0.3974^2"); }, 10000));
    EXPECT_TRUE(equation().contains("was 45.000 + 69.714 + 0.998 = 115.712, with n = 4")) << equation().toStdString();
    EXPECT_TRUE(equation().contains("kept 45.000 + 69.714 + 0.025"));
    panel.equation().setKept(false);
    EXPECT_FALSE(equation().contains("kept"));
}

// A drag is one change: what was is what was before it began.
TEST_F(InspectorPanelTest, ComparesWithTheStartOfADrag) {
    const auto setting = pipeline::findSetting(document.scene(), "material.0.n");
    for (const double n : {7.0, 6.0, 5.0, 4.0}) {
        document.change(*setting, n, Document::Change::Live);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy(); }, 10000));
    }
    EXPECT_TRUE(equation().contains("was 45.000 + 69.714 + 0.025 = 114.739, with n = 8")) << equation().toStdString();
    document.history().stack()->undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy(); }, 10000));
    EXPECT_TRUE(equation().contains("was 45.000 + 69.714 + 0.998 = 115.712, with n = 4")) << equation().toStdString();
}

TEST_F(InspectorPanelTest, APointedSymbolIsKnownToTheOtherViews) {
    QSignalSpy changed(&document.pointing(), &Pointing::symbolChanged);
    emit panel.equation().math()->pointedAt("n_dot_l.0");
    ASSERT_EQ(changed.size(), 1);
    EXPECT_EQ(app::vectorsOf(document.pointing().symbol()),
              (std::vector{pipeline::VectorCode::N, pipeline::VectorCode::L}));
    emit panel.equation().math()->pointedAt("material.0.n");
    EXPECT_TRUE(app::vectorsOf(document.pointing().symbol()).empty());
}

// Lecture 1: 0.9·50 + 100·(0.9 + 0.4) = 175.
TEST_F(InspectorPanelTest, TheMaximumSaysWhatItIsMadeOf) {
    emit panel.equation().math()->pointedAt("i_max");
    const QString says = panel.equation().math()->toolTip();
    EXPECT_TRUE(says.startsWith("I_max, the intensity that 255 stands for: the most that ")) << says.toStdString();
    EXPECT_TRUE(says.endsWith(" = 0.9·50 + 100·(0.9 + 0.4) = 175.")) << says.toStdString();
    EXPECT_EQ(document.pointing().symbol(), "") << "no buffer and no setting";
    pipeline::Scene scene = document.scene();
    scene.settings.model = pipeline::Model::BlinnPhong;
    EXPECT_TRUE(app::maximumText(scene, 1).contains(": 1 in this model"));
}

// The equation writes I_0 and L; so do the settings, and what they were before.
TEST(Pointed, SettingsHaveTheLettersOfTheEquation) {
    const pipeline::Scene scene = test::pyramid();
    const auto of = [&](const char* key) { return *pipeline::findSetting(scene, key); };
    EXPECT_EQ(app::labelOf(of("light.0.intensity")), "I_0 intensity");
    EXPECT_EQ(app::symbolOf(of("light.0.intensity")), "I_0");
    EXPECT_EQ(app::symbolOf(of("light.0.y")), "L y");
    EXPECT_EQ(app::symbolOf(of("material.0.kr")), "k_r");
    EXPECT_EQ(app::symbolOf(of("material.0.n")), "n");
}

// Ambient alone: 45 of 114.739; the strips leave the terms themselves as they are.
TEST_F(InspectorPanelTest, StripsMixTheTerms) {
    auto* terms = panel.findChild<app::TermsSection*>();
    QToolButton* solo = nullptr;
    for (auto* button : terms->findChildren<QToolButton*>())
        if (button->accessibleName() == "Solo ambient") solo = button;
    ASSERT_NE(solo, nullptr);
    solo->click();
    EXPECT_NEAR(terms->mixed(), 45, 1e-9);
    EXPECT_NEAR(terms->sum(), 114.739, 5e-4);
    const QObject viewer;
    const pipeline::BufferName mix{pipeline::BufferId::Mix};
    document.derived().want(&viewer, {mix});
    ASSERT_TRUE(QTest::qWaitFor([&] { return document.derived().made(mix) != nullptr; }, 10000));
    EXPECT_EQ(document.derived().made(mix)->buffer.value(268, 281, 2), 66) << "round(255·45/175)";
    EXPECT_TRUE(shows("Mix of terms: ambient alone"));
    document.mixer().reset();
    EXPECT_TRUE(document.mixer().isPlain());
    EXPECT_FALSE(solo->isChecked());
}

TEST_F(InspectorPanelTest, BackgroundSaysSoAndHasNoEquation) {
    document.pointing().pick(glm::ivec2(3, 3));
    EXPECT_FALSE(panel.report()->covered);
    EXPECT_TRUE(shows("Background: nothing was drawn here."));
    EXPECT_FALSE(panel.equation().isVisible());
}

// 0.5 · 100 from the farther one, of which the nearer one lets 1 − 0.25 through, and 0.25 · 80.
TEST(LayersSection, EveryLayerAddsItsShareOfThePixel) {
    const std::vector<pipeline::LayerReport> layers{{3, 9, 0.5, pipeline::Vec3d(100), {}},
                                                    {1, 7, 0.25, pipeline::Vec3d(80), {}}};
    EXPECT_EQ(app::addedBy(layers, 0, 2), 37.5);
    EXPECT_EQ(app::addedBy(layers, 1, 2), 20);
    pipeline::PixelReport report{};
    report.layers = layers;
    report.transmittance = 0.375, report.intensity = pipeline::Vec3d(16);
    report.translucent = pipeline::Vec3d(57.5), report.composed = pipeline::Vec3d(63.5);
    app::LayersSection section;
    section.show(report, 2);
    EXPECT_TRUE(section.accessibleDescription().contains("polygon 3 9.0000"))
        << section.accessibleDescription().toStdString();
    EXPECT_TRUE(section.accessibleDescription().contains("37.500"));
    EXPECT_TRUE(section.accessibleDescription().contains("0.3750 · 16.000 + 57.500 = 63.500"));
}

TEST_F(InspectorPanelTest, WithoutAPixelItSaysWhatToDo) {
    document.pointing().pick(std::nullopt);
    EXPECT_TRUE(shows("Click a pixel to see why it has its colour."));
}

TEST_F(InspectorPanelTest, ASymbolOpensItsBuffer) {
    QSignalSpy asked(&panel, &InspectorPanel::bufferAsked);
    emit panel.equation().math()->activated("diffuse.0");
    ASSERT_EQ(asked.size(), 1);
    EXPECT_EQ(asked[0][0].value<pipeline::BufferName>(), (pipeline::BufferName{pipeline::BufferId::Diffuse, 0}));
    emit panel.equation().math()->activated("material.0.n");  // a setting is no buffer
    EXPECT_EQ(asked.size(), 1);
}

TEST_F(InspectorPanelTest, ASymbolOfASettingAsksForItsControl) {
    QSignalSpy asked(&panel, &InspectorPanel::settingAsked);
    emit panel.equation().math()->activated("material.0.n");
    ASSERT_EQ(asked.size(), 1);
    EXPECT_EQ(asked[0][0].toString(), "material.0.n");
}

// As chosen in the preferences: equation, what it was before, terms, fragments, and what is copied.
TEST_F(InspectorPanelTest, NumbersAreWrittenAsChosen) {
    using Form = app::NumberFormat::Form;
    document.change(*pipeline::findSetting(document.scene(), "material.0.n"), 4.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return equation().contains("was 45.000 + 69.714 + 0.025 = 114.739"); }, 10000));
    app::NumberStyle::current().set({Form::Scientific, 2, {}});
    EXPECT_TRUE(equation().contains("= 4.50·10^1 + 6.97·10^1 + 9.98·10^−1 = 1.16·10^2")) << equation().toStdString();
    EXPECT_TRUE(equation().contains("was 4.50·10^1 + 6.97·10^1 + 2.49·10^−2 = 1.15·10^2, with n = 8"))
        << equation().toStdString();
    EXPECT_TRUE(panel.equation().math()->asLatex().contains("6.97\\cdot 10^{1}"));
    EXPECT_TRUE(shows("6.97e1")) << "a term";
    const auto* fragments = panel.findChild<app::FragmentsSection*>();
    EXPECT_TRUE(fragments->accessibleDescription().contains("e2 < +∞")) << "a depth of some hundred units";
    app::NumberStyle::current().set({Form::Fixed, 1, {}});
    EXPECT_TRUE(equation().contains("= 45.0 + 69.7 + 1.0 = 115.7")) << equation().toStdString();
    app::NumberStyle::current().set({});
    EXPECT_TRUE(equation().contains("= 45.000 + 69.714 + 0.998 = 115.712"));
}

// Polygon 2 is seen there; polygon 4, the base, came and lost.
TEST_F(InspectorPanelTest, ARowOfTheFragmentsSelectsItsPolygon) {
    auto* rows = panel.findChild<app::FragmentsSection*>();
    ASSERT_EQ(rows->rows().size(), panel.report()->fragments.size() + panel.report()->culled.size());
    QTest::mouseClick(rows, Qt::LeftButton, {}, rows->rows().front().center());
    const auto polygonAt = [&](std::size_t i) {
        const auto& r = *panel.report();
        return std::size_t(i < r.fragments.size() ? r.fragments[i].polygon : r.culled[i - r.fragments.size()].polygon);
    };
    EXPECT_EQ(document.pointing().selection(), (lessons::Selection{lessons::Selection::Kind::Polygon, polygonAt(0)}));
    EXPECT_TRUE(document.pointing().pixel()) << "the pixel stays picked";
    if (rows->rows().size() < 2) return;
    rows->setFocus();
    QTest::keyClick(rows, Qt::Key_Down);
    QTest::keyClick(rows, Qt::Key_Return);
    EXPECT_EQ(document.pointing().selection(), (lessons::Selection{lessons::Selection::Kind::Polygon, polygonAt(1)}));
}

TEST_F(InspectorPanelTest, PolygonVerticesAndObjectAreJumps) {
    auto* why = panel.findChild<app::WhySection*>();
    const auto buttons = why->findChildren<QToolButton*>();
    ASSERT_EQ(buttons.size(), 7);
    buttons[3]->click();
    EXPECT_EQ(document.pointing().selection(), (lessons::Selection{lessons::Selection::Kind::Polygon, 2}));
    EXPECT_EQ(document.stage(), pipeline::StageId::Cull);
    const int vertex = panel.report()->vertices[1];
    for (auto* label : why->findChildren<QLabel*>())
        if (label->text().contains("vertex:")) emit label->linkActivated(QString("vertex:%1").arg(vertex));
    EXPECT_EQ(document.pointing().selection(),
              (lessons::Selection{lessons::Selection::Kind::Vertex, std::size_t(vertex)}));
    EXPECT_EQ(document.stage(), pipeline::StageId::Transform);
    buttons[5]->click();
    EXPECT_EQ(document.pointing().selection(), (lessons::Selection{lessons::Selection::Kind::Object, 0}));
}

// Below the box stands its top, polygon 7, nearest to the light.
TEST_F(InspectorPanelTest, TheShadowIsAJumpToWhatCastsIt) {
    const pipeline::Scene scene = test::boxOverGround();
    const auto frame = test::frameOf(scene);
    std::optional<glm::ivec2> shadowed;
    for (int y = 0; y < scene.settings.height && !shadowed; ++y)
        for (int x = 0; x < scene.settings.width && !shadowed; ++x)
            if (blockersOf(*frame, inspectPixel(*frame, {x, y})) == std::vector<int>{7}) shadowed = glm::ivec2(x, y);
    ASSERT_TRUE(shadowed);
    auto* why = panel.findChild<app::WhySection*>();
    const auto shadow = why->findChildren<QToolButton*>()[6];
    EXPECT_FALSE(shadow->isVisible()) << "the pyramid casts none";
    document.setScene(scene);
    document.pointing().pick(*shadowed);
    ASSERT_TRUE(QTest::qWaitFor([&] { return shadow->isVisible(); }, 10000));
    QSignalSpy buffers(why, &app::WhySection::bufferAsked);
    shadow->click();
    ASSERT_EQ(buffers.size(), 1);
    EXPECT_EQ(buffers[0][0].value<pipeline::BufferName>(), (pipeline::BufferName{pipeline::BufferId::ShadowBuffer, 0}));
    EXPECT_EQ(document.pointing().selection(), (lessons::Selection{lessons::Selection::Kind::Polygon, 7}));
    EXPECT_EQ(document.stage(), pipeline::StageId::ShadowBuffer);
}

// Before the first step there is no background yet.
TEST_F(InspectorPanelTest, InsideAFrameItSaysWhatIsStillToCome) {
    document.stepper().toFirst();
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return document.stepper().isSettled() && shows("Nothing is drawn here yet."); }, 10000));
}

TEST(SourceView, ShowsTheLineOfAFile) {
    const app::SourceView view("folder/a.des", "one\ntwo\nthree\n", 2, 3);
    const auto* lines = view.findChild<QPlainTextEdit*>();
    EXPECT_EQ(lines->textCursor().block().text(), "two");
    EXPECT_EQ(lines->textCursor().positionInBlock(), 2);
    EXPECT_TRUE(view.windowTitle().contains("a.des, line 2"));
    EXPECT_EQ(app::sourceFile("/scenes/a.scene", "models/b.des"), "/scenes/models/b.des");
    EXPECT_EQ(app::sourceFile("/scenes/a.scene", ""), "") << "a built-in shape";
}
