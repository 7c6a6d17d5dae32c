"""What is kept from one run to the next: the same picture with it and without it, whatever befalls it."""

import os
import pathlib
import unittest

from command import SCENES, CommandTest, make_floor

# Mesa keeps its compiled shaders where it always does.
MESA_CACHE = os.environ.get("MESA_SHADER_CACHE_DIR") or str(
    pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache")
    / "mesa_shader_cache"
)


class Caches(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_scene("floor.gltf", make_floor())
        self.caches = self.folder / "caches"

    def draw(self, *options, sky="auto", caches=None):
        """The picture's bytes, and what was said."""
        result = self.expect_done(
            "render", "floor.gltf", f"--sky={sky}", "--size=32x18", "-o", "out.png", "--verbose", *options,
            environment={"XDG_CACHE_HOME": str(caches or self.caches), "MESA_SHADER_CACHE_DIR": MESA_CACHE},
        )
        return (self.folder / "out.png").read_bytes(), result.stderr

    def kept(self):
        return sorted((self.caches / "ribalta").glob("*"))

    def test_second_run_takes_what_the_first_made(self):
        first, said = self.draw()
        self.assertNotIn("kept from before", said)
        [file] = self.kept()
        second, said = self.draw("--sun=20,90")
        self.assertIn("kept from before", said)
        self.assertEqual(self.kept(), [file])
        self.assertNotEqual(first, second)
        third, said = self.draw()
        self.assertIn("kept from before", said)
        self.assertEqual(first, third)

    def test_without_it(self):
        expected, said = self.draw("--no-cache")
        self.assertFalse(self.caches.exists())
        self.assertNotIn("cache", said)
        self.assertEqual(self.draw()[0], expected)
        self.assertEqual(self.draw("--no-cache")[0], expected)

    def test_scenes_without_a_sky_keep_nothing(self):
        self.draw(sky="none")
        self.assertFalse((self.caches / "ribalta").exists())

    def test_damage(self):
        expected, _ = self.draw()
        [file] = self.kept()
        whole = file.read_bytes()
        for damaged in [b"", b"foreign", whole[:-1], whole[:1000] + b"x" + whole[1001:]]:
            file.write_bytes(damaged)
            drawn, said = self.draw()
            self.assertEqual(drawn, expected)
            self.assertIn(file.name, said)
            self.assertIn("made anew", said)
            self.assertEqual(file.read_bytes(), whole)

    def inspect_stage(self, *options):
        """What it prints but for times, and how many meshes it found decoded."""
        text = self.expect_done("inspect", SCENES / "stage.glb", *options,
                                environment={"XDG_CACHE_HOME": str(self.caches)}).stdout
        lines = text.splitlines()
        found = [line for line in lines if line.startswith("cache ")]
        return [line for line in lines if not line.startswith(("load ", "cache "))], found

    def test_meshes_are_decoded_once(self):
        expected, found = self.inspect_stage("--no-cache")
        self.assertEqual(found, [])
        self.assertFalse(self.caches.exists())
        self.assertEqual(self.inspect_stage(), (expected, []))
        [file] = self.kept()
        again, found = self.inspect_stage()
        self.assertEqual(again, expected)
        self.assertRegex(found[0], "182 meshes")
        whole = file.read_bytes()
        file.write_bytes(whole[:-1])
        self.assertEqual(self.inspect_stage(), (expected, []))
        self.assertEqual(len(file.read_bytes()), len(whole))

    def test_its_limit(self):
        self.inspect_stage("--cache-limit", "1M")
        self.assertEqual(self.kept(), [])
        self.inspect_stage("--cache-limit", "1G")
        self.assertEqual(len(self.kept()), 1)
        for words in [["--cache-limit", "much"], ["--cache-limit=1M", "--no-cache"]]:
            self.expect_error(2, ["--cache-limit"], "inspect", SCENES / "stage.glb", *words)

    def test_a_folder_that_cannot_be_written(self):
        expected, _ = self.draw("--no-cache")
        self.write("file", b"")
        drawn, said = self.draw(caches=self.folder / "file")
        self.assertEqual(drawn, expected)
        self.assertIn("cannot be made", said)
        self.assertIn("nothing is kept", said)


if __name__ == "__main__":
    unittest.main()
