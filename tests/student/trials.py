#!/usr/bin/env python3
"""What `shadescope compare` says of four students' renderers in four languages, error by error.

    trials.py --program SHADESCOPE --c++ RENDERER --c RENDERER [--node NODE] [--only WORD] [--all] [--level LEVEL] [--report FILE]

Each renderer draws a scene of 320 x 240 in its own conventions, once with each of its errors, and hands in its natural files:
picture and depth; normals too; all that it has. An error that changes none of these files beyond its tolerance is left out. Of
each row: whether the first wrong stage is right, alone or among two, and whether the error is named alone, among two, in a
larger set, not at all, or wrongly. Without --all, or SHADESCOPE_LONG=1, twelve spread rows are taken. The exit status is 1 where
a count is below its floor, and 77 where something to run is missing.
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
LEVELS = {"picture": ("color", "depth", "z_view"), "normals": ("color", "depth", "z_view", "normal"), "all": ()}
TWELVE = 12


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

    def compare(self, who, folder):
        scene, _, settings = WAYS[who]
        command = [self.o.program, "compare", os.path.join(HERE, "scenes", scene + ".scene"), folder, "--json",
                   "--size", "320x240", "--set", "shading=phong"]
        for setting in settings:
            if not (setting.startswith("light.1") and scene == "quay"):
                command += ["--set", setting]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode not in (0, 1):
            sys.exit(f"{' '.join(command)}: status {done.returncode}\n{done.stderr}")
        return done.returncode, json.loads(done.stdout)

    def run(self, level):
        count = dict.fromkeys(("rows", "right renderers accused", "agrees", "stage", "stage of two", "alone", "two", "set",
                               "none", "wrong", "unknown", "unknown named"), 0)
        for who in self.renderers:
            right = self.render(who, "", os.path.join(self.work, f"right-{who}"))
            self.keep(right, level)
            status, found = self.compare(who, right)
            count["right renderers accused"] += status != 0
            print(f"{level} {who} right: {found['headline']}", flush=True)
        rows = [row for row in self.rows if self.o.only in " ".join(row)]
        if not self.o.all and len(rows) > TWELVE:
            rows = [rows[i * (len(rows) - 1) // (TWELVE - 1)] for i in range(TWELVE)]
        for who, error, known, stage in rows:
            mine = self.render(who, error, os.path.join(self.work, "mine"))
            self.keep(mine, level)
            if not judge.differing(mine, os.path.join(self.work, f"right-{who}")):
                print(f"{level} {who} {error}: changes nothing here")
                continue
            status, found = self.compare(who, mine)
            count["rows"] += 1
            names = sorted({one["id"] for one in found["known"]})
            first = found.get("first_wrong") or {}
            stages = first.get("stages") or [first.get("stage")]
            count["stage"] += stages == [stage]
            count["stage of two"] += stage in stages and len(stages) <= 2
            if status == 0:
                outcome = "agrees"
            elif known == "-":
                count["unknown"] += 1
                outcome = "unknown named" if names else "none"
            elif known in names:
                outcome = "alone" if len(names) == 1 else "two" if len(names) == 2 else "set"
            else:
                outcome = "wrong" if names else "none"
            count[outcome] += 1
            print(f"{level} {who} {error} ({known}): {outcome} {','.join(names)}; {'/'.join(map(str, stages))} for {stage}; "
                  f"{found['headline']}", flush=True)
        print(json.dumps({level: count}), flush=True)
        return count


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--c++", dest="cpp", required=True)
    parser.add_argument("--c", required=True)
    parser.add_argument("--node", default="node")
    parser.add_argument("--only", default="")
    parser.add_argument("--level", choices=tuple(LEVELS), action="append")
    parser.add_argument("--all", action="store_true", default=os.environ.get("SHADESCOPE_LONG", "0") not in ("", "0"))
    options = parser.parse_args()
    trials = Trials(options)
    good = True
    for level in options.level or (LEVELS if options.all else ("picture",)):
        count = trials.run(level)
        good = good and count["right renderers accused"] == 0
        known = sum(count[name] for name in ("alone", "two", "set", "none", "wrong", "agrees")) - count["unknown"]
        known += count["unknown named"]
        if level == "picture" and not options.all and not options.only and known >= 8:  # what has been reached
            named = count["alone"] + count["two"]
            good = good and named >= 0.5 * known and named + count["set"] >= 0.8 * known and count["wrong"] == 0
    shutil.rmtree(trials.work, ignore_errors=True)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
