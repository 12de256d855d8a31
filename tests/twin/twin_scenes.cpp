#include "tests/twin/twin_scenes.h"

#include <cmath>
#include <random>

#include "tests/support/scenes.h"

namespace twin {

using namespace pipeline;

namespace {

Scene empty() {
    Scene scene;
    scene.settings.model = Model::OpenGl;
    scene.settings.shading = Shading::Gouraud;
    scene.settings.depthFormat = DepthFormat::Fixed24;
    scene.settings.width = 160, scene.settings.height = 120;
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 0, -1}, scene.camera.up = {0, 1, 0};
    scene.camera.near = 1, scene.camera.far = 10;
    scene.ambient.intensity = 0.2;
    return scene;
}

// A ball of radius 1 at distance 4, lit by one light at a point.
Scene ball() {
    Scene scene = empty();
    Object object{"ball", test::sphere(1, 12, 20), {}, {}};
    object.transform.translation = {0.1, -0.05, -4};
    object.transform.rotation = {70, 0, 10};
    object.material = {{0.5, 0.3, 0.6}, Vec3d(0.6), 20, {0.4, 0.3, 0.2}};
    scene.objects.push_back(object);
    Light light{LightKind::Point, {1.5, 2, -2}, 1, {0.8, 0.7, 0.6}, true};
    light.gl.ambient = Vec3d(0.1), light.gl.specular = {0.9, 0.8, 0.7};
    scene.lights.push_back(light);
    return scene;
}

// A box without its front, seen from there: its inside shows.
Scene openBox() {
    Scene scene = ball();
    scene.settings.cull = CullMode::None;
    scene.settings.twoSided = true;
    scene.objects[0].name = "open box";
    scene.objects[0].mesh =
        test::mesh({{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}},
                   {{0, 3, 2, 1}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
    scene.objects[0].transform.rotation = {20, 25, 5};
    scene.lights[0].position = {0.5, 1, -1};
    return scene;
}

// Two panes that reach beyond the picture on all sides: the ball's outline is the only edge in it.
Scene panesBeforeBall() {
    Scene scene = ball();
    scene.settings.translucency = Translucency::Polygons;
    for (int i = 0; i < 2; ++i) {
        Object pane{"pane", test::mesh({{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}, {{0, 1, 2, 3}}), {}, {}};
        pane.transform.translation = {0, 0, -1.5 - 0.7 * i};
        pane.transform.rotation = {3, 4.0 * i, 0};
        pane.material = {{0.9, 0.2 + 0.5 * i, 0.1}, Vec3d(0.2), 10, {0.5, 0.4, 0.9}};
        pane.material.alpha = i == 0 ? 0.3 : 0.6;
        scene.objects.push_back(pane);  // the nearer one first
    }
    return scene;
}

// Every vertex with a normal of its own, far from that of its polygons; of length 1 to a few units.
void giveNormals(Scene& scene) {
    scene.settings.normalWeight = NormalWeight::Given;
    for (Object& object : scene.objects) {
        Mesh mesh = *object.mesh;
        mesh.normals.clear();
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const double k = double(i);
            mesh.normals.push_back(glm::normalize(mesh.positions[i]) +
                                   0.6 * Vec3d(std::sin(7 * k), std::cos(5 * k), std::sin(3 * k)));
        }
        object.mesh = makeMesh(std::move(mesh));
    }
}

}  // namespace

Scene lectureCube() {
    Scene scene = test::openGlCube();
    scene.settings = empty().settings;
    return scene;
}

std::vector<NamedScene> featureScenes() {
    std::vector<NamedScene> scenes;
    const auto add = [&](const char* name, Scene scene, auto change) {
        change(scene);
        scenes.push_back({name, std::move(scene)});
    };
    add("CubeSmooth", lectureCube(), [](Scene&) {});
    add("CubeFlat", lectureCube(), [](Scene& s) { s.settings.shading = Shading::Flat; });
    add("Point", ball(), [](Scene&) {});
    add("PointFlat", ball(), [](Scene& s) { s.settings.shading = Shading::Flat; });
    // A polygon is lit with the normal of its first vertex, not with its own.
    add("GivenNormalsFlat", ball(), [](Scene& s) { s.settings.shading = Shading::Flat, giveNormals(s); });
    add("GivenNormalsSmooth", ball(), [](Scene& s) { giveNormals(s); });
    add("GivenNormalsFlatMirrored", ball(), [](Scene& s) {
        s.settings.shading = Shading::Flat, giveNormals(s);
        s.objects[0].transform.scale = {1, -0.8, 1.1};
    });
    add("GivenNormalsFlatTwoSided", openBox(), [](Scene& s) { s.settings.shading = Shading::Flat, giveNormals(s); });
    add("Directional", ball(), [](Scene& s) { s.lights[0].kind = LightKind::AtInfinity; });
    add("LocalViewer", ball(), [](Scene& s) { s.settings.localViewer = true; });
    add("Orthographic", ball(), [](Scene& s) { s.camera.projection = ProjectionKind::Orthographic; });
    add("OrthographicNearBehindTheEye", ball(), [](Scene& s) {
        s.camera.projection = ProjectionKind::Orthographic;
        s.camera.near = -3;
        s.objects.push_back(s.objects[0]);
        s.objects[1].transform.translation = {0.9, 0.4, 1.5};  // around the eye and behind it
        s.objects[1].transform.scale = Vec3d(0.5);
    });
    add("OrthographicLocalViewer", ball(), [](Scene& s) {
        s.camera.projection = ProjectionKind::Orthographic;
        s.settings.localViewer = true;
    });
    add("Attenuation", ball(),
        [](Scene& s) { s.lights[0].gl.constant = 0.3, s.lights[0].gl.linear = 0.2, s.lights[0].gl.quadratic = 0.1; });
    add("Spot", ball(), [](Scene& s) {
        s.lights[0].gl.spotDirection = {-1.3, -1.8, -1.9};
        s.lights[0].gl.spotCutoff = 20, s.lights[0].gl.spotExponent = 7;
    });
    add("DirectionalSpot", ball(), [](Scene& s) {
        s.lights[0].kind = LightKind::AtInfinity;
        s.lights[0].gl.spotDirection = {-1, -1.8, 2.1};
        s.lights[0].gl.spotCutoff = 80, s.lights[0].gl.spotExponent = 2;
    });
    add("Emission", ball(), [](Scene& s) { s.objects[0].material.emission = {0.3, 0, 0.1}; });
    add("ShininessZero", ball(), [](Scene& s) { s.objects[0].material.exponent = 0; });
    add("ShininessLargest", ball(), [](Scene& s) { s.objects[0].material.exponent = 128; });
    add("NoLight", ball(), [](Scene& s) { s.lights.clear(); });
    add("Overbright", ball(), [](Scene& s) { s.lights[0].intensity = 3; });
    add("EightLights", ball(), [](Scene& s) {
        const Light first = s.lights[0];
        for (int k = 1; k < 8; ++k) {
            Light light = first;
            light.kind = k % 2 == 0 ? LightKind::Point : LightKind::AtInfinity;
            light.position = {3 * std::cos(k), 3 * std::sin(k), 1.0 - k % 3};
            light.intensity = 0.25;
            light.color = {k % 3 == 0 ? 1 : 0.2, k % 3 == 1 ? 1 : 0.2, k % 3 == 2 ? 1 : 0.2};
            s.lights.push_back(light);
        }
    });
    add("Headlight", ball(), [](Scene& s) {
        s.camera.eye = {3, 2, -1}, s.camera.target = {0.1, 0, -4};
        s.lights[0].gl.space = LightSpace::Eye;
        s.lights[0].position = {0.5, 0.3, 0};
        s.lights[0].gl.spotCutoff = 12, s.lights[0].gl.spotDirection = {-0.1, -0.1, -1};
    });
    add("WorldLightMovedCamera", ball(), [](Scene& s) {
        s.camera.eye = {3, 2, -1}, s.camera.target = {0.1, 0, -4};
        s.settings.localViewer = true;
    });
    add("DirectionalHeadlight", ball(), [](Scene& s) {
        s.camera.eye = {3, 2, -1}, s.camera.target = {0.1, 0, -4};
        s.lights[0].gl.space = LightSpace::Eye;
        s.lights[0].kind = LightKind::AtInfinity, s.lights[0].position = {0.5, 0.3, 1};
    });
    add("Scaled", ball(), [](Scene& s) { s.objects[0].transform.scale = {1.2, 0.4, 0.7}; });
    add("Mirrored", ball(), [](Scene& s) { s.objects[0].transform.scale = {1, -0.8, 1.1}; });
    add("TwoSided", openBox(), [](Scene&) {});
    add("TwoSidedFlat", openBox(), [](Scene& s) { s.settings.shading = Shading::Flat; });
    add("OneSidedInside", openBox(), [](Scene& s) { s.settings.twoSided = false; });
    add("BackMaterial", openBox(), [](Scene& s) {
        s.objects[0].backMaterial = Material{{0.1, 0.8, 0.2}, Vec3d(0.9), 60, {0.3, 0.1, 0.1}, {0, 0, 0.2}};
    });
    add("Translucent", panesBeforeBall(), [](Scene&) {});
    add("MirroredTwoSided", openBox(), [](Scene& s) {
        s.objects[0].transform.scale = {-1, 1, 0.8};
        s.objects[0].backMaterial = Material{{0.1, 0.8, 0.2}, Vec3d(0.9), 60, {0.3, 0.1, 0.1}};
    });
    return scenes;
}

Scene randomGlScene(unsigned seed) {
    std::mt19937 random(seed);
    // Not std::uniform_real_distribution: its sequence differs between libraries.
    const auto between = [&](double low, double high) {
        return low + (high - low) * double(random()) / double(std::mt19937::max());
    };
    const auto box = [&](double low, double high) {
        const double x = between(low, high), y = between(low, high), z = between(low, high);
        return Vec3d(x, y, z);
    };
    const auto coin = [&] { return random() % 2 == 0; };
    const auto material = [&] {
        Material m{box(0, 1), box(0, 1), between(0, 128), box(0, 1), coin() ? Vec3d(0) : box(0, 0.3)};
        if (random() % 4 == 0) m.specular = Vec3d(0);
        return m;
    };
    Scene scene = empty();
    scene.settings.shading = coin() ? Shading::Flat : Shading::Gouraud;
    scene.settings.cull = coin() ? CullMode::Back : CullMode::None;
    scene.settings.localViewer = coin();
    scene.settings.twoSided = coin();
    scene.camera.eye = box(-3, 3) + Vec3d(0, 0, 7);
    scene.camera.target = Vec3d(0);
    if (random() % 4 == 0) scene.camera.projection = ProjectionKind::Orthographic;
    scene.camera.near = 2, scene.camera.far = 20;
    for (unsigned i = 0; i < 1 + seed % 3; ++i) {
        Object object;
        object.name = "object";
        object.mesh = coin() ? test::box(Vec3d(-1), Vec3d(1)) : test::sphere(1, 5 + int(random() % 6), 7);
        object.transform.translation = box(-1.5, 1.5);
        object.transform.scale = box(0.4, 1.5);
        if (coin()) object.transform.scale.y *= -1;
        object.transform.rotation = box(-180, 180);
        object.material = material();
        if (coin()) object.backMaterial = material();
        scene.objects.push_back(object);
    }
    const auto lights = unsigned(random() % 9);
    for (unsigned k = 0; k < lights; ++k) {
        Light light;
        light.kind = coin() ? LightKind::Point : LightKind::AtInfinity;
        light.position = box(-4, 4) + Vec3d(0, 0, 3);
        light.intensity = between(0, 1.5);
        light.color = box(0, 1);
        light.gl.ambient = box(0, 0.2), light.gl.specular = box(0, 1);
        light.gl.constant = between(0.2, 1), light.gl.linear = between(0, 0.3), light.gl.quadratic = between(0, 0.1);
        light.gl.spotDirection = -light.position + box(-1, 1);
        if (random() % 3 == 0) light.gl.spotCutoff = between(5, 90), light.gl.spotExponent = between(0, 40);
        if (coin()) light.gl.space = LightSpace::Eye;
        scene.lights.push_back(light);
    }
    return scene;
}

}  // namespace twin
