"""The Python package, held against the command line, whose program is in SHADESCOPE."""
import gc
import json
import os
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import zlib

import numpy as np
import shadescope as sh

PROGRAM = os.environ["SHADESCOPE"]


def program(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False)


def kilobytes():
    with open("/proc/self/status", encoding="ascii") as status:
        return int(next(line for line in status if line.startswith("VmRSS")).split()[1])


def pixels(png):
    """Of a PNG file of 8-bit colours, whose rows are packed as they are, or less the pixel to the left or above."""
    at, data, size = 8, b"", None
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        if kind == b"IHDR":
            size = struct.unpack(">II", png[at + 8:at + 16])
        data += png[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    rows = np.frombuffer(zlib.decompress(data), np.uint8).reshape(size[1], 1 + 3 * size[0])
    picture = rows[:, 1:].reshape(size[1], size[0], 3).copy()
    for y, kind in enumerate(rows[:, 0]):
        if kind == 1:
            picture[y] = np.cumsum(picture[y], axis=0, dtype=np.uint8)
        elif kind == 2 and y > 0:
            picture[y] += picture[y - 1]
        assert kind <= 2
    return picture


class Frames(unittest.TestCase):
    def test_every_exported_buffer_has_the_bits_of_export(self):
        # Every kind of buffer is among them: vertices, polygons, pixels, texels; float, double, integers, bytes.
        for scene, settings in (("pyramid", {}), ("soft_shadow", {"width": 320, "height": 240}), ("translucent", {}),
                                ("teapot", {"precision": "double", "shading": "gouraud", "width": 320, "height": 240})):
            with tempfile.TemporaryDirectory() as folder:
                told = program("export", scene, "--format", "npy", "-o", folder,
                               *(word for key, value in settings.items() for word in ("--set", f"{key}={value}")))
                self.assertEqual(0, told.returncode, told.stderr)
                frame = sh.render(scene, settings)
                files = sorted(file[:-4] for file in os.listdir(folder) if file.endswith(".npy"))
                self.assertLessEqual(set(frame.keys()), set(files))
                self.assertGreater(len(files), 10)
                for name in files:
                    with self.subTest(scene=scene, buffer=name):
                        expected = np.load(f"{folder}/{name}.npy")
                        self.assertEqual((expected.dtype, expected.shape), (frame[name].dtype, frame[name].shape))
                        self.assertEqual(expected.tobytes(), frame[name].tobytes())

    def test_a_buffer_read_later_has_the_same_bits(self):
        alone, asked = sh.render("pyramid"), sh.render("pyramid")
        for name in asked:  # each makes the frame run what it lacks, on top of all before
            asked[name]
        self.assertEqual(alone["n_dot_l.0"].tobytes(), asked["n_dot_l.0"].tobytes())
        self.assertEqual(alone["color"].tobytes(), asked["color"].tobytes())

    def test_names_are_those_of_the_program(self):
        told = json.loads(program("plan", "soft_shadow", "--json").stdout)
        frame = sh.render("soft_shadow")
        self.assertEqual(told["settings"].keys(), frame.settings.keys())
        names = {row["name"] for row in told["buffers"]}
        self.assertLessEqual({row["name"] for row in frame.buffers}, names)  # the others are derived

    def test_arrays_are_views_that_cannot_be_written(self):
        z = sh.render("pyramid")["z_view"]
        self.assertFalse(z.flags.owndata)
        with self.assertRaises(ValueError):
            z[0, 0] = 1
        with self.assertRaises(ValueError):
            z.flags.writeable = True

    def test_an_array_outlives_its_frame(self):
        kept = sh.render("teapot")["normal"]
        copy = kept.copy()
        for size in range(300, 310):
            sh.render("teapot", width=size)["normal"]
        gc.collect()
        np.testing.assert_array_equal(kept, copy)

    def test_with_reuses_what_did_not_change_and_keeps_the_bits(self):
        frame = sh.render("pyramid", shading="phong")
        frame["z_view"]
        other = frame.with_({"material.0.n": 4})
        self.assertEqual(frame["z_view"].ctypes.data, other["z_view"].ctypes.data)
        actions = {row["stage"]: row["action"] for row in other.plan["stages"]}
        self.assertEqual("reused", actions["z-buffer"])
        fresh = sh.render("pyramid", {"material.0.n": 4}, shading="phong")
        np.testing.assert_array_equal(other["color"], fresh["color"])

    def test_memory_does_not_grow(self):
        def loop(frames):
            frame = sh.render("pyramid", width=160, height=120)
            for n in range(frames):
                frame = frame.with_({"material.0.n": 1 + n % 64})
                frame["color"], frame["z_view"]
        loop(200)
        before = kilobytes()
        loop(800)
        # A frame has 160 × 120 × (4 + 3) bytes in these two buffers alone: 105 MB if they were kept. A tenth of that is left
        # to the heap.
        self.assertLess(kilobytes() - before, 10500)

    def test_threads_read_one_frame(self):
        frame, alone, wrong = sh.render("teapot"), sh.render("teapot"), []
        expected = {name: alone[name].tobytes() for name in alone}

        def read():
            wrong.extend(name for name in expected if frame[name].tobytes() != expected[name])
        threads = [threading.Thread(target=read) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([], wrong)

    def test_another_thread_runs_while_a_frame_is_computed(self):
        turns, ended = [], threading.Event()

        def count():
            while not ended.wait(0.001):
                turns.append(time.monotonic())
        thread = threading.Thread(target=count)
        thread.start()
        before = time.monotonic()
        sh.render("teapot", width=2000, height=2000, antialiasing=2)
        after = time.monotonic()
        ended.set()
        thread.join()
        self.assertGreater(sum(before < turn < after for turn in turns), 2)

    def test_pictures_are_the_programs(self):
        frame = sh.render("pyramid")
        np.testing.assert_array_equal(frame["color"], frame.picture())
        with tempfile.TemporaryDirectory() as folder:
            program("export", "pyramid", "--format", "png", "--buffers", "z_view", "-o", folder)
            with open(folder + "/z_view.png", "rb") as file:
                exported = file.read()
        for png in (exported, frame.png("z_view")):
            np.testing.assert_array_equal(frame.picture("z_view"), pixels(png))

    def test_a_saved_scene_renders_the_same(self):
        frame = sh.render("teapot", shading="flat")
        with tempfile.TemporaryDirectory() as folder:
            frame.save(folder + "/flat.toml")
            again = sh.render(folder + "/flat.toml")
        np.testing.assert_array_equal(frame["color"], again["color"])


class Errors(unittest.TestCase):
    def test_a_place_in_a_file(self):
        with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
            file.write('[[object]]\nshape = "cubee"\n')
            file.flush()
            with self.assertRaises(sh.Error) as raised:
                sh.render(file.name)
        self.assertIn(":2:9: object.0.shape", str(raised.exception))
        self.assertEqual((file.name, 2, 9), raised.exception.places[0][:3])

    def test_unknown_names_are_answered_with_the_nearest(self):
        frame = sh.render("pyramid")
        for bad in (lambda: frame["zview"], lambda: frame.with_(shadin="flat"), lambda: sh.render("pyramidd"),
                    lambda: sh.compare("pyramid", {"dept": [0.0]})):
            with self.assertRaisesRegex(sh.Error, "nearest|there are"):
                bad()

    def test_what_is_no_answer_is_refused(self):
        frame = sh.render("pyramid")
        for bad in (lambda: frame.inspect(640, 0), lambda: frame.inspect(-1, 0), lambda: frame["n_dot_l.7"],
                    lambda: frame.with_(width=-1), lambda: sh.study(frame, shading="round"),
                    lambda: sh.study(frame, shading="all", repeat=0), lambda: sh.compare(frame, {}),
                    lambda: sh.render(b"\xff\xfe.toml".decode("utf-8", "surrogateescape"))):
            with self.assertRaises(sh.Error):
                bad()

    def test_arrays_of_another_shape_are_refused_as_files_are(self):
        depth = sh.render("pyramid")["z_view"]
        with tempfile.TemporaryDirectory() as folder:
            np.save(folder + "/depth.npy", depth.T)
            told = program("compare", "pyramid", folder).stderr
        with self.assertRaises(sh.Error) as raised:
            sh.compare("pyramid", {"depth": depth.T})
        self.assertIn("transpose", told)
        self.assertIn(str(raised.exception), told)

    def test_too_much_memory_is_refused_before_anything_is_made(self):
        frame = sh.render("teapot")
        frame["position"]
        with self.assertRaisesRegex(sh.Error, "at most 4 GiB"):
            frame.with_(width=16000, height=16000)

    def test_too_little_memory_is_an_exception(self):
        child = ("import resource, shadescope as sh\n"
                 "sh.render('pyramid')['color']\n"
                 "now = int(open('/proc/self/statm').read().split()[0]) * 4096\n"
                 "resource.setrlimit(resource.RLIMIT_AS, (now + (200 << 20),) * 2)\n"
                 "try: sh.render('pyramid', width=8000, height=8000)['z_view']\n"
                 "except MemoryError: print(sh.render('pyramid')['color'].shape)\n")
        told = subprocess.run([sys.executable, "-c", child], capture_output=True, text=True, check=False)
        self.assertEqual("(480, 640, 3)\n", told.stdout, told.stderr)

    def test_control_c_ends_a_long_call_and_the_session_goes_on(self):
        signal.signal(signal.SIGINT, signal.default_int_handler)  # a job in the background ignores it
        for call in (lambda: sh.study("pyramid", shading="all", repeat=100000),
                     lambda: sh.render("teapot", width=4096, height=4096, antialiasing=8)):
            timer = threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT))
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                call()
            timer.join()
        self.assertEqual((480, 640, 3), sh.render("pyramid")["color"].shape)


class Judging(unittest.TestCase):
    def test_inspect_says_what_the_command_says(self):
        pixel = sh.render("pyramid").inspect(268, 281)
        told = program("inspect", "pyramid", "--pixel", "268,281", "--json").stdout
        self.assertEqual(json.loads(told), dict(pixel))
        self.assertEqual(program("inspect", "pyramid", "--pixel", "268,281").stdout.strip(), str(pixel).strip())

    def test_compare_says_what_the_command_says(self):
        size = {"width": 160, "height": 120}
        frame = sh.render("pyramid", size)
        bent = frame["z_view"] + np.float32(9) * (frame["polygon_id"] == 2)
        with tempfile.TemporaryDirectory() as folder:
            np.save(folder + "/depth.npy", bent)
            told = json.loads(program("compare", "pyramid", folder, "--json", "--size", "160x120").stdout)
        ours = sh.compare("pyramid", {"depth": bent}, size)
        self.assertFalse(ours)
        self.assertIn(told["headline"], str(ours))
        for member in ("headline", "exit", "first_wrong", "stages", "known"):
            self.assertEqual(told[member], ours[member])

    def test_what_is_right_agrees(self):
        frame = sh.render("pyramid")
        self.assertTrue(sh.compare(frame, {name: frame[name] for name in ("z_view", "color", "normal")}))

    def test_a_study_has_a_row_for_each_point(self):
        study = sh.study("pyramid", shading="all", repeat=2)
        self.assertEqual(["flat", "gouraud", "phong"], [row["shading"] for row in study.rows])
        self.assertTrue(all(row["milliseconds"] > 0 for row in study.rows))
        self.assertEqual(1, study["processes"])
        self.assertIn("phong", str(study))


if __name__ == "__main__":
    unittest.main()
