#include "pipeline/buffers/buffer_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "pipeline/buffers/any_buffer.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// Section 5 of the specification, name by name, with one light.
constexpr const char* kSpecification[] = {
    "vertices.world", "vertices.view", "vertices.screen", "vertices.normal", "vertices.intensity", "polygons.verdict",
    "polygons.normal", "polygons.intensity", "depth", "z_view", "object_id", "polygon_id", "barycentric", "position",
    "normal", "view_vector", "light_vector.0", "reflection_vector.0", "halfway_vector.0", "n_dot_l.0", "r_dot_v.0",
    "n_dot_h.0", "ambient", "diffuse.0", "specular.0", "emission", "intensity", "shadow.0", "shadow_buffer.0",
    "overdraw", "depth_writes", "color",
    // Of the specification's translucent surfaces.
    "translucent", "transmittance", "layers",
    // Of several samples a pixel.
    "antialiased",
    // Of colours of vertices.
    "k_d"};

TEST(BufferTable, HasEveryBufferOfTheSpecificationAndNoOther) {
    std::set<std::string> expected(std::begin(kSpecification), std::end(kSpecification)), found;
    for (const BufferName& name : allBuffers(1)) EXPECT_TRUE(found.insert(name.text()).second) << name.text();
    EXPECT_EQ(found, expected);
}

TEST(BufferTable, FindsWhatItNames) {
    for (const BufferName& name : allBuffers(12)) EXPECT_EQ(findBuffer(name.text()), name) << name.text();
    for (const char* wrong : {"", "dept", "depth.0", "n_dot_l", "n_dot_l.", "n_dot_l.x", "n_dot_l.-1", "n_dot_l.01",
                              "n_dot_l.0.1", "n_dot_l.99999999999", "shadow", "shadow_buffer.", "Depth", "depth "})
        EXPECT_FALSE(findBuffer(wrong)) << wrong;
}

TEST(BufferTable, ShadowAndShadowBufferAreTwo) {
    EXPECT_EQ(findBuffer("shadow.3"), (BufferName{BufferId::Shadow, 3}));
    EXPECT_EQ(findBuffer("shadow_buffer.3"), (BufferName{BufferId::ShadowBuffer, 3}));
}

// What is made of a frame has a name that no frame's buffer has, and none that frames are asked for.
TEST(BufferTable, DerivedBuffersAreNamesApart) {
    EXPECT_EQ(derivedTable().size(), kDerivedCount);
    for (const BufferName& name : allDerived(3)) {
        EXPECT_EQ(findDerived(name.text()), name);
        EXPECT_EQ(findAnyBuffer(name.text()), name);
        EXPECT_FALSE(findBuffer(name.text())) << name.text();
        EXPECT_TRUE(isDerived(name.id) && &bufferInfo(name.id) == &derivedTable()[index(name.id) - kBufferCount]);
    }
    EXPECT_EQ(findDerived("shadow_verdict.2"), (BufferName{BufferId::ShadowVerdict, 2}));
    EXPECT_EQ(findAnyBuffer("depth"), BufferName{BufferId::Depth});
    EXPECT_FALSE(findDerived("depth") || findDerived("shadow_verdict") || findDerived("mix.0"));
}

TEST(BufferTable, NoFrameHoldsADerivedBuffer) {
    const FramePtr frame = test::frameOf(test::pyramid(), test::everyBuffer());
    for (const BufferName& name : allDerived(1)) {
        EXPECT_FALSE(frame->buffer(name)) << name.text();
        EXPECT_EQ(frame->whyAbsent(name), "It was not derived.") << name.text();
    }
}

TEST(BufferTable, SuggestsTheNearestName) {
    EXPECT_EQ(insteadOfBuffer("colour"), "the nearest is \"color\"");
    EXPECT_EQ(insteadOfBuffer("zview"), "the nearest is \"z_view\"");
    EXPECT_EQ(insteadOfBuffer("n_dot_l"), "the nearest is \"n_dot_l.0\"");
    EXPECT_TRUE(insteadOfBuffer("picture").ends_with("; shadescope plan --json SCENE lists all"));
    EXPECT_EQ(insteadOfAnyBuffer("zndc"), "the nearest is \"z_ndc\"");
    const std::size_t all = allBuffers(1).size() + allDerived(1).size();
    EXPECT_TRUE(insteadOfAnyBuffer("picture").starts_with("there are " + std::to_string(all) + ", the nearest are "));
}

TEST(BufferTable, NeutralValuesAreThoseOfTheSpecification) {
    for (const BufferInfo& info : bufferTable()) {
        const bool distance =
            info.id == BufferId::Depth || info.id == BufferId::ZView || info.id == BufferId::ShadowBuffer;
        const bool id = info.id == BufferId::ObjectId || info.id == BufferId::PolygonId;
        if (distance)
            EXPECT_TRUE(std::isinf(info.neutral) && info.neutral > 0) << info.name;
        else
            EXPECT_EQ(info.neutral, id                                   ? -1
                                    : info.id == BufferId::Shadow        ? 1
                                    : info.id == BufferId::Transmittance ? 1
                                                                         : 0)
                << info.name;
    }
}

TEST(BufferTable, SetsHoldWhatIsPutIn) {
    const BufferSet set = setOf({BufferId::Color, BufferId::Depth});
    EXPECT_EQ(set.count(), 2u);
    EXPECT_TRUE(set.test(index(BufferId::Color)) && set.test(index(BufferId::Depth)));
}

TEST(Stages, AreFoundByTheirNames) {
    for (const StageId stage : kStages) EXPECT_EQ(findStage(stageInfo(stage).name), stage);
    EXPECT_EQ(stageInfo(StageId::ShadowBuffer).name, "shadow-buffer");
    EXPECT_EQ(stageInfo(StageId::ZBuffer).name, "z-buffer");
    EXPECT_FALSE(findStage("zbuffer"));
}

template <class T>
AnyBuffer buffer(BufferId id, std::vector<std::size_t> shape, const std::vector<T>& numbers) {
    AnyBuffer any{{id, bufferInfo(id).perLight ? 0 : -1}, &bufferInfo(id), std::move(shape), {}, nullptr};
    any.data = std::span<const T>(numbers);
    return any;
}

TEST(AnyBuffer, ReadsARowMajorPicture) {
    const std::vector<std::uint8_t> numbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17};
    const AnyBuffer color = buffer(BufferId::Color, {2, 3, 3}, numbers);
    EXPECT_EQ(color.rows(), 2u);
    EXPECT_EQ(color.columns(), 3u);
    EXPECT_EQ(color.count(), 18u);
    EXPECT_EQ(color.value(1, 1, 2), 14);  // row 1 begins at 9, column 1 at 12
    EXPECT_STREQ(color.dtype(), "uint8");
}

TEST(AnyBuffer, KnowsTheOtherShapes) {
    const std::vector<double> six(6 * 4 * 5), vertices(7 * 3);
    const std::vector<std::uint8_t> verdicts(4);
    const AnyBuffer faces = buffer(BufferId::ShadowBuffer, {6, 4, 5}, six);
    EXPECT_EQ(faces.rows(), 24u);
    EXPECT_EQ(faces.columns(), 5u);
    EXPECT_STREQ(faces.dtype(), "float64");
    const AnyBuffer world = buffer(BufferId::VerticesWorld, {7, 3}, vertices);
    EXPECT_EQ(world.rows(), 7u);
    EXPECT_EQ(world.columns(), 1u);
    const AnyBuffer verdict = buffer(BufferId::PolygonsVerdict, {4}, verdicts);
    EXPECT_EQ(verdict.rows(), 4u);
    EXPECT_EQ(verdict.columns(), 1u);
}

TEST(Statistics, SetsAsideWhatIsNotFinite) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> numbers{3, inf, -1, nan, inf, 2, -inf};
    const BufferStatistics found = statistics(buffer(BufferId::Depth, {1, 7}, numbers));
    EXPECT_EQ(found.min, -1);
    EXPECT_EQ(found.max, 3);
    EXPECT_EQ(found.finite, 3u);
    EXPECT_EQ(found.infinite, 3u);
    EXPECT_EQ(found.nan, 1u);
    EXPECT_EQ(found.negative, 2u);
    const std::vector<float> nothing{inf, inf};
    // In any place of a long row, where many are counted at a time.
    std::vector<float> many(75, 2.0f);
    many[3] = many[40] = many[74] = NAN;
    many[20] = -INFINITY, many[71] = INFINITY;
    many[33] = -5, many[72] = 9;
    const BufferStatistics row = statistics(buffer(BufferId::Depth, {1, 75}, many));
    EXPECT_EQ(row.min, -5);
    EXPECT_EQ(row.max, 9);
    EXPECT_EQ(row.nan, 3u);
    EXPECT_EQ(row.infinite, 2u);
    EXPECT_EQ(row.negative, 2u);  // −5 and −∞
    EXPECT_EQ(row.finite, 70u);

    const BufferStatistics empty = statistics(buffer(BufferId::Depth, {1, 2}, nothing));
    EXPECT_EQ(empty.min, 0);
    EXPECT_EQ(empty.max, 0);
}

}  // namespace
}  // namespace pipeline
