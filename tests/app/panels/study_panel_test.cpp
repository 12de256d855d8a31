#include "app/study/study_panel.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include "app/study/study_choice.h"
#include "app/study/study_pictures.h"
#include "app/study/study_run.h"
#include "app/study/study_sweep.h"
#include "pipeline/export/json/study_json.h"
#include "pipeline/scene/settings_table.h"
#include "tests/app/panels/study_panel_fixture.h"

namespace {

using app::StudyPoints;
using pipeline::StudyReport;
using test::pyramidStudy;
using test::smallPyramid;
using test::StudyPanelTest;

}  // namespace

TEST_F(StudyPanelTest, AClickOnAPointSelectsItEverywhere) {
    click(9);  // phong, 16: the sixth by time
    EXPECT_EQ(panel.selected(), 9u);
    EXPECT_EQ(part<StudyPoints>().currentRow(), 5);
    EXPECT_TRUE(part<QWidget>("studyErrors").isVisible());
    click(0);
    EXPECT_EQ(panel.selected(), 0u);
    const auto& errors = part<QTableWidget>("studyErrors");
    ASSERT_EQ(errors.rowCount(), 2);
    EXPECT_EQ(errors.item(1, 0)->text(), "normal");
    EXPECT_EQ(errors.item(1, 3)->text(), "1.2e-5");
    EXPECT_EQ(errors.item(0, 4)->text(), QString("–")) << "an error that there is not";
    EXPECT_EQ(part<QWidget>("blameBars").accessibleName(), QString("Normals 97 %, Shading −2 %"));
}

TEST_F(StudyPanelTest, ArrowsGoThroughThePointsByTime) {
    plot().setFocus();
    for (const std::size_t expected : {0u, 4u, 1u, 5u}) {
        QTest::keyClick(&plot(), Qt::Key_Right);
        EXPECT_EQ(panel.selected(), expected);
    }
    QTest::keyClick(&plot(), Qt::Key_Left);
    EXPECT_EQ(panel.selected(), 1u);
}

TEST_F(StudyPanelTest, TheTableIsSortedByTimeAndEndsWithWhatFailed) {
    EXPECT_EQ(part<StudyPoints>().rowCount(), 12);
    EXPECT_EQ(cell(0, 0), "flat");
    EXPECT_EQ(cell(0, 2), "0.590");
    EXPECT_EQ(cell(4, 5), "gouraud, n exponent 16");
    EXPECT_EQ(cell(11, 5), "stopped after 60 s");
    part<StudyPoints>().setCurrentCell(2, 0);
    EXPECT_EQ(panel.selected(), 1u);
    EXPECT_EQ(plot().selected(), 1u);
}

TEST_F(StudyPanelTest, TakesTheSettingsOverInOneStepOfUndo) {
    const pipeline::Scene before = document.scene();
    auto& use = part<QPushButton>("useSettings");
    EXPECT_FALSE(use.isEnabled());
    EXPECT_EQ(use.toolTip(), "Choose a point first.");
    click(9);
    ASSERT_TRUE(use.isEnabled());
    use.click();
    EXPECT_EQ(document.scene().settings.shading, pipeline::Shading::Phong);
    EXPECT_EQ(pipeline::findSetting(document.scene(), "material.0.n")->get(document.scene()), 16);
    EXPECT_EQ(document.history().stack()->undoText(), "settings: phong, n exponent 16");
    document.history().stack()->undo();
    EXPECT_EQ(document.scene(), before);
}

TEST_F(StudyPanelTest, AStudyOfAnotherSceneCannotBeTakenOver) {
    StudyReport report = pyramidStudy();
    report.scene = "teapot";
    panel.setReport(report);
    click(0);
    auto& use = part<QPushButton>("useSettings");
    EXPECT_FALSE(use.isEnabled());
    EXPECT_EQ(use.toolTip(), "this study is of teapot, another scene is open");
}

TEST_F(StudyPanelTest, AnotherErrorIsAnotherPlot) {
    auto& buffer = part<QComboBox>("studyBuffer");
    ASSERT_EQ(buffer.findText("normal"), 1);
    buffer.setCurrentIndex(1);
    emit buffer.activated(1);
    // One point alone has an error of its normals.
    EXPECT_TRUE(plot().placeOf(0));
    EXPECT_FALSE(plot().placeOf(1));
    EXPECT_EQ(cell(1, 5), "it has no such error");
    EXPECT_TRUE(part<QLabel>("studyReference").text().contains("analytic (")) << "no bar of another measure";
}

TEST_F(StudyPanelTest, AnswersForTheLimitThatIsTyped) {
    EXPECT_TRUE(part<QLabel>("cheapestSentence").text().contains("2.94 ms: phong, n exponent 16"))
        << "the middle of the front, unasked";
    auto& limit = part<QLineEdit>("errorLimit");
    limit.setText("1e-5");
    emit limit.editingFinished();
    EXPECT_TRUE(part<QLabel>("cheapestSentence").text().contains("8.50 ms: phong, n exponent 128"));
    limit.setText("small");
    emit limit.editingFinished();
    EXPECT_EQ(limit.text(), "1e-5") << "what is no number changes nothing";
}

TEST_F(StudyPanelTest, OpensAStudyAndSaysWhatIsWrongWithAFile) {
    const QTemporaryDir folder;
    const auto write = [&](const QString& name, const std::string& text) {
        QFile file(folder.filePath(name));
        EXPECT_TRUE(file.open(QFile::WriteOnly));
        file.write(text.data(), qint64(text.size()));
        return folder.filePath(name);
    };
    StudyReport other = pyramidStudy();
    other.points.resize(5);
    EXPECT_TRUE(panel.openStudy(write("good.json", studyFileText(other))));
    EXPECT_EQ(panel.report(), other);
    EXPECT_FALSE(panel.openStudy(write("bad.json", "{")));
    EXPECT_TRUE(part<QLabel>("studyMessage").text().contains("bad.json:1:2: this is not JSON"))
        << part<QLabel>("studyMessage").text().toStdString();
    EXPECT_FALSE(panel.openStudy(folder.filePath("none.json")));
    EXPECT_EQ(panel.report(), other) << "the study before is still there";
}

TEST_F(StudyPanelTest, ExportsEverything) {
    const QTemporaryDir folder;
    EXPECT_TRUE(panel.exportTo(folder.path()));
    for (const char* name : {"study.json", "study.csv", "report.html", "plot.svg", "plot.png"})
        EXPECT_TRUE(QFile::exists(folder.filePath(name))) << name;
    EXPECT_FALSE(panel.exportTo(folder.filePath("plot.png")));
    EXPECT_TRUE(part<QLabel>("studyMessage").text().contains("could not write"));
}

TEST_F(StudyPanelTest, SaysWhatIsWrongWithASweep) {
    auto& sweep = part<app::StudySweep>();
    sweep.setAxes({"shading=flat,phonk"});
    EXPECT_FALSE(sweep.sweep());
    EXPECT_FALSE(part<QPushButton>("studyBegin").isEnabled());
    EXPECT_TRUE(part<QLabel>("studySweepState").text().contains("phonk"));
    sweep.setAxes({"shading=flat,phong", "material.0.n=4..16*2"});
    ASSERT_TRUE(sweep.sweep());
    EXPECT_EQ(pointCount(sweep.sweep()->axes), 6u);
    EXPECT_TRUE(part<QPushButton>("studyBegin").isEnabled());
}

TEST_F(StudyPanelTest, MeasuresAStudyBesideTheWindow) {
    part<app::StudySweep>().setAxes({"shading=flat,phong"});
    QSignalSpy reported(&part<app::StudyRun>(), &app::StudyRun::reported);
    part<QPushButton>("studyBegin").click();
    EXPECT_TRUE(part<app::StudyRun>().running());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !part<app::StudyRun>().running(); }, 60000));
    EXPECT_EQ(reported.size(), 3) << "each of the two as it arrives, then all";
    EXPECT_EQ(reported[0][0].value<StudyReport>().points.size(), 1u);
    const StudyReport& report = panel.report();
    ASSERT_EQ(report.points.size(), 2u);
    for (const pipeline::StudyPoint& point : report.points) {
        EXPECT_EQ(point.failure, "");
        EXPECT_FALSE(point.errors.empty());
        ASSERT_EQ(point.frame.processes.size(), 1u);
        EXPECT_EQ(point.frame.processes[0].size(), 21u);
    }
    EXPECT_EQ(report.scene, document.scene().name);
}

TEST_F(StudyPanelTest, EscStopsAStudyThenClosesTheWindow) {
    part<app::StudySweep>().setAxes({"shading=all", "material.0.n=1..200"});
    part<QPushButton>("studyBegin").click();
    ASSERT_TRUE(part<app::StudyRun>().running());
    QTest::keyClick(&part<StudyPoints>(), Qt::Key_Escape);
    EXPECT_TRUE(panel.isVisible());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !part<app::StudyRun>().running(); }, 30000));
    QTest::keyClick(&part<StudyPoints>(), Qt::Key_Escape);
    EXPECT_FALSE(panel.isVisible());
}

TEST_F(StudyPanelTest, CancelsAStudy) {
    part<app::StudySweep>().setAxes({"shading=all", "material.0.n=1..200"});
    part<QPushButton>("studyBegin").click();
    auto& cancel = part<QPushButton>("studyCancel");
    ASSERT_TRUE(cancel.isEnabled());
    cancel.click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !part<app::StudyRun>().running(); }, 30000));
    EXPECT_EQ(panel.report(), pyramidStudy()) << "the study before is still there";
    EXPECT_TRUE(part<QPushButton>("studyBegin").isEnabled());
}

TEST_F(StudyPanelTest, ShowsThePicturesOfTheSelectedPoint) {
    app::StudyImages images;
    QSignalSpy ready(&images, &app::StudyImages::ready);
    const StudyReport report = pyramidStudy();
    images.ask(std::make_shared<const pipeline::Scene>(smallPyramid()), report.axes, report.points[0]);
    images.ask(std::make_shared<const pipeline::Scene>(smallPyramid()), report.axes, report.points[9]);
    ASSERT_TRUE(QTest::qWaitFor([&] { return ready.size() > 0; }, 30000));
    QTest::qWait(100);
    ASSERT_EQ(ready.size(), 1) << "the newest alone";
    const auto pictures = ready[0][0].value<app::SettingPictures>();
    EXPECT_EQ(pictures.image.size(), QSize(64, 48));
    EXPECT_EQ(pictures.reference.size(), QSize(64, 48));
    EXPECT_EQ(pictures.error.size(), QSize(64, 48));
    EXPECT_GT(pictures.range, 0);
}

// Reference pictures take rays: nobody waits for those of a panel that is closed.
TEST_F(StudyPanelTest, ClosedItMakesNoPicturesAndOpenedAgainThoseOfTheSceneThen) {
    const auto says = [&] { return panel.findChild<app::PictureFrame*>()->accessibleName(); };
    click(0);
    EXPECT_EQ(says(), "Image: computing");
    ASSERT_TRUE(QTest::qWaitFor([&] { return says() == "Image"; }, 20000));
    panel.hide();
    document.change(*findSetting(document.scene(), "camera.theta"), 80);
    EXPECT_EQ(says(), "Image") << "that of before";
    panel.show();
    EXPECT_EQ(says(), "Image: computing");
    EXPECT_TRUE(QTest::qWaitFor([&] { return says() == "Image"; }, 20000));
}
