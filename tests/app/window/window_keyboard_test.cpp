#include <QAbstractItemView>
#include <QAccessible>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSet>
#include <QTest>
#include <QToolButton>

#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/commands/actions.h"
#include "app/docks/panel_dock.h"
#include "app/export/export_dialog.h"
#include "app/export/film_dialog.h"
#include "app/frames/pixel_inspection.h"
#include "app/inspector/math_view.h"
#include "app/look/theme.h"
#include "app/stages/step_bar.h"
#include "app/start/start_page.h"
#include "app/view3d/scene_view.h"
#include "app/views/view_area.h"
#include "app/widgets/tab_order.h"
#include "tests/app/quiet.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

using WindowKeyboard = WindowTest;

// Two columns under a bar: the bar, then the left column to its foot, then the right one.
TEST(TabOrder, ReadsColumnsUnderABar) {
    QWidget window;
    window.resize(300, 300);
    const auto place = [](QWidget* parent, int x, int y) {
        auto* field = new QLineEdit(parent);
        field->setGeometry(x, y, 80, 20);
        return field;
    };
    auto* right = new QWidget(&window);
    right->setGeometry(150, 50, 150, 250);
    auto* left = new QWidget(&window);
    left->setGeometry(0, 50, 140, 250);
    QWidget* rightTop = place(right, 0, 10);
    QWidget* leftFoot = place(left, 0, 200);
    QWidget* leftTop = place(left, 0, 0);
    QWidget* barEnd = place(&window, 100, 4);
    QWidget* bar = place(&window, 0, 0);
    place(&window, -400, 60);  // behind another's tab
    place(left, 0, 100)->setEnabled(false);
    window.show();
    EXPECT_EQ(tabOrder(window), (QList<QWidget*>{bar, barEnd, leftTop, leftFoot, rightTop}));
    EXPECT_EQ(nextInTabOrder(window, rightTop, true), bar);
    EXPECT_EQ(nextInTabOrder(window, bar, false), rightTop);
    EXPECT_EQ(nextInTabOrder(window, &window, true), nullptr);
}

TEST_F(WindowKeyboard, TabGoesThroughTheWholeWindowAndBack) {
    openPyramid();
    for (const char* panel : {"tables", "scanline"}) find<QDockWidget>(panel)->show();
    document().pointing().pick(glm::ivec2(280, 257));
    ASSERT_TRUE(waitForFrame());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().inspection().busy(); }));
    ASSERT_TRUE(test::waitUntilQuiet());  // what the pixel shows comes and goes
    const QList<QWidget*> order = tabOrder(window);
    const qsizetype all = order.size();
    ASSERT_GT(all, 40);
    canvas()->setFocus();
    QList<QWidget*> seen;
    do {
        press("Tab");
        QWidget* now = QApplication::focusWidget();
        ASSERT_NE(now, nullptr);
        if (const auto* words = qobject_cast<QLabel*>(now)) {
            EXPECT_TRUE(words->text().contains("href")) << words->text().toStdString() << " does nothing";
            if (!seen.isEmpty() && seen.back() == now) continue;  // from link to link
        }
        seen += now;
        const bool isSeen = !now->visibleRegion().isEmpty() || qobject_cast<SceneView*>(now);  // OpenGL's is above it
        EXPECT_TRUE(isSeen) << now->accessibleName().toStdString() << " cannot be seen";
        const QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(now);
        EXPECT_FALSE(spoken->text(QAccessible::Name).isEmpty())
            << now->metaObject()->className() << ' ' << now->objectName().toStdString() << " has no name";
        EXPECT_NE(spoken->role(), QAccessible::Client) << now->metaObject()->className() << " has no role";
    } while (seen.back() != canvas() && seen.size() <= all);
    EXPECT_EQ(seen.back(), canvas()) << "it comes round";
    EXPECT_EQ(QSet<QWidget*>(seen.begin(), seen.end()), QSet<QWidget*>(order.begin(), order.end())) << "each, and once";
    EXPECT_EQ(seen.size(), all);
    EXPECT_LT(seen.indexOf(window.findChild<StepBar*>()), seen.indexOf(window.findChild<QWidget*>("runCommand")))
        << "from the foot to the top";
    press("Shift+Tab");
    EXPECT_EQ(QApplication::focusWidget(), seen[all - 2]);
}

TEST_F(WindowKeyboard, TabScrollsToWhatItComesTo) {
    auto* page = window.findChild<StartPage*>();
    ASSERT_TRUE(page->isVisible());
    for (qsizetype i = tabOrder(window).size(); i > 0; --i) {
        press("Tab");
        QWidget* now = QApplication::focusWidget();
        EXPECT_FALSE(now->visibleRegion().isEmpty()) << now->accessibleName().toStdString();
        EXPECT_FALSE(qobject_cast<QScrollArea*>(now));
    }
}

TEST_F(WindowKeyboard, DialogsBeginAtTheirFirstFieldAndEveryFieldHasAName) {
    openPyramid();
    FilmDialog film(document(), {pipeline::BufferId::Color});
    ExportDialog buffers(document());
    for (QDialog* dialog : {static_cast<QDialog*>(&film), static_cast<QDialog*>(&buffers)}) {
        dialog->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog));
        QApplication::setActiveWindow(dialog);
        const QList<QWidget*> order = tabOrder(*dialog);
        for (QWidget* widget : order) {
            EXPECT_EQ(QApplication::focusWidget(), widget) << dialog->objectName().toStdString();
            EXPECT_FALSE(QAccessible::queryAccessibleInterface(widget)->text(QAccessible::Name).isEmpty())
                << widget->objectName().toStdString();
            press("Tab");
        }
        EXPECT_EQ(QApplication::focusWidget(), order.front());
        dialog->hide();
    }
}

TEST_F(WindowKeyboard, TheKeysGoToThePictureOfAnOpenedScene) {
    openPyramid();
    EXPECT_TRUE(QTest::qWaitFor([&] { return canvas()->hasFocus(); }));
}

TEST_F(WindowKeyboard, ArrowsMoveThePixelThatWasGoneTo) {
    openPyramid();
    find<QWidget>("runCommand")->setFocus();
    press("Ctrl+G");
    auto* field = find<QLineEdit>("pixelText");
    field->setText("640, 0");
    press("Return");
    EXPECT_TRUE(field->isVisible()) << "there is no such column";
    field->setText("280, 257");
    press("Return");
    press("Right");
    EXPECT_EQ(document().pointing().pixel(), glm::ivec2(281, 257));
    ASSERT_TRUE(waitForFrame());
    EXPECT_TRUE(canvas()->accessibleDescription().startsWith("x 281 y 257 → "))
        << canvas()->accessibleDescription().toStdString();
}

// The list below the field never has the focus.
TEST_F(WindowKeyboard, TheFieldTellsWhichCommandTheArrowsHaveComeTo) {
    openPyramid();
    press("Ctrl+Shift+P");
    auto* command = find<QLineEdit>("commandField");
    command->setText("theme");
    const QString first = command->accessibleDescription();
    EXPECT_FALSE(first.isEmpty());
    press("Down");
    EXPECT_NE(command->accessibleDescription(), first);
    press("Tab");
    EXPECT_TRUE(command->hasFocus()) << "in an overlay Tab goes round";
    press("Escape");
    EXPECT_TRUE(canvas()->hasFocus());
}

// The track keeps the keys after a drag, until one goes back to a view.
TEST_F(WindowKeyboard, AClickInAViewsHeaderGivesItTheKeys) {
    openPyramid();
    auto* track = find<StepBar>("stepBar");
    const auto click = [&](QWidget* view, const QString& button) {
        track->setFocus();
        for (auto* one : view->findChildren<QToolButton*>())
            if (one->accessibleName() == button) return QTest::mouseClick(one, Qt::LeftButton);
        FAIL() << button.toStdString();
    };
    click(&window.views().first(), "Fit");
    EXPECT_TRUE(canvas()->hasFocus());
    auto* space = window.findChild<SceneView*>();
    click(space->parentWidget(), "Lights");
    EXPECT_TRUE(space->hasFocus());
}

TEST_F(WindowKeyboard, APanelsKeysBringItToTheFrontBeforeTheyCloseIt) {
    openPyramid();
    auto *lesson = find<PanelDock>("lesson"), *cues = find<PanelDock>("cues");
    ASSERT_TRUE(QTest::qWaitFor([&] { return lesson->isInFront(); }));
    const auto becomes = [](PanelDock* dock, bool inFront) {
        return QTest::qWaitFor([&] { return dock->isInFront() == inFront; });
    };
    press("Ctrl+Alt+6");
    EXPECT_TRUE(becomes(cues, true)) << "it was behind";
    EXPECT_TRUE(cues->toggleViewAction()->isChecked());
    EXPECT_FALSE(lesson->isInFront());
    press("Ctrl+Alt+3");
    EXPECT_TRUE(becomes(lesson, true));
    EXPECT_FALSE(cues->isHidden());
    press("Ctrl+Alt+3");
    EXPECT_TRUE(lesson->isHidden()) << "it was in front";
    EXPECT_FALSE(lesson->toggleViewAction()->isChecked());
    EXPECT_TRUE(becomes(cues, true));
    press("Ctrl+Alt+3");
    EXPECT_TRUE(becomes(lesson, true)) << "it was hidden";
    EXPECT_TRUE(lesson->toggleViewAction()->isChecked());
}

TEST_F(WindowKeyboard, CtrlWClosesAWindowOfItsOwnAlone) {
    openPyramid();
    for (const ActionId id : {ActionId::Study, ActionId::Check}) {
        window.actions()[id]->trigger();
        QWidget* apart = window.findChild<QWidget*>(id == ActionId::Study ? "studyPanel" : "checkPanel");
        ASSERT_NE(apart, nullptr);
        ASSERT_TRUE(QTest::qWaitForWindowExposed(apart));
        QApplication::setActiveWindow(apart);
        QTest::keySequence(apart, QKeySequence("Ctrl+W"));
        EXPECT_FALSE(apart->isVisible());
        EXPECT_TRUE(document().hasScene());
        QApplication::setActiveWindow(&window);
    }
}

TEST_F(WindowKeyboard, EscLeavesAConditionForThePicture) {
    openPyramid();
    canvas()->setFocus();
    press("/");
    ASSERT_FALSE(canvas()->hasFocus());
    press("Escape");
    EXPECT_TRUE(canvas()->hasFocus());
}

TEST_F(WindowKeyboard, EveryMenuHasALetterThatNoCommandHas) {
    QSet<QString> keys;
    for (const auto& [id, row] : window.actions().rows())
        for (const QKeySequence& key : window.actions()[row.id]->shortcuts()) keys += key.toString();
    QSet<QString> letters;
    for (const QAction* menu : window.findChild<QMenuBar*>()->actions()) {
        const QString key = QKeySequence::mnemonic(menu->text()).toString();
        EXPECT_TRUE(key.startsWith("Alt+")) << menu->text().toStdString();
        EXPECT_FALSE(keys.contains(key)) << key.toStdString();
        EXPECT_FALSE(letters.contains(key)) << key.toStdString();
        letters += key;
    }
}

TEST_F(WindowKeyboard, TheEquationsRingGoesWithTheFocus) {
    openPyramid();
    document().pointing().pick(glm::ivec2(280, 257));
    ASSERT_TRUE(waitForFrame());
    auto* equation = window.findChild<MathView*>();
    ASSERT_NE(equation, nullptr);
    const auto rim = [&] {
        EXPECT_TRUE(test::waitUntilQuiet());
        const QPoint at = equation->mapToGlobal(QPoint(equation->width() / 2, 1));
        return equation->screen()->grabWindow(0).toImage().pixelColor(at);
    };
    equation->setFocus();
    EXPECT_EQ(rim(), Theme::current().colors().focus);
    canvas()->setFocus();
    EXPECT_NE(rim(), Theme::current().colors().focus);
}

TEST_F(WindowKeyboard, ListsAndTablesShowThatTheyHaveTheFocus) {
    openPyramid();
    for (const char* name : {"cues", "tables"}) {
        auto* dock = find<PanelDock>(name);
        dock->show(), dock->raise();
    }
    QCoreApplication::processEvents();
    int seen = 0;
    for (auto* list : window.findChildren<QAbstractItemView*>()) {
        if (!list->isVisible() || list->focusPolicy() == Qt::NoFocus) continue;
        const auto rim = [list] { return list->grab().toImage().pixelColor(list->width() / 2, 1); };
        list->setFocus();
        EXPECT_EQ(rim(), Theme::current().colors().focus) << list->objectName().toStdString();
        canvas()->setFocus();
        EXPECT_NE(rim(), Theme::current().colors().focus) << list->objectName().toStdString();
        ++seen;
    }
    EXPECT_GE(seen, 3) << "the scene's, the cues, a table";
}

// For a mail as for another window: the picture, and the text that shows it again.
TEST_F(WindowKeyboard, CopyingInAViewCopiesThePictureToo) {
    openPyramid();
    canvas()->setFocus();
    press("Ctrl+C");
    const QImage copied = QApplication::clipboard()->image();
    EXPECT_EQ(copied.size(), QSize(document().scene().settings.width, document().scene().settings.height));
    const glm::ivec2 pixel(268, 281);
    EXPECT_EQ(copied.pixelColor(pixel.x, pixel.y), frameColor(pixel));
    EXPECT_TRUE(QApplication::clipboard()->text().contains("pyramid"));
}

TEST_F(WindowKeyboard, TwoFingersOnATouchpadZoom) {
    openPyramid();
    const double before = canvas()->placing().zoom();
    const auto pinch = [&](double by) {
        const QPointF at(canvas()->rect().center());
        QNativeGestureEvent event(Qt::ZoomNativeGesture, QPointingDevice::primaryPointingDevice(), 2, at, at, at, by,
                                  {});
        QCoreApplication::sendEvent(canvas(), &event);
    };
    for (int i = 0; i < 12; ++i) pinch(0.25);
    const double larger = canvas()->placing().zoom();
    EXPECT_GT(larger, 2 * before);
    for (int i = 0; i < 6; ++i) pinch(-0.25);
    EXPECT_LT(canvas()->placing().zoom(), larger);
}

TEST_F(WindowKeyboard, TextFieldsCopyTheirOwnText) {
    openPyramid();
    canvas()->setFocus();
    press("Ctrl+/");
    auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    ASSERT_TRUE(field);
    field->setText("x < 3");
    field->selectAll();
    press("Ctrl+C");
    EXPECT_EQ(QApplication::clipboard()->text(), "x < 3");
}

// Qt does so in dialogs alone; a choice is made with Space, so that Enter can take it.
TEST_F(WindowKeyboard, EnterPressesTheButtonThatHasTheFocus) {
    openPyramid();
    QWidget tools;
    auto* push = new QPushButton("push", &tools);
    auto* tool = new QToolButton(&tools);
    auto* check = new QCheckBox("check", &tools);
    tool->move(0, 40), check->move(0, 80);
    tools.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&tools));
    tools.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&tools));
    for (QAbstractButton* button : std::initializer_list<QAbstractButton*>{push, tool, check}) {
        int clicks = 0;
        const auto counted = QObject::connect(button, &QAbstractButton::clicked, [&] { ++clicks; });
        button->setFocus();
        QTest::keyClick(button, Qt::Key_Return);
        QTest::keyClick(button, Qt::Key_Enter, Qt::KeypadModifier);
        EXPECT_EQ(clicks, button == check ? 0 : 2) << button->text().toStdString();
        QObject::disconnect(counted);
    }
}

TEST_F(WindowKeyboard, APanelThatAKeyOpensGetsTheKeys) {
    openPyramid();
    auto* dock = find<PanelDock>("tables");
    if (dock->isInFront()) dock->toggleViewAction()->trigger();
    canvas()->setFocus();
    dock->toggleViewAction()->trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return dock->isInFront(); }, 5000));
    EXPECT_TRUE(dock->isAncestorOf(QApplication::focusWidget()));
}

}  // namespace
}  // namespace app
