#include "pipeline/inspect/picture_vectors.h"

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// Flat shading evaluates in the middle of a polygon. N and the L of a light at infinity are the same at the pixel, so
// lines, arc and horizon stand there: a point and its reflection in N's foot are as far from it, but for perspective.
TEST(PictureVectors, StandTogetherAtThePixelOfAFlatPolygon) {
    const auto vectors = vectorsInPicture(*test::frameOf(test::pyramid()), {268, 281});
    ASSERT_TRUE(vectors);
    EXPECT_LT(glm::distance(vectors->at, glm::dvec2(268.5, 281.5)), 1);
    glm::dvec2 middle(0.0);
    for (int i = 0; i < 32; ++i) middle += vectors->horizon[std::size_t(i)] / 32.0;
    const double across = glm::distance(vectors->horizon[0], vectors->horizon[16]);
    EXPECT_LT(glm::distance(middle, vectors->at), 0.1 * across);
}

}  // namespace
}  // namespace pipeline
