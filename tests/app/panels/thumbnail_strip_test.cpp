#include "app/canvas/thumbnail_strip.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "app/canvas/thumbnail.h"
#include "app/frames/derived_buffers.h"
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

// Twice the pixels at the same size, and each of them the buffer's own, not a larger one of the coarse picture.
TEST(ThumbnailStrip, APictureHasThePixelsOfTheScreen) {
    const auto frame = test::frameOf(test::pyramid(), pipeline::setOf({BufferId::PolygonId, BufferId::PolygonsNormal}));
    const auto ids = frame->buffer({BufferId::PolygonId});
    for (const BufferId id : {BufferId::PolygonId, BufferId::PolygonsNormal}) {
        const QImage usual = app::thumbnail(*frame, *frame->buffer({id}), {80, 60}, ids);
        const QImage fine = app::thumbnail(*frame, *frame->buffer({id}), {80, 60}, ids, 2);
        EXPECT_EQ(fine.size(), 2 * usual.size());
        EXPECT_EQ(fine.deviceIndependentSize(), QSizeF(usual.size()));
        EXPECT_NE(fine.convertToFormat(QImage::Format_ARGB32),
                  usual.scaled(fine.size()).convertToFormat(QImage::Format_ARGB32));
    }
}

// Until pictures of the new size are drawn the old ones are there: they may not cover the names below them.
TEST(ThumbnailStrip, PicturesOfALargerStripCoverNoNames) {
    Document document;
    app::ThumbnailStrip strip(document);
    const int low = strip.sizeHint().height();
    strip.resize(900, 4 * low);
    strip.show();
    document.setScene(test::pyramid());
    const auto names = [&] {
        const int line = app::Theme::current().px(20);  // of the names, at the bottom
        return strip.grab().toImage().copy(0, low - line - 4, 900, line);
    };
    const auto pictures = [&] { return strip.grab().toImage().copy(0, 0, 900, strip.height() / 2); };
    const QImage hatched = pictures();
    ASSERT_TRUE(QTest::qWaitFor([&] { return pictures() != hatched; }, 10000));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document.frames().busy(); }, 10000));
    strip.resize(900, low);
    const QImage first = names();
    ASSERT_TRUE(
        QTest::qWaitFor([&, before = strip.grab().toImage()] { return strip.grab().toImage() != before; }, 10000));
    EXPECT_EQ(names(), first);
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
