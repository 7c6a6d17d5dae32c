"""The reference as a file, and how far drawn frames are from it."""

import json
import re
import unittest

from command import (BAD_INPUT, JOB_FAILED, USAGE, CommandTest, add_node, make_floor,
                     make_moving_floor)

# No driver is named by this, so that no OpenGL is to be had.
NO_DRIVERS = {"__EGL_VENDOR_LIBRARY_FILENAMES": "/nonexistent"}
SIZE = ["--size", "48x27"]


def make_stage():
    """A floor with a lamp above it and a second floor, smaller, in the lamp's way."""
    scene = make_floor()
    add_node(scene, mesh=0, name="shelf", translation=[0.4, 2.5, 0.1], scale=[0.2, 1, 0.2])
    return scene


class Pictures(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_scene("stage.gltf", make_stage())

    def relative_error(self, a, b, *arguments):
        self.expect_done("compare", a, b, "--json", "difference.json", *arguments)
        numbers = json.loads((self.folder / "difference.json").read_text())
        return numbers["linear"]["relative_rmse"]

    def test_frames_agree_with_it(self):
        self.expect_done("render", "stage.gltf", *SIZE, "-o", "drawn.exr", "--beams", "clipped",
                         "--planes", "512", "--aov", "beams")
        for visibility, bound in [("shadow-map", 0.005), ("geometry", 0.01)]:
            output = self.expect_done("reference", "stage.gltf", *SIZE, "-o", "exact.exr",
                                      "--visibility", visibility).stdout
            reached = re.search(r"largest (\S+), RMS (\S+)", output)
            self.assertLessEqual(float(reached[1]), 1e-5)
            for layer in [[], ["--layer", "beams"]]:
                error = self.relative_error("drawn.exr", "exact.exr", *layer)
                self.assertLess(error, bound, f"{visibility} {layer}")

    def test_needs_no_opengl_for_geometry(self):
        self.expect_done("reference", "stage.gltf", *SIZE, "-o", "a.exr", environment=NO_DRIVERS)
        self.expect_done("reference", "stage.gltf", *SIZE, "-o", "b.exr")
        self.assertEqual(self.relative_error("a.exr", "b.exr"), 0.0)

    def test_says_what_it_is(self):
        self.expect_done("reference", "stage.gltf", *SIZE, "-o", "a.exr", "--aov",
                         "transmittance,depth", "--haze=0.03,0.01", "--phase=hg:0.5")
        content = (self.folder / "a.exr").read_bytes()
        for text in [b"beams.R", b"transmittance.G", b"\0Z\0", b"ribalta/camera", b"ribalta/haze",
                     b"henyey-greenstein", b"48x27", b"ribalta/version"]:
            self.assertIn(text, content)

    def test_at_a_time_it_is_of_the_moved_scene(self):
        self.write_scene("moving.gltf", make_moving_floor())
        self.expect_done("reference", "moving.gltf", *SIZE, "-o", "rest.exr")
        for moment in [["--time", "0.5"], ["--time", "1", "--animation", "rise"]]:
            self.expect_done("reference", "moving.gltf", *SIZE, "-o", "exact.exr", *moment)
            self.expect_done("render", "moving.gltf", *SIZE, "-o", "drawn.exr", "--beams",
                             "clipped", "--planes", "256", *moment)
            self.assertLess(self.relative_error("drawn.exr", "exact.exr"), 0.01)
            self.assertGreater(self.relative_error("rest.exr", "exact.exr"), 0.03)

    def test_clear_air_has_no_beams(self):
        output = self.expect_done("reference", "stage.gltf", *SIZE, "-o", "a.exr", "--haze=0")
        self.assertIn("largest 0,", output.stdout)


class Skies(CommandTest):
    # Across the horizon; the floor is lit by sun and sky, with nothing to cast a shadow.
    CLEAR = [*SIZE, "--haze=0", "--ambient=0"]

    def setUp(self):
        super().setUp()
        self.write_scene("floor.gltf", make_floor())

    def draw(self, command, output, *options):
        return self.expect_done(command, "floor.gltf", *self.CLEAR, "-o", output, "--sky=auto",
                                *options)

    def test_frames_agree_with_it(self):
        for options, bound in [(["--sun=30,40", "--sky-orders=1"], 0.004),
                               (["--sun=3,200", "--sky-orders=2", "--altitude=2000"], 0.01),
                               (["--sun=50,0"], 0.006),
                               (["--sun=10,100", "--sky-orders=1", "--planet-radius=1e6",
                                 "--mie-scattering=2e-5", "--mie-g=0.6", "--ground-albedo=0.5",
                                 "--sun-illuminance=1e5,9e4,8e4"], 0.006)]:
            told = self.draw("reference", "exact.exr", *options).stdout
            self.assertRegex(told, r"error of the sky, relative: largest \S+, RMS \S+")
            self.draw("render", "drawn.exr", *options)
            self.expect_done("compare", "drawn.exr", "exact.exr", f"--max-relative={bound}")

    def test_another_sky_is_refused(self):
        self.draw("reference", "exact.exr", "--sun=30,40", "--sky-orders=1")
        for other in [["--sun=31,40", "--sky-orders=1"], ["--sun=30,40", "--sky-orders=2"],
                      ["--sun=30,40", "--sky-orders=1", "--altitude=5"]]:
            self.draw("render", "drawn.exr", *other)
            self.expect_error(BAD_INPUT, ["drawn.exr", "another sky", "--sun"], "compare",
                              "drawn.exr", "exact.exr")

    def test_other_air_is_refused(self):
        sun = ["--sun=30,40", "--sky-orders=1"]
        self.draw("reference", "exact.exr", *sun, "--mie-g=0.7")
        for other in [[], ["--mie-g=0.7", "--air-top=50000"], ["--rayleigh-only"]]:
            self.draw("render", "drawn.exr", *sun, *other)
            self.expect_error(BAD_INPUT, ["drawn.exr", "other air", "g 0.69999"], "compare",
                              "drawn.exr", "exact.exr")
        self.draw("render", "drawn.exr", *sun, "--mie-g=0.7")
        self.expect_done("compare", "drawn.exr", "exact.exr", "--max-relative=0.006")

    def test_a_camera_below_the_planets_ground_is_told_of(self):
        scene = make_floor()
        for node in scene["nodes"]:
            if "camera" in node:
                node["translation"][1] -= 30
        self.write_scene("sunk.gltf", scene)
        for command, output in [("reference", "a.exr"), ("render", "b.exr")]:
            options = ["sunk.gltf", *self.CLEAR, "--sky=auto", "--sun=30,40", "--sky-orders=1"]
            said = self.expect_done(command, *options, "-o", output).stderr
            self.assertRegex(said, r"warning: .*camera is 2\d(\.\d)? m below .*--altitude")
            said = self.expect_done(command, *options, "-o", output, "--altitude=40").stderr
            self.assertNotIn("below", said)

    def test_what_does_not_go_with_a_sky(self):
        for words, options in [(["--haze", "--haze 0"], ["--haze=0.01"]),
                               (["--visibility", "geometry"],
                                ["--haze=0", "--visibility=shadow-map"]),
                               (["'bruneton'", "none, auto"], ["--sky=bruneton"])]:
            self.expect_error(USAGE, words, "reference", "floor.gltf", "-o", "a.exr",
                              *(["--sky=auto"] if "--sky=bruneton" not in options else []),
                              *options)
        self.expect_error(USAGE, ["--sun", "--sky auto"], "reference", "floor.gltf", "-o", "a.exr",
                          "--sun=3,4")


class WrongUsage(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_scene("stage.gltf", make_stage())

    def refuse(self, words, *arguments, code=USAGE):
        self.expect_error(code, words, "reference", "stage.gltf", *arguments)
        self.assertEqual(self.files(), ["stage.gltf"])

    def test_values_out_of_range(self):
        output = ["-o", "a.exr"]
        for value in ["0", "1", "-1e-5", "nan", "small", "1e-30"]:
            self.refuse([f"'{value}'", "1e-9..0.1"], *output, f"--error={value}")
        self.refuse(["0x5", "1..16384"], *output, "--size=0x5")
        self.refuse(["geometry", "shadow-map"], *output, "--visibility=raster")
        self.refuse(["transmittance", "depth"], *output, "--aov=normal")
        self.refuse(["--ambient", "0..1e9"], *output, "--ambient=-1")
        self.refuse(["--K", "gibbons"], *output, "--K=2", "--phase=rayleigh")

    def test_outputs(self):
        self.refuse(["--output"])
        self.refuse(["a.png", ".exr"], "-o", "a.png")
        self.refuse(["nowhere"], "-o", "nowhere/a.exr", code=JOB_FAILED)


if __name__ == "__main__":
    unittest.main()
