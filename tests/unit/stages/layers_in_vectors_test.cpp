#include <gtest/gtest.h>

#include <cstring>

#include "pipeline/run/frame_data.h"
#include "pipeline/scene/model_facts.h"
#include "pipeline/stages/translucent.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// Layers shaded as pictures of a tile in vectors have the bits of layers shaded one by one, in every model and shading,
// where a pixel has many of them and where a tile has few.
TEST(LayersInVectors, AreShadedToTheSameBits) {
    int compared = 0;
    for (const ModelFacts& model : modelTable())
        for (const Shading shading : {Shading::Flat, Shading::Gouraud, Shading::Phong})
            for (const Interpolation interpolation : {Interpolation::Perspective, Interpolation::Affine}) {
                SCOPED_TRACE(std::string(model.word) + " " + std::to_string(int(shading)));
                Scene scene = test::spheres();
                scene.settings.model = Model(&model - modelTable().data());
                scene.settings.shading = shading, scene.settings.interpolation = interpolation;
                scene.settings.cull = CullMode::None;
                for (Object& object : scene.objects) object.material.alpha = 0.25;
                Object plane = scene.objects[0];  // cut by the near plane
                plane.mesh = makeShape({ShapeKind::Plane, 1}), plane.transform.scale = Vec3d(9000);
                plane.transform.rotation = {80, 0, 20}, plane.material.alpha = 0.5;
                scene.objects.push_back(plane);
                const FramePtr frame = test::frameOf(scene, setOf({BufferId::Color}));
                const auto& data = *dataOf<float>(*frame);
                ShadingInputs inputs = data.keys.shading;
                if (!inputs.parts[Part::ShadedInVectors]) continue;
                inputs.parts.whole.set(Part::ShadedInVectors, false);
                const ShadingSources<float> in = data.shadingSources();
                ShadingOutput<float> out = prepareShading(inputs, in, {});
                out.polygons = data.shading->polygons, out.vertices = data.shading->vertices;
                const LayerBins<float> bins = binLayers(inputs, in);
                ShadingCounts counts;
                for (std::size_t tile = 0; tile < bins.order.size(); ++tile) {
                    counts += shadePixels(inputs, in, tileOf(data.transform->view.size, tile), out);
                    counts += drawLayers(inputs, in, bins, tile, out);
                }
                const auto intensity = [](const ShadingOutput<float>& of) {
                    const auto& pixels = of.vectors[index(BufferId::Intensity)][0].pixels;
                    std::vector<std::uint32_t> words(pixels.size() * 3);
                    std::memcpy(words.data(), pixels.data(), words.size() * 4);
                    return words;
                };
                EXPECT_TRUE(intensity(out) == intensity(*data.shading));
                EXPECT_TRUE(out.color.pixels == data.shading->color.pixels);
                EXPECT_GT(counts.layers, 4000);
                EXPECT_EQ(counts.layers, data.shading->counts.layers);
                EXPECT_EQ(counts.lookups, data.shading->counts.lookups);
                if (shading == Shading::Phong) {
                    EXPECT_EQ(counts.evaluations, data.shading->counts.evaluations);
                    EXPECT_EQ(counts.powers, data.shading->counts.powers);
                    EXPECT_EQ(counts.vanished, data.shading->counts.vanished);
                }
                ++compared;
            }
    EXPECT_GE(compared, 15);
}

}  // namespace
}  // namespace pipeline
