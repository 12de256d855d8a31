#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "app/drawing3d/view_content.h"
#include "tests/support/scenes.h"

// What the tests of the 3D view's content begin with.
namespace view3d {

using app::Vec3d;
using app::VectorArrow;
using app::VectorCode;
using app::ViewContent;

inline constexpr glm::ivec2 kRightFace{268, 281};  // a pixel of polygon 2, "Right"
inline constexpr glm::dvec2 kView{640, 480};       // size of the view, pixels

inline ViewContent contentOf(const pipeline::Scene& scene, std::optional<glm::ivec2> pixel = {}) {
    return app::contentOf(*test::frameOf(scene, app::contentBuffers(scene, true)), pixel);
}

inline const VectorArrow& vectorOf(const ViewContent& content, VectorCode code) {
    const auto found =
        std::ranges::find_if(content.vectors, [&](const VectorArrow& v) { return v.main && v.code == code; });
    EXPECT_NE(found, content.vectors.end());
    return *found;
}

inline void expectNear(Vec3d a, Vec3d b, double tolerance) {
    EXPECT_NEAR(glm::length(a - b), 0, tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

}  // namespace view3d
