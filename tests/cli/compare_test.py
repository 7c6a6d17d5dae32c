"""How far two pictures are apart: the numbers, the difference picture, what is refused."""

import json
import struct
import unittest

from command import (BAD_INPUT, JOB_FAILED, USAGE, CommandTest, make_floor, make_png, read_png)


def make_exr(width, height, value):
    """An uncompressed OpenEXR of B, G, R as 32-bit floats; value(x, y) is one for all three."""

    def attribute(name, kind, content):
        return name + b"\0" + kind + b"\0" + struct.pack("<I", len(content)) + content

    channels = b"".join(c + b"\0" + struct.pack("<iB3xii", 2, 0, 1, 1) for c in [b"B", b"G", b"R"])
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    header = (
        struct.pack("<II", 20000630, 2)
        + attribute(b"channels", b"chlist", channels + b"\0")
        + attribute(b"compression", b"compression", b"\0")
        + attribute(b"dataWindow", b"box2i", window)
        + attribute(b"displayWindow", b"box2i", window)
        + attribute(b"lineOrder", b"lineOrder", b"\0")
        + attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1))
        + attribute(b"screenWindowCenter", b"v2f", struct.pack("<2f", 0, 0))
        + attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1))
        + b"\0"
    )
    line = 8 + 12 * width
    table = b"".join(struct.pack("<Q", len(header) + 8 * height + y * line) for y in range(height))
    rows = b""
    for y in range(height):
        row = struct.pack(f"<{width}f", *(value(x, y) for x in range(width)))
        rows += struct.pack("<iI", y, 12 * width) + 3 * row
    return header + table + rows


class Numbers(CommandTest):
    def compare(self, *arguments):
        return json.loads(self.expect_done("compare", *arguments, "--json", "-").stdout)

    def test_rendered_pictures(self):
        self.write_scene("floor.gltf", make_floor())
        for name, planes in [("a", 4), ("b", 64)]:
            self.expect_done("render", "floor.gltf", "--size", "64x36", "--planes", planes,
                             "-o", f"{name}.exr", "-o", f"{name}.png", "--aov", "beams")
        found = self.compare("a.exr", "b.exr")
        self.assertGreater(found["linear"]["relative_rmse"], 0)
        self.assertGreater(found["display"]["rmse_percent"], 0)
        self.assertGreater(found["display"]["psnr_db"], 10)
        self.assertEqual((found["width"], found["height"]), (64, 36))
        beams = self.compare("a.exr", "b.exr", "--layer", "beams")
        # The same difference against less light.
        self.assertGreater(beams["linear"]["relative_rmse"], found["linear"]["relative_rmse"])
        for name in ["a.exr", "a.png"]:
            same = self.compare(name, name)
            self.assertEqual(same["display"]["rmse_percent"], 0)
            self.assertEqual(same["display"]["flip_mean"], 0)
            self.assertIsNone(same["display"]["psnr_db"])  # infinite
        self.assertIsNone(self.compare("a.png", "b.png")["linear"])

    def test_exposure(self):
        self.write("a.exr", make_exr(4, 3, lambda x, y: 9.0 + x))
        self.write("b.exr", make_exr(4, 3, lambda x, y: 10.0 + x))
        errors = [self.compare("a.exr", "b.exr", f"--exposure={ev}")["display"]["rmse_percent"]
                  for ev in [4, 8, 16]]
        self.assertGreater(errors[0], errors[1])
        self.assertGreater(errors[1], errors[2])

    def test_report_and_difference_picture(self):
        self.write("a.png", make_png(6, 4, (100, 50, 50)))
        self.write("b.png", make_png(6, 4, (90, 50, 50)))
        result = self.expect_done("compare", "a.png", "b.png", "-o", "d.png", "--json", "d.json",
                                  "--scale", "10")
        for words in ["tone-mapped RMSE", "PSNR", "FLIP", "at 0,0 R"]:
            self.assertIn(words, result.stdout)
        self.assertIn("white 10 %", result.stderr)
        width, height, rows = read_png(self.folder / "d.png")
        self.assertEqual((width, height), (6, 4))
        self.assertEqual(len(set(rows)), 1)
        self.assertGreater(max(rows[0]), 0)
        found = json.loads((self.folder / "d.json").read_text())
        self.assertAlmostEqual(found["display"]["rmse_percent"], 100 * 10 / 255 / 3**0.5, places=4)


class Refused(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("a.png", make_png(6, 4))
        self.write("b.png", make_png(4, 6))
        self.write("a.exr", make_exr(6, 4, lambda x, y: 1.0))
        self.write("nan.exr", make_exr(6, 4, lambda x, y: float("nan") if x == 3 else 1.0))

    def refused(self, exit_code, words, *arguments):
        self.expect_error(exit_code, words, "compare", *arguments)

    def test_what_cannot_be_compared(self):
        self.refused(BAD_INPUT, ["a.png", "6x4", "4x6", "--size"], "a.png", "b.png")
        self.refused(BAD_INPUT, ["none.png"], "none.png", "b.png")
        self.refused(BAD_INPUT, ["a.exr", "no layer 'beams'"], "a.exr", "a.exr", "--layer=beams")
        self.refused(BAD_INPUT, ["luminance", "display values"], "a.exr", "a.png")
        self.refused(BAD_INPUT, ["nan.exr", "4 of 24 pixels", "3,0"], "nan.exr", "a.exr")
        self.refused(BAD_INPUT, ["nan.exr", "4 of 24 pixels", "3,0"], "a.exr", "nan.exr")

    def test_wrong_usage(self):
        self.refused(USAGE, ["--exposure", "have been exposed"], "a.png", "a.png", "--exposure=3")
        self.refused(USAGE, ["--exposure", "-60..60"], "a.exr", "a.exr", "--exposure=99")
        self.refused(USAGE, ["--scale"], "a.png", "a.png", "--scale=0")
        self.refused(USAGE, ["d.exr", ".png"], "a.png", "a.png", "-o", "d.exr")
        self.refused(USAGE, ["--max-display"], "a.png", "a.png", "--max-relative=1")
        self.refused(JOB_FAILED, ["no/d.png"], "a.png", "a.png", "-o", "no/d.png")

    def test_outputs_replace_no_input(self):
        before = (self.folder / "a.png").read_bytes()
        (self.folder / "link.png").symlink_to("a.png")
        for output in ["a.png", "./a.png", "link.png"]:
            self.refused(USAGE, [output, "replaced"], "a.png", "a.png", "-o", output)
        self.refused(USAGE, ["a.exr", "replaced"], "a.exr", "a.exr", "--json", "a.exr")
        self.assertEqual((self.folder / "a.png").read_bytes(), before)

    def test_limits(self):
        self.write("c.png", make_png(6, 4, (210, 100, 50)))
        self.refused(JOB_FAILED, ["more than is allowed", "RMSE", "PSNR"], "a.png", "c.png",
                     "--max-display=1", "--min-psnr=60", "--max-flip=1")
        self.expect_done("compare", "a.png", "c.png", "--max-display=5", "--min-psnr=20")
        self.expect_done("compare", "a.png", "a.png", "--max-display=0", "--min-psnr=1000")


if __name__ == "__main__":
    unittest.main()
