"""The reference as a file, and how far drawn frames are from it."""

import json
import re
import unittest

from command import JOB_FAILED, USAGE, CommandTest, add_node, make_floor

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

    def test_clear_air_has_no_beams(self):
        output = self.expect_done("reference", "stage.gltf", *SIZE, "-o", "a.exr", "--haze=0")
        self.assertIn("largest 0,", output.stdout)


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
