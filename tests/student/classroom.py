#!/usr/bin/env python3
"""A made-up class: `shadescope compare --class` over hand-ins of two renderers that share no code with the program.

    classroom.py --program SHADESCOPE --renderer C++_RENDERER [--all]

Sixty folders of 96 x 60 (300 with --all, or SHADESCOPE_LONG=1): errors in conventions, right ones, and broken ones. The points of
eleven are computed by hand below. The hand-ins keep their bytes. Killed again and again and started again, and shared out in two
parts, a class gives the bytes of one run.
"""
import argparse
import array
import csv
import hashlib
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

HERE = os.path.dirname(os.path.abspath(__file__))
SCENE = "tower"
OPTIONS = ["--shading", "flat", "--no-shadow", "--planes", "4,40", "--near", "4", "--size", "96x60"]
COURSE = """title = "Towers"
most_mb = 1
[[task]]
name = "tower"
scene = "tower.scene"
set = ["shading=flat", "light.0.shadow=off", "camera.near=4", "camera.far=40", "width=96", "height=60"]
points = {color = 4, "z-buffer" = 2}
"""
CONVENTIONS = [[], ["--rows", "bottom-up"], ["--channels", "bgr"], ["--depth", "window"], ["--depth", "ndc", "--rows", "bottom-up"],
               ["--encoding", "srgb"]]
# Of color 4 points and of the z-buffer 2. Right: all. An error of the light that has a name: half of the picture's, all of the
# depth's. One of visibility: half of both. One of places whose depth is wrong in another way too: half of the picture's. One that
# no table has: none of the picture's. A file that is missing: none.
BY_HAND = {
    "a-right": ([], 6), "b-upside-down": (["--rows", "bottom-up"], 6), "c-blue-first": (["--channels", "bgr"], 6),
    "d-window": (["--depth", "window"], 6), "e-both-sides": (["--error", "both-sides"], 4),
    "f-farthest": (["--error", "gl-greater"], 3), "g-banded": (["--error", "banded"], 2),
    "k-other-depth": (["--error", "translate-first"], 2), "h-no-depth": ([], 4), "i-cut-off": ([], 4), "j-empty": ([], 0),
}


class Classroom:
    def __init__(self, options):
        self.o = options
        self.work = tempfile.mkdtemp(prefix="class-")
        self.renderers = [[options.renderer], [sys.executable, os.path.join(HERE, "renderer.py")]]
        self.failures = 0
        self.course = self.path("course", "course.toml")
        shutil.copytree(os.path.join(HERE, "scenes"), self.path("course"))
        with open(self.course, "w") as file:
            file.write(COURSE)

    def path(self, *names):
        return os.path.join(self.work, *names)

    def expect(self, holds, what):
        if not holds:
            self.failures += 1
            print(f"FAILED: {what}", flush=True)

    def hand_in(self, folder, options, renderer=None):
        os.makedirs(folder)
        subprocess.run((renderer or self.renderers[0]) + [os.path.join(HERE, "scenes", SCENE + ".scene"), folder] + OPTIONS
                       + options, check=True)
        for name in os.listdir(folder):
            if name.rsplit(".", 1)[0] not in ("color", "depth", "z_view"):
                os.remove(os.path.join(folder, name))

    def depth_of(self, folder):
        return next(os.path.join(folder, name) for name in os.listdir(folder) if not name.startswith("color"))

    def make(self, folder, count):
        for name, (options, _) in BY_HAND.items():
            if name == "j-empty":
                os.makedirs(os.path.join(folder, name))
                continue
            self.hand_in(os.path.join(folder, name), options)
        os.remove(self.depth_of(os.path.join(folder, "h-no-depth")))
        cut = self.depth_of(os.path.join(folder, "i-cut-off"))
        os.truncate(cut, os.path.getsize(cut) // 2)
        other = self.depth_of(os.path.join(folder, "k-other-depth"))
        with open(other, "rb") as file:
            text = file.read()
        depths = array.array("f", text[-4 * 96 * 60:])
        with open(other, "wb") as file:
            file.write(text[:-4 * 96 * 60])
            array.array("f", [z * (1.01 + 0.01 * (i // 8 % 2)) for i, z in enumerate(depths)]).tofile(file)
        errors = []
        for renderer in self.renderers:
            lines = subprocess.run(renderer + ["--list"], capture_output=True, text=True, check=True).stdout.splitlines()
            errors.append([line.split()[0] for line in lines])
        for i in range(count - len(BY_HAND) - 3):  # right ones and wrong ones by turns, of each renderer
            who = i // 2 % 2
            self.hand_in(os.path.join(folder, f"student {i:03}"),
                         CONVENTIONS[i % len(CONVENTIONS)]
                         + (["--error", errors[who][i // 4 % len(errors[who])]] if i % 2 else []), self.renderers[who])
        # Broken ones: names that are markup and a formula, a hand-in that is too large, a link to somebody else's.
        os.makedirs(os.path.join(folder, "=1+1<b>"))
        os.symlink(os.path.join(folder, "a-right", "color.ppm"), os.path.join(folder, "=1+1<b>", "color.ppm"))
        os.makedirs(os.path.join(folder, "large"))
        with open(os.path.join(folder, "large", "depth.npy"), "wb") as file:
            file.truncate(2 * 1000 * 1000)
        os.makedirs(os.path.join(folder, "no-picture"))
        with open(os.path.join(folder, "no-picture", "color.png"), "wb") as file:
            file.write(b"\x89PNG\r\n\x1a\nand nothing more")
        with open(os.path.join(folder, "notes.txt"), "w") as file:
            file.write("no folder")
        os.symlink(os.path.join(folder, "a-right"), os.path.join(folder, "somebody-else"))

    def command(self, handed_in, out, *more):
        return [self.o.program, "compare", "--class", self.course, handed_in, "-o", out, *more]

    def run(self, *arguments):
        return subprocess.run(self.command(*arguments), capture_output=True, text=True)

    @staticmethod
    def bytes_of(folder):
        found = {}
        for at, folders, names in os.walk(folder):
            for name in folders + names:
                path = os.path.join(at, name)
                whole = os.path.isfile(path) and not os.path.islink(path)
                found[os.path.relpath(path, folder)] = hashlib.sha256(open(path, "rb").read()).hexdigest() if whole else ""
        return found

    def points(self, handed_in, out, count):
        before = self.bytes_of(handed_in)
        done = self.run(handed_in, out)
        self.expect(done.returncode == 3, f"status {done.returncode} where a folder cannot be compared: {done.stderr}")
        self.expect(self.bytes_of(handed_in) == before, "the hand-ins keep their bytes")
        with open(os.path.join(out, "students.csv"), newline="") as file:
            rows = {row["student"]: row for row in csv.DictReader(file)}
        self.expect(len(rows) == count, f"{len(rows)} rows of {count} students")
        for name, (_, points) in BY_HAND.items():
            row = rows.get(name, {})
            self.expect(float(row.get("points", -1)) == points and row["of"] == "6",
                        f"{name}: {row.get('points')} of {row.get('of')} points, by hand {points}: {row}")
        self.expect(rows["e-both-sides"]["tower error"] == "no-max", rows["e-both-sides"])
        self.expect(rows["f-farthest"]["tower error"] == "z-flip", rows["f-farthest"])
        self.expect("'=1+1<b>" in rows and "=1+1<b>" not in rows, "a name is no formula")
        for name in ("j-empty", "'=1+1<b>", "large", "no-picture"):
            self.expect(rows[name]["notes"] == "nothing could be compared" and rows[name]["points"] == "0", rows[name])
        for i in range(0, count - len(BY_HAND) - 3, 2):  # right ones in every convention
            self.expect(rows[f"student {i:03}"]["points"] == "6", rows[f"student {i:03}"])
        page = open(os.path.join(out, "class.html"), encoding="utf-8").read()
        self.expect("<b>" not in page, "a name is no markup")
        self.expect("notes.txt: no folder" in page and "somebody-else: a link" in page, "what is no hand-in is told")
        self.expect("page “" in page, "an error has its lesson page")
        whole = json.load(open(os.path.join(out, "class.json")))
        self.expect(sum(len(error["students"]) for error in whole["errors"] if error["id"] == "no-max") >= 1, whole["errors"])
        self.expect(abs(sum(s["points"] for s in whole["students"]) - sum(float(r["points"]) for r in rows.values())) < 1e-9,
                    "the table and the JSON have the same points")
        suites = xml.etree.ElementTree.parse(os.path.join(out, "junit.xml")).getroot()
        self.expect(len(suites) == count and all(len(suite) == 2 for suite in suites), "a suite for each, a case for each part")
        self.expect(sum(int(suite.get("failures")) for suite in suites) == len(list(suites.iter("failure"))), "failures")
        results = json.load(open(os.path.join(out, "students", "e-both-sides", "results.json")))
        self.expect(results["score"] == 4 and [t["max_score"] for t in results["tests"]] == [4, 2], results)
        with open(os.path.join(out, "moodle.csv"), newline="") as file:
            self.expect({row["Identifier"]: row["Grade"] for row in csv.DictReader(file)}["f-farthest"] == "3", "Moodle's table")
        below = self.run(handed_in, out, "--pass", "50")
        self.expect("below 50 %" in below.stdout, below.stdout)
        refused = self.run(handed_in, os.path.join(handed_in, "class"))
        self.expect(refused.returncode == 2, "nothing is written into the hand-ins")

    def killed(self, handed_in, expected, seed):
        out, chance = self.path("killed"), random.Random(seed)
        kills = 0
        for pause in [chance.uniform(0.05, 0.9) for _ in range(4)] + [600]:
            running = subprocess.Popen(self.command(handed_in, out), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                running.wait(pause)
            except subprocess.TimeoutExpired:
                running.kill()
                running.wait()
                kills += 1
        print(f"killed {kills} times, seed {seed}", flush=True)
        self.same(out, expected, "killed and started again")

    def shared_out(self, handed_in, expected):
        out, jobs = self.path("shared"), self.path("jobs")
        self.expect(self.run(handed_in, out, "--commands", jobs).returncode == 0, "--commands")
        lines = open(jobs).read().splitlines()
        for half in (lines[::2], lines[1::2]):
            subprocess.run(["sh"], input="\n".join(half), text=True, stdout=subprocess.DEVNULL)
        begun = time.monotonic()
        self.run(handed_in, out)
        print(f"joined in {time.monotonic() - begun:.2f} s", flush=True)
        self.same(out, expected, "shared out in two parts")

    def same(self, out, expected, what):
        found = self.bytes_of(out)
        differ = sorted(name for name in found.keys() | expected.keys() if found.get(name) != expected.get(name))
        self.expect(not differ, f"{what}: {', '.join(differ[:5])} differ")

    def autograder(self, handed_in):
        folder = self.path("autograder")
        os.makedirs(os.path.join(folder, "source"))
        shutil.copytree(self.path("course"), os.path.join(folder, "source", "course"))
        shutil.copytree(os.path.join(handed_in, "a-right"), os.path.join(folder, "submission"))
        programs = self.path("programs")
        os.makedirs(programs)
        os.symlink(os.path.abspath(self.o.program), os.path.join(programs, "shadescope"))
        script = os.path.join(HERE, "..", "..", "resources", "packaging", "autograder", "run_autograder")
        subprocess.run(["sh", script], env={**os.environ, "AUTOGRADER": folder, "PATH": f"{programs}:{os.environ['PATH']}"},
                       stdout=subprocess.DEVNULL)
        results = json.load(open(os.path.join(folder, "results", "results.json")))
        self.expect(results["score"] == 6, results)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--renderer", required=True)
    parser.add_argument("--seed", type=int, default=74)
    parser.add_argument("--all", action="store_true", default=os.environ.get("SHADESCOPE_LONG", "0") not in ("", "0"))
    options = parser.parse_args()
    room = Classroom(options)
    count = 300 if options.all else 60
    room.make(room.path("handed-in"), count)
    room.points(room.path("handed-in"), room.path("class"), count)
    few = room.path("few")  # of the same course, as each costs its time thrice
    os.makedirs(few)
    for name in ("a-right", "e-both-sides", "f-farthest", "i-cut-off", "j-empty", "student 003"):
        shutil.copytree(os.path.join(room.path("handed-in"), name), os.path.join(few, name))
    room.run(few, room.path("once"))
    once = room.bytes_of(room.path("once"))
    room.expect(len(once) > 12, "a class of few")
    room.killed(few, once, options.seed)
    room.shared_out(few, once)
    room.autograder(room.path("handed-in"))
    shutil.rmtree(room.work, ignore_errors=True)
    return 1 if room.failures else 0


if __name__ == "__main__":
    sys.exit(main())
