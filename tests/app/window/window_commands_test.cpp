// Commands and keys, found by their words.
#include <QDockWidget>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <map>
#include "app/buffer_view/buffer_view.h"
#include "app/canvas/buffer_canvas.h"
#include "app/commands/actions.h"
#include "app/commands/command_palette.h"
#include "app/compare/buffer_compare.h"
#include "app/desktop/key_sheet.h"
#include "app/docks/layout_store.h"
#include "app/docks/panel_table.h"
#include "app/lesson/lesson_panel.h"
#include "app/look/theme.h"
#include "app/views/even_splitter.h"
#include "app/views/view_area.h"
#include "tests/app/quiet.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

class WindowCommands : public WindowTest {};

TEST_F(WindowCommands, CommandIsFoundByAPartOfItsName) {
    openPyramid();
    press("Ctrl+Shift+P");
    auto* field = find<QLineEdit>("commandField");
    ASSERT_TRUE(field->isVisible());
    QTest::keyClicks(field, "z-buf");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_FALSE(field->isVisible());
    EXPECT_EQ(document().stage(), pipeline::StageId::ZBuffer);
}

TEST_F(WindowCommands, ACommandIsFoundByWordsInAnyOrderTheBestFirst) {
    press("Ctrl+Shift+P");
    QTest::keyClicks(find<QLineEdit>("commandField"), "point light shadow");
    auto* list = find<CommandPalette>("commandPalette")->findChild<QListWidget*>();
    ASSERT_GT(list->count(), 0);
    EXPECT_EQ(list->item(0)->text(), "Shadow of a point light");
}

// Who looks for a comparison or an overlay looks in the menus.
TEST_F(WindowCommands, TheMenusHaveWhatTheActiveBufferViewHasAboveItsPicture) {
    openPyramid();
    const auto textsIn = [this](const QString& name) {
        QStringList texts;
        for (auto* menu : window.findChildren<QMenu*>()) {
            if (menu->title().remove('&') != name) continue;
            emit menu->aboutToShow();
            for (const QAction* action : menu->actions()) texts += action->text();
        }
        return texts;
    };
    EXPECT_TRUE(textsIn("Compare with").contains("Another pipeline"));
    EXPECT_TRUE(textsIn("Overlays").contains("Condition…"));
    EXPECT_EQ(textsIn("Overlays").count("Condition…"), 1) << "each time anew";
    const auto mayWriteHandout = [this, &textsIn] {
        EXPECT_TRUE(textsIn("File").contains("Lesson as a handout…"));
        const auto actions = window.findChildren<QAction*>();
        return std::ranges::any_of(actions,
                                   [](QAction* a) { return a->text() == "Lesson as a handout…" && a->isEnabled(); });
    };
    EXPECT_FALSE(mayWriteHandout()) << "of no lesson";
    window.lessons().open("pyramid");
    EXPECT_TRUE(mayWriteHandout());
}

TEST_F(WindowCommands, TheFieldsWordsFindWhatTheyMean) {
    openPyramid();
    press("Ctrl+Shift+P");
    auto* field = find<QLineEdit>("commandField");
    const auto* list = find<CommandPalette>("commandPalette")->findChild<QListWidget*>();
    constexpr std::pair<const char*, const char*> kWords[]{{"painter", "painter"},
                                                           {"cosine", "n_dot_l"},
                                                           {"RGB normals", "normal"},
                                                           {"bounding boxes", "Bounding boxes"},
                                                           {"debug camera", "Frustum of the camera"},
                                                           {"hemisphere", "At the point"},
                                                           {"side by side", "Side by side: all values of"},
                                                           {"compare with file", "A file…"},
                                                           {"double precision", "In double precision"},
                                                           {"wipe", "Wipe between A and B"},
                                                           {"overlays", "Polygon edges"},
                                                           {"polygon edges", "Polygon edges"},
                                                           {"shading phong", "Shading: phong"},
                                                           {"cull", "Cull"}};
    for (const auto& [typed, name] : kWords) {
        field->setText(typed);
        ASSERT_GT(list->count(), 0) << typed;
        EXPECT_TRUE(list->item(0)->text().contains(name)) << typed << ": " << list->item(0)->text().toStdString();
    }
}

TEST_F(WindowCommands, AllValuesOfASettingStandSideBySide) {
    openPyramid();
    press("Ctrl+Shift+P");
    auto* field = find<QLineEdit>("commandField");
    field->setText("side by side shading");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_TRUE(waitForFrame());
    EXPECT_EQ(window.views().arrangement(), "buffer | buffer | buffer");
    EXPECT_TRUE(window.views().links().isOn());
    QStringList names;
    for (BufferView* view : window.views().shownBuffers()) {
        EXPECT_TRUE(QTest::qWaitFor([&] { return view->compare().difference().found().has_value(); }, 20000));
        names << view->canvas()->wipe().nameB;
        EXPECT_EQ(view->canvas()->placing().zoom(), window.views().first().canvas()->placing().zoom());
        EXPECT_EQ(view->canvas()->height(), window.views().first().canvas()->height()) << "at the same height";
    }
    EXPECT_TRUE(names[0].contains("flat") && names[1].contains("gouraud") && names[2].contains("phong"))
        << names.join("; ").toStdString();
}

TEST_F(WindowCommands, ACommandThatNothingIsCalledSaysSo) {
    press("Ctrl+Shift+P");
    auto* field = find<QLineEdit>("commandField");
    const auto says = [this] {
        for (const auto* label : find<CommandPalette>("commandPalette")->findChildren<QLabel*>())
            if (label->isVisible() && label->text() == "No match") return true;
        return false;
    };
    EXPECT_FALSE(says());
    QTest::keyClicks(field, "qqqq");
    EXPECT_TRUE(says());
    EXPECT_EQ(field->accessibleDescription(), "No match");
    field->clear();
    EXPECT_FALSE(says());
}

TEST_F(WindowCommands, ASettingAndALessonAreFoundAmongTheCommands) {
    openPyramid();
    const auto run = [this](const char* words) {
        press("Ctrl+Shift+P");
        auto* field = find<QLineEdit>("commandField");
        QTest::keyClicks(field, words);
        QTest::keyClick(field, Qt::Key_Return);
        EXPECT_TRUE(test::waitUntilQuiet());
    };
    find<QDockWidget>("settings")->hide();
    run("material.0.n");
    EXPECT_TRUE(find<QDockWidget>("settings")->isVisible());
    EXPECT_EQ(QApplication::focusWidget()->objectName(), "material.0.n");
    auto* lessons = window.findChild<LessonPanel*>();
    ASSERT_EQ(lessons->lesson(), nullptr);
    run("from its file to its last pixel");
    ASSERT_NE(lessons->lesson(), nullptr);
    EXPECT_EQ(lessons->lesson()->name, "pyramid");
}

// Typed digits replace the number, without a click in between.
TEST_F(WindowCommands, ASettingThatThePaletteFoundTakesTypedDigits) {
    openPyramid();
    press("Ctrl+Shift+P");
    auto* field = find<QLineEdit>("commandField");
    QTest::keyClicks(field, "n exponent");
    QTest::keyClick(field, Qt::Key_Return);
    QTest::keyClicks(QApplication::focusWidget(), "12");
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    EXPECT_EQ(document().scene().objects[0].material.exponent, 12);
}

TEST_F(WindowCommands, NoPageOfALessonShowsOneBufferTwice) {
    window.resize(1600, 1000);
    window.lessons().open("pyramid");
    auto* lessons = window.findChild<LessonPanel*>();
    for (int page = 0; page < int(lessons->lesson()->pages.size()); ++page) {
        lessons->goTo(page);
        ASSERT_TRUE(waitForFrame());
        if (window.views().hasSecond()) {
            EXPECT_NE(window.views().first().buffer().text(), window.views().second().buffer().text()) << page + 1;
        }
    }
}

TEST_F(WindowCommands, BuffersAreNoCommandsOnceTheSceneIsClosed) {
    const auto offers = [this](const QString& name) {
        press("Ctrl+Shift+P");
        auto* palette = find<CommandPalette>("commandPalette");
        const bool found = !palette->findChild<QListWidget*>()->findItems(name, Qt::MatchExactly).isEmpty();
        palette->close();
        return found;
    };
    openPyramid();
    EXPECT_TRUE(offers("z_view"));
    press("Ctrl+W");
    EXPECT_FALSE(offers("z_view"));
    EXPECT_TRUE(offers("Open…"));
}

TEST_F(WindowCommands, ThePaletteOpenedTwiceGivesTheFocusBackToTheView) {
    openPyramid();
    canvas()->setFocus();
    press("Ctrl+Shift+P");
    window.actions()[ActionId::RunCommand]->trigger();
    QTest::keyClick(find<QLineEdit>("commandField"), Qt::Key_Escape);
    EXPECT_EQ(QApplication::focusWidget(), canvas());
}

TEST(CommandMatch, PrefersBeginningsThenWordsThenLettersInOrder) {
    EXPECT_GT(matchQuality("no", "Normals"), matchQuality("no", "Go to north"));
    EXPECT_GT(matchQuality("pix", "Go to pixel…"), matchQuality("gtp", "Go to pixel…"));
    EXPECT_GT(matchQuality("gtp", "Go to pixel…"), 0);
    EXPECT_EQ(matchQuality("xq", "Go to pixel…"), 0);
    EXPECT_GT(matchQuality("pixel go", "Go to pixel…"), matchQuality("ixel go", "Go to pixel…"));
    EXPECT_GT(matchQuality("to pixel", "Go to pixel…"), matchQuality("pixel to", "Go to pixel…"))
        << "as it stands there";
    EXPECT_EQ(matchQuality("pixel north", "Go to pixel…"), 0) << "all of the words";
    const app::PaletteEntry dark{"Dark", "View › Theme", "", "", {}};
    EXPECT_GT(matchQuality("theme", dark), matchQuality("tm", "The mean"));
    EXPECT_LT(matchQuality("theme", dark), matchQuality("theme", "A theme"));
    EXPECT_EQ(matchQuality("", dark), 1);
    EXPECT_EQ(matchQuality("theme dark", dark), matchQuality("dark view", dark)) << "name and place together";
    EXPECT_GT(matchQuality("theme dark", dark), 0);
}

TEST_F(WindowCommands, KeysAreListedAndEscapeClosesTheList) {
    openPyramid();
    canvas()->setFocus();
    QTest::keyClick(canvas(), Qt::Key_H);
    auto* sheet = find<KeySheet>("keySheet");
    ASSERT_TRUE(sheet->isVisible());
    QWidget* field = QApplication::focusWidget();
    ASSERT_TRUE(sheet->isAncestorOf(field));
    QTest::keyClicks(field, "fit buffer");
    EXPECT_FALSE(sheet->shown().empty());
    for (const KeyRow& row : sheet->shown()) EXPECT_EQ(row.region, "In a buffer") << row.what.toStdString();
    QTest::keyClick(field, Qt::Key_Escape);
    EXPECT_FALSE(sheet->isVisible());
}

TEST_F(WindowCommands, AllKeysOfAnActionAreListed) {
    EXPECT_EQ(keysText(*window.actions()[ActionId::Redo]), "Ctrl+Shift+Z or Ctrl+Y");
    EXPECT_EQ(keysText(*window.actions()[ActionId::NextStage]), "Ctrl+→");
    openPyramid();
    canvas()->setFocus();
    QTest::keyClick(canvas(), Qt::Key_H);
    const auto* sheet = find<KeySheet>("keySheet");
    EXPECT_LE(sheet->width(), window.width());
    QTest::keyClicks(QApplication::focusWidget(), "ctrl+y");
    ASSERT_EQ(sheet->shown().size(), 1u);
    EXPECT_EQ(sheet->shown()[0].what, "Redo");
}

TEST(Keys, AreFoundByAnyOfTheirWords) {
    const std::vector<KeyRow> rows{{"Run", "Step back", "Shift+F10"}, {"In a buffer", "Loupe", "Z"}};
    EXPECT_EQ(rowsWith(rows, ""), rows);
    EXPECT_EQ(rowsWith(rows, "f10 STEP"), std::vector<KeyRow>{rows[0]});
    EXPECT_EQ(rowsWith(rows, "loupe run"), std::vector<KeyRow>());
}

// A row that a feature forgot to add would be no command at all.
TEST_F(WindowCommands, EveryActionHasItsRow) {
    EXPECT_EQ(window.actions().rows().size(), std::size_t(ActionId::Manual) + 1) << "Manual is the last one";
}

// One that cannot run says why, in every place where one looks for it.
TEST_F(WindowCommands, AnActionSaysWhyItCannotRun) {
    const Actions& actions = window.actions();
    for (const auto& [id, row] : actions.rows()) {
        EXPECT_EQ(actions[id]->isEnabled(), actions.whyNot(id).isEmpty()) << row.text;
        EXPECT_EQ(actions[id]->toolTip(), actions[id]->isEnabled() ? QString(row.tip) : actions.whyNot(id)) << row.text;
    }
    EXPECT_EQ(actions.whyNot(ActionId::Play), "Open a scene first.");
    openPyramid();
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(actions.whyNot(ActionId::Play), "");
    EXPECT_EQ(actions[ActionId::StepOn]->toolTip(), "Already at the last step; Home goes to the first.");
}

// "Open a scene file.", or a noun phrase; not what somebody does, as "Opens".
TEST_F(WindowCommands, AreDescribedInTheImperative) {
    for (const auto& [id, row] : window.actions().rows()) {
        const QString verb = QString(row.tip).section(' ', 0, 0);
        EXPECT_FALSE(verb.endsWith('s') && !verb.endsWith("ss")) << row.text << ": " << row.tip;
    }
}

// Two that share a key: Qt calls neither.
TEST_F(WindowCommands, HaveEachAKeyOfTheirOwn) {
    std::map<QString, std::string> owners;
    const auto add = [&](const char* keys, const char* owner) {
        for (const QString& key : QString(keys).split("; ", Qt::SkipEmptyParts)) {
            const auto [at, isNew] = owners.try_emplace(key, owner);
            EXPECT_TRUE(isNew) << key.toStdString() << ": " << at->second << " and " << owner;
        }
    };
    for (const auto& [id, row] : window.actions().rows()) add(row.keys, row.text);
    for (const PanelRow& row : panelTable()) add(row.keys, row.title);
}

}  // namespace
}  // namespace app
