#pragma once
#include <gtest/gtest.h>

#include <QFile>
#include <QString>
#include <QTemporaryDir>
#include <QTest>

#include "app/document/document.h"
#include "app/document/renderer_check.h"
#include "pipeline/defects/defect_table.h"
#include "pipeline/export/buffers/npy_file.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_reader.h"
#include "tests/support/scenes.h"

namespace app {

// A scene in which nothing is symmetrical, small enough for a test.
inline pipeline::Scene smallCheckMe() {
    pipeline::Scene scene = pipeline::readScene(pipeline::resourceFolder() / "starter/check_me.toml").value();
    scene.settings.width = 160, scene.settings.height = 100;
    scene.settings.shadowSize = 128;  // the frame of each known error has one
    scene.camera.screenDistance = 165;
    return scene;
}

// As a renderer writes: over what is there.
inline void writeAnew(const pipeline::AnyBuffer& buffer, const QString& file) {
    QFile::remove(file);
    ASSERT_TRUE(pipeline::writeNpy({buffer, statistics(buffer), {}}, file.toStdString()));
}

// What a renderer with this error would have written; one without an error where it is None.
inline void handIn(const QString& folder, pipeline::Defect defect,
                   std::initializer_list<pipeline::BufferId> ids = {
                       pipeline::BufferId::VerticesScreen, pipeline::BufferId::VerticesNormal,
                       pipeline::BufferId::ZView, pipeline::BufferId::Normal, pipeline::BufferId::Color}) {
    pipeline::Scene scene = plant(smallCheckMe(), defect);
    scene.settings.precision = pipeline::Precision::Double;
    scene.settings.leaveOut = false;
    pipeline::BufferSet wanted;
    for (const pipeline::BufferId id : ids) wanted.set(index(id));
    const auto frame = test::frameOf(scene, wanted);
    for (const pipeline::BufferId id : ids) {
        const auto buffer = *frame->buffer({id});
        writeAnew(buffer, folder + '/' + QString::fromStdString(buffer.name.text()) + ".npy");
    }
}

// Until the stages are compared. Where something differs the search for its name, a frame for each known error, goes on.
inline bool waitForStages(const RendererCheck& renderer) {
    return QTest::qWaitFor(
        [&] {
            return renderer.work() != RendererCheck::Work::Stages && (renderer.report() || !renderer.errors().empty());
        },
        120000);
}

// Until the stages and, where something differs, the names are there.
inline bool waitForReport(const RendererCheck& renderer) {
    return QTest::qWaitFor(
        [&] {
            const bool isDone = renderer.report() && (renderer.report()->agrees() || renderer.report()->suspects);
            return renderer.work() == RendererCheck::Work::None && (isDone || !renderer.errors().empty());
        },
        120000);
}

}  // namespace app
