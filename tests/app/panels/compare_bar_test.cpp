#include "app/compare/compare_bar.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "app/look/theme.h"
#include "app/widgets/segmented.h"

namespace {

class Bar : public testing::Test {
protected:
    Bar() { view.show(); }
    void show(int width, int height) {
        bar.resize(width, 100);
        bar.fit(height);
        QCoreApplication::processEvents();
    }
    QWidget view;
    app::CompareBar bar{&view};
};

TEST_F(Bar, InALowViewItIsOneRow) {
    bar.setFinding("They differ at 12 pixels.", {});
    const auto heightIn = [&](int height) {
        show(280, height);
        return bar.sizeHint().height();
    };
    const int all = heightIn(1000), low = heightIn(200);
    EXPECT_LT(low, all - app::Theme::current().px(14)) << "a row of words";
    EXPECT_LT(all, 3 * low) << "two rows, not three";
    EXPECT_EQ(heightIn(1000), all);
}

TEST_F(Bar, InANarrowViewAllThatWasFoundIsRead) {
    bar.setFinding("180 897 of 307 200 pixels differ, most by 40 at 268, 281", {});
    show(280, 1000);
    bar.resize(280, bar.heightForWidth(280));
    QCoreApplication::processEvents();
    const auto* finding = bar.findChild<QLabel*>();
    EXPECT_GE(finding->height(), finding->heightForWidth(finding->width()));
    const auto buttons = bar.findChildren<QPushButton*>();
    EXPECT_TRUE(std::ranges::any_of(buttons, [](auto* b) { return b->accessibleName() == "Worst pixel"; }));
    for (const auto* button : buttons) EXPECT_LE(button->geometry().right(), 280) << button->text().toStdString();
}

// Of choices that lie under buttons some cannot be chosen.
TEST_F(Bar, NothingLiesOnTheChoices) {
    bar.setMode(app::CompareMode::Difference);
    const auto* choices = bar.findChild<app::Segmented*>();
    for (const double scale : {1.0, 1.25, 1.5})
        for (const int height : {200, 1000}) {
            app::Theme::current().setScale(scale);
            show(int(282 * std::max(scale, 1.1)), height);
            for (const auto* part : bar.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
                EXPECT_TRUE(part == choices || !part->isVisible() || !part->geometry().intersects(choices->geometry()))
                    << scale << ' ' << height << ' ' << part->accessibleName().toStdString();
        }
    app::Theme::current().setScale(1);
}

}  // namespace
