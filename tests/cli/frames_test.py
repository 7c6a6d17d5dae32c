"""Animated scenes: a time, a range of frames, what is kept between runs, films."""

import json
import os
import re
import signal
import stat
import subprocess
import sys
import time
import unittest

from command import (DIALS, JOB_FAILED, LIGHT, PROGRAM, USAGE, CommandTest, add_accessor, add_node,
                     make_dialed_floor, make_floor, make_moving_floor, read_png)

SIZE = ["--size", "32x18", "--exposure", "5"]

# An ffmpeg for tests: keeps its arguments and its input where the film would be.
FAKE_FFMPEG = """#!{python}
import json, sys
content = sys.stdin.buffer.read()
with open(sys.argv[-1].removeprefix("file:"), "wb") as film:
    film.write(json.dumps(sys.argv[1:]).encode() + b"\\n" + content)
"""
BROKEN_FFMPEG = """#!{python}
import sys
sys.stdin.buffer.read(1)
sys.stderr.write("Unknown encoder 'libx264'\\n")
sys.exit(8)
"""


def add_moving_sun(scene):
    """A sun that climbs while the lamp swings."""
    extension = "KHR_lights_punctual"
    scene["extensions"][extension]["lights"].append({"type": "directional"})
    add_node(scene, name="sun", extensions={extension: {"light": 1}})
    turns = add_accessor(scene, 4, [-0.1, 0, 0, 0.99498744, -0.5, 0, 0, 0.8660254])
    dolly = scene["animations"][-1]["samplers"][0]
    scene["animations"].append({
        "samplers": [{"input": dolly["input"], "output": turns}],
        "channels": [{"sampler": 0,
                      "target": {"node": len(scene["nodes"]) - 1, "path": "rotation"}}]})
    return scene


class Moving(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_scene("floor.gltf", make_moving_floor())

    def render(self, *arguments, **options):
        return self.expect_done("render", "floor.gltf", *SIZE, *arguments, **options)

    def pictures(self):
        return [name for name in self.files() if name.endswith((".png", ".exr"))]

    def content(self, name):
        """Without the time at which an EXR was written."""
        content = (self.folder / name).read_bytes()
        return re.sub(rb"\d{4}:\d\d:\d\d \d\d:\d\d:\d\d", b"", content, count=1)


class Times(Moving):
    def test_a_time_moves_the_scene(self):
        for seconds in ["0", "0.25", "0.5", "1", "7"]:
            self.render("--time", seconds, "-o", f"{seconds}.png")
        self.render("-o", "rest.png")
        self.assertEqual(self.content("0.png"), self.content("rest.png"))
        self.assertNotEqual(self.content("0.25.png"), self.content("rest.png"))
        self.assertNotEqual(self.content("0.25.png"), self.content("0.5.png"))
        # After its end the animation stands still.
        self.assertEqual(self.content("7.png"), self.content("1.png"))

    def test_one_animation_of_several(self):
        for name in ["swing", "rise", "dolly", "0", "all"]:
            self.render("--time", "0.5", "--animation", name, "-o", f"{name}.png")
        self.assertEqual(self.content("swing.png"), self.content("0.png"))
        contents = {self.content(f"{name}.png") for name in ["swing", "rise", "dolly", "all"]}
        self.assertEqual(len(contents), 4)
        self.expect_error(USAGE, ["no animation 'jump'", "0 swing", "1 rise"], "render",
                          "floor.gltf", "--time", "1", "--animation", "jump", "-o", "a.png")
        self.expect_error(USAGE, ["no animation '3'"], "render", "floor.gltf", "--time", "1",
                          "--animation", "3", "-o", "a.png")

    def test_inspect_lists_them(self):
        text = self.expect_done("inspect", "floor.gltf").stdout
        self.assertIn("animations 3, 1 s together, of 3 nodes", text)
        self.assertIn("0 'swing' 1 s, 1 channel\n", text)

    def test_a_scene_that_does_not_move_is_told(self):
        self.write_scene("still.gltf", make_floor())
        text = self.expect_done("render", "still.gltf", *SIZE, "--time", "1", "-o", "a.png").stderr
        self.assertIn("nothing in the file is animated", text)

    def test_wrong_usage(self):
        for arguments, words in [
                (["--animation", "rise"], ["--animation", "--time or --frames"]),
                (["--time", "-1"], ["--time", "-1"]),
                (["--time", "soon"], ["--time", "soon"]),
                (["--fps", "24"], ["--fps", "--frames"]),
                (["--frames", "3"], ["--frames", "FIRST:LAST"]),
                (["--frames", "3:1"], ["--frames", "3:1"]),
                (["--frames", "-1:1"], ["--frames", "-1:1"]),
                (["--frames", "a:b"], ["--frames", "a:b"]),
                (["--frames", "0:1000000"], ["--frames", "999999"]),
                (["--frames", "0:1", "--fps", "0"], ["--fps", "0"]),
                (["--frames", "0:1", "--time", "1"], ["--frames", "--time"]),
                (["--frames", "0:1", "--repeat", "2"], ["--frames", "--repeat"]),
                (["--frames", "0:1", "--stats", "a.json"], ["--frames", "--stats"]),
                (["--frames", "0:1", "--still"], ["--frames", "--still"])]:
            self.expect_error(USAGE, words, "render", "floor.gltf", "-o", "a.png", *arguments)
        # Frame 10 of both.
        self.expect_error(USAGE, ["a_10.png"], "render", "floor.gltf", "-o", "a_#.png", "-o", "a_##.png",
                          "--frames", "9:10")
        self.expect_error(USAGE, ["--frames", "-o"], "render", "floor.gltf", "--frames", "0:1",
                          "--verbose")
        self.expect_error(USAGE, ["a.mp4", "--frames"], "render", "floor.gltf", "-o", "a.mp4")
        self.assertEqual(self.files(), ["floor.gltf"])


class Pointers(Moving):
    """What KHR_animation_pointer changes of lamps, cameras and materials reaches the picture."""

    def test_each_is_drawn_as_if_it_were_the_files_own(self):
        """At its end an animation shows what a file shows that has the last keys' values itself."""
        for pointer, (_, last) in DIALS.items():
            self.write_scene("floor.gltf", make_dialed_floor({pointer: DIALS[pointer]}))
            scene = make_dialed_floor({pointer: DIALS[pointer]})
            holder = scene
            *path, name = pointer[1:].split("/")
            for step in path:
                holder = holder[int(step) if step.isdigit() else step]
            holder[name] = last[0] if len(last) == 1 else last
            del scene["animations"], scene["extensionsRequired"]
            self.write_scene("own.gltf", scene)
            self.render("-o", "rest.png")
            self.render("--time", "1", "-o", "posed.png")
            self.expect_done("render", "own.gltf", *SIZE, "-o", "own.png")
            self.assertEqual(self.content("posed.png"), self.content("own.png"), pointer)
            self.assertNotEqual(self.content("posed.png"), self.content("rest.png"), pointer)

    def test_frames_are_their_times_drawn_alone(self):
        self.write_scene("floor.gltf", make_dialed_floor())
        self.render("--frames", "0:4", "--fps", "4", "-o", "shot_#.png")
        contents = set()
        for i in range(5):
            self.render("--time", i / 4, "-o", "alone.png")
            self.assertEqual(self.content(f"shot_{i}.png"), self.content("alone.png"), i)
            contents.add(self.content("alone.png"))
        self.assertEqual(len(contents), 5)

    def test_a_look_has_the_last_word(self):
        self.write_scene("floor.gltf", make_dialed_floor({LIGHT + "/intensity": ([1000], [10])}))
        look = {"ribalta_look": 1, "lamps": [{"name": "lamp", "intensity": 1000}]}
        self.write("a.look.json", json.dumps(look).encode())
        self.render("-o", "rest.png")
        self.render("--time", "1", "-o", "dim.png")
        self.render("--time", "1", "--look", "a.look.json", "-o", "look.png")
        self.assertEqual(self.content("look.png"), self.content("rest.png"))
        self.assertNotEqual(self.content("look.png"), self.content("dim.png"))
        self.render("--frames", "0:1", "--fps", "1", "--look", "a.look.json", "-o", "f_#.png")
        self.assertEqual(self.content("f_1.png"), self.content("rest.png"))

    def test_inspect_counts_them(self):
        self.write_scene("floor.gltf", make_dialed_floor())
        text = self.expect_done("inspect", "--strict", "floor.gltf").stdout
        self.assertIn("animations 1, 1 s together, of 0 nodes and 5 properties of lamps, cameras, "
                      "materials and nodes", text)


class Frames(Moving):
    def test_numbers_and_contents(self):
        """Each frame is, byte by byte, the picture of its time drawn alone; the last two are alike,
        as nothing moves any more."""
        self.render("--frames", "0:5", "--fps", "4", "-o", "shot_##.png", "-o", "light.exr")
        self.assertEqual(self.pictures(),
                         [f"light_000{i}.exr" for i in range(6)]
                         + [f"shot_0{i}.png" for i in range(6)])
        for i in range(6):
            self.render("--time", i / 4, "-o", "alone.png", "-o", "alone.exr")
            self.assertEqual(self.content(f"shot_0{i}.png"), self.content("alone.png"), i)
            self.assertEqual(self.content(f"light_000{i}.exr"), self.content("alone.exr"), i)
        self.assertNotEqual(self.content("shot_00.png"), self.content("shot_01.png"))

    def test_a_sun_that_moves(self):
        self.write_scene("sun.gltf", add_moving_sun(make_moving_floor()))
        sky = ["sun.gltf", "--size", "32x18", "--exposure", "13", "--sky", "chapman"]
        self.expect_done("render", *sky, "--frames", "0:2", "--fps", "2", "-o", "a_#.png")
        for i in range(3):
            self.expect_done("render", *sky, "--time", i / 2, "-o", "alone.png")
            self.assertEqual(self.content(f"a_{i}.png"), self.content("alone.png"), i)
        # A sun that is told stays where it is.
        self.expect_done("render", *sky, "--sun", "12,180", "--frames", "2:2", "--fps", "2", "-o",
                         "b_#.png")
        self.assertNotEqual(self.content("a_2.png"), self.content("b_2.png"))

    def test_names(self):
        self.render("--frames", "9:10", "-o", "#.png", "-o", "a##b###c.png", "-o", "plain.png")
        self.assertEqual(self.pictures(), ["10.png", "9.png", "a##b009c.png", "a##b010c.png",
                                           "plain_0009.png", "plain_0010.png"])

    def test_what_is_there_is_kept(self):
        command = ["--frames", "0:3", "--fps", "4", "-o", "a_#.png", "-o", "b_#.exr"]
        self.render(*command)
        first = {name: self.content(name) for name in self.pictures()}
        times = {name: (self.folder / name).stat().st_mtime_ns for name in first}
        (self.folder / "a_1.png").unlink()
        cut = first["a_2.png"]
        self.write("a_2.png", cut[: len(cut) // 2])
        self.write("b_3.exr", first["b_3.exr"][:200])
        text = self.render(*command).stderr
        self.assertIn("1 of 4 were there already", text)
        for name, content in first.items():
            self.assertEqual(self.content(name), content, name)
            kept = (self.folder / name).stat().st_mtime_ns == times[name]
            self.assertEqual(kept, name not in ["a_1.png", "a_2.png", "b_3.exr"], name)
        # All of it.
        self.assertIn("4 of 4", self.render(*command).stderr)
        # Not of this size, and not wanted.
        self.expect_done("render", "floor.gltf", "--size", "30x18", *command)
        self.assertEqual(read_png(self.folder / "a_0.png")[:2], (30, 18))
        before = (self.folder / "a_0.png").stat().st_mtime_ns
        self.expect_done("render", "floor.gltf", "--size", "30x18", *command, "--fresh")
        self.assertGreater((self.folder / "a_0.png").stat().st_mtime_ns, before)

    def test_what_has_other_layers_or_is_older_than_the_scene_is_not_kept(self):
        command = ["--frames", "0:1", "-o", "b.exr"]
        self.render(*command)
        self.assertNotIn("were there already", self.render(*command, "--aov", "depth").stderr)
        self.assertIn(b"\0Z\0", self.content("b_0001.exr"))
        self.assertIn("2 of 2", self.render(*command).stderr)
        later = (self.folder / "b_0001.exr").stat().st_mtime + 1
        os.utime(self.folder / "floor.gltf", (later, later))
        self.assertNotIn("were there already", self.render(*command).stderr)

    def test_auto_exposure_is_told(self):
        text = self.expect_done("render", "floor.gltf", "--size", "32x18", "--frames", "0:1", "-o",
                                "a.png").stderr
        self.assertRegex(text, r"each has its own exposure.*--exposure")
        # Its own, and not that of the frames before.
        self.expect_done("render", "floor.gltf", "--size", "32x18", "--time", 1 / 24, "-o",
                         "alone.png")
        self.assertEqual(self.content("a_0001.png"), self.content("alone.png"))

    def test_no_frame_replaces_the_scene(self):
        self.write("floor_0001.png", self.content("floor.gltf"))
        scene = make_moving_floor()
        scene["nodes"][-1]["extras"] = {"light_map": "floor_0001.png"}
        self.write_scene("own.gltf", scene)
        self.expect_error(USAGE, ["floor_0001.png", "replaced"], "render", "own.gltf", *SIZE,
                          "--frames", "0:2", "-o", "floor.png")
        self.assertEqual(self.content("floor_0001.png"), self.content("floor.gltf"))

    def test_no_folder_is_told_before_drawing(self):
        self.expect_error(JOB_FAILED, ["none", "folder"], "render", "floor.gltf", "--frames", "0:1",
                          "-o", "none/a_#.png")

    def test_an_interrupt_keeps_what_is_done(self):
        process = subprocess.Popen(
            [PROGRAM, "render", "floor.gltf", "--size", "640x360", "--frames", "0:9999", "-o",
             "a_####.png"], cwd=self.folder, stderr=subprocess.PIPE, text=True)
        end = time.monotonic() + 60
        while not (self.folder / "a_0002.png").exists() and time.monotonic() < end:
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, text = process.communicate(timeout=60)
        self.assertEqual(process.returncode, -signal.SIGINT, text)
        self.assertIn("interrupted", text)
        names = self.pictures()
        self.assertEqual(names, [f"a_{i:04}.png" for i in range(len(names))])
        for name in names:
            self.assertEqual(read_png(self.folder / name)[:2], (640, 360))
        self.assertIn(f"{len(names)} of 10000", text)


class Films(Moving):
    def install(self, text):
        (self.folder / "bin").mkdir(exist_ok=True)
        program = self.folder / "bin/ffmpeg"
        program.write_text(text.format(python=sys.executable), encoding="utf-8")
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
        return {"PATH": str(self.folder / "bin")}

    def test_frames_reach_ffmpeg(self):
        path = self.install(FAKE_FFMPEG)
        self.render("--frames", "0:2", "--fps", "4", "-o", "a.mp4", "-o", "a_#.png",
                    environment=path)
        arguments, pixels = self.content("a.mp4").split(b"\n", 1)
        arguments = json.loads(arguments)
        for option, value in [("-video_size", "32x18"), ("-framerate", "4"), ("-i", "pipe:0"),
                              ("-c:v", "libx264")]:
            self.assertEqual(arguments[arguments.index(option) + 1], value)
        shown = b"".join(b"".join(read_png(self.folder / f"a_{i}.png")[2]) for i in range(3))
        self.assertEqual(pixels, shown)
        self.assertEqual(self.files(), ["a.mp4", "a_0.png", "a_1.png", "a_2.png", "bin",
                                        "floor.gltf"])

    def test_no_ffmpeg_is_told_before_drawing(self):
        (self.folder / "bin").mkdir()
        self.expect_error(JOB_FAILED, ["a.webm", "ffmpeg", "install", "a_####.png"], "render",
                          "floor.gltf", *SIZE, "--frames", "0:1", "-o", "a.webm", "-o", "a.png",
                          environment={"PATH": str(self.folder / "bin")})
        self.assertEqual(self.files(), ["bin", "floor.gltf"])

    def test_what_ffmpeg_says_is_passed_on(self):
        path = self.install(BROKEN_FFMPEG)
        self.write("a.mkv", b"kept")
        self.expect_error(JOB_FAILED, ["a.mkv", "ffmpeg", "Unknown encoder 'libx264'"], "render",
                          "floor.gltf", "--size", "640x360", "--frames", "0:3", "-o", "a.mkv",
                          environment=path)
        self.assertEqual(self.content("a.mkv"), b"kept")
        self.assertEqual(self.files(), ["a.mkv", "bin", "floor.gltf"])

    def test_odd_sizes_are_refused(self):
        self.expect_error(USAGE, ["--size", "even", "33x18"], "render", "floor.gltf", "--size",
                          "33x18", "--frames", "0:1", "-o", "a.mp4",
                          environment=self.install(FAKE_FFMPEG))

    def test_an_interrupt_leaves_no_film(self):
        path = self.install(FAKE_FFMPEG)
        process = subprocess.Popen(
            [PROGRAM, "render", "floor.gltf", "--size", "640x360", "--frames", "0:9999", "-o",
             "a_#.png", "-o", "a.mp4"], cwd=self.folder, stderr=subprocess.PIPE, text=True,
            env={**os.environ, **path})
        end = time.monotonic() + 60
        while not (self.folder / "a_1.png").exists() and time.monotonic() < end:
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, text = process.communicate(timeout=60)
        self.assertEqual(process.returncode, -signal.SIGINT, text)
        self.assertIn("the film is not written", text)
        self.assertEqual([name for name in self.files() if name.endswith(".mp4")], [])


if __name__ == "__main__":
    unittest.main()
