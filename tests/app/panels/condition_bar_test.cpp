// A search for where a condition begins to hold, and what ends it.
#include "app/canvas/condition_bar.h"

#include <gtest/gtest.h>

#include <QTest>

#include "app/buffer_view/buffer_view.h"
#include "tests/support/scenes.h"

namespace {

class ConditionSearch : public testing::Test {
protected:
    ConditionSearch() {
        view.resize(640, 560);
        view.show();
        document.setScene(test::pyramid());
        bar().open();
        bar().setText("z_view < 700");
        EXPECT_TRUE(
            QTest::qWaitFor([this] { return bar().mask() && document.stepper().steps() && !bar().busy(); }, 20000));
        bar().runToStop();
        EXPECT_TRUE(bar().busy());
    }
    app::ConditionBar& bar() { return view.condition(); }
    // A search that goes on brings the stepper to its end, and picks a pixel.
    void expectNothingMoves() {
        EXPECT_FALSE(
            QTest::qWaitFor([this] { return document.stepper().isInside() || document.pointing().pixel(); }, 1500));
    }
    app::Document document;
    app::BufferView view{document};
};

TEST_F(ConditionSearch, TheButtonThatClosesTheBarEndsIt) {
    bar().close();
    EXPECT_FALSE(bar().busy());
    expectNothingMoves();
}

TEST_F(ConditionSearch, AnotherTextEndsIt) {
    bar().setText("x < 0");
    expectNothingMoves();
}

TEST_F(ConditionSearch, LeftAloneItArrives) {
    EXPECT_TRUE(
        QTest::qWaitFor([this] { return document.stepper().isInside() && document.pointing().pixel(); }, 20000));
}

}  // namespace
