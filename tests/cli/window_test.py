"""The window, as a person uses it: real keys, a real mouse, dropped files, on a display of its own."""

import json
import math
import os
import pathlib
import re
import shutil
import signal
import subprocess
import time
import unittest

from command import (NO_OPENGL, PROGRAM, SCENES, CommandTest, add_node, make_dialed_floor, make_floor,
                     make_moving_floor, make_png, read_png)
from desktop import Desktop, wait_until

WIDTH, HEIGHT = 640, 360
SHADERS = pathlib.Path(__file__).resolve().parents[2] / "shaders"


class WindowTest(CommandTest):
    @classmethod
    def setUpClass(cls):
        cls.desktop = Desktop()

    @classmethod
    def tearDownClass(cls):
        cls.desktop.close()

    def setUp(self):
        super().setUp()
        self.write_scene("floor.gltf", make_floor())

    def open(self, *arguments, first="opened"):
        """Opens the window and waits for the first picture."""
        self.log = open(self.folder / "log.txt", "w+", encoding="utf-8")
        self.addCleanup(self.log.close)
        self.process = subprocess.Popen(
            [PROGRAM, "view", "--no-panels", *map(str, arguments), "--size", f"{WIDTH}x{HEIGHT}", "--stats",
             "stats.json"], cwd=self.folder, stderr=self.log,
            env={**os.environ, "DISPLAY": self.desktop.display,
                 "XDG_CACHE_HOME": str(self.folder / "cache")})
        self.addCleanup(self.end)
        self.window = self.desktop.find_window(self.process)
        if first:
            self.expect(first)
            self.rest()
            self.point(WIDTH // 4, HEIGHT - 20)

    def end(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()

    def said(self):
        return (self.folder / "log.txt").read_text(encoding="utf-8")

    def expect(self, text, times=1):
        """Waits until the window has said so."""
        def heard():
            self.assertIsNone(self.process.poll(), self.said())
            return self.said().count(text) >= times
        wait_until(f"'{text}' in: {self.said()}", heard)

    def rest(self, seconds=0.1):
        """Waits until the window has taken in what was done: for so long it does nothing."""
        def ticks():
            fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text(encoding="utf-8")
            return sum(map(int, fields.rpartition(")")[2].split()[11:13]))

        def rests():
            before = ticks()
            self.assertIsNone(self.process.poll(), self.said())
            time.sleep(seconds)
            return ticks() - before <= 1
        wait_until("the window to rest", rests)

    def choose(self, x, y):
        """Clicks on a lamp."""
        self.point(x, y)
        self.desktop.do("click", 1)
        self.rest()

    def point(self, x, y):
        self.desktop.do("mousemove", "--window", self.window, round(x), round(y))

    def press(self, *keys):
        self.desktop.do("key", *keys)

    def drag(self, button, start, end):
        self.point(*start)
        self.desktop.do("mousedown", button)
        self.rest()
        for step in range(1, 6):
            self.point(*(a + (b - a) * step / 5 for a, b in zip(start, end)))
        self.rest()
        self.desktop.do("mouseup", button)

    def drop(self, *files):
        self.desktop.drop(self.window, [self.folder / file for file in files])

    def save_look(self, name):
        """Presses Ctrl+S; the look, once it is there."""
        before = self.said().count("saved")
        self.press("ctrl+s")
        self.expect("saved", before + 1)
        return json.loads((self.folder / name).read_text())

    def save_picture(self, name):
        before = self.said().count("saved")
        self.press("F12")
        self.expect("saved", before + 1)
        return read_png(self.folder / name)

    def close(self):
        """Presses Escape; the statistics."""
        self.press("Escape")
        self.process.wait(timeout=60)
        self.assertEqual(self.process.returncode, 0, self.said())
        stats = json.loads((self.folder / "stats.json").read_text())
        self.assertEqual(stats["gl_errors"], 0, self.said())
        self.assertNotIn("OpenGL error", self.said())
        return stats

    def expect_same_picture(self, look, name):
        """`render --look` and `sweep --look` draw what the window saved, to the last code value."""
        seen = read_png(self.folder / name)
        self.expect_done("render", "floor.gltf", "--look", look, "-o", "rendered.png")
        self.assertEqual(read_png(self.folder / "rendered.png"), seen)
        self.expect_done("sweep", "floor.gltf", "--look", look, "-o", "swept", "--keep-frames", "--repeat=1",
                         "--warmup=0", "--reference-visibility=none")
        points = json.loads((self.folder / "swept/sweep.json").read_text())["benchmarks"]
        self.assertEqual(len(points), 1)
        self.assertEqual(read_png(self.folder / "swept" / points[0]["frame"]), seen)


class AnEvening(WindowTest):
    """What a lighting designer does, from opening a scene to rendering the look that was found."""

    def lamp_in_view(self):
        """Where the lamp of make_floor() is seen: 5 m high, from 2 m and 8 m away."""
        focal = HEIGHT / 2 / math.tan(0.9 / 2)
        return WIDTH / 2, HEIGHT / 2 - focal * (5 - 2) / 8

    def test_find_and_keep_a_look(self):
        # With a black rim, which is left out.
        self.write("gobo.png", (SCENES / "gobo_star.png").read_bytes())
        self.open("floor.gltf")
        before = self.save_picture("floor_001.png")

        self.choose(*self.lamp_in_view())
        self.press("equal", "equal", "equal")
        look = self.save_look("floor.look.json")
        self.assertEqual([lamp["name"] for lamp in look["lamps"]], ["lamp"])
        self.assertAlmostEqual(look["lamps"][0]["outer_cone_degrees"],
                               math.degrees(0.3 * 1.05**3), places=5)

        self.drop("gobo.png")
        wait_until("the light map", lambda: self.save_look("floor.look.json")["lamps"][0].get(
            "light_map") == {"file": "gobo.png"})
        self.drag(1, (150, 250), (190, 240))  # around the middle
        self.drag(3, (150, 250), (150, 230))  # nearer
        turned = self.save_look("floor.look.json")
        self.assertNotEqual(turned["camera"]["position"], look["camera"]["position"])
        self.assertEqual(turned["size"], [WIDTH, HEIGHT])

        after = self.save_picture("floor_002.png")
        self.assertNotEqual(before, after)
        stats = self.close()
        self.assertEqual(stats["scenes_loaded"], 1)
        self.expect_same_picture("floor.look.json", "floor_002.png")

    def test_aim_by_dragging_the_cross(self):
        self.open("floor.gltf")
        self.choose(*self.lamp_in_view())
        # The lamp aims at the floor's middle, 2 m below the camera's height.
        focal = HEIGHT / 2 / math.tan(0.9 / 2)
        cross = WIDTH / 2, HEIGHT / 2 + focal * 2 / 8
        self.drag(1, cross, (cross[0] - focal * 1 / 8, cross[1]))
        lamp = self.save_look("floor.look.json")["lamps"][0]
        self.close()
        # Turned towards a point 1 m to the left on the floor, 5 m below.
        x, y, z, w = lamp["rotation"]
        forward = (-2 * (x * z + w * y), -2 * (y * z - w * x), -(1 - 2 * (x * x + y * y)))
        self.assertAlmostEqual(forward[0] / -forward[1], -1 / 5, delta=0.02)
        self.assertAlmostEqual(forward[2], 0.0, delta=0.02)

    def test_switches_solo_and_panels(self):
        scene = make_floor()
        add_node(scene, name="other", translation=[1, 5, 0],
                 extensions={"KHR_lights_punctual": {"light": 0}})
        self.write_scene("floor.gltf", scene)
        self.open("floor.gltf")
        self.choose(*self.lamp_in_view())
        self.press("shift+o")
        self.assertTrue(self.save_look("floor.look.json")["lamps"][0]["solo"])
        self.press("shift+o", "o")
        lamp = self.save_look("floor.look.json")["lamps"][0]
        self.assertEqual((lamp["on"], lamp.get("solo")), (False, None))
        self.press("h", "p", "z", "l")
        self.press("h", "p", "z", "l")
        # Cameras: walk away, come back.
        self.desktop.do("keydown", "d")
        self.desktop.do("keyup", "d")
        self.press("Return")
        home = self.save_look("floor.look.json")["camera"]
        self.assertEqual(home["position"], [0, 2, 8])
        self.close()


class Animation(WindowTest):
    def play_and_pause(self):
        """The look at a moment within the second of the animation."""
        self.press("space")

        def moment():
            look = self.save_look("floor.look.json")  # which pauses
            if 0.05 < look["time"]["seconds"] < 0.95:
                return look
            self.press("space")
            return None
        return wait_until("a moment of the animation", moment)

    def test_play_and_keep_a_moment(self):
        self.write_scene("floor.gltf", make_moving_floor())
        self.open("floor.gltf")
        self.assertNotIn("time", self.save_look("floor.look.json"))
        before = self.save_picture("floor_001.png")
        look = self.play_and_pause()
        # The camera goes from 8 m to 6 m in a second.
        self.assertAlmostEqual(look["camera"]["position"][2], 8 - 2 * look["time"]["seconds"], 5)
        self.assertNotEqual(before, self.save_picture("floor_002.png"))
        self.close()
        self.expect_same_picture("floor.look.json", "floor_002.png")


    def test_play_what_pointers_change(self):
        """Lamp, camera and material go on together, and the moment is drawn alike everywhere."""
        self.write_scene("floor.gltf", make_dialed_floor())
        self.open("floor.gltf")
        before = self.save_picture("floor_001.png")
        look = self.play_and_pause()
        angle = 0.9 + (0.625 - 0.9) * look["time"]["seconds"]
        self.assertAlmostEqual(look["camera"]["vertical_fov_degrees"], math.degrees(angle), 4)
        self.assertNotEqual(before, self.save_picture("floor_002.png"))
        self.close()
        self.expect_same_picture("floor.look.json", "floor_002.png")


class LiveReload(WindowTest):
    def test_scene_light_map_and_look(self):
        self.write("gobo.png", make_png(8, 8, (255, 255, 255)))
        self.write("floor.look.json", json.dumps({
            "ribalta_look": 1,
            "lamps": [{"name": "lamp", "light_map": {"file": "gobo.png"}}]}).encode())
        self.open("floor.gltf", "--look", "floor.look.json")
        white = self.save_picture("floor_001.png")

        self.write("gobo.png", make_png(8, 8, (255, 0, 0)))
        self.expect("reloaded gobo.png")
        red = self.save_picture("floor_002.png")
        self.assertNotEqual(white, red)

        scene = make_floor()
        scene["extensions"]["KHR_lights_punctual"]["lights"][0]["spot"]["outerConeAngle"] = 0.1
        self.write_scene("floor.gltf", scene)
        self.expect("reloaded floor.gltf")
        narrow = self.save_picture("floor_003.png")
        self.assertNotEqual(red, narrow)

        # What is broken is told, and the picture stays.
        self.write("floor.gltf", b"{ broken")
        self.expect("the scene stays as it was")
        self.write("floor.look.json", b'{"ribalta_look": 1, "haze": {"scattering": "much"}}')
        self.expect("/haze/scattering")
        self.expect("the look stays as it was")
        self.assertEqual(narrow, self.save_picture("floor_004.png"))

        self.write("floor.look.json", b'{"ribalta_look": 1, "haze": {"scattering": 0}}')
        self.expect("loaded floor.look.json")
        self.assertNotEqual(narrow, self.save_picture("floor_005.png"))
        (self.folder / "floor.gltf").unlink()
        self.expect("is gone")
        self.close()

    def test_many_reloads_take_no_more_memory(self):
        self.open("floor.gltf")

        def reload(count):
            done = self.said().count("reloaded")
            for i in range(done + 1, done + 1 + count):
                self.press("F5")
                self.expect("reloaded", i)
            status = pathlib.Path(f"/proc/{self.process.pid}/status").read_text(encoding="utf-8")
            return int(re.search(r"VmRSS:\s+(\d+)", status).group(1))

        settled = reload(10)
        # A scene and its pictures take some 20 MB: a leak of one would show.
        self.assertLess(reload(20), settled + 10_000)
        self.assertEqual(self.close()["scenes_loaded"], 31)


class Arrival(WindowTest):
    def test_pictures_come_after_the_geometry(self):
        scene = make_floor()
        scene["images"] = [{"uri": "large.png"}, {"uri": "missing.png"}]
        scene["textures"] = [{"source": 0}, {"source": 1}]
        scene["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
                               "emissiveTexture": {"index": 1}}]
        scene["meshes"][0]["primitives"][0]["material"] = 0
        self.write_scene("floor.gltf", scene)
        # Long in decoding: the geometry is seen before, and what F12 saves is whole all the same.
        self.write("large.png", make_png(9000, 9000))
        self.open("floor.gltf")
        self.save_picture("floor_001.png")
        self.assertIn("1 pictures of the scene are missing", self.said())
        self.save_look("floor.look.json")
        stats = self.close()
        self.assertLess(stats["first_picture_ms"], stats["whole_picture_ms"])
        self.expect_same_picture("floor.look.json", "floor_001.png")


class Measurements(WindowTest):
    def test_beams_and_their_error(self):
        self.open("floor.gltf")
        self.press("b")
        self.expect("sheets: ")
        before = self.save_picture("floor_001.png")
        for keys in ["m", "shift+m"]:
            self.press(keys)
            self.rest(seconds=1)
        # A measurement leaves the picture as it was, and ends where the view changes.
        self.assertEqual(self.save_picture("floor_002.png"), before)
        self.press("shift+m", "minus", "c", "Return")
        self.rest()
        self.assertNotIn("warning", self.said())
        self.close()


class Shaders(WindowTest):
    def test_are_made_anew_when_they_change(self):
        shutil.copytree(SHADERS, self.folder / "shaders")
        curve = self.folder / "shaders/passes/tonemap.frag"
        right = curve.read_text()
        self.open("floor.gltf", "--shaders", "shaders")
        before = self.save_picture("floor_001.png")
        curve.write_text(right.replace("display = vec4(", "display = vec4(0.5) + 0.5 * vec4("))
        self.expect("shaders are made anew")
        brighter = self.save_picture("floor_002.png")
        self.assertNotEqual(before, brighter)
        curve.write_text(right.replace("void main", "void mean"))
        self.expect("(the old shaders stay)")
        curve.write_text(right.replace("display =", "displey ="))
        self.expect("passes/tonemap.frag: line ")
        self.assertEqual(self.save_picture("floor_003.png"), brighter)
        curve.write_text(right)
        self.expect("shaders are made anew", 2)
        self.assertEqual(self.save_picture("floor_004.png"), before)
        self.close()


class Idle(WindowTest):
    def test_draws_nothing_and_takes_no_time(self):
        self.open("floor.gltf")

        self.rest(seconds=0.5)
        # Once more, after what was shown for a while has gone.
        time.sleep(6)
        self.rest(seconds=0.5)
        self.close()


class BadInput(WindowTest):
    def test_what_is_dropped(self):
        self.write("notes.txt", b"no scene")
        self.write("broken.glb", b"glTF")
        self.open(first=None)
        self.drop("notes.txt")
        self.expect("is no scene")
        self.drop("broken.glb")
        self.expect("broken.glb: ")
        self.drop("floor.gltf")
        self.expect("opened floor.gltf")
        self.drop("notes.txt")
        self.expect("choose a lamp first")
        self.close()

    def test_a_window_without_pixels(self):
        self.open("floor.gltf")
        for size in [(1, 1), (3, 700), (WIDTH, HEIGHT)]:
            self.desktop.do("windowsize", "--sync", self.window, *size)
        self.assertEqual(self.save_picture("floor_001.png")[:2], (WIDTH, HEIGHT))
        self.close()

    def test_a_scene_that_is_not_there(self):
        self.open("missing.gltf", first="missing.gltf: ")
        self.drop("floor.gltf")
        self.expect("opened")
        self.close()

    def test_a_look_for_another_scene(self):
        self.write("a.json", b'{"ribalta_look": 1, "lamps": [{"name": "lamp", "on": false}, '
                             b'{"name": "gone", "on": false}]}')
        self.open("floor.gltf", "--look", "a.json")
        self.expect("no lamp 'gone'")
        self.assertFalse(self.save_look("a.json")["lamps"][0]["on"])
        self.close()

    def test_a_look_that_is_none(self):
        """What is no look is told, and never written over."""
        self.write("notes.json", b'{"mine": 1}')
        self.open("floor.gltf")
        self.drop("notes.json")
        self.expect("ribalta_look")
        self.save_look("floor.look.json")
        self.assertEqual((self.folder / "notes.json").read_bytes(), b'{"mine": 1}')
        self.close()

    def test_what_is_not_saved_is_kept(self):
        self.write("floor.look.json", b'{"ribalta_look": 1, "ambient_lux": 3}')
        self.open("floor.gltf")
        self.point(WIDTH / 2, HEIGHT / 2 - HEIGHT / 2 / math.tan(0.9 / 2) * 3 / 8)
        self.desktop.do("click", 1)
        self.rest()
        self.press("o")
        self.close()
        kept = json.loads((self.folder / "floor.look.json~").read_text())
        self.assertFalse(kept["lamps"][0]["on"])
        self.assertIn(b"ambient_lux", (self.folder / "floor.look.json").read_bytes())

    def test_a_scene_that_loses_what_was_chosen(self):
        self.open("floor.gltf")
        self.point(WIDTH / 2, HEIGHT / 2 - HEIGHT / 2 / math.tan(0.9 / 2) * 3 / 8)
        self.desktop.do("click", 1)
        self.rest()
        self.write_scene("floor.gltf", make_floor(camera=False, spot=False))
        self.expect("reloaded floor.gltf")
        self.write("gobo.png", make_png(8, 8))
        self.drop("gobo.png")
        self.expect("choose a lamp first")
        self.press("o", "f", "equal", "Return")
        self.save_picture("floor_001.png")
        self.close()

    def test_a_folder_that_cannot_be_written(self):
        self.open("floor.gltf", "--pictures", "nowhere", "--look", self.write(
            "a.json", b'{"ribalta_look": 1}'))
        self.press("F12")
        self.expect("nowhere")
        self.close()

    def test_ends_in_order_when_asked_to(self):
        self.open("floor.gltf")
        before = self.files()
        self.process.send_signal(signal.SIGTERM)
        self.process.wait(timeout=60)
        self.assertEqual(self.process.returncode, -signal.SIGTERM)
        self.assertEqual(self.files(), before)


class NoDisplay(CommandTest):
    def test_no_display(self):
        self.write_scene("floor.gltf", make_floor())
        for display in ["", ":9999"]:
            self.expect_error(NO_OPENGL, ["no display", "ribalta render"], "view", "floor.gltf",
                              environment={"DISPLAY": display})

    def test_old_opengl(self):
        desktop = Desktop()
        self.addCleanup(desktop.close)
        self.write_scene("floor.gltf", make_floor())
        self.expect_error(NO_OPENGL, ["OpenGL 4.5", "3.1", "ribalta render"], "view", "floor.gltf",
                          environment={"DISPLAY": desktop.display,
                                       "MESA_GL_VERSION_OVERRIDE": "3.1"})


if __name__ == "__main__":
    unittest.main()
