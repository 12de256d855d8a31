#pragma once
#include <gtest/gtest.h>

#include "pipeline/formats/scene_reader.h"
#include "pipeline/run/runner.h"

// Lecture 1's pyramid: 640 by 480 pixels, one light, five vertices, five polygons.
inline pipeline::Scene pyramidScene() {
    const auto scene = pipeline::readScene(pipeline::builtInScenes().front().file);
    EXPECT_TRUE(scene) << pipeline::format(scene ? pipeline::Errors{} : scene.errors());
    return scene ? *scene : pipeline::Scene{};
}

inline pipeline::FramePtr frameOf(const pipeline::Scene& scene, const pipeline::FrameRequest& request) {
    return pipeline::runFrame(std::make_shared<const pipeline::Scene>(scene), request, nullptr);
}

inline pipeline::FramePtr frameOf(const pipeline::Scene& scene, pipeline::BufferSet wanted) {
    pipeline::FrameRequest request;
    request.wanted = wanted;
    return frameOf(scene, request);
}
