// A second student's renderer, in single precision, with the matrices of a graphics library: written from the lectures'
// formulas, without any of Shadescope's code.
//
//   renderer SCENE FOLDER [--size 160x120] [--shading flat|gouraud|phong] [--near N] [--halfway I,J] [--no-shadow]
//            [--error NAME] [--color-only] [CONVENTION...]
//
// It reads lecture 1's two files and writes vertices and polygons as .csv, depth and z as .pfm, the rest as .npy, the picture
// as .ppm in text. --list names the errors: name, what it is in the program's table (- for none), where it shows first.
#include <sys/stat.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

struct V {
    float x = 0, y = 0, z = 0;
};
V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
V operator-(V a) { return {-a.x, -a.y, -a.z}; }
V operator*(float s, V a) { return {s * a.x, s * a.y, s * a.z}; }
V operator*(V a, V b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
float dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
V cross(V a, V b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
float length(V a) { return std::sqrt(dot(a, a)); }
V normalize(V a) {
    const float l = length(a);
    return l > 0 ? (1 / l) * a : a;
}
V reflect(V i, V n) { return i - (2 * dot(n, i)) * n; }  // as in GLSL

struct M {  // row by row
    std::array<V, 3> r{V{1, 0, 0}, V{0, 1, 0}, V{0, 0, 1}};
    V operator*(V a) const { return {dot(r[0], a), dot(r[1], a), dot(r[2], a)}; }
    M transposed() const { return {{V{r[0].x, r[1].x, r[2].x}, V{r[0].y, r[1].y, r[2].y}, V{r[0].z, r[1].z, r[2].z}}}; }
    M operator*(const M& o) const {
        const M t = o.transposed();
        M out;
        for (int i = 0; i < 3; ++i) out.r[i] = {dot(r[i], t.r[0]), dot(r[i], t.r[1]), dot(r[i], t.r[2])};
        return out;
    }
    M inverseTransposed() const {
        const float det = dot(r[0], cross(r[1], r[2]));
        return {{(1 / det) * cross(r[1], r[2]), (1 / det) * cross(r[2], r[0]), (1 / det) * cross(r[0], r[1])}};
    }
};

struct Mistake {
    const char *name, *known, *buffer;
};
const Mistake kMistakes[] = {
    {"translate-first", "trs-order", "vertices.world"},  // M = R S T
    {"sin-of-degrees", "radians", "vertices.world"},     // in rotations and in the camera
    {"flipped-y", "y-down", "vertices.screen"},          // a minus in the projection
    {"front-is-clockwise", "cull-sign", "polygons.visible"},
    {"cull-in-eye-space", "cull-axis", "polygons.visible"},  // z of the normal in eye space
    {"discard-at-near", "near-drop", "polygons.visible"},
    {"cross-about-v1", "normal-flip", "polygons.normal"},  // (v0 - v1) x (v2 - v1)
    {"model-times-normal", "normal-matrix", "polygons.normal"},
    {"transposed-model", "normal-matrix", "polygons.normal"},  // transpose for inverse transpose
    {"normalize-after-dot", "normal-short", "n_dot_l.0"},      // N.L of the interpolated N, then N / |N|
    {"clear-to-distance", "z-clear", "z_view"},
    {"gl-greater", "z-flip", "z_view"},
    {"depth-mask-off", "z-no-write", "z_view"},
    {"screen-linear-z", "z-affine", "z_view"},
    {"affine-varyings", "affine", "normal"},  // all that is interpolated, without 1/w
    {"raw-light", "l-raw", "n_dot_l.0"},
    {"incoming-light", "light-from", "n_dot_l.0"},
    {"light-in-eye-space", "light-in-eye", "n_dot_l.0"},  // N turned into eye space, L not
    {"reflect-of-l", "r-flip", "r_dot_v.0"},
    {"ambient-in-loop", "ambient-per-light", "intensity"},
    {"turn-z-first", "rotation-order", "vertices.world"},  // rotations about z, y, x
    {"both-sides", "no-max", "diffuse.0"},                 // |N.L|
    // In no table.
    {"half-lambert", "half-lambert", "diffuse.0"},  // ((N.L + 1) / 2)^2
    {"neighbour-normal", "-", "vertices.normal"},   // of the vertex before
    {"repeated-rows", "-", "color"},                // each eighth row is the one before
    {"banded", "-", "intensity"},                   // in sixteenths of I_max
    {"swapped-light", "-", "n_dot_l.0"},            // y and z of the light's direction
};

struct Options {
    int width = 160, height = 120;
    float near = 0, far = 0;
    std::string shading = "flat", error, rows = "top-down", channels = "rgb", encoding = "linear", depth = "view";
    std::string normals = "world", ids = "0", verdicts = "kept", sample = "centre", halfway;
    bool shadow = true, colorOnly = false;
    bool wrong(const char* name) const { return error == name; }
    bool halfwayOf(int object) const {
        return ("," + halfway + ",").find("," + std::to_string(object) + ",") != std::string::npos;
    }
} o;

struct Tokens {
    std::vector<std::string> words;
    std::size_t at = 0;
    explicit Tokens(const std::string& file) {
        std::ifstream in(file);
        if (!in) std::cerr << file << ": cannot be read\n", std::exit(3);
        for (std::string line; std::getline(in, line);) {
            line = line.substr(0, line.find("//"));
            for (char& c : line)
                if (c == ',' || c == '(' || c == ')') c = ' ';
            std::istringstream in_line(line);
            words.insert(words.end(), std::istream_iterator<std::string>(in_line), {});
        }
    }
    std::string word() { return words.at(at++); }
    float number() { return std::stof(word()); }
    V vector() {
        const float x = number(), y = number();
        return {x, y, number()};
    }
};

float sinOf(float degrees) { return std::sin(o.wrong("sin-of-degrees") ? degrees : degrees * float(M_PI) / 180); }
float cosOf(float degrees) { return std::cos(o.wrong("sin-of-degrees") ? degrees : degrees * float(M_PI) / 180); }

struct Material {
    V kd;
    float ks, n;
};
struct Polygon {
    std::vector<int> vertices;
    int object;
    V normal;
    bool visible;
};
struct Light {
    V place;
    float power;
};

std::vector<V> world, view, vertexNormal;
std::vector<Polygon> polygons;
std::vector<Material> materials;
std::vector<Light> lights;
float screenDistance, rho, ambient;
M eyeFromWorld;
V eye;

void readObject(const std::string& file, V scale, V turn, V move) {
    Tokens in(file);
    const int points = int(in.number()), faces = int(in.number()), first = int(world.size());
    const float sx = sinOf(turn.x), cx = cosOf(turn.x), sy = sinOf(turn.y), cy = cosOf(turn.y), sz = sinOf(turn.z),
                cz = cosOf(turn.z);
    const M rx{{V{1, 0, 0}, V{0, cx, -sx}, V{0, sx, cx}}}, ry{{V{cy, 0, sy}, V{0, 1, 0}, V{-sy, 0, cy}}};
    const M rz{{V{cz, -sz, 0}, V{sz, cz, 0}, V{0, 0, 1}}}, s{{V{scale.x, 0, 0}, V{0, scale.y, 0}, V{0, 0, scale.z}}};
    const M model = o.wrong("turn-z-first") ? rx * (ry * (rz * s)) : rz * (ry * (rx * s));
    std::vector<V> local;
    for (int i = 0; i < points; ++i) {
        const V p = in.vector();
        local.push_back(p);
        world.push_back(o.wrong("translate-first") ? model * (p + move) : model * p + move);
    }
    const M normalMatrix = o.wrong("model-times-normal") ? model
                           : o.wrong("transposed-model") ? model.transposed()
                                                         : model.inverseTransposed();
    for (int i = 0; i < faces; ++i) {
        Polygon p{{}, int(materials.size()), {}, true};
        std::vector<V> corners;
        for (int n = int(in.number()); n > 0; --n) {
            const int v = int(in.number());
            p.vertices.push_back(first + v), corners.push_back(local[std::size_t(v)]);
        }
        const V n = o.wrong("cross-about-v1") ? cross(corners[0] - corners[1], corners[2] - corners[1])
                                              : cross(corners[1] - corners[0], corners[2] - corners[0]);
        p.normal = normalize(normalMatrix * n);
        polygons.push_back(p);
    }
    const V kd = in.vector();
    const float ks = in.number();
    materials.push_back({kd, ks, in.number()});
}

void readScene(const std::string& file) {
    Tokens in(file);
    screenDistance = in.number(), rho = in.number();
    const float theta = in.number(), phi = in.number();
    const float st = sinOf(theta), ct = cosOf(theta), sp = sinOf(phi), cp = cosOf(phi);
    eyeFromWorld = {{V{-st, ct, 0}, V{-cp * ct, -cp * st, sp}, V{-sp * ct, -sp * st, -cp}}};
    eye = -rho * eyeFromWorld.r[2];
    const std::string folder = file.substr(0, file.find_last_of('/') + 1);
    for (int n = int(in.number()); n > 0; --n) {
        const std::string name = folder + in.word();
        const V scale = in.vector(), turn = in.vector();
        readObject(name, scale, turn, in.vector());
    }
    for (int n = int(in.number()); n > 0; --n) {
        const V place = in.vector();
        lights.push_back({place, in.number()});
    }
    ambient = in.number();
}

V project(V v) {
    const float y = screenDistance * v.y / v.z;
    return {float(o.width) / 2 + screenDistance * v.x / v.z, float(o.height) / 2 + (o.wrong("flipped-y") ? y : -y),
            v.z};
}

// What is interpolated over a triangle.
struct Corner {
    V view, world, normal;
    std::vector<V> lit;  // Gouraud: as lit() gives it
};
Corner mix(const Corner& a, const Corner& b, float t) {
    Corner c{
        a.view + t * (b.view - a.view), a.world + t * (b.world - a.world), a.normal + t * (b.normal - a.normal), {}};
    for (std::size_t i = 0; i < a.lit.size(); ++i) c.lit.push_back(a.lit[i] + t * (b.lit[i] - a.lit[i]));
    return c;
}
std::vector<Corner> clipNear(const std::vector<Corner>& in) {
    std::vector<Corner> out;
    for (std::size_t i = 0; i < in.size(); ++i) {
        const Corner &a = in[i], &b = in[(i + 1) % in.size()];
        const float da = a.view.z - o.near, db = b.view.z - o.near;
        if (da >= 0) out.push_back(a);
        if ((da >= 0) != (db >= 0)) out.push_back(mix(a, b, da / (da - db)));
    }
    return out;
}

// ambient, then for each light diffuse, specular, (N.L, R.V, S)
std::vector<V> lit(V p, V n, int object) {
    const Material& m = materials[std::size_t(object)];
    const V v = normalize(eye - p);
    const V sharp = o.wrong("normalize-after-dot") ? normalize(n) : n;
    std::vector<V> terms{ambient * m.kd};
    for (const Light& light : lights) {
        V l = o.wrong("swapped-light") ? V{light.place.x, light.place.z, light.place.y} : light.place;
        if (!o.wrong("raw-light")) l = normalize(l);
        if (o.wrong("incoming-light")) l = -l;
        const V shaded = o.wrong("light-in-eye-space") ? eyeFromWorld * n : n;
        const float nl = dot(shaded, l);
        const V r = o.wrong("reflect-of-l")         ? reflect(l, sharp)
                    : o.wrong("light-in-eye-space") ? reflect(-l, shaded)
                                                    : reflect(-l, sharp);
        const float rv = dot(r, v), nh = dot(sharp, normalize(l + v));
        const float lambert = o.wrong("both-sides")     ? std::fabs(nl)
                              : o.wrong("half-lambert") ? (nl + 1) * (nl + 1) / 4
                                                        : std::max(nl, 0.f);
        const float c = o.halfwayOf(object) ? nh : rv;
        const float shine = nl > 0 && c > 0 ? std::pow(c, m.n) : 0;
        terms.push_back((light.power * lambert) * m.kd);
        const float s = light.power * m.ks * shine;
        terms.push_back({s, s, s});
        terms.push_back({nl, rv, 1});
    }
    return terms;
}

struct Pixel {
    int polygon = -1;
    float z = 0;
    V world, normal;
    std::vector<V> lit;
};
std::vector<Pixel> pixels;

void cull() {
    for (Polygon& p : polygons) {
        std::vector<Corner> corners;
        bool before = false;
        for (const int v : p.vertices)
            corners.push_back({view[std::size_t(v)], {}, {}, {}}), before = before || view[std::size_t(v)].z < o.near;
        corners = clipNear(corners);
        float twice = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const V a = project(corners[i].view), b = project(corners[(i + 1) % corners.size()].view);
            twice += a.x * b.y - b.x * a.y;
        }
        p.visible = o.wrong("front-is-clockwise") ? twice > 0 : twice < 0;
        if (o.wrong("cull-in-eye-space")) p.visible = corners.size() > 2 && (eyeFromWorld * p.normal).z < 0;
        if (o.wrong("discard-at-near") && before) p.visible = false;
    }
}

void triangle(int number, const Corner& a, const Corner& b, const Corner& c) {
    const V p[3] = {project(a.view), project(b.view), project(c.view)};
    const auto side = [](V from, V to, float x, float y) {
        return (to.x - from.x) * (y - from.y) - (to.y - from.y) * (x - from.x);
    };
    const float area = side(p[0], p[1], p[2].x, p[2].y);
    if (area == 0) return;
    const float offset = o.sample == "centre" ? 0.5f : 0;
    const int x0 = std::max(0, int(std::floor(std::min({p[0].x, p[1].x, p[2].x}))) - 1);
    const int x1 = std::min(o.width - 1, int(std::ceil(std::max({p[0].x, p[1].x, p[2].x}))) + 1);
    const int y0 = std::max(0, int(std::floor(std::min({p[0].y, p[1].y, p[2].y}))) - 1);
    const int y1 = std::min(o.height - 1, int(std::ceil(std::max({p[0].y, p[1].y, p[2].y}))) + 1);
    const Corner* corner[3] = {&a, &b, &c};
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            const float sx = float(x) + offset, sy = float(y) + offset;
            float share[3] = {side(p[1], p[2], sx, sy) / area, side(p[2], p[0], sx, sy) / area,
                              side(p[0], p[1], sx, sy) / area};
            if (share[0] < 0 || share[1] < 0 || share[2] < 0) continue;
            const float linear = share[0] * p[0].z + share[1] * p[1].z + share[2] * p[2].z;
            const float true_ = 1 / (share[0] / p[0].z + share[1] / p[1].z + share[2] / p[2].z);
            const float z = o.wrong("screen-linear-z") ? linear : true_;
            Pixel& pixel = pixels[std::size_t(y * o.width + x)];
            if (o.wrong("gl-greater") ? !(z > pixel.z) : !(z < pixel.z)) continue;
            if (!o.wrong("depth-mask-off")) pixel.z = z;
            if (!o.wrong("affine-varyings"))
                for (int i = 0; i < 3; ++i) share[i] *= true_ / p[i].z;
            pixel.polygon = number;
            pixel.world = pixel.normal = {};
            pixel.lit.assign(a.lit.size(), {});
            for (int i = 0; i < 3; ++i) {
                pixel.world = pixel.world + share[i] * corner[i]->world;
                pixel.normal = pixel.normal + share[i] * corner[i]->normal;
                for (std::size_t k = 0; k < a.lit.size(); ++k)
                    pixel.lit[k] = pixel.lit[k] + share[i] * corner[i]->lit[k];
            }
        }
    }
}

// S of a light at infinity: whether a ray to it meets another polygon. Moeller and Trumbore.
float shadowAt(V p, int number, V light) {
    const V to = normalize(light);
    const auto at = [](const Polygon& q, std::size_t i) { return world[std::size_t(q.vertices[i])]; };
    const Polygon& own = polygons[std::size_t(number)];
    if (dot(cross(at(own, 1) - at(own, 0), at(own, 2) - at(own, 0)), to) <= 0) return 0;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        if (int(i) == number) continue;
        for (std::size_t j = 1; j + 1 < polygons[i].vertices.size(); ++j) {
            const V a = at(polygons[i], 0), e1 = at(polygons[i], j) - a, e2 = at(polygons[i], j + 1) - a;
            const V h = cross(to, e2);
            const float det = dot(e1, h);
            if (std::fabs(det) < 1e-9f) continue;
            const V s = p - a, q = cross(s, e1);
            const float u = dot(s, h) / det, v = dot(to, q) / det;
            if (u >= 0 && v >= 0 && u + v <= 1 && dot(e2, q) / det > 1e-4f) return 0;
        }
    }
    return 1;
}

std::vector<std::vector<V>> terms;  // per pixel
std::vector<V> normals, intensity;

void draw() {
    const float cleared = o.wrong("clear-to-distance") ? rho
                          : o.wrong("gl-greater")      ? 0
                                                       : std::numeric_limits<float>::infinity();
    pixels.assign(std::size_t(o.width * o.height), {});
    for (Pixel& pixel : pixels) pixel.z = cleared;
    for (std::size_t number = 0; number < polygons.size(); ++number) {
        const Polygon& p = polygons[number];
        if (!p.visible) continue;
        std::vector<Corner> corners;
        for (const int v : p.vertices) {
            const auto i = std::size_t(v);
            corners.push_back({view[i], world[i], vertexNormal[i], {}});
            if (o.shading == "gouraud") corners.back().lit = lit(world[i], vertexNormal[i], p.object);
        }
        corners = clipNear(corners);
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
            triangle(int(number), corners[0], corners[i], corners[i + 1]);
    }
    const float iMax = [] {
        float kd = 0, ks = 0, sum = 0;
        for (const Material& m : materials) kd = std::max({kd, m.kd.x, m.kd.y, m.kd.z}), ks = std::max(ks, m.ks);
        for (const Light& l : lights) sum += l.power;
        return kd * ambient + sum * (kd + ks);
    }();
    normals.assign(pixels.size(), {}), intensity.assign(pixels.size(), {});
    terms.assign(pixels.size(), std::vector<V>(1 + 3 * lights.size()));
    for (std::size_t at = 0; at < pixels.size(); ++at) {
        const Pixel& pixel = pixels[at];
        if (pixel.polygon < 0) continue;
        const Polygon& p = polygons[std::size_t(pixel.polygon)];
        V n = o.shading == "flat" ? p.normal : o.wrong("normalize-after-dot") ? pixel.normal : normalize(pixel.normal);
        if (o.shading == "flat") {
            V middle;
            for (const int v : p.vertices) middle = middle + (1 / float(p.vertices.size())) * world[std::size_t(v)];
            terms[at] = lit(middle, n, p.object);
        } else if (o.shading == "phong") {
            terms[at] = lit(pixel.world, n, p.object);
        } else {
            terms[at] = pixel.lit;
        }
        normals[at] = normalize(n);
        V sum = terms[at][0];
        for (std::size_t k = 0; k < lights.size(); ++k) {
            const float s = o.shadow ? shadowAt(pixel.world, pixel.polygon, lights[k].place) : 1;
            terms[at][3 * k + 1] = s * terms[at][3 * k + 1], terms[at][3 * k + 2] = s * terms[at][3 * k + 2];
            terms[at][3 * k + 3].z = s;
            sum = sum + (terms[at][3 * k + 1] + terms[at][3 * k + 2]);
            if (o.wrong("ambient-in-loop") && k > 0) sum = sum + terms[at][0];
        }
        if (o.wrong("banded"))
            for (float* c : {&sum.x, &sum.y, &sum.z}) *c = std::floor(16 * *c / iMax) / 16 * iMax;
        intensity[at] = sum;
    }
    for (V& i : intensity) i = (1 / iMax) * i;  // as shares; written times iMax
    for (V& i : normals)
        if (o.normals == "view") i = eyeFromWorld * i;
    intensity.push_back({iMax, 0, 0});
}

std::string folder;
std::ofstream open(const std::string& name) {
    std::ofstream file(folder + "/" + name, std::ios::binary);
    if (!file) std::cerr << folder << "/" << name << ": cannot be written\n", std::exit(4);
    return file;
}
std::size_t row(int y) { return std::size_t((o.rows == "top-down" ? y : o.height - 1 - y) * o.width); }

// get(pixel, channel)
template <class T, class Get>
void npy(const std::string& name, int channels, const char* type, Get get) {
    std::ostringstream head;
    head << "{'descr': '" << type << "', 'fortran_order': False, 'shape': (" << o.height << ", " << o.width;
    if (channels > 1) head << ", " << channels;
    head << "), }";
    std::string text = head.str();
    text += std::string(63 - (text.size() + 10) % 64, ' ') + "\n";
    std::ofstream file = open(name + ".npy");
    file << "\x93NUMPY" << '\x01' << '\0' << char(text.size() & 255) << char(text.size() >> 8) << text;
    for (int y = 0; y < o.height; ++y)
        for (int x = 0; x < o.width; ++x)
            for (int c = 0; c < channels; ++c) {
                const T value = T(get(row(y) + std::size_t(x), c));
                file.write(reinterpret_cast<const char*>(&value), sizeof value);
            }
}
float part(V v, int c) { return c == 0 ? v.x : c == 1 ? v.y : v.z; }

// Portable float map: its rows run upwards in the file.
template <class Get>
void pfm(const std::string& name, Get get) {
    std::ofstream file = open(name + ".pfm");
    file << "Pf\n" << o.width << " " << o.height << "\n-1.0\n";
    for (int y = o.height; y-- > 0;)
        for (int x = 0; x < o.width; ++x) {
            const float value = get(row(y) + std::size_t(x));
            file.write(reinterpret_cast<const char*>(&value), sizeof value);
        }
}

void csv(const std::string& name, const std::vector<V>& rows) {
    std::ofstream file = open(name + ".csv");
    file.precision(9);
    for (const V v : rows) file << v.x << "," << v.y << "," << v.z << "\n";
}

float coded(const Pixel& pixel) {
    const bool empty = pixel.polygon < 0 || !(pixel.z > 0);
    if (o.depth == "view") return pixel.z;
    if (o.depth == "distance") return empty ? std::numeric_limits<float>::infinity() : length(pixel.world - eye);
    if (o.depth == "inverse") return empty ? 0 : 1 / pixel.z;
    const float window = empty ? 1 : o.far / (o.far - o.near) - o.far * o.near / ((o.far - o.near) * pixel.z);
    return o.depth == "ndc" ? 2 * window - 1 : o.depth == "reversed" ? 1 - window : window;
}

void write() {
    const float iMax = intensity.back().x;
    std::ofstream picture = open("color.ppm");
    picture << "P3\n" << o.width << " " << o.height << "\n255\n";
    for (int y = 0; y < o.height; ++y) {
        const int from = o.wrong("repeated-rows") && y % 8 == 7 ? y - 1 : y;
        for (int x = 0; x < o.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                float share = part(intensity[row(from) + std::size_t(x)], o.channels == "rgb" ? c : 2 - c);
                share = std::min(std::max(share, 0.f), 1.f);
                if (o.encoding == "srgb")
                    share = share <= 0.0031308f ? 12.92f * share : 1.055f * std::pow(share, 1 / 2.4f) - 0.055f;
                picture << int(255 * share + 0.5f) << " ";
            }
        }
        picture << "\n";
    }
    if (o.colorOnly) return;
    std::vector<V> screen;
    for (const V v : view) screen.push_back(v.z > 1e-6f ? project(v) : V{-1e30f, -1e30f, -1e30f});
    csv("vertices.world", world), csv("vertices.view", view), csv("vertices.screen", screen);
    std::ofstream visible = open("polygons.visible.csv");
    std::vector<V> facing;
    for (const Polygon& p : polygons) {
        visible << (p.visible == (o.verdicts == "kept") ? 1 : 0) << "\n";
        facing.push_back(o.normals == "view" ? eyeFromWorld * p.normal : p.normal);
    }
    csv("polygons.normal", facing);
    if (o.shading != "flat") {
        for (V& n : vertexNormal)
            if (o.normals == "view") n = eyeFromWorld * n;
        csv("vertices.normal", vertexNormal);
    }
    pfm(o.depth == "view" ? "z_view" : "depth", [](std::size_t at) { return coded(pixels[at]); });
    npy<std::int32_t>("polygon_id", 1, "<i4", [](std::size_t at, int) {
        const int id = pixels[at].polygon;
        if (id < 0) return o.ids == "1" ? 0 : -1;
        return o.ids == "permuted" ? (11 * id + 5) % 1013 : o.ids == "1" ? id + 1 : id;
    });
    npy<float>("normal", 3, "<f4", [](std::size_t at, int c) {
        const float n = part(normals[at], c);
        return o.normals == "rgb" && pixels[at].polygon >= 0 ? (n + 1) / 2 : n;
    });
    npy<float>("ambient", 3, "<f4", [](std::size_t at, int c) { return part(terms[at][0], c); });
    npy<float>("intensity", 3, "<f4", [&](std::size_t at, int c) { return iMax * part(intensity[at], c); });
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const std::string of = "." + std::to_string(k);
        npy<float>("diffuse" + of, 3, "<f4", [&](std::size_t at, int c) { return part(terms[at][3 * k + 1], c); });
        npy<float>("specular" + of, 3, "<f4", [&](std::size_t at, int c) { return part(terms[at][3 * k + 2], c); });
        npy<float>("n_dot_l" + of, 1, "<f4", [&](std::size_t at, int) { return terms[at][3 * k + 3].x; });
        npy<float>("r_dot_v" + of, 1, "<f4", [&](std::size_t at, int) { return terms[at][3 * k + 3].y; });
        npy<float>("shadow" + of, 1, "<f4",
                   [&](std::size_t at, int) { return pixels[at].polygon < 0 ? 1 : terms[at][3 * k + 3].z; });
    }
}

int main(int argc, char** argv) {
    std::vector<std::string> names;
    const std::map<std::string, std::string*> texts{
        {"--shading", &o.shading},   {"--error", &o.error},   {"--rows", &o.rows},       {"--channels", &o.channels},
        {"--encoding", &o.encoding}, {"--depth", &o.depth},   {"--normals", &o.normals}, {"--ids", &o.ids},
        {"--verdicts", &o.verdicts}, {"--sample", &o.sample}, {"--halfway", &o.halfway}};
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const auto text = texts.find(word);
        if (word == "--list") {
            for (const Mistake& m : kMistakes) std::cout << m.name << " " << m.known << " " << m.buffer << "\n";
            return 0;
        }
        if (word == "--no-shadow") {
            o.shadow = false;
        } else if (word == "--color-only") {
            o.colorOnly = true;
        } else if (text != texts.end() && i + 1 < argc) {
            *text->second = argv[++i];
        } else if (word == "--near" && i + 1 < argc) {
            o.near = std::stof(argv[++i]);
        } else if (word == "--planes" && i + 1 < argc) {
            std::sscanf(argv[++i], "%f,%f", &o.near, &o.far);
        } else if (word == "--size" && i + 1 < argc) {
            std::sscanf(argv[++i], "%dx%d", &o.width, &o.height);
        } else if (word.rfind("--", 0) == 0) {
            std::cerr << "renderer: no option " << word << "\n";
            return 2;
        } else {
            names.push_back(word);
        }
    }
    const auto known = [](const Mistake& m) { return o.error == m.name; };
    if (names.size() != 2 || (!o.error.empty() && std::none_of(std::begin(kMistakes), std::end(kMistakes), known))) {
        std::cerr << "renderer SCENE FOLDER [OPTION...]; --list names the errors\n";
        return 2;
    }
    readScene(names[0]);
    folder = names[1];
    mkdir(folder.c_str(), 0777);
    float farthest = 0, nearest = std::numeric_limits<float>::infinity();
    for (const V p : world) {
        V v = eyeFromWorld * p;
        v.z += rho;
        view.push_back(v);
        farthest = std::max(farthest, v.z), nearest = std::min(nearest, v.z);
    }
    if (o.far == 0) o.far = farthest;
    if (o.near == 0) o.near = std::max(nearest, 1e-3f * rho);
    vertexNormal.assign(world.size(), {});
    for (const Polygon& p : polygons)
        for (const int v : p.vertices) vertexNormal[std::size_t(v)] = vertexNormal[std::size_t(v)] + p.normal;
    for (V& n : vertexNormal) n = normalize(n);
    if (o.wrong("neighbour-normal")) std::rotate(vertexNormal.begin(), vertexNormal.end() - 1, vertexNormal.end());
    cull();
    draw();
    write();
}
