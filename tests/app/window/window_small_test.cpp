// Large letters and small screens: nothing that is needed is out of reach.
#include <QCheckBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QTest>

#include "app/commands/actions.h"
#include "app/commands/command_palette.h"
#include "app/desktop/preferences_dialog.h"
#include "app/docks/panel_table.h"
#include "app/export/export_dialog.h"
#include "app/export/figure_dialog.h"
#include "app/export/film_dialog.h"
#include "app/export/slide_dialog.h"
#include "app/look/theme.h"
#include "app/stages/stage_card.h"
#include "app/stages/stage_strip.h"
#include "app/stages/step_bar.h"
#include "app/start/start_page.h"
#include "app/views/view_area.h"
#include "app/widgets/number_field.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

class WindowSmall : public WindowTest {
protected:
    ~WindowSmall() override { Theme::current().setScale(1); }
    // Of the light theme, in a window of a small laptop.
    void beSmall(double scale, QSize size = {1366, 768}) {
        window.resize(size);
        Theme::current().setScale(scale);
        settle();
    }
    void settle() {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        QCoreApplication::processEvents();
    }
    // From side to side: what is below the edge can be scrolled to.
    static void expectInside(const QWidget& part, const QWidget& around, const char* what) {
        const int left = part.mapTo(&around, QPoint()).x();
        EXPECT_GE(left, 0) << what;
        EXPECT_LE(left + part.width(), around.width()) << what;
    }
};

TEST_F(WindowSmall, ThePaletteStandsInTheWindow) {
    openPyramid();
    for (const double scale : {1.0, 2.0, 3.0}) {
        beSmall(scale);
        window.actions()[ActionId::RunCommand]->trigger();
        settle();
        auto* palette = window.findChild<CommandPalette*>();
        ASSERT_TRUE(palette->isVisible());
        EXPECT_TRUE(window.rect().contains(palette->geometry())) << scale;
        auto* field = find<QLineEdit>("commandField");
        EXPECT_TRUE(window.rect().contains(QRect(field->mapTo(&window, QPoint()), field->size()))) << scale;
        palette->close();
    }
}

// A window without a window manager grows to what its panels need; one with it cuts them.
TEST_F(WindowSmall, APanelThatOpensNeverMakesTheWindowLarger) {
    openPyramid();
    for (const double scale : {1.5, 2.0}) {
        for (const PanelId id : {PanelId::Inspector, PanelId::Settings, PanelId::Algorithm, PanelId::Lesson,
                                 PanelId::Tables, PanelId::Settings}) {
            beSmall(scale);
            const PanelDock& dock = window.docks()[id];
            if (dock.isInFront()) dock.toggleViewAction()->trigger();
            dock.toggleViewAction()->trigger();
            settle();
            EXPECT_EQ(window.size(), QSize(1366, 768)) << scale << ", " << dock.row().name;
            EXPECT_TRUE(dock.isInFront()) << scale << ", " << dock.row().name;
            expectInside(dock, window, dock.row().name);
        }
    }
}

TEST_F(WindowSmall, SettingsKeepTheirFieldsInTheirPanel) {
    openPyramid();
    for (const double scale : {1.0, 1.5, 2.0}) {
        beSmall(scale);
        const PanelDock& dock = window.docks()[PanelId::Settings];
        if (!dock.isInFront()) dock.toggleViewAction()->trigger();
        window.docks()[PanelId::Inspector].toggleViewAction()->trigger();
        settle();
        if (!dock.isInFront()) continue;  // the inspector has taken its room
        const auto fields = dock.findChildren<NumberField*>();
        EXPECT_FALSE(fields.isEmpty());
        for (const NumberField* field : fields)
            if (field->isVisible()) expectInside(*field, dock, "a number");
    }
}

TEST_F(WindowSmall, TheStartPageIsNotCut) {
    auto* page = window.findChild<StartPage*>();
    for (const QSize size : {QSize(1280, 720), QSize(1366, 768)}) {
        for (const double scale : {1.0, 1.5, 2.0}) {
            beSmall(scale, size);
            SCOPED_TRACE(testing::Message() << size.width() << " wide, text " << scale);
            EXPECT_EQ(window.size(), size);
            for (const QWidget* part : page->findChildren<QWidget*>())
                if (part->isVisible() && !qobject_cast<const QScrollArea*>(part))
                    expectInside(*part, *page, qPrintable(part->metaObject()->className() + part->objectName()));
            for (const QLabel* label : page->findChildren<QLabel*>())
                if (label->isVisible() && label->wordWrap() && !label->text().isEmpty()) {
                    EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
                }
        }
    }
}

TEST_F(WindowSmall, NoNameIsCutInTheTimeline) {
    openPyramid();
    for (const QSize size : {QSize(1280, 720), QSize(1366, 768), QSize(1600, 900)}) {
        for (const double scale : {1.0, 1.5, 2.0}) {
            beSmall(scale, size);
            const auto* bar = window.findChild<StepBar*>();
            const Theme& theme = Theme::current();
            const StageNames names((bar->width() - 2 * theme.px(8) - 5 * theme.px(3)) / 6);
            for (const QString& name : names.texts)
                EXPECT_FALSE(name.contains(QChar(0x2026))) << name.toStdString() << ", text " << scale;
            auto* words = find<QLabel>("stepWords");
            EXPECT_EQ(words->text(), "whole frame") << size.width() << ", text " << scale;
            EXPECT_LE(words->mapTo(&window, QPoint(words->width(), 0)).x(), window.width());
        }
    }
}

// Of a screen of 1280 × 720 the dialog has 1248 × 656.
TEST_F(WindowSmall, NoFieldOfTheExportDialogScrollsFromSideToSide) {
    openPyramid();
    for (const ThemeId theme : {ThemeId::Light, ThemeId::Projector}) {
        Theme::current().set(theme);
        for (const double scale : {1.0, 1.5, 2.0}) {
            Theme::current().setScale(scale);
            ExportDialog dialog(document(), &window);
            dialog.show();
            dialog.resize(1248, 656);
            settle();
            SCOPED_TRACE(testing::Message() << int(theme) << ", text " << scale);
            EXPECT_EQ(dialog.width(), 1248);
            const QScrollArea* area = dialog.findChild<QScrollArea*>();
            ASSERT_NE(area, nullptr);
            EXPECT_LE(area->widget()->width(), area->viewport()->width());
            for (const QWidget* part : area->widget()->findChildren<QWidget*>())
                if (part->isVisible())
                    expectInside(*part, *area->viewport(),
                                 qPrintable(part->metaObject()->className() + part->objectName()));
            for (const QCheckBox* box : area->findChildren<QCheckBox*>())
                if (box->isVisible()) {
                    EXPECT_LE(box->sizeHint().height(), box->height()) << box->text().toStdString();
                }
        }
        Theme::current().setScale(theme == ThemeId::Projector ? 1.25 : 1);
    }
    Theme::current().set(ThemeId::Light);
}

// A name is whole or its first word, which tells the stages apart; a state's word is whole or left to its mark. Where
// words are missing, the tool tip and the screen reader have them.
TEST_F(WindowSmall, AStageCardHasItsNameAndItsStateOrSaysThemElsewhere) {
    openPyramid();
    for (const ThemeId theme : {ThemeId::Dark, ThemeId::Light, ThemeId::Projector}) {
        Theme::current().set(theme);
        for (const double scale : {1.0, 1.5, 2.0})
            for (const QSize size : {QSize(1280, 720), QSize(1366, 768), QSize(1920, 1080)}) {
                beSmall(scale, size);
                QStringList names;
                for (const pipeline::StageId id : pipeline::kStages) {
                    StageCard& card = find<StageStrip>("stageStrip")->card(id);
                    SCOPED_TRACE(testing::Message() << card.text().toStdString() << ", " << size.width()
                                                    << " wide, theme " << int(theme) << ", text " << scale);
                    const StageCard::Words shown = card.shownWords();
                    EXPECT_LE(shown.nameWidth, shown.nameRoom);
                    EXPECT_TRUE(shown.name == card.text() || shown.name == card.text().section(' ', 0, 0));
                    names << shown.name;
                    const QString state = word(card.status().state);
                    EXPECT_TRUE(shown.state.isEmpty() || shown.state == state) << shown.state.toStdString();
                    EXPECT_TRUE(card.toolTip().startsWith(card.text() + ", " + state)) << card.toolTip().toStdString();
                    EXPECT_TRUE(card.accessibleName().startsWith(card.text() + ": " + state));
                }
                EXPECT_EQ(names.removeDuplicates(), 0);
            }
        Theme::current().setScale(theme == ThemeId::Projector ? 1.25 : 1);
    }
    Theme::current().set(ThemeId::Light);
}

// 1440 is the least width that has panels at both sides. The panel of another renderer, which is hidden, takes none of it.
TEST_F(WindowSmall, AWideWindowHasRoomForEveryViewOfAnOpenedScene) {
    window.resize(1440, 900);
    openPyramid();
    settle();
    EXPECT_TRUE(find<QDockWidget>("scene")->isVisible());
    EXPECT_TRUE(find<QDockWidget>("inspector")->isVisible());
    EXPECT_FALSE(find<QDockWidget>("renderer")->isVisible());
    EXPECT_EQ(window.views().grid().withoutRoom(), 0u);
    EXPECT_FALSE(find<QLabel>("missingViews")->isVisible());
}

// Whatever the letters: the dialog stands on its screen, and each of its buttons stands in the dialog or is scrolled to.
TEST_F(WindowSmall, DialogsStandOnTheirScreenWithTheirButtonsInReach) {
    openPyramid();
    const QSize room = window.screen()->availableSize();
    for (const double scale : {1.0, 2.0, 3.0}) {
        Theme::current().setScale(scale);
        PreferencesDialog preferences(&window);
        SlideDialog slide(document(), window.views(), *window.shown().now(), &window);
        ExportDialog exports(document(), &window);
        FilmDialog film(document(), {pipeline::BufferId::Color}, &window);
        FigureDialog figure(document(), {.buffer = {pipeline::BufferId::Color}}, &window);
        figure.show();
        EXPECT_TRUE(QTest::qWaitFor([&] { return !figure.findChild<QLabel*>("figureSize")->text().isEmpty(); }, 30000));
        for (QDialog* dialog : std::initializer_list<QDialog*>{&preferences, &slide, &exports, &film, &figure}) {
            dialog->show();
            settle();
            SCOPED_TRACE(testing::Message() << dialog->objectName().toStdString() << ", text " << scale);
            EXPECT_LE(dialog->width(), room.width());
            EXPECT_LE(dialog->height(), room.height());
            for (const QPushButton* button : dialog->findChildren<QPushButton*>()) {
                bool scrolls = false;
                for (const QWidget* up = button->parentWidget(); up != dialog; up = up->parentWidget())
                    scrolls |= qobject_cast<const QScrollArea*>(up) != nullptr;
                if (scrolls || !button->isVisible()) continue;
                EXPECT_TRUE(dialog->rect().contains(QRect(button->mapTo(dialog, QPoint()), button->size())))
                    << button->text().toStdString();
            }
            dialog->hide();
        }
    }
}

}  // namespace
}  // namespace app
