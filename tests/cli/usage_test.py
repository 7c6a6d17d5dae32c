"""What a new user types: help, wrong options, wrong files. Each error is one line with its cure."""

import unittest

from command import (BAD_INPUT, JOB_FAILED, SCENES, USAGE, CommandTest, add_texture, make_floor)


class Help(CommandTest):
    def test_names_subcommands_and_exit_codes(self):
        text = self.expect_done("--help").stdout
        for word in ["render", "inspect", "Exit codes", "4 no usable OpenGL"]:
            self.assertIn(word, text)

    def test_render_shows_units_and_defaults(self):
        text = self.expect_done("render", "--help").stdout
        for word in ["(default: 1280x720)", "S[,A]", "1/m", "(default: auto)", "cd/m2",
                     "(default: adaptive)", "in metres", "in lux", "(default: gibbons)",
                     "(default: 24)", "-o,--output"]:
            self.assertIn(word, text)

    def test_view_has_help_of_its_own(self):
        text = self.expect_done("view", "--help").stdout
        for word in ["glTF scene", "--look", "--no-panels", "--pictures"]:
            self.assertIn(word, text)

    def test_inspect_has_help_of_its_own(self):
        self.assertIn("glTF scene", self.expect_done("inspect", "--help").stdout)

    def test_version(self):
        self.assertRegex(self.expect_done("--version").stdout, r"^\d+\.\d+\.\d+\n$")


class WrongUsage(CommandTest):
    def expect_usage(self, words, *arguments):
        self.expect_error(USAGE, [*words, "--help"], *arguments)
        self.assertNotIn("a.png", self.files())

    def expect_option(self, words, *options):
        self.write_scene("floor.gltf", make_floor())
        self.expect_usage(words, "render", "floor.gltf", "-o", "a.png", *options)

    def test_no_subcommand(self):
        self.expect_usage(["render, view, inspect"])

    def test_unknown_subcommand(self):
        self.expect_usage(["'draw'", "render, view, inspect"], "draw")

    def test_unknown_option(self):
        self.expect_option(["--frobnicate", "ribalta render --help"], "--frobnicate")

    def test_no_scene(self):
        self.expect_usage(["scene is required"], "render", "-o", "a.png")

    def test_two_scenes(self):
        self.expect_option(["other.gltf"], "other.gltf")

    def test_nothing_to_write(self):
        self.write_scene("floor.gltf", make_floor())
        self.expect_usage(["nothing to write", "-o FILE.png"], "render", "floor.gltf")

    def test_size(self):
        for text in ["big", "0x0", "10", "10x", "x10", "-5x5", "1.5x2", "16385x1", "10x10x10",
                     "99999999999x1", " 10x10"]:
            self.expect_option(["--size", f"'{text}'", "WIDTHxHEIGHT", "1..16384"], "--size", text)

    def test_goals_of_auto(self):
        for option, text in [("--budget", "4s"), ("--budget", "-1ms"), ("--budget", "soon"),
                             ("--error", "0.5ms"), ("--error", "0%"), ("--error", "nan")]:
            self.expect_option([option, f"'{text}'", "such as"], "--beams", "auto", option, text)
        self.expect_option(["--beams auto"], "--budget", "4ms")
        self.expect_option(["--beams", "--planes"], "--beams", "auto", "--planes", 8)
        self.expect_option(["--tolerance", "adaptive"], "--beams", "clipped", "--tolerance", 0.1)

    def test_haze(self):
        for text in ["thick", "-1", "0.1,", "0.1,x", "nan", "inf", "0.1,-1", "1,2,3", "1e999"]:
            self.expect_option(["--haze", f"'{text}'", "SCATTERING", "1/m"], f"--haze={text}")

    def test_phase(self):
        for text in ["mie", "hg", "hg:1", "hg:x", "gibbons:1", "cornette-shanks:-1", "hg:nan"]:
            self.expect_option(["--phase", f"'{text}'", "hg:G"], "--phase", text)

    def test_numbers(self):
        for option, wrong in [("--planes", ["0", "-1", "x", "1.5", "65537"]),
                              ("--repeat", ["0", "x"]), ("--K", ["0", "-1", "nan", "x"]),
                              ("--dt", ["0", "inf", "x"]), ("--ambient", ["-1", "nan", "x", "1e10"]),
                              ("--exposure", ["bright", "61", "nan"]),
                              ("--cells", ["3", "0x1", "1025x1"])]:
            for text in wrong:
                self.expect_option([option, text], "--beams", "planes", option, text)

    def test_names(self):
        self.expect_option(["--beams", "rays", "clipped", "planes"], "--beams", "rays")
        self.expect_option(["--aov", "'sky'", "beams, transmittance, depth, normal"], "--aov",
                           "sky")

    def test_options_that_do_not_fit_together(self):
        self.expect_option(["--cells", "--beams planes"], "--cells", "2x2")
        self.expect_option(["--dt", "--beams planes"], "--dt", "1")
        self.expect_option(["--K", "gibbons"], "--K", "2", "--phase", "isotropic")
        self.expect_option(["--aov", "-o FILE.exr"], "--aov", "depth")

    def test_limits(self):
        for text in ["8G", "memory", "memory=", "memory=0", "memory=-1", "memory=8T", "disk=1G",
                     "memory=1G,memory=2G", "memory=1G,", "nesting=1001", "memory=99999999999G",
                     "pixels=1.5M"]:
            self.expect_option(["--limits", "nesting=1..1000"], f"--limits={text}")

    def test_option_without_value(self):
        self.expect_option(["--haze="], "--haze=")
        self.write_scene("floor.gltf", make_floor())
        self.expect_usage(["--output"], "render", "floor.gltf", "-o")

    def test_unknown_camera_says_which_there_are(self):
        self.expect_error(USAGE, ["'nope'", "0 front_of_house", "1 side_stage"], "render",
                          SCENES / "stage.glb", "--camera", "nope", "-o", "a.png")
        self.write_scene("floor.gltf", make_floor(camera=False))
        self.expect_error(USAGE, ["'0'", "the file has none"], "render", "floor.gltf", "--camera",
                          "0", "-o", "a.png")


class WrongInput(CommandTest):
    def expect_bad(self, words, path):
        for arguments in [["inspect", path], ["render", path, "-o", "a.png"]]:
            self.expect_error(BAD_INPUT, words, *arguments)
            self.assertNotIn("a.png", self.files())

    def test_missing_file(self):
        self.expect_bad(["missing.glb", "no such file"], "missing.glb")

    def test_no_name(self):
        self.expect_bad(["''", "no such file"], "")

    def test_folder(self):
        self.expect_bad([str(self.folder), "not a regular file"], self.folder)

    def test_no_gltf(self):
        self.expect_bad(["text.gltf", "not a glTF"], self.write("text.gltf", b"hello"))
        self.expect_bad(["empty.glb"], self.write("empty.glb", b""))

    def test_truncated_glb(self):
        whole = (SCENES / "stage.glb").read_bytes()
        for length in [11, 20, 5000, len(whole) - 1]:
            path = self.write("cut.glb", whole[:length])
            self.expect_bad(["cut.glb", "truncated" if length > 11 else ""], path)

    def test_over_the_limits(self):
        path = self.write_scene("floor.gltf", make_floor())
        self.expect_done("inspect", path, "--limits", "memory=1M,vertices=12,nodes=3,pixels=1")
        for limits in ["memory=1K", "vertices=11", "nodes=2", "nesting=5"]:
            self.expect_error(BAD_INPUT, ["floor.gltf", "limit" if "nest" not in limits else
                                          "deeper than 5"], "inspect", path, "--limits", limits)

    def test_place_within_the_file(self):
        scene = make_floor()
        scene["meshes"][0]["primitives"][0]["indices"] = 99
        self.expect_bad(["bad.gltf: /meshes/0/primitives/0/indices", "99"],
                        self.write_scene("bad.gltf", scene))

    def test_unsupported_required_extension(self):
        scene = make_floor()
        scene["extensionsUsed"] = scene["extensionsRequired"] = ["XY_unheard_of"]
        self.expect_bad(["bad.gltf: /extensionsRequired/0", "XY_unheard_of"],
                        self.write_scene("bad.gltf", scene))

    def test_line_breaks_in_names_make_no_second_line(self):
        scene = add_texture(make_floor(), "gone\nribalta: error: forged.png")
        self.write_scene("floor.gltf", scene)
        result = self.expect_done("render", "floor.gltf", "--size", "8x8", "-o", "a.png")
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)


class WrongOutput(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_scene("floor.gltf", make_floor())

    def expect_refused(self, exit_code, words, *outputs):
        # The work must not have been done first: a camera that is not there is found after loading.
        before = self.files()
        self.expect_error(exit_code, words, "render", "floor.gltf", "--camera", "nope", *outputs)
        self.assertEqual(self.files(), before)

    def test_format(self):
        self.expect_refused(USAGE, ["a.jpg", ".png or .exr"], "-o", "a.jpg")
        self.expect_refused(USAGE, ["a.txt", ".json"], "--stats", "a.txt")

    def test_missing_folder(self):
        for output in [["-o", "no/a.png"], ["-o", "a.png", "-o", "no/a.exr"],
                       ["--stats", "no/a.json"]]:
            self.expect_refused(JOB_FAILED, ["no/a.", "make the folder first"], *output)

    def test_folder(self):
        (self.folder / "dir.png").mkdir()
        self.expect_refused(JOB_FAILED, ["dir.png", "folder"], "-o", "dir.png")
        self.expect_refused(USAGE, [str(self.folder), "folder"], "-o", self.folder)

    def test_device(self):
        (self.folder / "null.png").symlink_to("/dev/null")
        self.expect_refused(JOB_FAILED, ["null.png", "not a regular file"], "-o", "null.png")


if __name__ == "__main__":
    unittest.main()
