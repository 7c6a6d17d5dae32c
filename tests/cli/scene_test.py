"""Scenes that are large, odd or incomplete, end to end; and what `inspect` says of a scene."""

import unittest

from command import (BAD_INPUT, DONE, SCENES, USAGE, CommandTest, add_node, add_texture,
                     make_floor, make_png, read_png)


class Scenes(CommandTest):
    def draw(self, scene, *arguments, name="floor.gltf"):
        """Draws the scene to 64x36 pixels; returns the picture's rows and stderr."""
        self.write_scene(name, scene)
        result = self.expect_done("render", name, "--size", "64x36", "-o", "a.png", *arguments)
        return read_png(self.folder / "a.png")[2], result.stderr

    def test_no_camera_makes_one_and_says_so(self):
        rows, text = self.draw(make_floor(camera=False))
        self.assertIn("no camera", text)
        # It frames the scene: the floor is in the middle of the picture.
        self.assertGreater(max(rows[18][3 * 28 : 3 * 36]), 0)

    def test_no_lamps_says_so(self):
        rows, text = self.draw(make_floor(spot=False))
        self.assertIn("no lamps", text)
        self.assertGreater(max(max(row) for row in rows), 0)

    def test_nothing_at_all(self):
        _, text = self.draw({"asset": {"version": "2.0"}})
        self.assertIn("no lamps", text)
        self.assertIn("no camera", text)

    def test_a_normal_scene_says_nothing(self):
        self.assertEqual(self.draw(make_floor())[1], "")

    def test_other_units(self):
        # The same scene ten times smaller and a hundred times larger, haze and lamps alike: one
        # picture, but for rounding, half a code value of dither, shadow edges and the first 5 cm of
        # the beam, which lie within the lamp.
        pictures = {}
        for scale in [1.0, 0.1, 100.0]:
            haze = f"--haze={0.05 / scale}"
            pictures[scale], _ = self.draw(make_floor(scale=scale), haze, "--ambient=0")
        for scale in [0.1, 100.0]:
            far_off = sum(abs(a - b) > 3 for one, other in zip(pictures[1.0], pictures[scale])
                          for a, b in zip(one, other))
            self.assertLess(far_off, 0.01 * 3 * 64 * 36, scale)

    def test_a_scene_of_centimetres_is_drawn(self):
        # All of it within 5 cm of the lamp, so without beams; ambient light is left.
        rows, _ = self.draw(make_floor(scale=0.01))
        self.assertGreater(max(max(row) for row in rows), 0)

    def test_missing_image_is_drawn_visibly_and_reported(self):
        scene = add_texture(make_floor(spot=False), "gone.png")
        rows, text = self.draw(scene, "--ambient=0")
        self.assertIn("/images/0", text)
        self.assertIn("gone.png", text)
        # Magenta somewhere: red and blue without green.
        self.assertTrue(any(row[i] > 60 and row[i + 2] > 60 and row[i + 1] < row[i] // 2
                            for row in rows for i in range(0, len(row), 3)))

    def test_broken_image_is_drawn_and_reported(self):
        self.write("cut.png", make_png(64, 64)[:80])
        _, text = self.draw(add_texture(make_floor(), "cut.png"))
        self.assertIn("/images/0", text)

    def test_image_outside_the_folder_is_not_read(self):
        result = self.run_command("render", self.write_scene("floor.gltf", add_texture(
            make_floor(), "../../etc/passwd.png")), "--size", "8x8", "-o", "a.png")
        self.assertIn("/images/0", result.stderr)

    def test_16000_pixels_wide_texture(self):
        # Its thin side keeps the test quick; the width is what renderers and loaders trip over.
        self.write("wide.png", make_png(16000, 16))
        rows, text = self.draw(add_texture(make_floor(spot=False), "wide.png"), "--ambient=0")
        self.assertEqual(text.count("warning"), 1, text)  # that there are no lamps
        self.assertGreater(max(max(row) for row in rows), 0)

    def test_100000_nodes(self):
        scene = make_floor()
        first = len(scene["nodes"])
        scene["nodes"] += [{"mesh": 0, "translation": [5 * (i % 316), -1, -5 * (i // 316)]}
                           for i in range(100000)]
        scene["scenes"][0]["nodes"] += list(range(first, first + 100000))
        self.draw(scene)

    def test_100000_nodes_deep(self):
        scene = make_floor()
        first = len(scene["nodes"])
        scene["nodes"] += [{"children": [first + i + 1]} for i in range(99999)] + [{"mesh": 0}]
        scene["scenes"][0]["nodes"].append(first)
        result = self.run_command("inspect", self.write_scene("deep.gltf", scene))
        self.assertEqual(result.returncode, DONE, result.stderr)
        self.assertIn("100003", result.stdout)


class Inspect(CommandTest):
    def test_stage(self):
        text = self.expect_done("inspect", SCENES / "stage.glb").stdout
        for word in ["meshes     182", "triangles  233056", "materials  9", "images     4",
                     "'gobo_window.png' 512x512", "spots      12", "cameras    2",
                     "0 'front_of_house' perspective", "KHR_draco_mesh_compression",
                     "report     0"]:
            self.assertIn(word, text)
        self.assertRegex(text, r"'spot_0' 489163 cd.*half angle 9\.0 deg.*light map "
                               r"'gobo_window\.png'\n")

    def test_all_meshes(self):
        some = self.expect_done("inspect", SCENES / "stage.glb", "--no-cache").stdout
        every = self.expect_done("inspect", SCENES / "stage.glb", "--all", "--no-cache").stdout
        self.assertIn("and 172 smaller ones", some)
        self.assertEqual(len(every.splitlines()) - len(some.splitlines()), 171)

    def test_tells_what_is_ignored_with_its_place(self):
        scene = make_floor()
        scene["extensionsUsed"].append("KHR_materials_iridescence")
        scene["materials"] = [{"extensions": {"KHR_materials_iridescence": {"iridescenceFactor": 1}}}]
        scene["meshes"][0]["primitives"][0]["material"] = 0
        text = self.expect_done("inspect", self.write_scene("coat.gltf", scene)).stdout
        self.assertIn("KHR_materials_iridescence (ignored)", text)
        self.assertRegex(text, r"ignored: /materials/0")

    def test_variants(self):
        scene = make_floor()
        scene["extensionsUsed"].append("KHR_materials_variants")
        scene["extensions"]["KHR_materials_variants"] = {"variants": [{"name": "by day"}, {"name": "by night"}]}
        scene["materials"] = [{"name": "light"}, {"name": "dark", "pbrMetallicRoughness": {
            "baseColorFactor": [0, 0, 0, 1], "metallicFactor": 0}}]
        scene["meshes"][0]["primitives"][0].update(material=0, extensions={
            "KHR_materials_variants": {"mappings": [{"variants": [1], "material": 1}]}})
        path = self.write_scene("variants.gltf", scene)
        for chosen, material in [([], "light"), (["--variant", "by day"], "light"),
                                 (["--variant", "by night"], "dark"), (["--variant=1"], "dark")]:
            text = self.expect_done("inspect", path, *chosen).stdout
            self.assertIn(f"'{material}'", text)
        self.expect_error(USAGE, ["by noon", "by day", "by night"], "inspect", path, "--variant=by noon")

    def test_other_units(self):
        path = self.write_scene("centimetres.gltf", make_floor(scale=100.0))
        text = self.expect_done("inspect", path, "--unit-scale=0.01", "--intensity-scale=2").stdout
        self.assertIn("4 x 0 x 4 m", text)
        self.assertIn("'lamp' 20000000 cd", text)
        for wrong in ["--unit-scale=0", "--unit-scale=x", "--intensity-scale=-1"]:
            self.expect_error(USAGE, [wrong.partition("=")[0]], "inspect", path, wrong)

    def test_strict_makes_errors_of_the_report(self):
        scene = make_floor()
        self.expect_done("inspect", self.write_scene("fine.gltf", scene), "--strict")
        scene["extensionsUsed"].append("KHR_unheard_of")
        scene["materials"] = [{"extensions": {"KHR_unheard_of": {}},
                               "pbrMetallicRoughness": {"roughnessFactor": 7}}]
        scene["meshes"][0]["primitives"][0]["material"] = 0
        path = self.write_scene("odd.gltf", scene)
        self.expect_done("inspect", path)
        result = self.run_command("inspect", path, "--strict")
        self.assertEqual(result.returncode, BAD_INPUT, result.stderr)
        *lines, last = result.stderr.splitlines()
        self.assertEqual(len(lines), 2, result.stderr)
        for line in lines:
            self.assertRegex(line, r"^ribalta: error: odd\.gltf: /materials/0")
        self.assertIn("has 2 faults, and --strict allows none", last)
        self.assertIn("report     2", result.stdout)

    def test_a_table_of_many_files(self):
        (self.folder / "below").mkdir()
        fine = self.write_scene("b fine.gltf", make_floor())
        odd = make_floor()
        odd["nodes"][0]["rotation"] = [0, 0, 0, 0]
        self.write_scene("below/a.GLTF", odd)
        self.write("c.glb", b"glTF")
        self.write("notes.txt", b"no scene")
        result = self.expect_done("inspect", "--table", ".")
        rows = [line.split("\t") for line in result.stdout.splitlines()]
        self.assertEqual([row[:2] for row in rows], [
            ["./b fine.gltf", "loaded"], ["./below/a.GLTF", "reported"], ["./c.glb", "refused"]])
        self.assertEqual(rows[0][2], "")
        self.assertRegex(rows[1][2], "^repaired: /nodes/0/rotation: ")
        self.assertRegex(rows[2][2], "^is a GLB cut off")
        self.assertIn("3 files: 1 loaded, 1 with something to report, 1 refused", result.stderr)
        self.expect_error(BAD_INPUT, ["3 files: 1 loaded"], "inspect", "--strict", "--table", ".")
        self.expect_done("inspect", "--strict", "--table", fine)
        (self.folder / "below/empty").mkdir()
        self.expect_error(BAD_INPUT, ["below/empty", "no .gltf"], "inspect", "--table",
                          "below/empty")
        self.expect_error(USAGE, ["scene"], "inspect")
        self.expect_error(USAGE, ["--table"], "inspect", fine, "--table", fine)

    def test_scenes_are_listed_and_chosen(self):
        scene = make_floor()
        scene["scenes"] = [{"name": "day", "nodes": [0, 1]}, {"name": "night", "nodes": [0, 1, 2]}]
        path = self.write_scene("two.gltf", scene)
        text = self.expect_done("inspect", path).stdout
        self.assertIn("scenes     2", text)
        self.assertIn("0 'day', drawn", text)
        text = self.expect_done("inspect", path, "--scene", "night", "--strict").stdout
        self.assertIn("1 'night', drawn", text)
        self.assertIn("spots      1", text)
        for command in [["inspect", path], ["render", path, "-o", "a.png"],
                        ["reference", path, "-o", "a.exr"], ["sweep", path, "-o", "sweep"],
                        ["sweep", path, SCENES / "stage.glb", "-o", "sweep"]]:
            self.expect_error(USAGE, ["two.gltf", "'dusk'", "0 day, 1 night"], *command,
                              "--scene", "dusk")

    def test_names_stay_on_their_lines(self):
        scene = make_floor()
        scene["nodes"][2]["name"] = "a\nb\x1b[2J"
        text = self.expect_done("inspect", self.write_scene("odd.gltf", scene)).stdout
        self.assertNotIn("\x1b", text)
        self.assertIn("a b", text)

    def test_no_lamps_no_camera(self):
        scene = make_floor(camera=False, spot=False)
        text = self.expect_done("inspect", self.write_scene("bare.gltf", scene)).stdout
        self.assertIn("no lamps", text)
        self.assertIn("one that frames the scene will be made", text)


if __name__ == "__main__":
    unittest.main()
