#include "app/panels/thumbnail_strip.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "app/core/derived_buffers.h"
#include "tests/support/scenes.h"

namespace {

using app::Document;
using pipeline::BufferId;

TEST(ThumbnailStrip, HatchesWhatIsLeftOutAndOpensWhatIsClicked) {
    Document document;
    app::ThumbnailStrip strip(document);
    strip.resize(900, strip.sizeHint().height());
    strip.show();
    document.setScene(test::pyramid());
    document.setStage(pipeline::StageId::ZBuffer);
    ASSERT_TRUE(QTest::qWaitFor([&] { return strip.accessibleDescription().contains("shadow_buffer.0"); }, 10000));
    EXPECT_TRUE(strip.accessibleDescription().contains("The only object is convex"));
    QSignalSpy chosen(&strip, &app::ThumbnailStrip::chosen);
    QTest::keyClick(&strip, Qt::Key_Left);
    QTest::keyClick(&strip, Qt::Key_Return);
    ASSERT_EQ(chosen.size(), 1);
}

TEST(ThumbnailStrip, ShowsADerivedBufferWhileSomebodyLooksAtIt) {
    Document document;
    app::ThumbnailStrip strip(document);
    strip.resize(900, strip.sizeHint().height());
    strip.show();
    document.setScene(test::pyramid());
    QSignalSpy chosen(&strip, &app::ThumbnailStrip::chosen);
    const auto last = [&] {
        for (int i = 0; i < 100; ++i) QTest::keyClick(&strip, Qt::Key_Right);
        QTest::keyClick(&strip, Qt::Key_Return);
        return chosen.takeLast().front().value<pipeline::BufferName>().text();
    };
    EXPECT_EQ(last(), "color");
    const pipeline::BufferName expression{BufferId::Expression};
    {
        const QObject view;
        document.derived().setText("2 * n_dot_l.0");
        document.derived().want(&view, {expression});
        ASSERT_TRUE(QTest::qWaitFor([&] { return document.derived().made(expression) != nullptr; }, 10000));
        EXPECT_EQ(last(), "expression");
    }
    EXPECT_TRUE(QTest::qWaitFor([&] { return last() == "color"; }, 5000));
}

}  // namespace
