#!/usr/bin/env python3
"""What `shadescope compare` says of four students' renderers in four languages, error by error.

    trials.py --program SHADESCOPE --c++ RENDERER --c RENDERER [--node NODE] [--only WORD] [--all] [--level LEVEL] [--report FILE]

Each renderer draws a scene of 320 x 240 in its own conventions, once with each of its errors, and hands in its natural files:
picture and depth; normals too; all that it has. An error that changes none of these files beyond its tolerance is left out. Of
each row: whether the first wrong stage is right, alone or among two, and whether the error is named alone, among two, in a
larger set, not at all, or wrongly. A name that is not the error's leaves at most 0.1 % of the pixels unexplained: then its
frame is that of the files, and it counts as a twin (y downwards is a picture upside down, of a program that culls the other
way). Level `left-out` hands in picture and depth, and the error's own name is not tried; level
`two` has two errors at once. Level `picture` is the default. Without --all, or SHADESCOPE_LONG=1, twelve spread rows are taken. The exit status is 1 where a
count is below its floor, and 77 where something to run is missing.
"""
import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import judge  # noqa: E402

BLINN = [f"material.{k}.highlight=blinn-phong" for k in range(3)]
DARK = ["light.0.shadow=off", "light.1.shadow=off"]
# Scene, options of the renderer, settings for Shadescope.
WAYS = {
    "python": ("kiln", ["--shading", "phong", "--no-shadow", "--near", "4", "--planes", "4,40", "--size", "320x240"],
               DARK + ["camera.near=4", "camera.far=40"]),
    "c++": ("quay", ["--shading", "phong", "--near", "4", "--planes", "4,40", "--rows", "bottom-up", "--depth", "ndc",
                     "--size", "320x240"], ["camera.near=4", "camera.far=40"]),
    "js": ("kiln", ["--near", "4"], DARK + BLINN + ["camera.near=4"]),
    "c": ("quay", ["--planes", "4,40"], ["camera.near=4", "camera.far=40"]),
}
PICTURE = ("color", "depth", "z_view")
LEVELS = {"picture": PICTURE, "normals": PICTURE + ("normal",), "all": (), "left-out": PICTURE, "two": PICTURE}
TWELVE = 12
# Two errors at once, each of which shows by itself, and their names in the program's table; the earlier stage first.
TWO = [("js", "turn-back+half-lambert", "rotation-sign+half-lambert", "transform"),
       ("js", "skip-scale+no-power", "unscaled+no-power", "transform"),
       ("js", "cull-positive+light-vector-raw", "cull-sign+l-raw", "cull"),
       ("js", "farther-wins+view-axis", "z-flip+v-axis", "z-buffer"),
       ("js", "one-to-the-right+half-lambert", "column+half-lambert", "transform"),
       ("c", "matrix-transposed+shadow-is-black", "view-transposed+ambient-in-shadow", "transform"),
       ("c", "z-in-a-line+power-as-factor", "z-affine+times-n", "z-buffer"),
       ("c", "normals-of-the-file+no-shadows", "normals-untouched+no-shadow", "normals")]
TWIN = 0.001 * 320 * 240  # pixels of each file that may be left
# From the best outcome to the worst.
OUTCOMES = ("agrees", "alone", "two", "set", "twin", "none", "wrong")


class Trials:
    def __init__(self, options):
        self.o = options
        self.work = tempfile.mkdtemp(prefix="trials-")
        self.renderers = {"python": [sys.executable, os.path.join(HERE, "renderer.py")], "c++": [options.cpp],
                          "js": [options.node, os.path.join(HERE, "renderer.js")], "c": [options.c]}
        if not shutil.which(options.node):
            print("left out: the renderer in JavaScript, as there is no node")
            del self.renderers["js"]
        self.rows = []
        for who, command in self.renderers.items():
            lines = subprocess.run(command + ["--list"], capture_output=True, text=True, check=True).stdout.splitlines()
            for words in map(str.split, lines):
                stage = words[2] if len(words) > 3 else judge.STAGES.get(words[-1], "shading")
                self.rows.append((who, words[0], words[1], stage))

    def render(self, who, error, folder):
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        scene, options, _ = WAYS[who]
        subprocess.run(self.renderers[who] + [os.path.join(HERE, "scenes", scene + ".scene"), folder] + options
                       + (["--error", error] if error else []), check=True)
        return folder

    def keep(self, folder, level):
        for name in os.listdir(folder):
            if LEVELS[level] and name.rsplit(".", 1)[0] not in LEVELS[level]:
                os.remove(os.path.join(folder, name))

    def compare(self, who, folder, *more):
        scene, _, settings = WAYS[who]
        command = [self.o.program, "compare", os.path.join(HERE, "scenes", scene + ".scene"), folder, "--json",
                   "--size", "320x240", "--set", "shading=phong", *more]
        for setting in settings:
            if not (setting.startswith("light.1") and scene == "quay"):
                command += ["--set", setting]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode not in (0, 1):
            sys.exit(f"{' '.join(command)}: status {done.returncode}\n{done.stderr}")
        return done.returncode, json.loads(done.stdout)

    def rows_of(self, level):
        rows = [row for row in (TWO if level == "two" else self.rows) if row[0] in self.renderers]
        if level == "left-out":
            rows = [row for row in rows if row[2] != "-"]
        rows = [row for row in rows if self.o.only in " ".join(row)]
        if not self.o.all and len(rows) > TWELVE:
            rows = [rows[i * (len(rows) - 1) // (TWELVE - 1)] for i in range(TWELVE)]
        return rows

    def outcome(self, level, status, known, found):
        names = sorted({one["id"] for one in found["known"]})
        if status == 0:
            return "agrees"
        if level == "two":
            both = set(known.split("+"))
            return "none" if not names else "alone" if set(names) == both else "set" if both & set(names) else "wrong"
        if known in names and not found["together"]:
            return "alone" if len(names) == 1 else "two" if len(names) == 2 else "set"
        files = sum(len(stage["buffers"]) for stage in found["stages"])
        if names and all(one["left"] <= TWIN * files for one in found["known"]):
            return "twin"
        return "wrong" if names else "none"

    def run(self, level):
        count = {"rows": 0, "right renderers accused": 0, "certain of shading though depth differs": 0, "stage": 0,
                 "stage of two": 0, "unknown": 0, "unknown named": 0, **dict.fromkeys(OUTCOMES, 0)}
        kinds, outcomes = {}, {}
        rows = self.rows_of(level)
        for who in sorted({row[0] for row in rows}):
            right = self.render(who, "", os.path.join(self.work, f"right-{who}"))
            self.keep(right, level)
            status, found = self.compare(who, right)
            count["right renderers accused"] += status != 0
            print(f"{level} {who} right: {found['headline']}", flush=True)
        for who, error, known, stage in rows:
            mine = self.render(who, error, os.path.join(self.work, "mine"))
            self.keep(mine, level)
            if not judge.differing(mine, os.path.join(self.work, f"right-{who}")):
                print(f"{level} {who} {error}: changes nothing here")
                continue
            begun = os.times()
            status, found = self.compare(who, mine, *(["--without", known] if level == "left-out" else []))
            ended = os.times()
            count["rows"] += 1
            first = found.get("first_wrong") or {}
            stages = first.get("stages") or [first.get("stage")]
            z_view = [buffer for row in found["stages"] for buffer in row["buffers"] if buffer["name"] == "z_view"]
            count["certain of shading though depth differs"] += (
                first.get("certain", False) and first["stage"] == "shading" and any(not one["agrees"] for one in z_view))
            count["stage"] += stages == [stage]
            count["stage of two"] += stage in stages and len(stages) <= 2
            outcome = self.outcome(level, status, known, found)
            if known == "-":
                count["unknown"] += 1
                count["unknown named"] += outcome == "wrong"
            else:
                count[outcome] += 1
                kinds.setdefault(stage, dict.fromkeys(OUTCOMES, 0))[outcome] += 1
                outcomes[who, error] = outcome
            seconds = ended.children_user + ended.children_system - begun.children_user - begun.children_system
            print(f"{level} {who} {error} ({known}): {outcome} {','.join(one['id'] for one in found['known'])}; "
                  f"{'/'.join(map(str, stages))} for {stage}; {found['headline']} next "
                  f"{(found.get('next') or {}).get('id')}; {seconds:.1f} s", flush=True)
        for stage, of in sorted(kinds.items()):
            print(f"{level} {stage}: " + ", ".join(f"{name} {n}" for name, n in of.items() if n), flush=True)
        print(json.dumps({level: count}), flush=True)
        return count, outcomes


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--c++", dest="cpp", required=True)
    parser.add_argument("--c", required=True)
    parser.add_argument("--node", default="node")
    parser.add_argument("--only", default="")
    parser.add_argument("--report", default="", help="a file for the outcome of each row, as JSON")
    parser.add_argument("--level", choices=tuple(LEVELS), action="append")
    parser.add_argument("--only-long", action="store_true", help="run nothing where twelve rows are asked for")
    parser.add_argument("--all", action="store_true", default=os.environ.get("SHADESCOPE_LONG", "0") not in ("", "0"))
    options = parser.parse_args()
    if options.only_long and not options.all:
        print("left out: ./test --long runs it")
        return 77
    trials = Trials(options)
    good, by_level = True, {}
    for level in options.level or ("picture",):
        count, by_level[level] = trials.run(level)
        good = good and count["right renderers accused"] == 0 and count["certain of shading though depth differs"] == 0
        known = sum(count[name] for name in OUTCOMES)
        if options.only or known < 8:
            continue
        # Shares of those that are known: alone or among two at least, the right one in what is named at least, wrong at most.
        named, holds, wrong = {"picture": (0.65, 0.9, 0), "normals": (0.65, 0.9, 0), "all": (0.9, 0.95, 0),
                               "left-out": (0, 0, 0.12), "two": (0, 0, 0)}[level]
        right = count["alone"] + count["two"] + count["twin"]
        good = good and right >= named * known and right + count["set"] >= holds * known and count["wrong"] <= wrong * known
    if "picture" in by_level and "normals" in by_level:
        for row, before in by_level["picture"].items():
            after = by_level["normals"].get(row, before)
            if OUTCOMES.index(after) > OUTCOMES.index(before):
                print(f"normals make it worse: {' '.join(row)}, {before} and then {after}")
                good = False
    if options.report:
        with open(options.report, "w") as file:
            json.dump({level: {" ".join(row): outcome for row, outcome in of.items()} for level, of in by_level.items()},
                      file, indent=1)
    shutil.rmtree(trials.work, ignore_errors=True)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
