/* A fourth student's renderer, in C and single precision: Phong shading with the shadow z-buffer of the lectures, rows from the
   bottom as glReadPixels gives them, window depth. Written from the lectures; no code of Shadescope's is in it.

     renderer SCENE FOLDER [--size 320x240] [--planes N,F] [--error NAME] [--rows top-down] [--no-shadow] [--list] */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* name, what it is in the program's table (- for none), the stage, the buffer where it shows first */
static const char *const kErrors[][4] = {
    {"matrix-transposed", "view-transposed", "transform", "vertices.view"},
    {"y-not-flipped", "y-down", "transform", "vertices.screen"},
    {"degrees-as-radians", "radians", "transform", "vertices.view"},
    {"cull-towards-light", "cull-light", "cull", "polygons.visible"},
    {"other-winding", "cull-sign", "cull", "polygons.visible"},
    {"normals-of-the-file", "normals-untouched", "normals", "vertices.normal"}, /* never turned with the object */
    {"first-corner", "one-normal", "shading", "normal"},                       /* one vertex's normal for a polygon */
    {"z-in-a-line", "z-affine", "z-buffer", "depth"},
    {"forgot-to-write", "z-no-write", "z-buffer", "depth"},
    {"without-perspective", "affine", "shading", "normal"}, /* everything but z */
    {"bias-added", "bias-sign", "shading", "color"},
    {"bias-missing", "no-bias", "shading", "color"},
    {"bias-huge", "big-bias", "shading", "color"},
    {"no-shadows", "no-shadow", "shading", "color"},
    {"map-upside-down", "shadow-flip", "shading", "color"},
    {"shadow-is-black", "ambient-in-shadow", "shading", "color"},
    {"shadow-shines", "spec-in-shadow", "shading", "color"},
    {"v-from-eye", "v-reversed", "shading", "color"},
    {"r-in-brackets", "r-parenthesis", "shading", "color"}, /* 2 (N.L) (N - L) */
    {"power-as-factor", "times-n", "shading", "color"},
};

typedef struct { float x, y, z; } V;
typedef struct { V view, world, normal; } Corner;
typedef struct { int corners[8], count, object; V normal; int visible; } Polygon;
typedef struct { V kd; float ks, n; } Material;

enum { kMost = 4096, kMap = 1024 };
static V world[kMost], local[kMost], eyeSpace[kMost], smooth[kMost];
static Polygon polygons[kMost];
static Material materials[64];
static V lightTo[8];
static float lightPower[8], ambient, distance_, rho, theta, phi, nearPlane = 4, farPlane = 40;
static int vertexCount, polygonCount, objectCount, lightCount, width = 320, height = 240, bottomUp = 1, shadows = 1;
static const char *error = "";
/* Several errors at once: one+another. */
static int wrong(const char *name) {
    size_t length = strlen(name);
    for (const char *at = error; *at; at += *at == '+') {
        size_t word = strcspn(at, "+");
        if (word == length && strncmp(at, name, length) == 0) return 1;
        at += word;
    }
    return 0;
}

static V vec(float x, float y, float z) { V v = {x, y, z}; return v; }
static V plus(V a, V b) { return vec(a.x + b.x, a.y + b.y, a.z + b.z); }
static V minus(V a, V b) { return vec(a.x - b.x, a.y - b.y, a.z - b.z); }
static V by(float s, V a) { return vec(s * a.x, s * a.y, s * a.z); }
static float dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static V cross(V a, V b) { return vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x); }
static V unit(V a) { float l = sqrtf(dot(a, a)); return l > 0 ? by(1 / l, a) : a; }

static char words[1 << 20];
static char *next;
static void open_words(const char *file) {
    FILE *in = fopen(file, "r");
    if (!in) { fprintf(stderr, "%s: cannot be read\n", file); exit(3); }
    size_t n = fread(words, 1, sizeof words - 1, in);
    words[n] = 0;
    fclose(in);
    for (char *c = words; *c; ++c)
        if (c[0] == '/' && c[1] == '/')
            while (*c && *c != '\n') *c++ = ' ';
    for (char *c = words; *c; ++c)
        if (*c == ',' || *c == '(' || *c == ')') *c = ' ';
    next = words;
}
static float number(void) { return strtof(next, &next); }
static V vector(void) { V v; v.x = number(); v.y = number(); v.z = number(); return v; }

/* The rows of the two matrices. */
static V axis[3], eye;

static float angle(float degrees) { return wrong("degrees-as-radians") ? degrees : degrees * 3.14159265f / 180; }

static V turned(V p, V turn) {
    float s = sinf(turn.x), c = cosf(turn.x), a, b;
    a = p.y * c - p.z * s, b = p.y * s + p.z * c, p.y = a, p.z = b;
    s = sinf(turn.y), c = cosf(turn.y), a = p.x * c + p.z * s, b = -p.x * s + p.z * c, p.x = a, p.z = b;
    s = sinf(turn.z), c = cosf(turn.z), a = p.x * c - p.y * s, b = p.x * s + p.y * c, p.x = a, p.y = b;
    return p;
}

static void read_object(const char *file, V scale, V turn, V move) {
    open_words(file);
    int points = (int)number(), faces = (int)number(), first = vertexCount;
    for (int i = 0; i < points; ++i) {
        V p = vector();
        local[vertexCount] = p;
        world[vertexCount++] = plus(turned(vec(p.x * scale.x, p.y * scale.y, p.z * scale.z), turn), move);
    }
    for (int i = 0; i < faces; ++i) {
        Polygon *p = &polygons[polygonCount++];
        p->count = (int)number(), p->object = objectCount;
        for (int c = 0; c < p->count; ++c) p->corners[c] = first + (int)number();
    }
    Material *m = &materials[objectCount++];
    m->kd = vector(), m->ks = number(), m->n = number();
}

static void read_scene(const char *file) {
    open_words(file);
    static char folder[4096], names[64][256], path[sizeof folder + 256];
    static V scales[64], turns[64], moves[64];
    snprintf(folder, sizeof folder, "%s", file);
    char *slash = strrchr(folder, '/');
    if (slash) slash[1] = 0; else folder[0] = 0;
    distance_ = number(), rho = number(), theta = angle(number()), phi = angle(number());
    int objects = (int)number(), used;
    for (int k = 0; k < objects; ++k) {
        sscanf(next, " %255s%n", names[k], &used);
        next += used;
        scales[k] = vector(), turns[k] = vector(), moves[k] = vector();
        if (!wrong("degrees-as-radians")) turns[k] = by(3.14159265f / 180, turns[k]);
    }
    lightCount = (int)number();
    for (int k = 0; k < lightCount; ++k) lightTo[k] = unit(vector()), lightPower[k] = number();
    ambient = number();
    for (int k = 0; k < objects; ++k) {
        strcat(strcpy(path, folder), names[k]);
        read_object(path, scales[k], turns[k], moves[k]);
    }
}

static V project(V v) {
    float y = distance_ * v.y / v.z;
    return vec(width / 2.0f + distance_ * v.x / v.z, height / 2.0f + (wrong("y-not-flipped") ? y : -y), v.z);
}

static int clip(const Corner *in, int count, Corner *out) {
    int n = 0;
    for (int i = 0; i < count; ++i) {
        const Corner *a = &in[i], *b = &in[(i + 1) % count];
        float da = a->view.z - nearPlane, db = b->view.z - nearPlane;
        if (da >= 0) out[n++] = *a;
        if ((da >= 0) != (db >= 0)) {
            float t = da / (da - db);
            out[n].view = plus(a->view, by(t, minus(b->view, a->view)));
            out[n].world = plus(a->world, by(t, minus(b->world, a->world)));
            out[n++].normal = plus(a->normal, by(t, minus(b->normal, a->normal)));
        }
    }
    return n;
}

static int corners_of(const Polygon *p, Corner *out) {
    Corner in[8];
    for (int c = 0; c < p->count; ++c) {
        int i = p->corners[c];
        in[c].view = eyeSpace[i], in[c].world = world[i];
        in[c].normal = wrong("first-corner") ? smooth[p->corners[0]] : smooth[i];
    }
    return clip(in, p->count, out);
}

/* ---- The shadow z-buffer: the light as viewpoint, in parallel. */
static float map_[kMap * kMap], mapScale, mapBias;
static V mapAxis[3], mapMiddle;
static void light_space(int light) {
    mapAxis[2] = by(-1, lightTo[light]);
    mapAxis[0] = unit(cross(fabsf(mapAxis[2].z) < 0.9f ? vec(0, 0, 1) : vec(1, 0, 0), mapAxis[2]));
    mapAxis[1] = cross(mapAxis[2], mapAxis[0]);
    V low = vec(1e9f, 1e9f, 1e9f), high = vec(-1e9f, -1e9f, -1e9f);
    for (int i = 0; i < vertexCount; ++i) {
        V p = vec(dot(mapAxis[0], world[i]), dot(mapAxis[1], world[i]), dot(mapAxis[2], world[i]));
        low = vec(fminf(low.x, p.x), fminf(low.y, p.y), fminf(low.z, p.z));
        high = vec(fmaxf(high.x, p.x), fmaxf(high.y, p.y), fmaxf(high.z, p.z));
    }
    mapMiddle = by(0.5f, plus(low, high));
    mapScale = (kMap - 4) / fmaxf(high.x - low.x, high.y - low.y);
    mapBias = 2.5f / mapScale;
    if (wrong("bias-added")) mapBias = -mapBias;
    if (wrong("bias-missing")) mapBias = 0;
    if (wrong("bias-huge")) mapBias = 0.3f * (high.z - low.z);
}
static V in_light(V p) {
    return vec(kMap / 2 + mapScale * (dot(mapAxis[0], p) - mapMiddle.x),
               kMap / 2 + mapScale * (dot(mapAxis[1], p) - mapMiddle.y), dot(mapAxis[2], p));
}
static float side(V a, V b, float x, float y) { return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x); }
static void draw_map(void) {
    for (int i = 0; i < kMap * kMap; ++i) map_[i] = 1e30f;
    for (int k = 0; k < polygonCount; ++k)
        for (int j = 1; j + 1 < polygons[k].count; ++j) {
            V a = in_light(world[polygons[k].corners[0]]), b = in_light(world[polygons[k].corners[j]]);
            V c = in_light(world[polygons[k].corners[j + 1]]);
            float area = side(a, b, c.x, c.y);
            if (area == 0) continue;
            int x0 = (int)fminf(a.x, fminf(b.x, c.x)), x1 = (int)fmaxf(a.x, fmaxf(b.x, c.x)) + 1;
            int y0 = (int)fminf(a.y, fminf(b.y, c.y)), y1 = (int)fmaxf(a.y, fmaxf(b.y, c.y)) + 1;
            for (int y = y0 < 0 ? 0 : y0; y <= y1 && y < kMap; ++y)
                for (int x = x0 < 0 ? 0 : x0; x <= x1 && x < kMap; ++x) {
                    float sx = x + 0.5f, sy = y + 0.5f;
                    float u = side(b, c, sx, sy) / area, v = side(c, a, sx, sy) / area, w = 1 - u - v;
                    if (u < 0 || v < 0 || w < 0) continue;
                    float z = u * a.z + v * b.z + w * c.z;
                    if (z < map_[y * kMap + x]) map_[y * kMap + x] = z;
                }
        }
}
static float lit(V p, V n, int light) {
    if (!shadows || wrong("no-shadows")) return 1;
    V at = in_light(p);
    int x = (int)at.x, y = (int)at.y;
    if (wrong("map-upside-down")) y = kMap - 1 - y;
    if (x < 0 || y < 0 || x >= kMap || y >= kMap) return 1;
    float nl = dot(n, lightTo[light]), slope = nl > 0.15f ? sqrtf(1 - nl * nl) / nl : 6.5f;
    return at.z - mapBias * (0.5f + slope) > map_[y * kMap + x] ? 0 : 1;
}

/* ---- The picture. */
static float zBuffer[2048 * 2048];
static int ids[2048 * 2048];
static V places[2048 * 2048], normals[2048 * 2048], sums[2048 * 2048];

static void triangle(int number_, const Corner *a, const Corner *b, const Corner *c) {
    V p[3] = {project(a->view), project(b->view), project(c->view)};
    float area = side(p[0], p[1], p[2].x, p[2].y);
    if (area == 0) return;
    int x0 = (int)floorf(fminf(p[0].x, fminf(p[1].x, p[2].x))), x1 = (int)ceilf(fmaxf(p[0].x, fmaxf(p[1].x, p[2].x)));
    int y0 = (int)floorf(fminf(p[0].y, fminf(p[1].y, p[2].y))), y1 = (int)ceilf(fmaxf(p[0].y, fmaxf(p[1].y, p[2].y)));
    for (int y = y0 < 0 ? 0 : y0; y <= y1 && y < height; ++y)
        for (int x = x0 < 0 ? 0 : x0; x <= x1 && x < width; ++x) {
            float sx = x + 0.5f, sy = y + 0.5f;
            float w[3] = {side(p[1], p[2], sx, sy) / area, side(p[2], p[0], sx, sy) / area, side(p[0], p[1], sx, sy) / area};
            if (w[0] < 0 || w[1] < 0 || w[2] < 0) continue;
            float z = 1 / (w[0] / p[0].z + w[1] / p[1].z + w[2] / p[2].z);
            float stored = wrong("z-in-a-line") ? w[0] * p[0].z + w[1] * p[1].z + w[2] * p[2].z : z;
            int at = y * width + x;
            if (stored >= zBuffer[at]) continue;
            if (!wrong("forgot-to-write")) zBuffer[at] = stored;
            if (!wrong("without-perspective"))
                for (int i = 0; i < 3; ++i) w[i] *= z / p[i].z;
            ids[at] = number_;
            places[at] = plus(by(w[0], a->world), plus(by(w[1], b->world), by(w[2], c->world)));
            normals[at] = unit(plus(by(w[0], a->normal), plus(by(w[1], b->normal), by(w[2], c->normal))));
        }
}

static void shade(void) {
    for (int k = 0; k < width * height; ++k)
        if (ids[k] >= 0) sums[k] = by(ambient, materials[polygons[ids[k]].object].kd);
    for (int light = 0; light < lightCount; ++light) {
        light_space(light);
        if (shadows) draw_map();
        for (int k = 0; k < width * height; ++k) {
            if (ids[k] < 0) continue;
            const Material *m = &materials[polygons[ids[k]].object];
            V n = normals[k], l = lightTo[light], v = unit(minus(eye, places[k]));
            if (wrong("v-from-eye")) v = by(-1, v);
            float nl = dot(n, l);
            V r = minus(by(2 * nl, n), l);
            if (wrong("r-in-brackets")) r = by(2 * nl, minus(n, l));
            float rv = dot(r, v), s = lit(places[k], polygons[ids[k]].normal, light);
            float shine = 0;
            if (nl > 0 && rv > 0) shine = wrong("power-as-factor") ? rv * m->n : powf(rv, m->n);
            float diffuse = lightPower[light] * s * (nl > 0 ? nl : 0);
            float specular = lightPower[light] * m->ks * shine * (wrong("shadow-shines") ? 1 : s);
            if (s == 0 && nl > 0 && wrong("shadow-is-black")) sums[k] = vec(0, 0, 0);
            sums[k] = plus(sums[k], plus(by(diffuse, m->kd), vec(specular, specular, specular)));
        }
    }
}

/* ---- Files. */
static const char *folder;
static FILE *open_file(const char *name) {
    char path[8192];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *out = fopen(path, "wb");
    if (!out) { fprintf(stderr, "%s: cannot be written\n", path); exit(4); }
    return out;
}
static int row(int y) { return (bottomUp ? height - 1 - y : y) * width; }
static FILE *npy(const char *name, const char *type, int rows, int columns, int channels) {
    char head[256], shape[64];
    FILE *out = open_file(name);
    if (columns == 0) snprintf(shape, sizeof shape, "%d,", rows);
    else if (channels == 1) snprintf(shape, sizeof shape, "%d, %d", rows, columns);
    else snprintf(shape, sizeof shape, "%d, %d, %d", rows, columns, channels);
    int n = snprintf(head, sizeof head, "{'descr': '%s', 'fortran_order': False, 'shape': (%s), }", type, shape);
    while ((n + 11) % 64) head[n++] = ' ';
    head[n++] = '\n';
    fwrite("\x93NUMPY\x01\x00", 1, 8, out);
    fputc(n & 255, out), fputc(n >> 8, out);
    fwrite(head, 1, (size_t)n, out);
    return out;
}
static void vectors(const char *name, const V *values, int count) {
    FILE *out = npy(name, "<f4", count, 3, 1);
    fwrite(values, sizeof(V), (size_t)count, out);
    fclose(out);
}
static int byte_of(float share) {
    share = share < 0 ? 0 : share > 1 ? 1 : share;
    return (int)(255 * share + 0.5f);
}

static void write_files(void) {
    float kd = 0, ks = 0, power = 0;
    for (int i = 0; i < objectCount; ++i) {
        kd = fmaxf(kd, fmaxf(materials[i].kd.x, fmaxf(materials[i].kd.y, materials[i].kd.z)));
        ks = fmaxf(ks, materials[i].ks);
    }
    for (int i = 0; i < lightCount; ++i) power += lightPower[i];
    float iMax = kd * ambient + power * (kd + ks);
    FILE *out = open_file("color.ppm");
    fprintf(out, "P6\n%d %d\n255\n", width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            V i = sums[row(y) + x];
            fputc(byte_of(i.x / iMax), out), fputc(byte_of(i.y / iMax), out), fputc(byte_of(i.z / iMax), out);
        }
    fclose(out);
    out = npy("depth.npy", "<f4", height, width, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            float z = zBuffer[row(y) + x], f = farPlane, n = nearPlane;
            float window = isinf(z) ? 1 : f / (f - n) - f * n / ((f - n) * z);
            fwrite(&window, sizeof window, 1, out);
        }
    fclose(out);
    out = npy("normal.npy", "<f4", height, width, 3);
    for (int y = 0; y < height; ++y) fwrite(&normals[row(y)], sizeof(V), (size_t)width, out);
    fclose(out);
    out = npy("polygon_id.npy", "<i4", height, width, 1);
    for (int y = 0; y < height; ++y) fwrite(&ids[row(y)], sizeof(int), (size_t)width, out);
    fclose(out);
    static V screen[kMost], facing[kMost];
    for (int i = 0; i < vertexCount; ++i) {
        screen[i] = eyeSpace[i].z > 1e-6f ? project(eyeSpace[i]) : vec(-1e30f, -1e30f, 0);
        screen[i].z = 0;
    }
    vectors("vertices.world.npy", world, vertexCount);
    vectors("vertices.view.npy", eyeSpace, vertexCount);
    vectors("vertices.screen.npy", screen, vertexCount);
    vectors("vertices.normal.npy", smooth, vertexCount);
    for (int i = 0; i < polygonCount; ++i) facing[i] = polygons[i].normal;
    vectors("polygons.normal.npy", facing, polygonCount);
    out = npy("polygons.visible.npy", "<i4", polygonCount, 0, 1);
    for (int i = 0; i < polygonCount; ++i) {
        int32_t visible = polygons[i].visible;
        fwrite(&visible, sizeof visible, 1, out);
    }
    fclose(out);
}

int main(int count, char **words_) {
    const char *names[2] = {0, 0};
    int named = 0, known = 0, errors = (int)(sizeof kErrors / sizeof *kErrors);
    for (int i = 1; i < count; ++i) {
        if (!strcmp(words_[i], "--list")) {
            for (int e = 0; e < errors; ++e)
                printf("%s %s %s %s\n", kErrors[e][0], kErrors[e][1], kErrors[e][2], kErrors[e][3]);
            return 0;
        }
        if (!strcmp(words_[i], "--no-shadow")) shadows = 0;
        else if (!strcmp(words_[i], "--error") && i + 1 < count) error = words_[++i];
        else if (!strcmp(words_[i], "--rows") && i + 1 < count) bottomUp = strcmp(words_[++i], "top-down") != 0;
        else if (!strcmp(words_[i], "--size") && i + 1 < count) sscanf(words_[++i], "%dx%d", &width, &height);
        else if (!strcmp(words_[i], "--planes") && i + 1 < count) sscanf(words_[++i], "%f,%f", &nearPlane, &farPlane);
        else if (named < 2) names[named++] = words_[i];
    }
    for (int e = 0; e < errors; ++e) known |= wrong(kErrors[e][0]);
    if (named < 2 || (*error && !known) || width > 2048 || height > 2048) {
        fprintf(stderr, "renderer SCENE FOLDER [--size WxH] [--planes N,F] [--error NAME]; --list names the errors\n");
        return 2;
    }
    read_scene(names[0]);
    folder = names[1];
    mkdir(folder, 0777);
    float st = sinf(theta), ct = cosf(theta), sp = sinf(phi), cp = cosf(phi);
    axis[0] = vec(-st, ct, 0), axis[1] = vec(-cp * ct, -cp * st, sp), axis[2] = vec(-sp * ct, -sp * st, -cp);
    eye = by(-rho, axis[2]);
    V rows[3] = {axis[0], axis[1], axis[2]};
    if (wrong("matrix-transposed"))
        rows[0] = vec(axis[0].x, axis[1].x, axis[2].x), rows[1] = vec(axis[0].y, axis[1].y, axis[2].y),
        rows[2] = vec(axis[0].z, axis[1].z, axis[2].z);
    for (int i = 0; i < vertexCount; ++i)
        eyeSpace[i] = vec(dot(rows[0], world[i]), dot(rows[1], world[i]), dot(rows[2], world[i]) + rho);
    for (int k = 0; k < polygonCount; ++k) {
        Polygon *p = &polygons[k];
        const V *of = wrong("normals-of-the-file") ? local : world;
        V a = of[p->corners[0]], b = of[p->corners[1]], c = of[p->corners[2]];
        V n = unit(cross(minus(b, a), minus(c, a)));
        for (int i = 0; i < p->count; ++i) smooth[p->corners[i]] = plus(smooth[p->corners[i]], n);
        a = world[p->corners[0]], b = world[p->corners[1]], c = world[p->corners[2]];
        p->normal = unit(cross(minus(b, a), minus(c, a)));
        Corner cut[16];
        int corners = corners_of(p, cut);
        float area = 0;
        for (int i = 0; i < corners; ++i) {
            V from = project(cut[i].view), to = project(cut[(i + 1) % corners].view);
            area -= (from.x * to.y - from.y * to.x) / 2;
        }
        p->visible = wrong("other-winding") ? area < 0 : area > 0;
        if (wrong("cull-towards-light")) p->visible = dot(p->normal, lightTo[0]) > 0;
    }
    for (int i = 0; i < vertexCount; ++i) smooth[i] = unit(smooth[i]);
    for (int i = 0; i < width * height; ++i) zBuffer[i] = INFINITY, ids[i] = -1;
    for (int k = 0; k < polygonCount; ++k) {
        Corner cut[16];
        int corners = polygons[k].visible ? corners_of(&polygons[k], cut) : 0;
        for (int j = 1; j + 1 < corners; ++j) triangle(k, &cut[0], &cut[j], &cut[j + 1]);
    }
    shade();
    write_files();
    return 0;
}
