// What must hold of a stage's output, as the window lists it and masks it.
#include "app/stages/contract_list.h"

#include <gtest/gtest.h>

#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include "app/buffer_view/buffer_overlays.h"
#include "app/buffer_view/buffer_view.h"
#include "tests/app/panels/renderer_files.h"

namespace app {
namespace {

using pipeline::BufferId;
using pipeline::Defect;
using pipeline::StageId;

class ContractListTest : public testing::Test {
protected:
    void open(Defect defect, StageId stage) {
        pipeline::Scene scene = plant(smallCheckMe(), defect);
        scene.settings.leaveOut = false;
        document.setScene(scene);
        window.resize(800, 600);
        window.show();
        list.open(window.mapToGlobal(QPoint(10, 10)), stage);
        ASSERT_TRUE(QTest::qWaitFor([this] { return !document.frames().busy() && !list.busy() && rows() > 0; }, 60000));
    }
    int rows() { return list.list().topLevelItemCount(); }
    QTreeWidgetItem* row(int i) { return list.list().topLevelItem(i); }

    Document document;
    QWidget window;
    ContractList list{document, &window};
};

TEST_F(ContractListTest, OfARightFrameEverythingHolds) {
    open(Defect::None, StageId::Shading);
    int checked = 0;
    for (int i = 0; i < rows(); ++i) {
        EXPECT_TRUE(row(i)->text(2) == "100 %" || row(i)->text(2) == "–") << row(i)->text(0).toStdString();
        checked += row(i)->text(2) == "100 %";
    }
    EXPECT_GT(checked, 5);
    EXPECT_FALSE(list.findChild<QPushButton*>("showViolators")->isEnabled());
}

// Normals that are not made unit after interpolating are shorter than 1 wherever the corners' differ.
TEST_F(ContractListTest, WhatIsViolatedComesFirstAndCanBeShown) {
    open(Defect::NormalShort, StageId::Shading);
    EXPECT_EQ(row(0)->text(1), "normal");
    EXPECT_TRUE(row(0)->text(2).endsWith(" %"));
    EXPECT_LT(row(0)->text(2).section(' ', 0, 0).toDouble(), 99.95);
    QSignalSpy asked(&list, &ContractList::violatorsAsked);
    list.findChild<QPushButton*>("showViolators")->click();
    ASSERT_EQ(asked.size(), 1);
    EXPECT_EQ(asked[0][0].value<pipeline::BufferName>().id, BufferId::Normal);
    EXPECT_FALSE(list.isVisible());
}

TEST_F(ContractListTest, TheOverlayMasksTheViolators) {
    open(Defect::NormalShort, StageId::Shading);
    list.hide();
    BufferView view(document);
    view.resize(400, 300);
    view.show();
    view.setBuffer({BufferId::Normal});
    view.features().overlays->set(OverlayId::Violators, true);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            return view.shown() && view.shown()->buffer.name.id == BufferId::Normal &&
                   view.shown()->notice.contains("|N| = 1");
        },
        60000));
    const pipeline::ContractInput input = contractInput(*document.frames().shown());
    const auto result = checkContract(*pipeline::findContract("unit-normals"), input);
    ASSERT_FALSE(result.holds());
    const QImage& mask = view.shown()->content.overlays.back();
    std::size_t masked = 0;
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            const bool isMasked = qAlpha(mask.pixel(x, y)) > 0;
            masked += isMasked;
            const std::size_t element = std::size_t(y) * std::size_t(mask.width()) + std::size_t(x);
            EXPECT_TRUE(isMasked || !result.violators[element]);
        }
    EXPECT_GE(masked, result.checked - result.hold) << "other contracts about the normal may be violated too";
}

TEST(ShareText, SaysAHundredPercentOnlyWhereAllHold) {
    pipeline::ContractResult result;
    result.checked = 100000, result.hold = 99999;
    EXPECT_EQ(shareText(result), "99.9 %");
    result.hold = 100000;
    EXPECT_EQ(shareText(result), "100 %");
    result.checked = result.hold = 0;
    EXPECT_EQ(shareText(result), "–");
}

}  // namespace
}  // namespace app
