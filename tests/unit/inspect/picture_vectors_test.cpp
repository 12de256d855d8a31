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

// H is in the plane of L and V, and V is seen end on: H lies along L in the picture, and is shorter.
TEST(PictureVectors, HaveHWhereTheHighlightReadsIt) {
    Scene scene = test::pyramid();
    EXPECT_FALSE(vectorsInPicture(*test::frameOf(scene), {268, 281})->H) << "Phong's highlight reads R";
    scene.objects[0].material.highlight = Highlight::BlinnPhong;
    scene.settings.shading = Shading::Phong;  // at the pixel itself, not in the middle of its polygon
    const auto vectors = vectorsInPicture(*test::frameOf(scene), {268, 281});
    ASSERT_TRUE(vectors && vectors->H);
    const glm::dvec2 H = *vectors->H - vectors->at, L = vectors->L - vectors->at;
    EXPECT_NEAR(H.x * L.y - H.y * L.x, 0, 1e-4 * glm::length(H) * glm::length(L));  // of floats
    EXPECT_GT(glm::dot(H, L), 0);
    EXPECT_LT(glm::length(H), glm::length(L));
    scene.objects[0].material.specular = Vec3d(0);
    EXPECT_FALSE(vectorsInPicture(*test::frameOf(scene), {268, 281})->H) << "without a highlight";
}

}  // namespace
}  // namespace pipeline
