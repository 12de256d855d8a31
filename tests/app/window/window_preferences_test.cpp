#include <QDialog>
#include <QLabel>
#include <QSettings>
#include <QSpinBox>
#include <QTest>

#include <QPushButton>

#include "app/buffer_view/buffer_view.h"
#include "app/docks/layout_store.h"
#include "app/look/number_format.h"
#include "app/look/theme.h"
#include "app/views/view_area.h"
#include "app/widgets/segmented.h"
#include "tests/app/window/window_fixture.h"

namespace app {
namespace {

class WindowPreferences : public WindowTest {
protected:
    ~WindowPreferences() override { NumberStyle::current().set({}); }
    QDialog* preferences() {
        press("Ctrl+,");
        return find<QDialog>("preferences");
    }
    void choose(const char* group, const char* button) {
        for (QPushButton* one : find<Segmented>(group)->findChildren<QPushButton*>())
            if (one->text() == button) return QTest::mouseClick(one, Qt::LeftButton);
        ADD_FAILURE() << button;
    }
    bool reads(const QString& words) {
        for (const QLabel* label : window.views().first().findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(words)) return true;
        return false;
    }
};

TEST_F(WindowPreferences, NumbersOfBuffersAreWrittenAsChosenAtOnceAndKept) {
    openPyramid();
    window.views().first().setBuffer({pipeline::BufferId::Depth});
    document().pointing().pick(glm::ivec2(268, 281));
    ASSERT_TRUE(waitForFrame());
    const auto depth = document().frames().shown()->buffer({pipeline::BufferId::Depth})->value(268, 281, 0);
    const NumberFormat scientific{NumberFormat::Form::Scientific, 3, {}};
    ASSERT_FALSE(reads("→ " + *written(scientific, depth)));
    ASSERT_TRUE(preferences());
    choose("preferencesForm", "Scientific");
    find<QSpinBox>("preferencesDigits")->setValue(3);
    EXPECT_TRUE(reads("→ " + *written(scientific, depth)));
    EXPECT_TRUE(find<QLabel>("preferencesSample")->text().startsWith("6.888e2 "));
    EXPECT_FALSE(find<QSpinBox>("preferencesPower")->isEnabled());
    EXPECT_FALSE(find<QSpinBox>("preferencesPower")->toolTip().isEmpty());

    NumberStyle::current().set({});
    restoreNumbers();  // as the next start does
    EXPECT_EQ(NumberStyle::current().format(), scientific);
}

TEST_F(WindowPreferences, ThemeAndLettersChangeAtOnceAndAreKept) {
    ASSERT_TRUE(preferences());
    choose("preferencesTheme", "Dark");
    EXPECT_EQ(Theme::current().id(), ThemeId::Dark);
    const double before = Theme::current().scale();
    find<QSpinBox>("preferencesLetters")->setValue(150);
    EXPECT_DOUBLE_EQ(Theme::current().scale(), 1.5);
    EXPECT_EQ(QSettings().value("theme").toString(), "dark");
    EXPECT_DOUBLE_EQ(QSettings().value("textScale/dark").toDouble(), 1.5);
    Theme::current().setScale(before);
    EXPECT_EQ(find<QSpinBox>("preferencesLetters")->value(), 100) << "what another place changes shows here";
}

TEST_F(WindowPreferences, EveryControlHasANameAndKeysOpenTheirSheet) {
    QDialog* dialog = preferences();
    ASSERT_TRUE(dialog);
    for (QWidget* control : dialog->findChildren<QWidget*>()) {
        if (!control->isVisible() || !(control->focusPolicy() & Qt::TabFocus)) continue;
        EXPECT_FALSE(control->accessibleName().isEmpty() && control->property("text").toString().isEmpty())
            << control->metaObject()->className() << ' ' << control->objectName().toStdString();
    }
    QTest::mouseClick(find<QPushButton>("preferencesKeys"), Qt::LeftButton);
    EXPECT_TRUE(QTest::qWaitFor([this] { return find<QWidget>("keySheet")->isVisible(); }));
}

}  // namespace
}  // namespace app
