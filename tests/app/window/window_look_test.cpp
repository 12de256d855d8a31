#include <QDockWidget>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QTest>
#include <QTimer>
#include <map>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/commands/actions.h"
#include "app/commands/command_palette.h"
#include "app/desktop/key_sheet.h"
#include "app/docks/layout_store.h"
#include "app/docks/panel_dock.h"
#include "app/docks/panel_table.h"
#include "app/lesson/lesson_panel.h"
#include "app/look/theme.h"
#include "app/views/even_splitter.h"
#include "app/views/view_area.h"
#include "tests/app/quiet.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

class WindowLooks : public WindowTest {
protected:
    void expectPictureIsFrame() {
        const QImage shown = canvas()->grab().toImage();
        // On the pyramid, at its edge, and outside.
        for (const glm::ivec2 pixel : {glm::ivec2(268, 281), glm::ivec2(292, 259), glm::ivec2(300, 285)})
            EXPECT_EQ(shownColor(shown, pixel), frameColor(pixel)) << pixel.x << ", " << pixel.y;
    }
    void expectNothingCut() {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);  // of what has just come
        for (const QPushButton* button : window.findChildren<QPushButton*>()) {
            if (!button->isVisible() || button->text().isEmpty()) continue;
            EXPECT_LE(button->fontMetrics().horizontalAdvance(button->text()), button->width())
                << '"' << button->text().toStdString() << '"';
        }
        for (const QLabel* label : window.findChildren<QLabel*>()) {
            if (!label->isVisible() || label->text().isEmpty() || label->wordWrap()) continue;
            if (label->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored) continue;
            EXPECT_LE(label->minimumSizeHint().height(), label->height() + 1)
                << '"' << label->text().toStdString() << '"';
        }
    }
};

TEST_F(WindowLooks, PictureIsTheFrameInEveryTheme) {
    openPyramid();
    for (const ThemeId theme : {ThemeId::Light, ThemeId::Dark, ThemeId::Projector}) {
        Theme::current().set(theme);
        ASSERT_TRUE(waitForFrame());
        expectPictureIsFrame();
    }
}

TEST_F(WindowLooks, NothingIsCutInAnySizeAndTheme) {
    openPyramid();
    document().pointing().pick(glm::ivec2(268, 281));
    for (const QSize size : {QSize(1024, 640), QSize(1280, 720), QSize(1600, 900)}) {
        for (const ThemeId theme : {ThemeId::Light, ThemeId::Dark, ThemeId::Projector}) {
            SCOPED_TRACE(testing::Message() << size.width() << " x " << size.height() << ", theme " << int(theme));
            window.resize(size);
            Theme::current().set(theme);
            EXPECT_TRUE(test::waitUntilQuiet());
            EXPECT_EQ(window.size(), size) << "the panels need more room than the window has";
            expectNothingCut();
        }
    }
}

// Beside the pixel under the cursor a sentence that the foot has room for stands whole; what stands elsewhere too gives
// way, and comes back when the next sentence is short.
TEST_F(WindowLooks, TheSentenceAtTheFootHasRoom) {
    openPyramid();
    window.resize(1280, 720);
    Theme::current().set(ThemeId::Projector);
    EXPECT_TRUE(test::waitUntilQuiet());
    auto* sentence = find<QLabel>("statusSentence");
    auto* error = find<QLabel>("statusError");
    emit document().said("5 stages ran, 1 left out.");
    EXPECT_TRUE(error->isVisible());
    document().pointing().hover(glm::ivec2(268, 281));
    emit document().said("The eye does not see that point: polygon 3 is turned away or hidden there.");
    EXPECT_TRUE(test::waitUntilQuiet());
    EXPECT_FALSE(error->isVisible());
    EXPECT_LE(sentence->sizeHint().width(), sentence->width());
    document().pointing().hover(std::nullopt);
    EXPECT_FALSE(error->isVisible()) << "not while the cursor moves";
    emit document().said("5 stages ran, 1 left out.");
    EXPECT_TRUE(error->isVisible());
}

TEST_F(WindowLooks, ResetBringsClosedPanelsBack) {
    openPyramid();
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) dock->close();
    auto* inspector = find<QDockWidget>("inspector");
    EXPECT_FALSE(inspector->isVisible());
    window.actions()[ActionId::ResetLayout]->trigger();
    EXPECT_TRUE(test::waitUntilQuiet());
    // Tables are shown when asked for, My renderer while one is checked.
    const QStringList later{"tables", "scanline", "renderer"};
    for (QDockWidget* dock : window.findChildren<QDockWidget*>())
        EXPECT_EQ(dock->isVisible(), !later.contains(dock->objectName())) << dock->objectName().toStdString();
    EXPECT_GT(inspector->width(), 300);
}

TEST_F(WindowLooks, TheNextStartHasTheWindowWhereItWasLeft) {
    window.setGeometry(40, 60, 1300, 800);
    window.close();
    MainWindow next;
    EXPECT_EQ(next.geometry(), QRect(40, 60, 1300, 800));
    EXPECT_FALSE(next.isMaximized());
    next.setWindowState(Qt::WindowMaximized);
    next.close();
    const MainWindow last;
    EXPECT_TRUE(last.isMaximized());
    EXPECT_EQ(last.normalGeometry(), QRect(40, 60, 1300, 800)) << "its size when it is no longer";
}

TEST_F(WindowLooks, AWindowFromAScreenThatIsGoneComesBackOnOneThatIsThere) {
    const QRect screen = window.screen()->availableGeometry();
    window.setGeometry(QRect(screen.bottomRight() + QPoint(900, 700), QSize(1300, 800)));
    window.close();
    const MainWindow next;
    EXPECT_TRUE(screen.contains(next.geometry())) << next.x() << ", " << next.y();
    EXPECT_EQ(next.size(), QSize(1300, 800));
}

TEST_F(WindowLooks, ResetBringsTheWindowsFirstPlaceBackAndNamedLayoutsLeaveIt) {
    openPyramid();
    window.setGeometry(40, 60, 1300, 800);
    press("Ctrl+Shift+3");
    EXPECT_EQ(window.geometry(), QRect(40, 60, 1300, 800));
    window.actions()[ActionId::ResetLayout]->trigger();
    const QRect screen = window.screen()->availableGeometry();
    EXPECT_EQ(window.size(), QSize(1680, 1000).boundedTo(screen.size()));
    EXPECT_TRUE(screen.contains(window.geometry()));
}

TEST_F(WindowLooks, NamedLayoutsPutViewsInTheirPlaces) {
    openPyramid();
    struct Case {
        const char *keys, *arrangement;
        bool first, second, space;
    };
    for (const Case& c : {Case{"Ctrl+Shift+3", "compare", true, true, false},
                          {"Ctrl+Shift+4", "space", false, false, true},
                          {"Ctrl+Shift+5", "buffer", true, false, false},
                          {"Ctrl+Shift+2", "two", true, true, true},
                          {"Ctrl+Shift+1", "one", true, false, true}}) {
        press(c.keys);
        EXPECT_EQ(window.views().arrangement(), c.arrangement) << c.keys;
        EXPECT_EQ(find<QWidget>("firstFrame")->isVisible(), c.first) << c.arrangement;
        EXPECT_EQ(find<QWidget>("secondFrame")->isVisible(), c.second) << c.arrangement;
        EXPECT_EQ(find<QWidget>("view3dFrame")->isVisible(), c.space) << c.arrangement;
        const auto state = window.shown().now();
        ASSERT_TRUE(state);
        EXPECT_EQ(state->arrangement, c.arrangement) << "a session keeps it";
    }
    press("Ctrl+Shift+3");
    const QRect a = find<QWidget>("firstFrame")->geometry(), b = find<QWidget>("secondFrame")->geometry();
    EXPECT_EQ(a.top(), b.top()) << "side by side";
    EXPECT_NEAR(a.width(), b.width(), 2);
    window.actions()[ActionId::ResetLayout]->trigger();
    EXPECT_TRUE(find<QWidget>("view3dFrame")->isVisible());
}

// Of 308 pixels a handle of 8 leaves 300: thirds at 100 and 200, the half at 150.
TEST(EvenSplitter, ItsHandleStopsAtHalvesAndThirds) {
    EXPECT_EQ(snappedPosition(146, 308, 8, 10), 150);
    EXPECT_EQ(snappedPosition(109, 308, 8, 10), 100);
    EXPECT_EQ(snappedPosition(195, 308, 8, 10), 200);
    EXPECT_EQ(snappedPosition(125, 308, 8, 10), 125) << "none is near";
}

TEST_F(WindowLooks, ADoubleClickEvensTheViews) {
    openPyramid();
    press("Ctrl+Shift+1");
    auto* columns = window.views().findChild<QSplitter*>();
    columns->setSizes({700, 300});
    QTest::mouseDClick(columns->handle(1), Qt::LeftButton);
    EXPECT_NEAR(columns->sizes()[0], columns->sizes()[1], 2);
}

TEST_F(WindowLooks, AKeptLayoutIsThereByItsName) {
    const KeptLayout layout{"panels", "2: buffer | 1: buffer", true};
    keepLayout("Lecture 2/shadows", layout);
    EXPECT_EQ(keptLayouts(), QStringList("Lecture 2/shadows"));
    EXPECT_EQ(keptLayout("Lecture 2/shadows"), layout);
    EXPECT_FALSE(keptLayout("Lecture 3"));
    dropLayout("Lecture 2/shadows");
    EXPECT_TRUE(keptLayouts().isEmpty());
}

TEST_F(WindowLooks, AKeptLayoutIsFoundAmongTheCommands) {
    openPyramid();
    press("Ctrl+Shift+1");
    keepLayout("Seminar", {{}, "four", false});
    press("Ctrl+Shift+P");
    auto* field = find<QLineEdit>("commandField");
    QTest::keyClicks(field, "seminar");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_EQ(window.views().arrangement(), "four");
    dropLayout("Seminar");
}

TEST_F(WindowLooks, AKeptLayoutIsReplacedOnlyWhenAsked) {
    openPyramid();
    const KeptLayout before{{}, "four", false};
    keepLayout("Seminar", before);
    const auto keepAgain = [this](const QString& button) {
        QTimer::singleShot(0, &window, [this, button] {
            auto* field = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
            ASSERT_NE(field, nullptr);
            field->setTextValue("Seminar");
            QTimer::singleShot(0, &window, [button] {
                auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
                ASSERT_NE(box, nullptr);
                for (QAbstractButton* one : box->buttons())
                    if (one->text() == button) one->click();
            });
            field->accept();
        });
        window.actions()[ActionId::KeepLayout]->trigger();
        QCoreApplication::processEvents();
    };
    keepAgain("Cancel");
    EXPECT_EQ(keptLayout("Seminar"), before);
    keepAgain("Replace");
    EXPECT_NE(keptLayout("Seminar"), before);
    dropLayout("Seminar");
}

TEST_F(WindowLooks, LargerTextIsLargerAndComesBack) {
    openPyramid();
    const double before = Theme::current().scale();
    press("Ctrl+Shift++");
    EXPECT_NEAR(Theme::current().scale(), before + 0.05, 1e-9);
    press("Ctrl+Shift+-");
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(Theme::current().scale() - before) < 1e-9; }));
}

// The scene's name gives way.
TEST_F(WindowLooks, WithLargeTextEveryMenuIsInReachOnASmallScreen) {
    window.resize(1366, 768);
    openPyramid();
    find<QLabel>("title")->setText(QString(60, 'x'));
    const double before = Theme::current().scale();
    Theme::current().setScale(2);
    QCoreApplication::processEvents();
    const auto* menus = window.findChild<QMenuBar*>();
    for (QAction* menu : menus->actions()) {
        const QRect place = menus->actionGeometry(menu);
        EXPECT_FALSE(place.isEmpty()) << menu->text().toStdString();
        EXPECT_LE(place.right(), menus->width()) << menu->text().toStdString();
    }
    Theme::current().setScale(before);
}

// A theme and the letters' size change how panels look, not which are there.
TEST_F(WindowLooks, AThemeAndLargerTextLeaveThePanelsAsChosen) {
    openPyramid();
    auto* inspector = find<QDockWidget>("inspector");
    auto* tree = find<QDockWidget>("scene");
    press("Ctrl+Alt+4");
    press("Ctrl+T");
    ASSERT_FALSE(inspector->isVisible());
    ASSERT_FALSE(window.views().hasThumbnails());
    window.resizeDocks({tree}, {350}, Qt::Horizontal);
    EXPECT_TRUE(test::waitUntilQuiet());
    ASSERT_EQ(tree->width(), 350);
    press("Ctrl+Shift++");
    EXPECT_TRUE(test::waitUntilQuiet());
    EXPECT_FALSE(inspector->isVisible());
    EXPECT_FALSE(window.views().hasThumbnails());
    EXPECT_NEAR(tree->width(), 350 * 1.03, 1) << "it grows with the letters, but less";
    window.actions()[ActionId::DarkTheme]->trigger();
    EXPECT_TRUE(test::waitUntilQuiet());
    EXPECT_FALSE(inspector->isVisible());
    EXPECT_FALSE(window.views().hasThumbnails());
    EXPECT_NEAR(tree->width(), 350, 2) << "the dark theme's letters have their first size";
    Theme::current().set(ThemeId::Light);
    Theme::current().setScale(1);
}

// What ends the program must not take back what was chosen: both are kept while the window is open.
TEST_F(WindowLooks, TheThemeAndThePlacesOfPanelsAreKeptAtOnce) {
    openPyramid();
    const auto kept = [] {
        for (const QString& key : QSettings().allKeys())
            if (key.startsWith("layout")) return QSettings().value(key).toByteArray();
        return QByteArray();
    };
    const QByteArray before = kept();
    window.actions()[ActionId::DarkTheme]->trigger();
    press("Ctrl+Alt+4");
    EXPECT_TRUE(QTest::qWaitFor([&] { return QSettings().value("theme").toString() == "dark" && kept() != before; }));
    Theme::current().set(ThemeId::Light);
}

// What gives way in the status line is hidden once, not shown and hidden again without end.
TEST_F(WindowLooks, TheLargestLettersLeaveTheWindowStanding) {
    window.resize(1280, 720);
    Theme::current().set(ThemeId::Projector);
    Theme::current().setScale(Theme::kMostScale);
    openPyramid();
    EXPECT_TRUE(find<QLabel>("statusSentence")->isVisible());
    Theme::current().setScale(1.25);
    Theme::current().set(ThemeId::Light);
}

TEST_F(WindowLooks, TheNextSceneHasThePanelsOfTheOneThatWasClosed) {
    openPyramid();
    press("Ctrl+Alt+4");
    press("Ctrl+W");
    openPyramid();
    EXPECT_FALSE(find<QDockWidget>("inspector")->isVisible());
    EXPECT_TRUE(find<QDockWidget>("settings")->isVisible());
}

// A program that was killed says no goodbye: the second window begins while the first still stands.
TEST_F(WindowLooks, PanelsAreKeptSoonAfterTheyChange) {
    window.resize(1900, 1000);
    openPyramid();
    PanelDock& settings = window.docks()[PanelId::Settings];
    ASSERT_FALSE(settings.isHidden());
    settings.toggleViewAction()->trigger();
    ASSERT_TRUE(settings.isHidden());
    const auto staysHidden = [&] {
        MainWindow next;
        next.resize(1900, 1000);
        next.show();
        EXPECT_TRUE(next.openFile(resourceScene("pyramid.scene")));
        return next.docks()[PanelId::Settings].isHidden();
    };
    EXPECT_TRUE(QTest::qWaitFor(staysHidden, 20000));
}

}  // namespace
}  // namespace app
