#!/usr/bin/env python3
"""A student's renderer, written from the lectures' formulas: no code of Shadescope's is in it.

    renderer.py SCENE FOLDER [--size 160x120] [--shading flat|gouraud|phong] [--near N] [--halfway I,J] [--no-shadow]
                [--error NAME] [--color-only] [CONVENTION...]

It reads lecture 1's two files (.scene and .des) and writes its buffers to FOLDER: vertices, verdicts, normals, depths, ids,
dot products and terms as .npy, the picture as .ppm. Conventions are right in their own way, errors are not; --list names all.
"""
import array
import math
import os
import re
import sys

# What a student gets wrong: the error of the program's table that it is, "" if none, and the buffer where it shows first.
ERRORS = {
    "move-first": ("trs-order", "vertices.world"),            # translated before it is scaled and turned
    "no-degrees": ("radians", "vertices.view"),               # sin and cos of the camera's degrees
    "plus-y": ("y-down", "vertices.screen"),                  # y_s = h/2 + ...
    "keep-negative": ("cull-sign", "polygons.visible"),       # the comparison turned round
    "cull-by-axis": ("cull-axis", "polygons.visible"),        # N against the viewing axis
    "skip-at-near": ("near-drop", "polygons.visible"),        # a polygon with a vertex before the near plane is skipped
    "cross-other-way": ("normal-flip", "polygons.normal"),    # v02 x v01
    "forgot-unit": ("normal-short", "normal"),                # mean of vertex normals, not made unit again
    "buffer-of-rho": ("z-clear", "z_view"),                   # the z-buffer begins with the eye's distance
    "greater": ("z-flip", "z_view"),                          # begins with 0, and takes what is farther
    "no-store": ("z-no-write", "z_view"),                     # the line after the test is not there
    "linear-z": ("z-affine", "z_view"),                       # z itself is interpolated in the picture
    "long-l": ("l-raw", "n_dot_l.0"),                         # the light's vector as the file has it
    "light-backwards": ("light-from", "n_dot_l.0"),           # where the light goes to, not where it is
    "signed-diffuse": ("no-max", "diffuse.0"),                # N.L below 0 counts
    "shine-behind": ("spec-behind", "specular.0"),            # a highlight wherever R.V is above 0
    "reflect": ("r-flip", "r_dot_v.0"),                       # reflect(L, N) of a shading language: L - 2 (N.L) N
    "origin-eye": ("eye-at-origin", "r_dot_v.0"),             # V = -p / |p|
    "coloured-shine": ("ks-kd", "specular.0"),                # k_d times k_s in the highlight
    "whole-numbers": ("integer", "color"),                    # 255 * (int)(I / I_max)
    # In no table.
    "next-material": ("", "ambient"),                         # each object has the material of the next
    "skewed": ("", "vertices.screen"),                        # x_s takes some of y_v
    "last-polygon": ("", "polygons.visible"),                 # i < n - 1: the last polygon of each object is missing
    "coarse-normal": ("", "normal"),                          # components rounded to a quarter
    "fog": ("", "intensity"),                                 # fades with distance
}
CONVENTIONS = {
    "rows": ("top-down", "bottom-up"),
    "channels": ("rgb", "bgr"),
    "encoding": ("linear", "srgb"),
    "depth": ("view", "ndc", "window", "reversed", "inverse", "distance"),
    "normals": ("world", "view", "rgb"),
    "ids": ("0", "1", "permuted"),
    "verdicts": ("kept", "culled"),
    "sample": ("centre", "corner"),
}


def sub(a, b): return (a[0] - b[0], a[1] - b[1], a[2] - b[2])
def add(a, b): return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
def times(s, a): return (s * a[0], s * a[1], s * a[2])
def dot(a, b): return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(dot(a, a))
    return times(1 / length, a) if length > 0 else (0.0, 0.0, 0.0)


def words_of(path):
    with open(path, encoding="utf-8") as file:
        text = re.sub(r"//.*", "", file.read())
    return re.sub(r"[(),]", " ", text).split()


class Reader:
    def __init__(self, path):
        self.words, self.at = words_of(path), 0

    def word(self):
        self.at += 1
        return self.words[self.at - 1]

    def number(self): return float(self.word())
    def whole(self): return int(self.word())
    def vector(self): return (self.number(), self.number(), self.number())


class Object:
    def __init__(self, path, scale, angles, move, error):
        file = Reader(path)
        points, polygons = file.whole(), file.whole()
        local = [file.vector() for _ in range(points)]
        self.polygons = [[file.whole() for _ in range(file.whole())] for _ in range(polygons)]
        self.kd, self.ks, self.n = file.vector(), file.number(), file.number()
        ax, ay, az = (math.radians(angle) for angle in angles)

        def place(p):
            if error == "move-first":
                p = add(p, move)
            x, y, z = p[0] * scale[0], p[1] * scale[1], p[2] * scale[2]
            y, z = y * math.cos(ax) - z * math.sin(ax), y * math.sin(ax) + z * math.cos(ax)
            x, z = x * math.cos(ay) + z * math.sin(ay), -x * math.sin(ay) + z * math.cos(ay)
            x, y = x * math.cos(az) - y * math.sin(az), x * math.sin(az) + y * math.cos(az)
            return (x, y, z) if error == "move-first" else add((x, y, z), move)

        self.world = [place(p) for p in local]


class Scene:
    def __init__(self, path, error):
        file = Reader(path)
        self.d, self.rho, self.theta, self.phi = (file.number() for _ in range(4))
        self.objects = []
        for _ in range(file.whole()):
            name = os.path.join(os.path.dirname(path), file.word())
            self.objects.append(Object(name, file.vector(), file.vector(), file.vector(), error))
        self.lights = [(file.vector(), file.number()) for _ in range(file.whole())]
        self.ambient = file.number()
        if error == "next-material":
            materials = [(o.kd, o.ks, o.n) for o in self.objects]
            for i, o in enumerate(self.objects):
                o.kd, o.ks, o.n = materials[(i + 1) % len(materials)]


class Renderer:
    def __init__(self, scene, options):
        self.scene, self.o, self.error = scene, options, options["error"]
        self.width, self.height = options["size"]
        theta, phi = scene.theta, scene.phi
        if self.error != "no-degrees":
            theta, phi = math.radians(theta), math.radians(phi)
        st, ct, sp, cp = math.sin(theta), math.cos(theta), math.sin(phi), math.cos(phi)
        self.right, self.up, self.forward = (-st, ct, 0.0), (-cp * ct, -cp * st, sp), (-sp * ct, -sp * st, -cp)
        self.eye = times(-scene.rho, self.forward)
        self.files = {}

    def transform(self):
        self.world, self.polygons, self.object_of, first = [], [], [], 0
        for k, o in enumerate(self.scene.objects):
            self.world += o.world
            self.polygons += [[first + i for i in polygon] for polygon in o.polygons]
            self.object_of += [k] * len(o.polygons)
            first += len(o.world)
        self.view = [(dot(self.right, p), dot(self.up, p), dot(self.forward, p) + self.scene.rho) for p in self.world]
        self.screen = [self.project(v) for v in self.view]

    def project(self, v):
        if v[2] <= 1e-9:
            return (-1e30, -1e30, -1e30)
        x, y = self.scene.d * v[0] / v[2], self.scene.d * v[1] / v[2]
        if self.error == "skewed":
            x += 0.2 * y
        y = y if self.error == "plus-y" else -y
        return (self.width / 2 + x, self.height / 2 + y, v[2])

    def clip(self, corners):
        """Cuts (view, world, normal) corners at the near plane; Sutherland and Hodgman."""
        near, out = self.o["near"], []
        for i, a in enumerate(corners):
            b = corners[(i + 1) % len(corners)]
            if a[0][2] >= near:
                out.append(a)
            if (a[0][2] >= near) != (b[0][2] >= near):
                t = (near - a[0][2]) / (b[0][2] - a[0][2])
                out.append(tuple(add(p, times(t, sub(q, p))) for p, q in zip(a, b)))
        return out

    def normals(self):
        self.polygon_normal = []
        for polygon in self.polygons:
            a, b = (sub(self.world[polygon[i]], self.world[polygon[0]]) for i in (1, 2))
            self.polygon_normal.append(unit(cross(b, a) if self.error == "cross-other-way" else cross(a, b)))
        sums = [(0.0, 0.0, 0.0)] * len(self.world)
        for polygon, normal in zip(self.polygons, self.polygon_normal):
            for i in polygon:
                sums[i] = add(sums[i], normal)
        self.vertex_normal = [unit(s) for s in sums]

    def cull(self):
        self.visible = []
        last = [i + 1 == len(self.polygons) or self.object_of[i + 1] != k for i, k in enumerate(self.object_of)]
        for i, polygon in enumerate(self.polygons):
            seen = self.clip([(self.view[v],) for v in polygon])
            area = 0.0
            points = [self.project(c[0]) for c in seen]
            for a, b in zip(points, points[1:] + points[:1]):
                area -= (a[0] * b[1] - b[0] * a[1]) / 2  # y runs down
            visible = area > 0
            if self.error == "keep-negative":
                visible = area < 0
            if self.error == "cull-by-axis":
                a, b = (sub(self.world[polygon[j]], self.world[polygon[0]]) for j in (1, 2))
                visible = len(seen) > 2 and dot(cross(a, b), self.forward) < 0
            if self.error == "skip-at-near" and any(self.view[v][2] < self.o["near"] for v in polygon):
                visible = False
            if self.error == "last-polygon" and last[i]:
                visible = False
            self.visible.append(int(visible))

    def rasterize(self):
        w, h, error = self.width, self.height, self.error
        cleared = self.scene.rho if error == "buffer-of-rho" else 0.0 if error == "greater" else math.inf
        self.z, self.id = [cleared] * (w * h), [-1] * (w * h)
        self.point, self.smooth, self.shade = [None] * (w * h), [None] * (w * h), [None] * (w * h)
        offset = 0.5 if self.o["sample"] == "centre" else 0.0
        for number, polygon in enumerate(self.polygons):
            if not self.visible[number]:
                continue
            vertices = [(self.view[v], self.world[v], self.vertex_normal[v]) + tuple(self.vertex_light(v, number)) for v in polygon]
            cut = self.clip(vertices)
            for j in range(1, len(cut) - 1):
                self.triangle(number, (cut[0], cut[j], cut[j + 1]), offset)

    def triangle(self, number, corners, offset):
        p = [self.project(c[0]) for c in corners]
        area = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1])
        if area == 0:
            return
        low_x, high_x = (f(q[0] for q in p) for f in (min, max))
        low_y, high_y = (f(q[1] for q in p) for f in (min, max))
        inverse = [1 / c[0][2] for c in corners]
        for y in range(max(0, math.floor(low_y) - 1), min(self.height, math.ceil(high_y) + 1)):
            for x in range(max(0, math.floor(low_x) - 1), min(self.width, math.ceil(high_x) + 1)):
                sx, sy = x + offset, y + offset
                weights = []
                for a, b in ((1, 2), (2, 0), (0, 1)):
                    weights.append(((p[b][0] - p[a][0]) * (sy - p[a][1]) - (p[b][1] - p[a][1]) * (sx - p[a][0])) / area)
                if min(weights) < 0:
                    continue
                z = 1 / sum(l * i for l, i in zip(weights, inverse))
                share = [l * i * z for l, i in zip(weights, inverse)]
                if self.error == "linear-z":
                    z = sum(l * c[0][2] for l, c in zip(weights, corners))
                at = y * self.width + x
                if (z <= self.z[at]) if self.error == "greater" else (z >= self.z[at]):
                    continue
                if self.error != "no-store":
                    self.z[at] = z
                self.id[at] = number
                mixed = []
                for column in zip(*corners):
                    mixed.append(tuple(sum(s * v[c] for s, v in zip(share, column)) for c in range(3)))
                self.point[at], self.smooth[at], self.shade[at] = mixed[1], mixed[2], mixed[3:]

    def vertex_light(self, vertex, number):
        """Gouraud: per vertex ambient, then per light diffuse, specular, and N.L, R.V, S as a vector."""
        if self.o["shading"] != "gouraud":
            return []
        return self.light(self.world[vertex], self.vertex_normal[vertex], self.object_of[number], number)[0]

    def shadow(self, point, light, number):
        """Whether something stands between the point and a light at infinity."""
        if self.o["no-shadow"] or point is None:
            return 1.0
        towards = unit(light)
        if dot(self.facing[number], towards) <= 0:
            return 0.0
        for i, (a, e1, e2) in enumerate(self.triangles):
            if self.owner[i] == number:
                continue
            h = cross(towards, e2)
            det = dot(e1, h)
            if abs(det) < 1e-12:
                continue
            s = sub(point, a)
            u = dot(s, h) / det
            if u < 0 or u > 1:
                continue
            q = cross(s, e1)
            v = dot(towards, q) / det
            if v >= 0 and u + v <= 1 and dot(e2, q) / det > 1e-6:
                return 0.0
        return 1.0

    def light(self, point, n, k, number):
        o, error = self.scene.objects[k], self.error
        v = unit(times(-1, point)) if error == "origin-eye" else unit(sub(self.eye, point))
        terms = [times(self.scene.ambient, o.kd)]
        rows = [v]
        for position, power in self.scene.lights:
            l = position if error == "long-l" else unit(position)
            if error == "light-backwards":
                l = times(-1, l)
            nl = dot(n, l)
            r = sub(l, times(2 * nl, n)) if error == "reflect" else sub(times(2 * nl, n), l)
            rv = dot(r, v)
            hv = unit(add(l, v))
            nh = dot(n, hv)
            c = nh if k in self.o["halfway"] else rv
            s = self.shadow(None if self.o["shading"] == "flat" else point, position, number)
            diffuse, specular = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
            if nl > 0 or error == "signed-diffuse":
                diffuse = times(s * power * nl, o.kd)
            if c > 0 and (nl > 0 or error == "shine-behind"):
                shine = s * power * o.ks * min(c, 1e3) ** o.n
                specular = times(shine, o.kd) if error == "coloured-shine" else (shine, shine, shine)
            terms += [diffuse, specular, (nl, rv, s), (nh, 0.0, 0.0)]
        return terms, rows

    def shading(self):
        count, lights = self.width * self.height, len(self.scene.lights)
        self.facing, self.triangles, self.owner = [], [], []
        for i, polygon in enumerate(self.polygons):
            p = [self.world[v] for v in polygon]
            self.facing.append(unit(cross(sub(p[1], p[0]), sub(p[2], p[0]))))
            for j in range(1, len(p) - 1):
                self.triangles.append((p[0], sub(p[j], p[0]), sub(p[j + 1], p[0])))
                self.owner.append(i)
        flat = {}
        self.rasterize()
        names = ["ambient"] + [f"{n}.{k}" for k in range(lights) for n in ("diffuse", "specular", "dots", "h")]
        self.terms = {name: [(0.0, 0.0, 0.0)] * count for name in names + ["normal", "view_vector", "intensity"]}
        for at in range(count):
            number = self.id[at]
            if number < 0:
                continue
            k, polygon = self.object_of[number], self.polygons[number]
            n = self.polygon_normal[number]
            if self.o["shading"] == "flat":
                if number not in flat:
                    middle = times(1 / len(polygon), tuple(map(sum, zip(*(self.world[v] for v in polygon)))))
                    flat[number] = self.light(middle, n, k, number)
                terms, rows = flat[number]
                if not self.o["no-shadow"]:
                    terms = self.shadowed(terms, at, number)
            elif self.o["shading"] == "gouraud":
                terms, rows, n = self.shade[at], [unit(sub(self.eye, self.point[at]))], unit(self.smooth[at])
            else:
                n = self.smooth[at] if self.error == "forgot-unit" else unit(self.smooth[at])
                if self.error == "coarse-normal":
                    n = tuple(round(4 * c) / 4 for c in n)
                terms, rows = self.light(self.point[at], n, k, number)
            for name, term in zip(names, terms):
                self.terms[name][at] = term
            self.terms["normal"][at], self.terms["view_vector"][at] = n, rows[0]
            total = terms[0]
            for i in range(lights):
                total = add(total, add(terms[1 + 4 * i], terms[2 + 4 * i]))
            if self.error == "fog":
                total = times(math.exp(-0.6 * self.z[at] / self.scene.rho), total)
            self.terms["intensity"][at] = total

    def shadowed(self, terms, at, number):
        """Flat shading: a polygon is lit once, its shadow falls on it pixel by pixel."""
        out = list(terms)
        for i, (position, _) in enumerate(self.scene.lights):
            s = self.shadow(self.point[at], position, number)
            out[1 + 4 * i], out[2 + 4 * i] = times(s, terms[1 + 4 * i]), times(s, terms[2 + 4 * i])
            out[3 + 4 * i] = terms[3 + 4 * i][:2] + (s,)
        return out

    def frame_buffer(self):
        highest = max(max(o.kd) for o in self.scene.objects)
        shine = max(o.ks for o in self.scene.objects)
        i_max = highest * self.scene.ambient + sum(power * (highest + shine) for _, power in self.scene.lights)
        color = []
        for intensity in self.terms["intensity"]:
            for i in intensity:
                share = min(max(i / i_max, 0.0), 1.0)
                if self.error == "whole-numbers":
                    share = float(int(share))
                if self.o["encoding"] == "srgb":
                    share = 12.92 * share if share <= 0.0031308 else 1.055 * share ** (1 / 2.4) - 0.055
                color.append(int(255 * share + 0.5))
        return color

    def rows(self, values, channels):
        """Row by row, from the top or from the bottom."""
        if self.o["rows"] == "top-down":
            return values
        step = self.width * channels
        return [v for y in reversed(range(self.height)) for v in values[y * step:(y + 1) * step]]

    def depths(self):
        n, kind = self.o["near"] or min(v[2] for v in self.view), self.o["depth"]
        n, f = self.o["planes"] or (n, max(v[2] for v in self.view))
        out = []
        for at, z in enumerate(self.z):
            seen = self.id[at] >= 0
            if kind == "view" or not (0 < z < math.inf):
                out.append(z if kind == "view" else 0.0 if kind in ("reversed", "inverse") else 1.0 if kind != "distance" else math.inf)
                continue
            window = f / (f - n) - f * n / ((f - n) * z)
            p = self.point[at] if seen else self.eye
            out.append({"ndc": 2 * window - 1, "window": window, "reversed": 1 - window, "inverse": 1 / z,
                        "distance": math.sqrt(dot(sub(p, self.eye), sub(p, self.eye)))}[kind])
        return out

    def directions(self, values, picture=False):
        kind, out = self.o["normals"], []
        for v in values:
            if kind == "view":
                v = (dot(self.right, v), dot(self.up, v), dot(self.forward, v))
            if kind == "rgb" and picture and v != (0.0, 0.0, 0.0):
                v = tuple((c + 1) / 2 for c in v)
            out += v
        return out

    def write(self, folder):
        os.makedirs(folder, exist_ok=True)
        w, h = self.width, self.height
        color = self.rows(self.frame_buffer(), 3)
        if self.o["channels"] == "bgr":
            color = [color[3 * (i // 3) + 2 - i % 3] for i in range(len(color))]
        with open(os.path.join(folder, "color.ppm"), "wb") as file:
            file.write(b"P6\n%d %d\n255\n" % (w, h) + bytes(color))
        if self.o["color-only"]:
            return
        flat = lambda vectors: [c for v in vectors for c in v]
        npy(folder, "vertices.world", (len(self.world), 3), flat(self.world))
        npy(folder, "vertices.view", (len(self.view), 3), flat(self.view))
        npy(folder, "vertices.screen", (len(self.screen), 3), flat(self.screen))
        npy(folder, "polygons.visible", (len(self.visible),),
            self.visible if self.o["verdicts"] == "kept" else [1 - v for v in self.visible], "i")
        npy(folder, "polygons.normal", (len(self.polygons), 3), self.directions(self.polygon_normal))
        if self.o["shading"] != "flat":
            npy(folder, "vertices.normal", (len(self.world), 3), self.directions(self.vertex_normal))
        depth = self.depths()
        npy(folder, "z_view" if self.o["depth"] == "view" else "depth", (h, w), self.rows(depth, 1))
        names = list(range(len(self.polygons)))
        if self.o["ids"] == "1":
            names = [n + 1 for n in names]
        if self.o["ids"] == "permuted":
            names = [(7 * n + 3) % 1009 for n in names]
        nothing = 0 if self.o["ids"] == "1" else -1
        npy(folder, "polygon_id", (h, w), self.rows([names[i] if i >= 0 else nothing for i in self.id], 1), "i")
        npy(folder, "normal", (h, w, 3), self.rows(self.directions(self.terms["normal"], True), 3))
        for name in ("ambient", "intensity"):
            npy(folder, name, (h, w, 3), self.rows(flat(self.terms[name]), 3))
        for k in range(len(self.scene.lights)):
            for name in (f"diffuse.{k}", f"specular.{k}"):
                npy(folder, name, (h, w, 3), self.rows(flat(self.terms[name]), 3))
            for i, name in enumerate((f"n_dot_l.{k}", f"r_dot_v.{k}", f"shadow.{k}")):
                nothing = 1.0 if i == 2 else 0.0
                values = [d[i] if self.id[at] >= 0 else nothing for at, d in enumerate(self.terms[f"dots.{k}"])]
                npy(folder, name, (h, w), self.rows(values, 1))


def npy(folder, name, shape, values, kind="f"):
    """Version 1.0 of the format: magic, a dictionary padded to 64 bytes, the numbers."""
    header = "{'descr': '<%s4', 'fortran_order': False, 'shape': (%s,), }" % (kind, ", ".join(map(str, shape)))
    header += " " * (-(len(header) + 11) % 64) + "\n"
    numbers = array.array(kind, values)
    if sys.byteorder != "little":
        numbers.byteswap()
    with open(os.path.join(folder, name + ".npy"), "wb") as file:
        file.write(b"\x93NUMPY\x01\x00" + len(header).to_bytes(2, "little") + header.encode() + numbers.tobytes())


def main(arguments):
    if arguments == ["--list"]:
        for name, (known, buffer) in ERRORS.items():
            print(name, known or "-", buffer)
        return 0
    options = {"size": (160, 120), "shading": "flat", "near": 0.0, "planes": None, "halfway": [], "no-shadow": False,
               "error": "", "color-only": False, **{name: values[0] for name, values in CONVENTIONS.items()}}
    names = []
    words = iter(arguments)
    for word in words:
        if not word.startswith("--"):
            names.append(word)
            continue
        key = word[2:]
        if key not in options:
            sys.exit(f"renderer.py: no option {word}")
        if isinstance(options[key], bool):
            options[key] = True
            continue
        value = next(words)
        if key in CONVENTIONS and value not in CONVENTIONS[key] or key == "error" and value not in ERRORS:
            sys.exit(f"renderer.py: {word} has no {value}")
        if key == "size":
            value = tuple(map(int, value.split("x")))
        elif key == "planes":
            value = tuple(map(float, value.split(",")))
        elif key == "halfway":
            value = list(map(int, value.split(",")))
        elif key == "near":
            value = float(value)
        options[key] = value
    if len(names) != 2:
        sys.exit(__doc__)
    renderer = Renderer(Scene(names[0], options["error"]), options)
    renderer.transform()
    if not options["near"]:
        options["near"] = 1e-3 * renderer.scene.rho
    renderer.cull()
    renderer.normals()
    renderer.shading()
    renderer.write(names[1])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
