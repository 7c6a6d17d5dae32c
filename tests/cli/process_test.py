"""The command as a process: its streams, the libraries it opens, OpenGL that is not there."""

import json
import os
import pty
import subprocess
import unittest

from command import (JOB_FAILED, LIMIT_SECONDS, NO_OPENGL, PROGRAM, SCENES, CommandTest, make_floor,
                     read_png)


class Libraries(CommandTest):
    """What the dynamic linker was asked for."""

    def libraries_of(self, *arguments, **environment):
        result = self.run_command(*arguments, environment={
            "LD_DEBUG": "files", "LD_DEBUG_OUTPUT": str(self.folder / "ld"), **environment})
        logs = [path for path in self.folder.iterdir() if path.name.startswith("ld.")]
        self.assertEqual(len(logs), 1)
        text = logs[0].read_text(errors="replace")
        logs[0].unlink()
        self.assertIn("libstdc++", text)
        return result, text

    def test_help_needs_next_to_nothing(self):
        _, text = self.libraries_of("--help")
        for name in ["OpenImageIO", "ribalta_image_io", "libEGL", "libOpenGL", "LLVM"]:
            self.assertNotIn(name, text)
        # GLFW brings those of X11; JSON, PNGs and JPEGs four small ones.
        self.assertLess(text.count("calling init"), 27)

    def test_inspecting_a_scene_without_images_opens_no_image_library(self):
        self.write_scene("floor.gltf", make_floor())
        _, text = self.libraries_of("inspect", "floor.gltf")
        for name in ["OpenImageIO", "ribalta_image_io", "libEGL"]:
            self.assertNotIn(name, text)

    def test_inspecting_a_scene_with_pngs_opens_no_image_library(self):
        _, text = self.libraries_of("inspect", "--no-cache", SCENES / "stage.glb")
        self.assertIn("libdeflate", text)
        for name in ["OpenImageIO", "ribalta_image_io", "libEGL"]:
            self.assertNotIn(name, text)

    def test_drawing_a_png_opens_no_image_library(self):
        self.write_scene("floor.gltf", make_floor())
        _, text = self.libraries_of("render", "floor.gltf", "--size", "8x8", "-o", "a.png")
        self.assertNotIn("OpenImageIO", text)
        self.assertIn("libEGL", text)

    def test_image_library_is_opened_only_when_an_exr_is_written(self):
        self.write_scene("floor.gltf", make_floor())
        # Ends where drawing would begin.
        result, text = self.libraries_of("render", "floor.gltf", "-o", "a.exr",
                                         __EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent")
        self.assertEqual(result.returncode, NO_OPENGL)
        self.assertNotIn("OpenImageIO", text)
        _, text = self.libraries_of("render", "floor.gltf", "--size", "8x8", "-o", "a.exr")
        self.assertIn("OpenImageIO", text)


class NoOpenGl(CommandTest):
    def expect_none(self, **environment):
        self.write_scene("floor.gltf", make_floor())
        self.write("a.png", b"kept")
        self.expect_error(NO_OPENGL, ["no usable OpenGL", "install"], "render", "floor.gltf", "-o",
                          "a.png", environment=environment)
        self.assertEqual((self.folder / "a.png").read_bytes(), b"kept")
        self.assertEqual(len(self.files()), 2 + len(list(self.folder.glob("lib*"))))

    def test_no_vendor(self):
        self.expect_none(__EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent")

    def test_library_cannot_be_opened(self):
        for name in ["libEGL.so.1", "libOpenGL.so.0"]:
            self.write(name, b"not a library")
            self.expect_none(LD_LIBRARY_PATH=str(self.folder))
            (self.folder / name).unlink()


class Streams(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_scene("floor.gltf", make_floor())

    def test_all_streams_closed(self):
        # A file must not be given the number of a stream that errors or data are written to.
        subprocess.run(
            ["sh", "-c", f'exec "{PROGRAM}" render floor.gltf --verbose --size 8x8 -o a.png '
             "--stats a.json <&- >&- 2>&-"], cwd=self.folder, check=True, timeout=LIMIT_SECONDS)
        self.assertEqual(read_png(self.folder / "a.png")[:2], (8, 8))

    def test_stdout_that_cannot_be_written(self):
        for arguments in [["inspect", "floor.gltf"], ["--help"]]:
            with open("/dev/full", "w", encoding="utf-8") as full:
                self.expect_error(JOB_FAILED, ["standard output", "No space"], *arguments,
                                  stdout=full)
        result = subprocess.run(["sh", "-c", f'exec "{PROGRAM}" inspect floor.gltf >&-'],
                                cwd=self.folder, check=False, stderr=subprocess.PIPE,
                                timeout=LIMIT_SECONDS)
        self.assertEqual(result.returncode, JOB_FAILED)

    def test_reader_that_goes_away_is_no_crash(self):
        reader, writer = os.pipe()
        os.close(reader)
        result = self.run_command("inspect", "floor.gltf", stdout=writer)
        os.close(writer)
        self.assertEqual(result.returncode, -13)  # SIGPIPE, as any command in a pipeline
        self.assertEqual(result.stderr, "")

    def test_data_goes_to_stdout_and_nothing_else_does(self):
        self.assertEqual(self.expect_done("inspect", "floor.gltf").stderr, "")
        result = self.expect_done("render", "floor.gltf", "--size", "8x8", "-o", "a.png",
                                  "--verbose")
        self.assertEqual(result.stdout, "")
        self.assertIn("OpenGL: ", result.stderr)


class ProgressLine(CommandTest):
    def run_on_terminal(self, *arguments):
        main, terminal = pty.openpty()
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=terminal)
        os.close(terminal)
        text = b""
        while True:
            try:
                part = os.read(main, 4096)
            except OSError:  # the other end is closed
                break
            if not part:
                break
            text += part
        os.close(main)
        self.assertEqual(process.wait(LIMIT_SECONDS), 0, text)
        return text.decode()

    LONG_MS = 2500

    def long_work(self):
        """A command that takes about LONG_MS to draw, on whatever it is drawn with."""
        frame = ["render", "floor.gltf", "--size", "64x36", "--stats", "a.json"]
        self.write_scene("floor.gltf", make_floor())
        self.expect_done(*frame, "--repeat", "20")
        frame_ms = json.loads((self.folder / "a.json").read_text())["frame_ms"]
        return [*frame, "--repeat", int(self.LONG_MS / frame_ms) + 1]

    def test_shows_and_clears_a_line_over_a_second(self):
        text = self.run_on_terminal(*self.long_work())
        self.assertRegex(text, r"\r\x1b\[Kdrawing  \d+/\d+  \d+ s")
        self.assertTrue(text.endswith("\r\x1b[K"), text[-80:])

    def test_is_not_shown_for_quick_work(self):
        self.write_scene("floor.gltf", make_floor())
        self.assertEqual(self.run_on_terminal("inspect", "floor.gltf"), "")

    def test_is_not_shown_without_a_terminal(self):
        self.assertEqual(self.expect_done(*self.long_work()).stderr, "")


if __name__ == "__main__":
    unittest.main()
