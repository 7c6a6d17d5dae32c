"""What a render writes: pictures of any size, all of it or nothing, statistics of a fixed shape."""

import json
import re
import resource
import signal
import subprocess
import time
import unittest

from command import (JOB_FAILED, PROGRAM, SCENES, USAGE, CommandTest, add_texture, make_floor,
                     make_png, read_png)


class Pictures(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_scene("floor.gltf", make_floor())

    def render(self, *arguments):
        return self.expect_done("render", "floor.gltf", *arguments)

    def test_odd_sizes(self):
        for width, height in [(1, 1), (1, 7), (33, 17), (257, 3)]:
            self.render("--size", f"{width}x{height}", "-o", "a.png", "-o", "a.exr")
            self.assertEqual(read_png(self.folder / "a.png")[:2], (width, height))

    def test_several_outputs_and_layers(self):
        layers = "beams,transmittance,depth,normal"
        self.render("--size", "16x9", "-o", "a.png", "-o", "a.exr", "-o", "b.EXR", "--aov", layers)
        self.assertEqual(self.files(), ["a.exr", "a.png", "b.EXR", "floor.gltf"])
        content = (self.folder / "a.exr").read_bytes()
        self.assertEqual(content, (self.folder / "b.EXR").read_bytes())
        for channel in [b"beams.R", b"transmittance.G", b"normal.Z", b"\0Z\0"]:
            self.assertIn(channel, content)

    def test_haze_of_zero_draws_no_beams(self):
        text = self.render("--size", "16x9", "-o", "a.png", "--haze=0", "--verbose").stderr
        self.assertRegex(text, r"plan: floor: .*forward")
        self.assertNotIn("beams", text)

    def test_auto_says_what_it_chose(self):
        scene = SCENES / "one_lamp.glb"
        for goal, words in [(["--error", "2%"], ["auto took", "error"]),
                            (["--budget", "60000ms"], ["auto took", "192 sheets"]),
                            (["--budget", "0.01ms"], ["warning", "nothing keeps within 0.01 ms"])]:
            result = self.expect_done("render", scene, "-o", "a.png", "--size", "48x27", "--beams",
                                      "auto", *goal)
            for word in words:
                self.assertIn(word, result.stderr)

    def test_what_auto_tried_is_not_counted(self):
        scene = SCENES / "one_lamp.glb"
        small = ["render", scene, "--size", "48x27", "--exposure", "8", "--stats", "a.json"]
        told = self.expect_done(*small, "--beams", "auto", "--error", "2%").stderr
        method, sheets = re.search(r"auto took (\S+) with (\d+) sheets", told).groups()
        counters = json.loads((self.folder / "a.json").read_text())["counters"]
        self.expect_done(*small, "--beams", method, "--planes", sheets)
        self.assertEqual(counters, json.loads((self.folder / "a.json").read_text())["counters"])

    def test_options_of_planes(self):
        self.render("--size", "32x18", "-o", "a.png", "--beams=planes", "--planes=8", "--cells=4x4",
                    "--K=20", "--dt=0.5", "--phase=gibbons")
        self.assertGreater(max(max(row) for row in read_png(self.folder / "a.png")[2]), 0)

    def test_negative_exposure_needs_no_equals_sign(self):
        self.render("--size", "32x18", "-o", "bright.png", "--exposure", "-2")
        self.render("--size", "32x18", "-o", "dark.png", "--exposure=8")
        total = {name: sum(map(sum, read_png(self.folder / name)[2]))
                 for name in ["bright.png", "dark.png"]}
        self.assertGreater(total["bright.png"], 2 * total["dark.png"])

    def test_what_a_scene_is_made_of_is_not_replaced(self):
        picture = make_png(4, 4)
        self.write("gobo 1.png", picture)
        self.write("wall.exr", b"no picture, but the scene's")
        scene = add_texture(make_floor(), "gobo%201.png")
        self.write_scene("own.gltf", scene)
        for output in ["gobo 1.png", "./gobo 1.png"]:
            self.expect_error(USAGE, ["gobo 1.png", "replaced"], "render", "own.gltf", "-o", output)
        self.assertEqual((self.folder / "gobo 1.png").read_bytes(), picture)
        scene["nodes"][-1]["extras"] = {"light_map": "wall.exr"}
        self.write_scene("own.gltf", scene)
        for command in ["render", "reference"]:
            self.expect_error(USAGE, ["wall.exr", "replaced"], command, "own.gltf", "-o",
                              "wall.exr")

    def test_infinite_light_is_told_of(self):
        errors = self.render("--size", "8x8", "-o", "a.exr", "--K", "1e38").stderr
        self.assertRegex(errors, r"warning: a.exr: \d+ of 64 pixels hold more light")
        errors = self.render("--size", "8x8", "-o", "a.exr", "--aov=depth").stderr
        self.assertEqual(errors, "")  # the depth of the background is infinite

    def test_same_command_same_picture(self):
        for name in ["a.png", "b.png"]:
            self.render("--size", "64x36", "-o", name)
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())

    def test_too_large_for_the_renderer(self):
        self.render("--size", "8x8", "--stats", "a.json")
        if "llvmpipe" not in json.loads((self.folder / "a.json").read_text())["renderer"]:
            self.skipTest("a graphics card may well hold the largest picture")
        self.write("a.png", b"kept")
        self.expect_error(JOB_FAILED, ["16384x16384", "smaller picture"], "render", "floor.gltf",
                          "--size", "16384x16384", "-o", "a.png")
        self.assertEqual((self.folder / "a.png").read_bytes(), b"kept")


class FailedWrites(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_scene("floor.gltf", make_floor())

    def test_no_room_keeps_the_old_picture(self):
        for name in ["a.png", "a.exr"]:
            self.write(name, b"kept")
            # A full disk, as far as the program can tell: no file may grow over 100 bytes.
            self.expect_error(JOB_FAILED, [name, "cannot be written", "raise the limit"], "render", "floor.gltf",
                              "--size", "64x36", "-o", name,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE,
                                                                    (100, 100)))
            self.assertEqual((self.folder / name).read_bytes(), b"kept")
        self.assertEqual(self.files(), ["a.exr", "a.png", "floor.gltf"])

    def test_no_room_for_statistics(self):
        self.expect_error(JOB_FAILED, ["a.json", "cannot be written"], "render", "floor.gltf",
                          "--size", "8x8", "--stats", "a.json",
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100)))
        self.assertEqual(self.files(), ["floor.gltf"])

    def test_interrupts_leave_nothing_half_written(self):
        for number in [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]:
            process = subprocess.Popen(
                [PROGRAM, "render", "floor.gltf", "--size", "1200x800", "-o", "a.exr"],
                cwd=self.folder, stderr=subprocess.PIPE)
            end = time.monotonic() + 60
            # As soon as its temporary file is there, where this is quick enough to see it.
            while process.poll() is None and time.monotonic() < end:
                if any(name.startswith("a.") and name != "a.exr" for name in self.files()):
                    process.send_signal(number)
                    break
            process.communicate(timeout=60)
            self.assertIn(process.returncode, [0, -number])
            self.assertEqual([n for n in self.files() if n not in ["a.exr", "floor.gltf"]], [])


class Statistics(CommandTest):
    def test_shape(self):
        self.expect_done("render", SCENES / "stage.glb", "--size", "64x36", "--repeat", "3",
                         "--stats", "a.json")
        stats = json.loads((self.folder / "a.json").read_text())
        self.assertEqual(stats["plan"], "shadow_map[12] shadow_pyramid[12] forward beams[12] "
                                        "exposure tonemap")
        self.assertGreater(stats["counters"]["runs_lit"], 0)
        self.assertGreater(stats["counters"]["runs_mixed"], 0)
        self.assertLess(stats["counters"]["shadow_fetches"], stats["counters"]["samples"])
        self.assertGreater(len(stats["renderer"]), 0)
        self.assertGreater(stats["frame_ms"], 0)
        self.assertEqual(stats["repeats"], 3)
        names = [each["name"] for each in stats["first_frame_passes"]]
        for name in ["shadow_map", "forward", "beams", "tonemap"]:
            self.assertIn(name, names)
        for each in stats["passes"] + stats["first_frame_passes"]:
            self.assertEqual(sorted(each), ["cpu_ms", "gpu_ms", "name"])
            self.assertGreaterEqual(each["cpu_ms"], 0)
            self.assertGreaterEqual(each["gpu_ms"], 0)
        counters = stats["counters"]
        self.assertEqual(counters["lamps_drawn"] + counters["lamps_skipped"], 12)
        # The later frames keep what the first has drawn.
        self.assertEqual(counters["shadow_maps_drawn"], 12)
        self.assertEqual(counters["shadow_maps_kept"], 24)
        self.assertGreater(counters["draw_calls"], 0)
        self.assertGreater(counters["samples"], 0)
        stages = [each["stage"] for each in stats["load"]]
        for stage in ["read", "parse", "meshes", "images", "context", "upload"]:
            self.assertIn(stage, stages)
        self.assertTrue(all(each["ms"] >= 0 for each in stats["load"]))
        self.assertGreater(stats["peak_bytes"], 1 << 20)

    def test_what_is_skipped_counts_nothing(self):
        self.write_scene("dark.gltf", make_floor(spot=False))
        self.expect_done("render", "dark.gltf", "--size", "8x8", "--stats", "a.json")
        stats = json.loads((self.folder / "a.json").read_text())
        self.assertNotIn("beams", stats["plan"])
        self.assertNotIn("shadow_map", stats["plan"])
        for name in ["lamps_drawn", "lamps_skipped", "shadow_maps_drawn", "samples"]:
            self.assertEqual(stats["counters"][name], 0, name)


if __name__ == "__main__":
    unittest.main()
