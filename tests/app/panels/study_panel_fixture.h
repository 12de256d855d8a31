#pragma once
#include <gtest/gtest.h>

#include <QTest>

#include "app/study/study_panel.h"
#include "app/study/study_plot.h"
#include "app/study/study_points.h"
#include "tests/support/scenes.h"
#include "tests/support/studies.h"

namespace test {

// A small picture: a study of it takes a moment.
inline pipeline::Scene smallPyramid() {
    pipeline::Scene scene = test::pyramid();
    scene.settings.width = 64;
    scene.settings.height = 48;
    return scene;
}

// The sphere's numbers under settings that the pyramid has.
inline StudyReport pyramidStudy() {
    StudyReport report = test::sphereStudy();
    report.scene = smallPyramid().name;
    report.axes[1] = {"material.0.n", "n exponent", {"4", "16", "64", "128"}};
    return report;
}

struct StudyPanelTest : testing::Test {
    app::Document document;
    app::StudyPanel panel{document};

    StudyPanelTest() {
        document.setScene(smallPyramid());
        panel.resize(1500, 900);
        panel.show();
        panel.setReport(pyramidStudy());
    }
    template <class Widget>
    Widget& part(const char* name = nullptr) {
        return *panel.findChild<Widget*>(name ? QString(name) : QString());
    }
    app::StudyPlot& plot() { return part<app::StudyPlot>(); }
    void click(std::size_t point) { QTest::mouseClick(&plot(), Qt::LeftButton, {}, plot().placeOf(point)->toPoint()); }
    QString cell(int row, int column) { return part<app::StudyPoints>().item(row, column)->text(); }
};

}  // namespace test
