#!/usr/bin/env python3
"""Runs `shadescope compare` over the students' renderers and counts how often it is right.

    judge.py --program SHADESCOPE --renderer C++_RENDERER [--only WORD] [--all] [--work FOLDER] [--list]

Right renderers, in every convention, must agree. A wrong one must be told apart where a buffer that it delivers differs from
the right one's beyond its tolerance, which is decided here, without Shadescope: which stage is the first wrong one, and what the
error is called. Each figure has an aim, and a floor, which is what has been reached: below it the exit status is 1. Without --all, or SHADESCOPE_LONG=1, 50 spread runs of each kind are taken. The exit status is 1 where a
figure misses its aim.
"""
import argparse
import array
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import renderer as python_renderer  # noqa: E402  its list of errors alone

OFF = ["light.0.shadow=off", "light.1.shadow=off"]
# The planes are given: lecture 1's file says nothing of them, and some depths mean nothing without.
PLANES = (["camera.near=4", "camera.far=40"], ["--planes", "4,40", "--near", "4"])
SCENES = {  # settings for Shadescope, options for the renderers
    "tower": (["shading=flat", OFF[0]], ["--shading", "flat", "--no-shadow"]),
    "pebbles": (["shading=phong"] + OFF, ["--shading", "phong", "--no-shadow"]),
    "bridge": (["shading=flat"], ["--shading", "flat"]),
    "vases": (["shading=gouraud", "material.1.highlight=blinn-phong"] + OFF,
              ["--shading", "gouraud", "--halfway", "1", "--no-shadow"]),
}
CONVENTIONS = [[]] + [[f"--{name}", value] for name, values in python_renderer.CONVENTIONS.items() for value in values[1:]]
CONVENTIONS += [["--rows", "bottom-up", "--channels", "bgr", "--depth", "window", "--ids", "1"],
                ["--rows", "bottom-up", "--encoding", "srgb", "--depth", "distance", "--normals", "view"]]
STAGES = {"vertices.world": "transform", "vertices.view": "transform", "vertices.screen": "transform",
          "polygons.visible": "cull", "polygons.normal": "normals", "vertices.normal": "normals",
          "z_view": "z-buffer", "depth": "z-buffer", "polygon_id": "z-buffer"}
# What still counts as the same; of the number's range over the picture where it says so.
TOLERANCES = {"vertices.world": (0.001, True), "vertices.view": (0.001, True), "vertices.screen": (0.01, False),
              "polygons.visible": (0, False), "polygons.normal": (0.0087, False), "vertices.normal": (0.0087, False),
              "z_view": (0.001, True), "polygon_id": (0, False), "normal": (0.0087, False), "n_dot_l": (0.005, False),
              "r_dot_v": (0.005, False), "shadow": (0.5, False), "ambient": (0.005, True), "diffuse": (0.005, True),
              "specular": (0.005, True), "intensity": (0.005, True), "color": (2, False)}
PIXELS_ASTRAY = 0.002  # of those drawn


def numbers_of(path):
    """The numbers of a file that one of the renderers has written, and how many belong together."""
    with open(path, "rb") as file:
        data = file.read()
    if path.endswith(".npy"):
        size = int.from_bytes(data[8:10], "little")
        head = data[10:10 + size].decode()
        values = array.array("i" if "<i4" in head else "f", data[10 + size:])
        shape = [int(n) for n in head.split("(")[1].split(")")[0].split(",") if n.strip()]
        return list(values), 1 if len(shape) < 2 or (len(shape) == 2 and shape[1] > 4) else shape[-1]
    if path.endswith(".pfm"):
        return list(array.array("f", data.split(b"\n", 3)[3])), 1
    if path.endswith(".ppm"):
        if data.startswith(b"P3"):
            return [float(word) for word in data.split()[4:]], 3
        return list(data.split(b"\n", 3)[3]), 3
    rows = [line.split(",") for line in data.decode().splitlines() if line]
    return [float(cell) for row in rows for cell in row], len(rows[0])


def differing(folder, right):
    """The buffers of a folder that differ from the right renderer's beyond tolerance."""
    found = []
    for name in sorted(os.listdir(folder)):
        buffer = name.rsplit(".", 1)[0]
        table = buffer if buffer in TOLERANCES else buffer.rsplit(".", 1)[0]
        if table not in TOLERANCES:
            continue
        (a, channels), (b, _) = numbers_of(os.path.join(folder, name)), numbers_of(os.path.join(right, name))
        bound, relative = TOLERANCES[table]
        finite = [x for x in b if math.isfinite(x) and x > -1e29]
        if relative and finite:
            bound *= max(map(abs, finite)) - (min(finite) if table == "z_view" else 0)
        astray = drawn = 0
        for i in range(0, len(b), channels):
            mine, theirs = a[i:i + channels], b[i:i + channels]
            drawn += any(x != 0 and x != -1 and math.isfinite(x) for x in mine + theirs)
            astray += any(x != y and not abs(x - y) <= bound for x, y in zip(mine, theirs))
        if astray > (PIXELS_ASTRAY * drawn if len(b) // channels > 4000 else 0):
            found.append(buffer)
    return found


def sample(runs, everything):
    """At most 50, evenly spread, the first and the last among them."""
    if everything or len(runs) <= 50:
        return runs
    return [runs[i * (len(runs) - 1) // 49] for i in range(50)]


class Judge:
    def __init__(self, options):
        self.o = options
        self.work = options.work or tempfile.mkdtemp(prefix="students-")
        self.renderers = {"python": [sys.executable, os.path.join(HERE, "renderer.py")], "c++": [options.renderer]}
        self.errors = {}
        for name, command in self.renderers.items():
            lines = subprocess.run(command + ["--list"], capture_output=True, text=True, check=True).stdout.splitlines()
            self.errors[name] = [line.split() for line in lines]
        self.right = {}

    def render(self, who, scene, options):
        folder = os.path.join(self.work, "mine")
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        subprocess.run(self.renderers[who] + [os.path.join(HERE, "scenes", scene + ".scene"), folder]
                       + SCENES[scene][1] + PLANES[1] + options, check=True)
        return folder

    def compare(self, scene, folder):
        command = [self.o.program, "compare", os.path.join(HERE, "scenes", scene + ".scene"), folder, "--json",
                   "--size", "160x120"]
        lights = 2 if scene in ("pebbles", "vases") else 1
        for setting in SCENES[scene][0] + PLANES[0]:
            if not (setting.startswith("light.1") and lights == 1):
                command += ["--set", setting]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode not in (0, 1):
            sys.exit(f"{' '.join(command)}: status {done.returncode}\n{done.stderr}")
        return done.returncode, json.loads(done.stdout)

    def right_of(self, who, scene):
        if (who, scene) not in self.right:
            folder = os.path.join(self.work, f"right-{who}-{scene}")
            shutil.rmtree(folder, ignore_errors=True)
            shutil.copytree(self.render(who, scene, []), folder)
            self.right[who, scene] = folder
        return self.right[who, scene]

    def say(self, *words):
        print(*words, flush=True)

    def conventions(self):
        """Right renderers: how many, and how many were accused; those that sample pixels at their corners apart."""
        runs = [(who, scene, convention, colour) for convention in CONVENTIONS for scene in SCENES
                for who in self.renderers for colour in (False, True)
                if not colour or not convention or convention[0] in ("--rows", "--channels", "--encoding", "--sample")]
        count = {False: [0, 0], True: [0, 0]}
        for who, scene, convention, colour in sample(runs, self.o.all):
            if self.o.only not in f"{who} {scene} {' '.join(convention)}":
                continue
            status, found = self.compare(scene, self.render(who, scene, convention + ["--color-only"] * colour))
            at_corner = "corner" in convention
            count[at_corner][1] += 1
            if status == 0:
                continue
            count[at_corner][0] += 1
            self.say(f"false alarm: {who} {scene} {' '.join(convention)}{' colour alone' * colour}: {found['headline']}")
        return count

    def mistakes(self):
        runs = [(who, scene, error, colour) for scene in SCENES for who in self.renderers for error in self.errors[who]
                for colour in (False, True)]
        runs = [run for run in sample(runs, self.o.all) if self.o.only in " ".join(run[:2] + (run[2][0],))]
        count = {name: [0, 0] for name in ("agrees", "noticed", "stage", "first", "first, colour alone", "three",
                                           "three, colour alone", "unknown")}

        def tally(name, holds):
            count[name][0] += bool(holds)
            count[name][1] += 1

        for who, scene, (error, known, buffer), colour in runs:
            right = self.right_of(who, scene)
            folder = self.render(who, scene, ["--error", error] + ["--color-only"] * colour)
            wrong = differing(folder, right)
            status, found = self.compare(scene, folder)
            where = f"{who} {scene} {error}{' colour alone' * colour}"
            names = [one["id"] for one in found["known"]]
            if not wrong:
                tally("agrees", status == 0)
                if status != 0:
                    self.say(f"{where}: accused, though nothing differs beyond its tolerance: {found['headline']}")
                continue
            tally("noticed", status == 1)
            if status == 0:
                self.say(f"{where}: not noticed; {', '.join(wrong)} differ")
            if not colour:
                stage = STAGES.get(buffer, "shading")
                said = (found.get("first_wrong") or {}).get("stage")
                tally("stage", said == stage)
                if said != stage:
                    self.say(f"{where}: first wrong stage {said}, not {stage}")
            if known == "-":
                tally("unknown", names)
                if names:
                    self.say(f"{where}: in no table, called {', '.join(names)}")
                continue
            alike = ", colour alone" if colour else ""
            tally("first" + alike, names[:1] == [known])
            tally("three" + alike, known in names[:3])
            if names[:1] != [known]:
                self.say(f"{where}: {known} called {', '.join(names) or 'nothing'}")
        return count


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--renderer", required=True)
    parser.add_argument("--only", default="")
    parser.add_argument("--work", default="")
    parser.add_argument("--all", action="store_true", default=os.environ.get("SHADESCOPE_LONG", "0") not in ("", "0"))
    parser.add_argument("--part", choices=("conventions", "mistakes"))
    options = parser.parse_args()
    if subprocess.run([options.program, "compare", "--help"], capture_output=True).returncode != 0:
        print("left out: this program has no command compare")
        return 77
    judge = Judge(options)
    good = True

    def say(what, hit, all_, aim, floor, least=True):
        nonlocal good
        reaches = lambda bound: hit >= bound * all_ if least else hit <= bound * all_
        good = good and reaches(floor)
        note = "" if reaches(aim) else f"the aim is {'at least' if least else 'at most'} {100 * aim:g} %"
        print(f"{what:<62} {hit:>4} of {all_:<4} {note if reaches(floor) else note + ', below its floor'}", flush=True)

    if options.part != "mistakes":
        count = judge.conventions()
        say("right renderers that are accused", *count[False], 0, 0, least=False)
        say("of those that sample pixels at their corners", *count[True], 0, 0, least=False)
    if options.part != "conventions":
        count = judge.mistakes()
        both = {name: [count[name][i] + count[name + ", colour alone"][i] for i in (0, 1)] for name in ("first", "three")}
        say("nothing differs, and it says so", *count["agrees"], 1, 0.9)
        say("a difference is noticed", *count["noticed"], 1, 0.97)
        say("first wrong stage right, with buffers", *count["stage"], 0.95, 0.95)
        say("error named first, with buffers", *count["first"], 0.8, 0.8)
        say("error named first, colour alone", *count["first, colour alone"], 0.8, 0.8)
        say("error named first, both", *both["first"], 0.8, 0.8)
        say("error among three, with buffers", *count["three"], 0.95, 0.9)
        say("error among three, colour alone", *count["three, colour alone"], 0.95, 0.9)
        say("error among three, both", *both["three"], 0.95, 0.9)
        say("error in no table called a known one", *count["unknown"], 0.05, 0.05, least=False)
    if not options.work:
        shutil.rmtree(judge.work, ignore_errors=True)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
