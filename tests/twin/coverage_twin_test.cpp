// The rasterizer of a real OpenGL against the exact verifier.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/sweep.h"
#include "tests/support/triangles.h"
#include "tests/twin/gl_context.h"

namespace twin {
namespace {

using pipeline::GlCall;

constexpr int kSide = 64;
constexpr std::size_t kTogether = 64;

// Pixels to the corners of clip space by a division by 32, which no float rounds; the i-th triangle is nearer than those
// before it.
std::vector<GlCall> callsOf(const std::vector<test::ScreenTriangle>& triangles) {
    std::vector<GlCall> calls{
        {"glViewport", {}, {0, 0, kSide, kSide}, {}},
        {"glMatrixMode", {"GL_PROJECTION"}, {}, {}},
        {"glLoadIdentity", {}, {}, {}},
        {"glOrtho", {}, {0, kSide, 0, kSide, -1, 1}, {}},
        {"glMatrixMode", {"GL_MODELVIEW"}, {}, {}},
        {"glLoadIdentity", {}, {}, {}},
        {"glDisable", {"GL_DITHER"}, {}, {}},
        {"glDisable", {"GL_CULL_FACE"}, {}, {}},
        {"glEnable", {"GL_DEPTH_TEST"}, {}, {}},
        {"glDepthFunc", {"GL_LESS"}, {}, {}},
        {"glClearColor", {}, {0, 0, 0, 0}, {}},
        {"glClear", {"GL_COLOR_BUFFER_BIT", "GL_DEPTH_BUFFER_BIT"}, {}, {}},
    };
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        calls.push_back({"glBegin", {"GL_POLYGON"}, {}, {}});
        for (const glm::dvec2 p : triangles[i])
            calls.push_back({"glVertex3d", {}, {p.x, kSide - p.y, double(i) / double(kTogether)}, {}});
        calls.push_back({"glEnd", {}, {}, {}});
    }
    return calls;
}

// A million triangles in a long run, inside the picture, for clipping makes vertices of its own.
TEST(OpenGlCoverage, HasNoViolationAtItsOwnNumberOfBits) {
    std::string whyNot;
    const auto gl = GlContext::make(whyNot);
    if (!gl) GTEST_SKIP() << "not compared with OpenGL: " << whyNot;
    const int bits = gl->subPixelBits();
    ASSERT_GE(bits, 1);
    ASSERT_LE(bits, 16);
    test::CoverageViolations found;
    std::size_t drawn = 0;
    for (const std::size_t i : test::sweep(1000000 / kTogether)) {
        const auto triangles = test::randomTriangles(unsigned(i), kTogether, kSide, 0, i % 2 ? 12 : bits + 1);
        const GlPicture picture = gl->draw(callsOf(triangles), {kSide, kSide});
        ASSERT_EQ(picture.error, "");
        found.add(triangles, picture.polygon, kSide, bits);
        drawn += kTogether;
    }
    fmt::print("{}: {} bits, {} triangles, {} samples decided, {} missing, {} extra\n", gl->renderer(), bits, drawn,
               found.decided, found.missing, found.extra);
    EXPECT_EQ(found.missing, 0u);
    EXPECT_EQ(found.extra, 0u);
    EXPECT_GT(found.decided, 10000u);
}

}  // namespace
}  // namespace twin
