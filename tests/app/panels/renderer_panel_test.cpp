// The panel My renderer, on a real document: what it says of files that another renderer has written.
#include "app/my_renderer/renderer_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <algorithm>

#include "app/stages/stage_card.h"
#include "app/stages/stage_strip.h"
#include "app/widgets/standing_row.h"
#include "pipeline/compare/report/worst_pixels.h"
#include "tests/app/panels/renderer_files.h"

namespace app {
namespace {

using pipeline::BufferId;
using pipeline::Defect;
using pipeline::StageId;
using pipeline::foreign::Standing;

class RendererPanelTest : public testing::Test {
protected:
    RendererPanelTest() {
        QSettings().remove("renderer/hints");
        document.setScene(smallCheckMe());
        panel.resize(320, 900);
        panel.show();
    }
    RendererCheck& renderer() { return document.renderer(); }
    // names: also the search for what the error is called has ended.
    void open(Defect defect, bool names = false) {
        handIn(folder.path(), defect);
        renderer().open({folder.path()});
        ASSERT_TRUE(names ? waitForReport(renderer()) : waitForStages(renderer()));
    }
    template <class Widget>
    Widget& part(const char* name) {
        auto* found = panel.findChild<Widget*>(name);
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    QString heading() { return part<QLabel>("rendererHeading").text(); }
    StandingRow& row(StageId stage) {
        return part<StandingRow>(("standing:" + std::string(stageInfo(stage).name)).c_str());
    }
    bool shows(const QString& text) {
        QCoreApplication::processEvents();  // labels that have just been made
        return std::ranges::any_of(panel.findChildren<QLabel*>(), [&](const QLabel* label) {
            return label->isVisibleTo(&panel) && label->text().contains(text);
        });
    }

    QTemporaryDir folder;
    Document document;
    RendererPanel panel{document};
};

TEST_F(RendererPanelTest, AsksForAFolderUntilThereIsOne) {
    EXPECT_TRUE(part<QPushButton>("chooseFolder").isVisibleTo(&panel));
    EXPECT_FALSE(part<QLabel>("rendererHeading").isVisibleTo(&panel));
}

// The egg is scaled unevenly, so a normal that is transformed like a point is wrong there: the stage and the name are the
// table's. Shading is right with these normals.
TEST_F(RendererPanelTest, NamesTheFirstWrongStageAndTheError) {
    open(Defect::NormalMatrix, true);
    const pipeline::DefectRow& planted = defectInfo(Defect::NormalMatrix);
    EXPECT_EQ(heading(), "Normals is the first wrong stage.");
    EXPECT_EQ(*planted.stage, StageId::Normals);
    EXPECT_EQ(row(StageId::Normals).standing(), Standing::WrongHere);
    EXPECT_EQ(row(StageId::Transform).standing(), Standing::Agrees);
    EXPECT_EQ(row(StageId::Shading).standing(), Standing::GivenInput);
    EXPECT_EQ(row(StageId::ShadowBuffer).standing(), Standing::NoFile);
    EXPECT_TRUE(shows(QString::fromStdString(std::string(planted.name))));
    EXPECT_TRUE(shows(QString::fromStdString(std::string(planted.fix)))) << "the line as it should be";
}

TEST_F(RendererPanelTest, PicksTheWorstPixelAndGoesToTheNext) {
    open(Defect::LRaw);  // all that a light reaches is too bright
    ASSERT_TRUE(document.pointing().pixel());
    const auto worst = worstPixels(*renderer().report());
    ASSERT_GT(worst.size(), 1u);
    EXPECT_EQ(*document.pointing().pixel(), worst[0]);
    panel.finding().goToWorst();
    EXPECT_EQ(*document.pointing().pixel(), worst[1]);
    for (std::size_t i = 0; i < worst.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const glm::ivec2 apart = glm::abs(worst[i] - worst[j]);
            EXPECT_GE(std::max(apart.x, apart.y), pipeline::foreign::kApart);
        }
}

TEST_F(RendererPanelTest, RightFilesAgree) {
    open(Defect::None);
    EXPECT_EQ(heading(), "Everything handed in agrees.");
    for (const StageId stage : {StageId::Transform, StageId::Normals, StageId::ZBuffer, StageId::Shading})
        EXPECT_EQ(row(stage).standing(), Standing::Agrees) << stageInfo(stage).name;
    EXPECT_FALSE(part<QPushButton>("goToWorst").isVisibleTo(&panel));
}

TEST_F(RendererPanelTest, ComparesAgainWhenTheFilesChange) {
    open(Defect::NormalMatrix);
    handIn(folder.path(), Defect::None);
    EXPECT_TRUE(QTest::qWaitFor([&] { return heading() == "Everything handed in agrees."; }, 60000));
}

TEST_F(RendererPanelTest, ComparesAgainWhenTheSceneChanges) {
    open(Defect::None);
    pipeline::Scene other = smallCheckMe();
    other.camera.theta += 20;
    document.replace(other, "turn");
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return renderer().report() && *renderer().report()->scene == document.scene(); }, 60000));
    EXPECT_FALSE(renderer().report()->agrees()) << "the files are of another view";
}

TEST_F(RendererPanelTest, ComparesNothingWhileNobodyLooks) {
    panel.hide();
    handIn(folder.path(), Defect::None);
    renderer().open({folder.path()});
    QCoreApplication::processEvents();
    EXPECT_EQ(renderer().work(), RendererCheck::Work::None);
    EXPECT_FALSE(renderer().report());
    panel.show();
    EXPECT_TRUE(waitForReport(renderer()));
    EXPECT_TRUE(renderer().report());
}

// The stages stay; the names are given up until it is asked for them again.
TEST_F(RendererPanelTest, CancelStopsTheSearchForNames) {
    bool cancelled = false;
    QObject::connect(&renderer(), &RendererCheck::changed, &panel, [&] {
        if (renderer().work() != RendererCheck::Work::Names || std::exchange(cancelled, true)) return;
        part<QPushButton>("rendererCancel").click();
    });
    handIn(folder.path(), Defect::NormalMatrix);
    renderer().open({folder.path()});
    ASSERT_TRUE(QTest::qWaitFor([&] { return cancelled; }, 60000));
    EXPECT_EQ(renderer().work(), RendererCheck::Work::None);
    ASSERT_TRUE(renderer().report());
    EXPECT_FALSE(renderer().report()->suspects);
    EXPECT_EQ(heading(), "Normals is the first wrong stage.");
    part<QPushButton>("rendererCancel").click();  // Go on
    ASSERT_TRUE(waitForReport(renderer()));
    EXPECT_TRUE(renderer().report()->suspects);
}

TEST_F(RendererPanelTest, SaysWhyAFolderCannotBeCompared) {
    QFile file(folder.filePath("final picture.txt"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.close();
    renderer().open({folder.path()});
    ASSERT_TRUE(waitForReport(renderer()));
    EXPECT_EQ(heading(), "The files cannot be compared");
    EXPECT_TRUE(shows("no file here has a known name"));
    EXPECT_FALSE(row(StageId::Transform).isVisibleTo(&panel));
}

// 160 by 100 are expected. The other files are compared all the same.
TEST_F(RendererPanelTest, SaysWhichFileHasAnotherSize) {
    handIn(folder.path(), Defect::None);
    pipeline::Scene large = smallCheckMe();
    large.settings.width = 32;
    const auto z = *test::frameOf(large, pipeline::setOf({BufferId::ZView}))->buffer({BufferId::ZView});
    writeAnew(z, folder.filePath("z_view.npy"));
    renderer().open({folder.path()});
    ASSERT_TRUE(waitForReport(renderer()));
    EXPECT_TRUE(part<QLabel>("rendererFiles").text().contains("z_view.npy"));
    EXPECT_TRUE(heading().startsWith("z_view.npy could not")) << heading().toStdString();
}

TEST_F(RendererPanelTest, AConventionCanBeChangedAndPutBack) {
    // The rows of a right picture from the foot up.
    handIn(folder.path(), Defect::None, {BufferId::Color, BufferId::ZView});
    auto color = *test::frameOf(plant(smallCheckMe(), Defect::None), pipeline::setOf({BufferId::Color}))
                      ->buffer({BufferId::Color});
    auto turned = std::make_shared<std::vector<std::uint8_t>>();
    for (std::size_t y = color.rows(); y-- > 0;)
        for (std::size_t i = 0; i < color.columns() * 3; ++i)
            turned->push_back(std::uint8_t(color.flat(y * color.columns() * 3 + i)));
    color.data = std::span<const std::uint8_t>(*turned), color.owner = turned;
    writeAnew(color, folder.filePath("color.npy"));
    renderer().open({folder.path()});
    ASSERT_TRUE(waitForReport(renderer()));
    EXPECT_EQ(heading(), "Everything handed in agrees.");
    auto& rows = part<QComboBox>("convention:rows");
    EXPECT_EQ(rows.currentText(), "bottom-up");
    emit rows.textActivated("top-down");
    ASSERT_TRUE(QTest::qWaitFor([&] { return renderer().report() && !renderer().report()->agrees(); }, 60000));
    part<QPushButton>("putBack:rows").click();
    EXPECT_TRUE(QTest::qWaitFor([&] { return heading() == "Everything handed in agrees."; }, 60000));
}

TEST_F(RendererPanelTest, HintsGiveAwayOneThingAfterTheOther) {
    panel.finding().setHints(0);
    open(Defect::NormalMatrix, true);
    auto& next = part<QPushButton>("nextHint");
    const QString name = QString::fromStdString(std::string(defectInfo(Defect::NormalMatrix).name));
    EXPECT_EQ(heading(), "Something differs.");
    EXPECT_FALSE(row(StageId::Normals).isVisibleTo(&panel));
    next.click();
    EXPECT_EQ(heading(), "Normals is the first wrong stage.");
    EXPECT_FALSE(part<QPushButton>("goToWorst").isVisibleTo(&panel));
    next.click();
    EXPECT_TRUE(part<QPushButton>("goToWorst").isVisibleTo(&panel));
    EXPECT_FALSE(shows(name));
    next.click();
    EXPECT_TRUE(shows(name));
    EXPECT_EQ(QSettings().value("renderer/hints").toInt(), 0) << "the next folder begins as this one did";
}

TEST_F(RendererPanelTest, TheStripSaysHowTheStagesStandWhileThePanelIsShown) {
    StageStrip strip(document);
    open(Defect::NormalMatrix);
    StageCard& card = strip.card(StageId::Normals);
    EXPECT_TRUE(card.accessibleName().contains("wrong here")) << card.accessibleName().toStdString();
    panel.finding().setHints(0);
    EXPECT_FALSE(card.accessibleName().contains("wrong here")) << "the stage is not given away";
    panel.finding().setHints(3);
    EXPECT_TRUE(card.accessibleName().contains("wrong here"));
    panel.hide();
    EXPECT_FALSE(card.accessibleName().contains("wrong here"));
}

TEST_F(RendererPanelTest, CopiesTheFindingAsText) {
    open(Defect::NormalMatrix);
    QTest::keyClick(&panel, Qt::Key_C, Qt::ControlModifier);
    EXPECT_TRUE(QApplication::clipboard()->text().startsWith("Normals is the first wrong stage.\n"));
}

}  // namespace
}  // namespace app
