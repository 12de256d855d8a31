#include "tests/support/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

#include "pipeline/scene/settings_table.h"

namespace test {

namespace {

double between(std::mt19937& random, double low, double high) {
    // Not std::uniform_real_distribution: its sequence differs between libraries.
    return low + (high - low) * double(random()) / double(std::mt19937::max());
}
Vec3d inBox(std::mt19937& random, double half) {
    return {between(random, -half, half), between(random, -half, half), between(random, -half, half)};
}
// One of the choices that the table of settings has for a key.
std::size_t choice(std::string_view key, std::size_t number) {
    return number % std::ranges::find(settingsTable(), key, &Setting::key)->choices.size();
}
bool coin(std::mt19937& random) { return random() % 2 == 0; }

Material randomMaterial(std::mt19937& random) {
    return {{between(random, 0, 1), between(random, 0, 1), between(random, 0, 1)},
            coin(random) ? Vec3d(0) : Vec3d(between(random, 0, 1)),
            random() % 4 == 0 ? between(random, 60, 1e6) : between(random, 0, 60)};
}

Light randomLight(std::mt19937& random) {
    Light light;
    light.kind = LightKind(choice("light.#.kind", random()));
    light.area = {inBox(random, 1), between(random, 0, 2), coin(random) ? between(random, 0, 2) : 0,
                  1 + int(random() % 3)};
    light.position = 4.0 * inBox(random, 1) + Vec3d(0, 0, 5);
    light.intensity = random() % 4 == 0 ? 0 : between(random, 0, 100);
    light.castsShadow = coin(random);
    return light;
}

Object randomObject(std::mt19937& random) {
    Object object;
    switch (random() % 3) {
        case 0: {
            const int segments = 3 + int(random() % 8), rings = 3 + int(random() % 5);
            object.mesh = sphere(1, rings, segments);
            break;
        }
        case 1: object.mesh = box({-1, -1, -1}, {1, 1, 1}); break;
        default:
            object.mesh = mesh({inBox(random, 2), inBox(random, 2), inBox(random, 2), inBox(random, 2)},
                               {{0, 1, 2}, {1, 2, 3}, {0, 1, 3, 2}});
    }
    object.transform.translation = inBox(random, 2.5);
    object.transform.rotation = inBox(random, 180);
    object.transform.scale = {between(random, 0.3, 2), between(random, 0.3, 2), between(random, -2, 2)};
    object.material = randomMaterial(random);
    return object;
}

}  // namespace

Scene randomScene(unsigned seed) {
    std::mt19937 random(seed);
    Scene scene;
    scene.settings.width = 97, scene.settings.height = 71;
    scene.settings.shadowSize = 64;
    scene.settings.shading = Shading(choice("shading", random()));
    scene.settings.cull = CullMode(choice("cull", random()));
    scene.settings.depthFormat = DepthFormat(choice("depth_format", random()));
    scene.camera.kind = CameraKind::LookAt;
    scene.camera.eye = inBox(random, 6) + Vec3d(0, 0, 3);
    scene.camera.projection = random() % 4 == 0 ? ProjectionKind::Orthographic : ProjectionKind::Perspective;
    scene.camera.height = 8;
    for (unsigned i = 0; i < 1 + seed % 4; ++i) scene.objects.push_back(randomObject(random));
    for (unsigned i = 0; i < random() % 4; ++i) scene.lights.push_back(randomLight(random));
    scene.ambient.intensity = between(random, 0, 50);
    if (seed % 5 == 0) scene.ambient.intensity = 0;
    scene.settings.model = Model(choice("model", seed));
    scene.settings.twoSided = (seed + seed / 8) % 2 == 0;
    scene.settings.interpolation = Interpolation(choice("interpolation", random()));
    for (Object& object : scene.objects) object.material.emission = Vec3d(0.1 * (seed % 5));
    if (seed / 4 % 2 == 1)  // half of them: some objects translucent, or wholly transparent, or beyond [0, 1]
        for (Object& object : scene.objects) object.material.alpha = between(random, -0.2, 1.4);
    scene.settings.translucency = Translucency(choice("translucency", seed / 8));
    for (Object& object : scene.objects)
        object.material.highlight = Highlight(choice("material.#.highlight", random()));
    return scene;
}

Forms randomForms(std::mt19937& random) {
    Forms forms;
    forms.power = PowerForm(choice("numerics.power", random())),
    forms.unit = UnitForm(choice("numerics.normalize", random()));
    forms.polygonNormal = PolygonNormalForm(choice("numerics.polygon_normal", random()));
    forms.normalMatrix = NormalMatrixForm(choice("numerics.normal_matrix", random()));
    forms.cameraBasis = CameraBasisForm(choice("numerics.camera_basis", random())),
    forms.cornerAngle = CornerAngleForm(choice("numerics.corner_angle", random()));
    return forms;
}

void giveColors(Scene& scene, std::mt19937& random) {
    for (Object& object : scene.objects) {
        if (random() % 4 == 0) continue;
        Mesh own = *object.mesh;
        own.colors.clear();
        for (std::size_t i = 0; i < own.positions.size(); ++i)
            own.colors.push_back(random() % 8 == 0 ? Vec3d(0) : glm::abs(inBox(random, 1)));
        object.mesh = makeMesh(std::move(own)), object.shape.reset();
    }
}

void giveNormals(Scene& scene, std::mt19937& random) {
    scene.settings.normalWeight = NormalWeight::Given;
    for (Object& object : scene.objects) {
        if (random() % 4 == 0) continue;
        Mesh own = *object.mesh;
        own.normals.clear();
        const bool alongAxes = coin(random);  // of them a flattened object loses some
        for (std::size_t i = 0; i < own.positions.size(); ++i) {
            Vec3d normal(0);
            if (alongAxes)
                normal[int(random() % 3)] = 1;
            else
                normal = inBox(random, 1);
            own.normals.push_back(normal);
        }
        if (random() % 3 == 0) {
            const double by = std::array{0.0, 1e-200, 1e-320, 1e200}[random() % 4];
            const std::size_t at = random() % own.normals.size();
            own.normals.set(at, by * own.normals[at]);
        }
        object.mesh = makeMesh(std::move(own));
        Vec3d& scale = object.transform.scale;
        if (random() % 6 == 0) scale.z = std::array{0.0, 1e-12, 1e-200}[random() % 3];
        if (random() % 12 == 0) scale.x = 0;
    }
}

Scene smallScene(unsigned seed) {
    Scene scene = randomScene(seed);
    std::mt19937 random(seed + 104729);
    scene.settings.width = 25 + int(random() % 24), scene.settings.height = 19 + int(random() % 16);
    scene.settings.shadowSize = 8 << random() % 3;
    scene.settings.shadowFilter = int(random() % 2);
    scene.settings.shadowBias = ShadowBias(choice("shadow.bias", random()));
    scene.settings.shadowBiasValue = between(random, 0, 0.5);
    scene.settings.shadowCull = ShadowCull(choice("shadow.cull", seed));
    scene.settings.localViewer = coin(random);
    const auto few = [](double v) { return std::round(v * 0x1p20) / 0x1p20; };
    for (Object& object : scene.objects) {
        Vec3d& angles = object.transform.rotation;
        angles = {few(angles.x), few(angles.y), few(angles.z)};
    }
    for (Light& light : scene.lights) {
        if (coin(random)) light.gl.linear = between(random, 0, 1), light.gl.quadratic = between(random, 0, 0.2);
        if (coin(random)) light.gl.spotDirection = inBox(random, 1), light.gl.spotCutoff = few(between(random, 5, 90));
    }
    if (random() % 4 == 0) {
        scene.camera.kind = CameraKind::Spherical;
        scene.camera.rho = between(random, 3, 9);
        scene.camera.theta = few(between(random, -180, 180)), scene.camera.phi = few(between(random, 0, 180));
        scene.camera.screenDistance = between(random, 20, 60);
    }
    if (random() % 4 == 0) scene.camera.near = between(random, 0.1, 5), scene.camera.far = between(random, 6, 12);
    return scene;
}

namespace {

double strangeNumber(std::mt19937& random, double most) {
    switch (random() % 6) {
        case 0: return 0;
        case 1: return -0.0;
        case 2: return most;
        case 3: return -most;
        default: return between(random, -2, 2);
    }
}
Vec3d strangeColor(std::mt19937& random) {
    return {strangeNumber(random, 1000), strangeNumber(random, 1000), strangeNumber(random, 1000)};
}

void makeStrange(Object& object, std::mt19937& random) {
    Material& m = object.material;
    if (coin(random)) m.diffuse = strangeColor(random);
    if (coin(random)) m.specular = strangeColor(random);
    if (coin(random)) m.ambient = strangeColor(random);
    if (coin(random)) m.emission = strangeColor(random);
    m.exponent = std::array{0.0, 1.0, 60.0, 128.0}[random() % 4];
    Vec3d& scale = object.transform.scale;
    switch (random() % 8) {
        case 0: scale = Vec3d(0); break;
        case 1: scale.x = 0; break;
        case 2: scale.y = scale.z = 0; break;
        case 3: scale.x = -scale.x; break;
        case 4: scale *= 1e-9; break;
        case 5: scale.z = 1e6; break;
        default: break;
    }
}

void makeStrange(Light& light, const Scene& scene, std::mt19937& random) {
    light.intensity = strangeNumber(random, 1e9);
    if (coin(random)) light.color = strangeColor(random);
    if (coin(random)) light.gl.ambient = strangeColor(random);
    if (coin(random)) light.gl.specular = strangeColor(random);
    light.gl.constant = light.gl.linear = light.gl.quadratic = 0;
    if (random() % 4 > 0) light.gl.constant = std::array{1.0, 1e9, 1e-300}[random() % 3];
    if (coin(random)) light.gl.spotCutoff = std::array{0.0, 90.0, 30.0}[random() % 3];
    if (light.kind == LightKind::AtInfinity) return;
    switch (random() % 4) {  // in a vertex, in the eye, in the world's origin
        case 0: light.position = scene.objects[0].transform.translation; break;
        case 1: light.position = scene.camera.eye; break;
        case 2: light.position = Vec3d(0); break;
        default: break;
    }
}

void makeStrange(Camera& camera, std::mt19937& random) {
    switch (random() % 8) {
        case 0: camera.target = camera.eye; break;
        case 1: camera.up = camera.target - camera.eye; break;
        case 2: camera.up = Vec3d(0); break;
        case 3: camera.eye = camera.target = camera.up = Vec3d(0); break;
        case 4: camera.kind = CameraKind::Spherical, camera.rho = 0; break;
        case 5: camera.fovY = coin(random) ? 0.01 : 179.99; break;
        case 6: camera.height = coin(random) ? 1e-9 : 1e9; break;
        default: camera.kind = CameraKind::Spherical, camera.rho = 4, camera.phi = 180 * double(random() % 2); break;
    }
}

}  // namespace

Scene strangeScene(unsigned seed) {
    Scene scene = randomScene(seed);
    std::mt19937 random(seed + 7919);
    for (Object& object : scene.objects) makeStrange(object, random);
    for (Light& light : scene.lights) makeStrange(light, scene, random);
    if (coin(random)) makeStrange(scene.camera, random);
    scene.ambient.intensity = strangeNumber(random, 1e9);
    scene.ambient.color = strangeColor(random);
    scene.settings.exponentFactor = std::array{0.0, 1.0, 1000.0}[random() % 3];
    scene.settings.shadowBias = ShadowBias(choice("shadow.bias", random()));
    scene.settings.shadowBiasValue = strangeNumber(random, 1e9);
    scene.settings.shadowCull = ShadowCull(choice("shadow.cull", seed));
    if (random() % 8 == 0) scene.settings.shadowSize = 1;
    if (random() % 8 == 0) scene.settings.width = scene.settings.height = 1;
    if (random() % 8 == 0) scene.lights.clear();
    if (random() % 16 == 0) scene.objects.clear();
    if (coin(random)) scene.settings.forms = randomForms(random);
    scene.settings.subPixelBits = std::array{1, 8, 16}[random() % 3];
    return scene;
}

namespace {

// Any row of the table, so that one that a stage reads and no plan compares is found. The picture stays small; extended and
// quad precision take long, and tests of defects plant them.
void changeSetting(Scene& scene, std::mt19937& random) {
    const std::vector<SettingRef> all = settingsOf(scene);
    const SettingRef& ref = all[random() % all.size()];
    const Setting& row = *ref.setting;
    if (row.group == SettingGroup::Defect) return;
    const bool isFew = row.key == "antialiasing" || row.key == "precision" || row.key.ends_with("samples");
    const double most = std::min(row.high, row.low + (isFew ? 1 : 40));
    const double value = row.kind == SettingKind::Number ? between(random, row.low, row.high)
                                                         : row.low + double(random() % unsigned(most - row.low + 1));
    Scene changed = scene;
    ref.set(changed, value);
    if (checkScene(changed).empty()) scene = std::move(changed);
}

}  // namespace

void changeSomething(Scene& scene, std::mt19937& random) {
    if (random() % 3 == 0) return changeSetting(scene, random);
    Settings& settings = scene.settings;
    Object& object = scene.objects[random() % scene.objects.size()];
    switch (random() % 28) {
        case 0: object.material = randomMaterial(random); break;
        case 1: object.transform.translation = inBox(random, 2); break;
        case 2: object.transform.scale.z = -object.transform.scale.z; break;
        case 3: scene.objects.push_back(randomObject(random)); break;
        case 4:
            if (scene.objects.size() > 1) scene.objects.pop_back();
            break;
        case 5: scene.lights.push_back(randomLight(random)); break;
        case 6:
            if (!scene.lights.empty()) scene.lights.pop_back();
            break;
        case 7:
            if (!scene.lights.empty()) scene.lights[0] = randomLight(random);
            break;
        case 8:
            if (!scene.lights.empty()) scene.lights[0].castsShadow = !scene.lights[0].castsShadow;
            break;
        case 9: settings.shading = Shading(choice("shading", random())); break;
        case 10: settings.cull = CullMode(choice("cull", random())); break;
        case 11: settings.depthFormat = DepthFormat(choice("depth_format", random())); break;
        case 12: scene.camera.eye = inBox(random, 6) + Vec3d(0, 0, 4); break;
        case 13: settings.normalWeight = NormalWeight(choice("normal_weight", random())); break;
        case 14: settings.model = Model(choice("model", random())); break;
        case 15: settings.twoSided = !settings.twoSided; break;
        case 16: settings.visibility = Visibility(choice("visibility", random())); break;
        case 17: settings.rules.flip(random() % kRuleCount); break;
        case 18: object.material.alpha = double(random() % 5) / 4; break;
        case 19: object.material.alpha = between(random, 0, 1); break;
        case 20: settings.translucency = Translucency(choice("translucency", random())); break;
        case 21: settings.interpolation = Interpolation(choice("interpolation", random())); break;
        case 23: settings.forms = randomForms(random); break;
        case 27: settings.shadowCull = ShadowCull(choice("shadow.cull", random())); break;
        case 24: settings.subPixelBits = 1 + int(random() % 16); break;
        case 25:
            settings.antialiasing = 1 + int(random() % 2),
            settings.antialiasingPattern = SamplePattern(choice("antialiasing_pattern", random()));
            break;
        case 22: settings.width = 60 + int(random() % 60); break;
        default: settings.shadowFilter = int(random() % 3); break;
    }
}

std::string buffersWithoutNumbers(const Frame& frame) {
    std::string names;
    for (const AnyBuffer& buffer : frame.buffers()) {
        const BufferStatistics s = statistics(buffer);
        const BufferId id = buffer.name.id;
        const bool depth = id == BufferId::Depth || id == BufferId::ZView || id == BufferId::ShadowBuffer;
        if (s.nan > 0 || (!depth && s.infinite > 0)) names += buffer.name.text() + ' ';
    }
    return names;
}

std::string firstDifference(const Frame& a, const Frame& b, BufferSet compared) {
    for (const BufferName& name : allBuffers(a.scene().lights.size())) {
        if (!compared[index(name.id)]) continue;
        const auto x = a.buffer(name), y = b.buffer(name);
        if (bool(x) != bool(y)) return name.text() + " is there in one frame only";
        if (!x) continue;
        if (x->shape != y->shape || std::string(x->dtype()) != y->dtype()) return name.text() + " has another shape";
        for (std::size_t i = 0; i < x->count(); ++i) {
            const double p = x->flat(i), q = y->flat(i);
            if (std::memcmp(&p, &q, sizeof p) != 0)
                return name.text() + " number " + std::to_string(i) + ": " + std::to_string(p) + " and " +
                       std::to_string(q);
        }
    }
    return {};
}

// Polygons of three corners and more side by side, one of so many that its triangles do not fit into the room for sums, some
// of them turned inside out, thin as a line, or behind the eye; and once more mirrored.
Scene polygonsOfAllSizes() {
    Scene scene = spheres();
    Mesh mesh;
    const auto add = [&](std::size_t corners, Vec3d middle, double radius, double width, bool turned) {
        std::vector<std::uint32_t> polygon;
        for (std::size_t i = 0; i < corners; ++i) {
            const double angle = (turned ? -1 : 1) * 2 * std::numbers::pi * double(i) / double(corners);
            polygon.push_back(std::uint32_t(mesh.positions.size()));
            mesh.positions.push_back(
                middle + radius * Vec3d(std::cos(angle), width * std::sin(angle), 0.1 * std::sin(3 * angle)));
        }
        mesh.addPolygon(polygon);
    };
    for (std::size_t n = 0; n < 300; ++n) {
        const std::size_t corners = n == 100 ? 300 : n == 200 ? 258 : n % 40 == 7 ? 12 : 3 + n % 4;
        add(corners, Vec3d(double(n % 20) - 10, double(n / 20) - 7, double(n % 3) * 40 - 40), 0.1 + double(n % 5),
            n % 11 == 0 ? 0 : 1, n % 2 == 0);
    }
    scene.objects.resize(1);
    scene.objects[0].mesh = makeMesh(std::move(mesh));
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].transform.scale.x = -scene.objects[1].transform.scale.x;
    return scene;
}

}  // namespace test
