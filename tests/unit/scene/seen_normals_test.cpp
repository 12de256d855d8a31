// Polygon normals that shadows alone read: of a fine mesh each is found where its polygon is seen.
#include <gtest/gtest.h>

#include "pipeline/inspect/pixel_report.h"
#include "pipeline/steps/steps.h"
#include "tests/support/scenes.h"

namespace pipeline {
namespace {

// A sphere of triangles alone, every vertex with a normal of its own.
std::shared_ptr<const Mesh> roundMesh(int rings, int segments) {
    const std::shared_ptr<const Mesh> sphere = test::sphere(150, rings, segments);
    Mesh mesh;
    mesh.positions = mesh.normals = sphere->positions;
    for (const Triangle& t : sphere->triangles) mesh.addPolygon(t.vertices);
    return makeMesh(std::move(mesh));
}

// Three spheres of 10 620 triangles each in a picture of 97 × 71; one is turned inside out, and one shades another.
Scene fineSpheres() {
    Scene scene = test::spheres();
    scene.settings.width = 97, scene.settings.height = 71;
    scene.settings.normalWeight = NormalWeight::Given;
    for (Object& object : scene.objects) object.mesh = roundMesh(60, 90);
    scene.objects[1].transform.scale = {-1, 1, 0.5};
    return scene;
}

bool hasNormals(const Frame& frame) { return frame.buffer({BufferId::PolygonsNormal}).has_value(); }

const BufferSet kPicture = setOf({BufferId::Color});

Scene withAllOfThem(Scene scene) {
    scene.settings.rules.reset(index(Rule::PolygonNormals));
    return scene;
}

void expectTheSamePicture(const Scene& scene, BufferSet wanted = kPicture) {
    const FramePtr frame = test::frameOf(scene, wanted), other = test::frameOf(withAllOfThem(scene), wanted);
    EXPECT_FALSE(hasNormals(*frame));
    EXPECT_TRUE(hasNormals(*other));
    EXPECT_EQ(test::firstDifference(*frame, *other, wanted), "");
}

// In vectors, exact and fast, in perspective and without, from lights of every kind; drawn one by one; and under a
// translucent sphere, whose fragments are shaded one by one.
TEST(SeenNormals, GiveTheSamePicture) {
    for (const Shading shading : {Shading::Phong, Shading::Gouraud})
        for (const LightKind kind : {LightKind::AtInfinity, LightKind::Point, LightKind::Area}) {
            Scene scene = fineSpheres();
            scene.settings.shading = shading;
            scene.lights[0].kind = kind;
            scene.lights[0].area = {{-1, -1, -1}, 80, 80, 2};
            expectTheSamePicture(scene);
            expectTheSamePicture(scene, setOf({BufferId::Color, BufferId::Shadow, BufferId::Intensity}));
            scene.settings.arithmetic = Arithmetic::Fast;
            expectTheSamePicture(scene);
            scene.settings.arithmetic = Arithmetic::Exact;
            scene.camera.projection = ProjectionKind::Orthographic;
            expectTheSamePicture(scene);
            scene.settings.visibility = Visibility::Painter;
            expectTheSamePicture(scene);
            scene.settings.visibility = Visibility::ZBuffer;
            scene.objects[2].material.alpha = 0.5;
            expectTheSamePicture(scene);
        }
}

// Who looks at a pixel is told the same of its shadow, and who steps through the pixels ends at the same picture.
TEST(SeenNormals, AreTheSameInAReportAndStepByStep) {
    const Scene scene = fineSpheres();
    const FramePtr frame = test::frameOf(scene, kPicture), other = test::frameOf(withAllOfThem(scene), kPicture);
    int shadowed = 0;
    for (int y = 5; y < 71; y += 15)
        for (int x = 5; x < 97; x += 15) {
            const std::string text = toText(*frame, inspectPixel(*frame, {x, y}));
            EXPECT_EQ(text, toText(*other, inspectPixel(*other, {x, y})));
            shadowed += text.find("> Z'") != std::string::npos;
        }
    EXPECT_GT(shadowed, 0);
    const Steps steps(frame);
    const Moment middle{StageId::Shading, steps.total(StageId::Shading) / 2};
    EXPECT_EQ(test::firstDifference(*steps.frameAt(middle), *Steps(other).frameAt(middle), kPicture), "");
}

// Of one polygon for four pixels and fewer all are found, and so are those that somebody else reads, those of polygons that
// are no triangles, and those of other forms or in another precision.
TEST(SeenNormals, AreThoseOfFineMeshesAlone) {
    const auto hasThem = [](auto change, BufferSet wanted = kPicture) {
        Scene scene = fineSpheres();
        change(scene);
        return hasNormals(*test::frameOf(scene, wanted));
    };
    using S = Scene;
    EXPECT_FALSE(hasThem([](S&) {}));
    EXPECT_TRUE(hasThem([](S&) {}, setOf({BufferId::PolygonsNormal})));
    EXPECT_TRUE(hasThem([](S& s) { s.settings.shading = Shading::Flat; }));
    EXPECT_TRUE(hasThem([](S& s) { s.settings.normalWeight = NormalWeight::Mean; }));
    EXPECT_TRUE(hasThem([](S& s) { s.settings.precision = Precision::Double; }));
    EXPECT_TRUE(hasThem([](S& s) { s.settings.forms.polygonNormal = PolygonNormalForm::FromOrigin; }));
    EXPECT_TRUE(hasThem([](S& s) { s.settings.forms.unit = UnitForm::Newton; }));
    EXPECT_TRUE(hasThem([](S& s) { s.objects[1].mesh = makeShape({ShapeKind::Box, 1}); }));
    // 3 × 2 × 30 × 29 = 5 220 triangles are one for four of 20 880 pixels, and of one pixel less more than that.
    EXPECT_TRUE(hasThem([](S& s) {
        for (Object& object : s.objects) object.mesh = roundMesh(30, 30);
        s.settings.width = 174, s.settings.height = 120;
    }));
    EXPECT_FALSE(hasThem([](S& s) {
        for (Object& object : s.objects) object.mesh = roundMesh(30, 30);
        s.settings.width = 173, s.settings.height = 120;
    }));
    FrameRequest request;
    request.until = StageId::Normals;
    EXPECT_TRUE(hasNormals(*runFrame(std::make_shared<const Scene>(fineSpheres()), request, nullptr)));
}

TEST(SeenNormals, AreLeftOutWithAReason) {
    const FramePtr frame = test::frameOf(fineSpheres(), kPicture);
    for (const PlanPart& part : frame->plan()[index(StageId::Normals)].parts) {
        if (part.name != "polygon normals") continue;
        EXPECT_EQ(part.action, Action::LeaveOut);
        EXPECT_EQ(part.rule, Rule::PolygonNormals);
        EXPECT_EQ(part.why, "Shadows alone read them, each where its polygon is seen: there it is found.");
        return;
    }
    FAIL() << "the plan does not name them";
}

}  // namespace
}  // namespace pipeline
