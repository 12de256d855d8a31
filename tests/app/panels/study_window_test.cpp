// What of a study stands where, in windows of all sizes and with text of all sizes.
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTabWidget>
#include <QTableWidget>

#include "app/look/theme.h"
#include "app/study/study_details.h"
#include "app/study/study_pictures.h"
#include "app/study/study_run.h"
#include "app/study/study_sweep.h"
#include "app/widgets/folding_panes.h"
#include "tests/app/panels/study_panel_fixture.h"
#include "tests/app/window/small_screen.h"

namespace {

using app::StudyPoints;
using pipeline::StudyReport;
using test::pyramidStudy;

struct StudyWindowTest : test::StudyPanelTest {};

}  // namespace

TEST_F(StudyWindowTest, FitsASmallScreenInEveryTheme) {
    panel.show();
    test::expectFitsASmallScreen(panel);
}

// Whatever the letters, and back to its size after a theme that needs more room.
TEST_F(StudyWindowTest, NothingOfItIsOutOfReachInLargeLetters) {
    test::onSmallScreens(panel, {1.0, 1.5, 2.0}, [&] {
        auto& panes = part<app::FoldingPanes>();
        auto& names = part<QWidget>("paneNames");
        EXPECT_EQ(names.isVisible(), panes.isFolded());
        const auto isInside = [&](const QWidget& there) {
            EXPECT_TRUE(there.isVisible());
            EXPECT_TRUE(panel.rect().contains(QRect(there.mapTo(&panel, QPoint()), there.size())));
            EXPECT_GE(there.width(), there.minimumSizeHint().width());
        };
        for (const char* name : {"studySweep", "studySetUp", "studyBegin", "studyExport"})
            isInside(part<QWidget>(name));
        for (int pane = 0; pane < 2; ++pane) {
            panes.bringToFront(pane);
            QCoreApplication::processEvents();
            isInside(pane == 0 ? static_cast<QWidget&>(plot()) : part<QWidget>("studyPoints"));
        }
        panes.bringToFront(0);
    });
    panel.resize(1024, 640);
    for (const app::ThemeId theme : {app::ThemeId::Projector, app::ThemeId::Light}) app::Theme::current().set(theme);
    QCoreApplication::processEvents();
    EXPECT_EQ(panel.size(), QSize(1024, 640));
}

// What is chosen, how far it is, and one button, above the plot and the numbers: as drawn.
TEST_F(StudyWindowTest, TheBarHasOneButtonWhichMeasuresOrCancels) {
    app::Theme::current().setScale(1.25);
    panel.resize(1280, 720);
    part<app::StudySweep>().setAxes({"shading=all", "material.0.n=1..200"});
    QCoreApplication::processEvents();
    const auto bottom = [&](const char* name) {
        const auto& there = part<QWidget>(name);
        EXPECT_TRUE(there.isVisible()) << name;
        return there.mapTo(&panel, QPoint(0, there.height())).y();
    };
    const int top = plot().mapTo(&panel, QPoint()).y();
    for (const char* name : {"studySweep", "studySummary", "studySetUp", "studyBegin", "studyExport"})
        EXPECT_LT(bottom(name), top) << name;
    EXPECT_EQ(part<QLabel>("studySummary").text(), "600 points · 21 frames each · 1 thread");
    EXPECT_EQ(part<QPushButton>("studyBegin").text(), "Measure again") << "a study is on show";
    part<QPushButton>("studyBegin").setFocus();
    part<QPushButton>("studyBegin").click();
    EXPECT_FALSE(part<QWidget>("studyBegin").isVisible());
    EXPECT_EQ(panel.focusWidget(), &part<QWidget>("studyCancel")) << "Return stops what Return began";
    EXPECT_FALSE(part<QWidget>("studySummary").isVisible());
    QCoreApplication::processEvents();
    for (const char* name : {"studyBar", "studyProgress", "studyCancel"}) EXPECT_LT(bottom(name), top) << name;
    ASSERT_TRUE(QTest::qWaitFor([&] { return part<QLabel>("studyAnswers").text().startsWith("errors of"); }, 30000));
    part<QPushButton>("studyCancel").click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !part<app::StudyRun>().running(); }, 30000));
    EXPECT_TRUE(part<QWidget>("studyBegin").isVisible());
    EXPECT_EQ(part<QLabel>("studySummary").text(), "Cancelled. Nothing was measured.");
    app::Theme::current().setScale(1);
}

TEST_F(StudyWindowTest, MeasuringBringsThePlotToTheFront) {
    ASSERT_NO_FATAL_FAILURE(test::foldToSecondPart(panel));
    EXPECT_FALSE(plot().isVisible());
    part<QPushButton>("studyBegin").click();
    EXPECT_TRUE(plot().isVisible());
    part<app::StudyRun>().cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !part<app::StudyRun>().running(); }, 30000));
    app::Theme::current().setScale(1);
}

TEST_F(StudyWindowTest, OwnSettingsOpenTheirFieldsWhichCloseWithTheWindow) {
    auto& dialog = part<QWidget>("studySetUpDialog");
    EXPECT_FALSE(dialog.isVisible());
    auto& sweeps = part<QComboBox>("studySweep");
    sweeps.setCurrentIndex(sweeps.count() - 1);
    emit sweeps.activated(sweeps.count() - 1);
    EXPECT_TRUE(dialog.isVisible());
    EXPECT_TRUE(part<QWidget>("studyValues0").isVisible());
    EXPECT_TRUE(part<QWidget>("studyRepeats").isVisible());
    panel.hide();
    EXPECT_FALSE(dialog.isVisible());
}

// The second where there is room for it whole.
TEST_F(StudyWindowTest, TheBottomLineHasWholeAnswers) {
    auto& words = part<QLabel>("studyAnswers");
    for (const int width : {1900, 1000}) {
        panel.resize(width, 720);
        QCoreApplication::processEvents();
        EXPECT_LE(words.fontMetrics().horizontalAdvance(words.text()), words.width());
        EXPECT_TRUE(words.text().startsWith(part<QLabel>("cheapestSentence").text()));
        EXPECT_EQ(words.text().contains(part<QLabel>("bestSentence").text()), width == 1900);
    }
}

// In a low window they stand below the table, one at a time; the plot has the height.
TEST_F(StudyWindowTest, ThePicturesFindTheirPlaceByTheHeight) {
    auto& pictures = part<app::StudyPicturesView>();
    auto& tabs = part<QTabWidget>("studyTabs");
    EXPECT_FALSE(tabs.isAncestorOf(&pictures)) << "900 high";
    for (int time = 0; time < 2; ++time) {
        panel.resize(1280, 720);
        QCoreApplication::processEvents();
        EXPECT_TRUE(tabs.isAncestorOf(&pictures));
        EXPECT_TRUE(pictures.isVisible());
        EXPECT_GE(part<app::PictureFrame>().height(), 96);
        tabs.setCurrentWidget(&part<app::StudyDetails>().errors());
        EXPECT_TRUE(part<QTableWidget>("studyErrors").isVisible());
        panel.resize(1500, 900);
        QCoreApplication::processEvents();
        EXPECT_FALSE(tabs.isAncestorOf(&pictures));
        EXPECT_TRUE(pictures.isVisible());
        EXPECT_TRUE(part<QTableWidget>("studyErrors").isVisible());
        EXPECT_TRUE(part<QWidget>("blameBars").isVisible());
    }
}

// What the table has no room for goes from the interval on; it never scrolls from side to side.
TEST_F(StudyWindowTest, TheIntervalGivesWayWhereTheTableIsNarrow) {
    auto& points = part<StudyPoints>();
    const int interval = points.columnCount() - 3;
    ASSERT_EQ(points.horizontalHeaderItem(interval)->text(), "95 % interval");
    points.resize(900, 300);
    EXPECT_FALSE(points.isColumnHidden(interval));
    for (const double scale : {1.0, 1.5}) {
        app::Theme::current().setScale(scale);
        panel.resize(scale == 1 ? 1024 : 1336, 704);
        QCoreApplication::processEvents();
        EXPECT_TRUE(points.isColumnHidden(interval));
        EXPECT_EQ(points.horizontalScrollBar()->maximum(), 0) << scale;
    }
    app::Theme::current().setScale(1);
}

// A window of its own, which the keyboard goes through and out of its tables again.
TEST_F(StudyWindowTest, HasATitleAndKeepsNoFocusInATable) {
    EXPECT_EQ(panel.windowTitle(), "Error against run time");
    const auto tables = panel.findChildren<QTableWidget*>();
    ASSERT_EQ(tables.size(), 3);
    for (QTableWidget* table : tables) {
        table->setFocus();
        QTest::keyClick(table, Qt::Key_Tab);
        EXPECT_NE(QApplication::focusWidget(), table) << table->accessibleName().toStdString();
    }
}

// A wide picture in a high place: what it is stands right below it.
TEST_F(StudyWindowTest, ACaptionStandsRightBelowItsPicture) {
    app::PictureFrame frame;
    frame.resize(200, 400);
    QImage picture(100, 50, QImage::Format_RGB32);
    picture.fill(Qt::red);
    frame.show(picture, "Reference", {});
    const QImage shown = frame.grab().toImage();
    ASSERT_EQ(shown.pixelColor(100, 99), QColor(Qt::red)) << "scaled to 200 by 100";
    const QColor ground = shown.pixelColor(199, 399);
    const auto hasInk = [&](int from, int to) {
        for (int y = from; y < to; ++y)
            for (int x = 0; x < shown.width(); ++x)
                if (shown.pixelColor(x, y) != ground) return true;
        return false;
    };
    const int line = QFontMetrics(app::Theme::current().text(12)).height();
    EXPECT_TRUE(hasInk(101, 101 + line));
    EXPECT_FALSE(hasInk(101 + line, 400));
}

// What the machine did beside it, as the command says.
TEST_F(StudyWindowTest, SaysHowBusyTheMachineWas) {
    StudyReport report = pyramidStudy();
    report.load.clear();
    panel.setReport(report);
    EXPECT_FALSE(part<QLabel>("studyLoad").isVisible()) << "a study that does not say";
    report.load = {0.5, 3.06, 1};
    panel.setReport(report);
    EXPECT_EQ(part<QLabel>("studyLoad").text(), "machine load 3.1") << "the most of the processes";
}
