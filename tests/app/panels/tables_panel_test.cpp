#include "app/tables/tables_panel.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include "pipeline/scene/settings_table.h"
#include "tests/app/quiet.h"
#include "tests/support/scenes.h"

namespace {

using app::Document;
using app::Pointing;
using app::TablePage;
using lessons::Selection;
using pipeline::TableFormat;
using pipeline::TableId;

struct TablesPanelTest : testing::Test {
    Document document;
    app::TablesPanel panel{document};

    TablesPanelTest() {
        panel.resize(900, 300);
        panel.show();
        document.setScene(test::pyramid());
        EXPECT_TRUE(QTest::qWaitFor([&] { return polygons().model().rowCount() == 5; }, 10000));
    }
    TablePage& polygons() { return panel.page(TableId::Polygons); }
    TablePage& show(TableId table) {
        panel.setCurrentIndex(int(table));
        return panel.page(table);
    }
    static QString text(TablePage& page, int place, const QString& heading) {
        auto& model = page.model();
        for (int c = 0; c < model.columnCount(); ++c)
            if (model.headerData(c, Qt::Horizontal, Qt::DisplayRole).toString() == heading)
                return model.data(model.index(place, c), Qt::DisplayRole).toString();
        return "no such column";
    }
    static std::vector<int> chosen(TablePage& page) {
        std::vector<int> places;
        for (const QModelIndex& index : page.view().selectionModel()->selectedRows()) places.push_back(index.row());
        std::ranges::sort(places);
        return places;
    }
    void click(TablePage& page, int place) {
        const QRect cell = page.view().visualRect(page.model().index(place, 0));
        QTest::mouseClick(page.view().viewport(), Qt::LeftButton, {}, cell.center());
    }
    void sortBy(TablePage& page, const QString& heading, Qt::SortOrder order) {
        for (int c = 0; c < page.model().columnCount(); ++c)
            if (page.model().headerData(c, Qt::Horizontal, Qt::DisplayRole).toString() == heading)
                page.view().sortByColumn(c, order);
    }
};

}  // namespace

TEST_F(TablesPanelTest, FollowsEveryChangeOfTheFrame) {
    EXPECT_EQ(text(polygons(), 2, "lblue"), "114.739");
    // With n = 4 the specular term is 0.4·100·0.3974^4 = 0.998 instead of 0.025.
    document.change(*pipeline::findSetting(document.scene(), "material.0.n"), 4);
    EXPECT_TRUE(QTest::qWaitFor([&] { return text(polygons(), 2, "lblue") == "115.712"; }, 10000))
        << text(polygons(), 2, "lblue").toStdString();
    EXPECT_EQ(text(show(TableId::Objects), 0, "n"), "4");
}

TEST_F(TablesPanelTest, AClickedRowIsSelectedEverywhere) {
    QSignalSpy selected(&document.pointing(), &Pointing::selectionChanged);
    click(polygons(), 3);
    EXPECT_EQ(document.pointing().selection(), (lessons::Selection{lessons::Selection::Kind::Polygon, 3}));
    EXPECT_EQ(selected.size(), 1);
    EXPECT_EQ(chosen(show(TableId::Vertices)), (std::vector{0, 3, 4})) << "the corners of Back";
    EXPECT_EQ(chosen(show(TableId::Objects)), std::vector{0});
}

// Pixel (268, 281) shows polygon 2, whose corners are 2, 3 and 4.
TEST_F(TablesPanelTest, ThePickedPixelsPolygonIsMarked) {
    click(polygons(), 0);
    document.pointing().pick(glm::ivec2(268, 281));
    EXPECT_FALSE(document.pointing().selection()) << "picking forgets what was selected";
    EXPECT_EQ(chosen(polygons()), std::vector{2});
    EXPECT_EQ(chosen(show(TableId::Vertices)), (std::vector{2, 3, 4}));
    document.pointing().pick(glm::ivec2(1, 1));
    EXPECT_TRUE(chosen(panel.page(TableId::Vertices)).empty());
}

TEST_F(TablesPanelTest, WhatIsUnderTheCursorElsewhereStandsOut) {
    const auto pointed = [](TablePage& page) {
        std::vector<int> places;
        for (int place = 0; place < page.view().model()->rowCount(); ++place)
            if (page.view().model()->index(place, 0).data(Qt::BackgroundRole).isValid()) places.push_back(place);
        return places;
    };
    click(polygons(), 0);
    document.pointing().hover(glm::ivec2(268, 281));
    EXPECT_EQ(pointed(polygons()), std::vector{2});
    EXPECT_EQ(document.pointing().selection(), (lessons::Selection{lessons::Selection::Kind::Polygon, 0}))
        << "hovering changes nothing";
    document.pointing().hover(std::nullopt);
    EXPECT_TRUE(pointed(polygons()).empty());
    TablePage& vertices = show(TableId::Vertices);
    document.pointing().hover(glm::ivec2(268, 281));
    EXPECT_EQ(pointed(vertices), (std::vector{2, 3, 4}));
}

// Signed areas: −1991, −697, 36, 895, 1757 for polygons 4, 0, 3, 1, 2.
TEST_F(TablesPanelTest, SortsByValueAndKeepsWhatIsSelected) {
    click(polygons(), 3);
    sortBy(polygons(), "signed area", Qt::AscendingOrder);
    QStringList order;
    for (int place = 0; place < 5; ++place) order << text(polygons(), place, "polygon");
    EXPECT_EQ(order.join(' '), "4 0 3 1 2");
    EXPECT_EQ(chosen(polygons()), std::vector{2});
    EXPECT_EQ(document.pointing().selection(), (lessons::Selection{lessons::Selection::Kind::Polygon, 3}));
    click(polygons(), 0);
    EXPECT_EQ(document.pointing().selection(), (lessons::Selection{lessons::Selection::Kind::Polygon, 4}));
    // The order holds when the frame changes.
    document.change(*pipeline::findSetting(document.scene(), "object.0.sx"), 1.9);
    QSignalSpy frame(&document.frames(), &app::FrameFeed::stateReady);
    ASSERT_TRUE(frame.wait());
    ASSERT_TRUE(test::waitUntilQuiet());
    EXPECT_EQ(text(polygons(), 0, "polygon"), "4");
}

TEST_F(TablesPanelTest, CopiesTheChosenRows) {
    panel.setCurrentIndex(int(TableId::Lights));
    TablePage& lights = panel.page(TableId::Lights);
    click(lights, 0);
    lights.view().setFocus();
    QApplication::setActiveWindow(&panel);
    lights.copy(TableFormat::Csv);
    const QString csv = QApplication::clipboard()->text();
    EXPECT_TRUE(csv.startsWith("k,kind,Lx,Ly,Lz,Ip,")) << csv.toStdString();
    EXPECT_TRUE(csv.contains("\n0,at-infinity,500,500,500,100,"));
    lights.copy(TableFormat::Latex);
    EXPECT_TRUE(QApplication::clipboard()->text().startsWith("\\begin{tabular}"));
    lights.copy(TableFormat::Markdown);
    EXPECT_TRUE(QApplication::clipboard()->text().startsWith("| k | kind | Lx |"));
}

TEST_F(TablesPanelTest, ALowPanelHasItsFactsBesideTheTabs) {
    const auto* facts = panel.findChild<QLabel*>("factsBesideTabs");
    EXPECT_FALSE(facts->isVisible());
    const int rows = polygons().view().viewport()->height();
    panel.resize(900, 180);
    EXPECT_TRUE(test::waitUntilQuiet());
    EXPECT_TRUE(facts->isVisible());
    EXPECT_EQ(facts->text(), "polygons = 5   polygons that are not lit: culled, or seen in no pixel = 2");
    EXPECT_LT(facts->geometry().right(), panel.width());
    EXPECT_EQ(facts->geometry().center().y(), panel.tabBar()->geometry().center().y());
    EXPECT_GT(polygons().view().viewport()->height(), rows - 120) << "120 lower, and a line less above the rows";
    panel.resize(900, 300);
    EXPECT_TRUE(test::waitUntilQuiet());
    EXPECT_FALSE(facts->isVisible());
}

TEST_F(TablesPanelTest, AnEmptyColumnSaysWhy) {
    TablePage& vertices = show(TableId::Vertices);
    EXPECT_EQ(text(vertices, 0, "N x"), QString("–"));
    bool said = false;
    for (const QLabel* label : vertices.findChildren<QLabel*>())
        said |= label->isVisible() && label->text().contains("N x, N y, N z: Flat shading needs polygon normals only.");
    EXPECT_TRUE(said);
}

TEST_F(TablesPanelTest, AnotherSceneTakesTheSelectionAway) {
    click(polygons(), 3);
    pipeline::Scene scene = test::pyramid();
    scene.objects.clear();
    document.setScene(scene);
    EXPECT_FALSE(document.pointing().selection());
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return document.frames().shown() && polygons().model().rowCount() == 0; }, 10000));
    document.pointing().select(lessons::Selection{lessons::Selection::Kind::Polygon, 0});
    EXPECT_FALSE(document.pointing().selection()) << "there is no such polygon";
}
