"""Sweeps: what is measured and written, going on after an end, points that fail, the report in a browser."""

import csv
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import time
import unittest

from command import BAD_INPUT, JOB_FAILED, PROGRAM, USAGE, CommandTest, add_node, make_floor

QUICK = ["--size", "32x18", "--repeat", "2", "--warmup", "1"]


class SweepTest(CommandTest):
    def setUp(self):
        super().setUp()
        scene = make_floor()
        add_node(scene, name="above", camera=0, translation=[0, 3, 7])
        self.write_scene("floor.gltf", scene)

    def sweep(self, *arguments, scene="floor.gltf", **options):
        return self.expect_done("sweep", scene, "-o", "out", *arguments, **options)

    def results(self, folder="out"):
        return json.loads((self.folder / folder / "sweep.json").read_text())

    def records(self, folder="out"):
        return {each["name"]: each for each in self.results(folder)["benchmarks"]}


class Results(SweepTest):
    def test_end_to_end(self):
        result = self.sweep(*QUICK, "--planes", "2:8", "--beams=planes,clipped", "--camera=all",
                            "--reference-visibility=both")
        self.assertIn("12 points: 12 measured", result.stdout)
        self.assertIn("to 0.5 % tone-mapped RMSE", result.stdout)
        context = self.results()["context"]
        for name in ["date", "renderer", "opengl", "cpu", "num_cpus", "version", "command"]:
            self.assertTrue(context[name], name)
        records = self.records()
        self.assertEqual(len(records), 12)
        errors = {}
        for name, record in records.items():
            self.assertEqual((record["status"], record["repetitions"], record["warmups"]),
                             ("measured", 2, 1), name)
            self.assertAlmostEqual(record["fps"], 1000 / record["frame_ms"]["median"], places=6)
            self.assertIn("beams", [each["name"] for each in record["passes"]])
            self.assertGreater(record["samples"], 0)
            self.assertGreater(record["peak_gl_bytes"], 0)
            self.assertEqual([each["against"] for each in record["errors"]],
                             ["shadow-map", "geometry"])
            self.assertLess(record["errors"][0]["reference_relative_rms"], 1e-4)
            errors[name] = record["errors"][0]["display_rmse_percent"]
            for picture in ["picture", "difference", "reference"]:
                self.assertTrue((self.folder / "out" / record[picture]).is_file(), picture)
        # More sheets, less error.
        self.assertLess(errors["floor/side/32x18/clipped/8"], errors["floor/side/32x18/clipped/2"])
        self.assertEqual(len(list((self.folder / "out/references").iterdir())), 4)
        self.compare_csv_with_json()

    def compare_csv_with_json(self):
        records = self.records()
        with open(self.folder / "out/sweep.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["name"] for row in rows], list(records))
        for row in rows:
            record = records[row["name"]]
            beams = next(each for each in record["passes"] if each["name"] == "beams")
            self.assertEqual(float(row["fps"]), record["fps"])
            self.assertEqual(float(row["beams_gpu_ms"]), beams["gpu_ms"]["median"])
            self.assertEqual(float(row["beams_gpu_ms_iqr"]), beams["gpu_ms"]["iqr"])
            self.assertEqual(int(row["planes"]), record["settings"]["planes"])
            for error in record["errors"]:
                self.assertEqual(float(row["flip_mean@" + error["against"]]), error["flip_mean"])

    def test_the_thesis_has_six_configurations(self):
        result = self.sweep("--size=32x24", "--repeat=1", "--warmup=0", "--preset=pessoa2007",
                            "--reference-visibility=none")
        lines = [line for line in result.stdout.splitlines() if re.match(r"A-\d ", line)]
        self.assertEqual(len(lines), 6)
        for line, thesis in zip(lines, [41, 28, 37, 43, 28, 28]):
            self.assertIn(f" {thesis} fps", line)
            self.assertGreaterEqual(line.count("fps"), 3)
        cells = [each["settings"]["cells"] for each in self.records().values()
                 if each["settings"]["beams"] == "planes"]
        self.assertEqual(cells, [[n, n] for n in [20, 30, 30, 20, 10, 30]])

    def test_a_point_over_its_time_is_skipped_or_cut_short(self):
        self.sweep("--size=64x36", "--planes=1,65536", "--beams=planes", "--repeat=3",
                   "--warmup=1", "--reference-visibility=none", "--max-point-seconds=0.01")
        records = self.records()
        skipped = records["floor/side/64x36/planes/65536"]
        self.assertEqual(skipped["status"], "skipped")
        self.assertIn("--max-point-seconds", skipped["message"])
        for record in records.values():
            if record["status"] == "measured" and record["repetitions"] < 3:
                self.assertIn("of 3 repeats", record["message"])


class OfALook(SweepTest):
    LOOK = {"ribalta_look": 1, "size": [48, 27], "exposure": 6, "tone_curve": "agx",
            "beams": {"method": "march", "planes": 3},
            "camera": {"position": [0, 2, 8], "rotation": [0, 0, 0, 1], "vertical_fov_degrees": 50}}

    def write_look(self, **changed):
        self.write("a.json", json.dumps({**self.LOOK, **changed}).encode())

    def test_it_is_what_is_measured(self):
        self.write_look()
        self.sweep("--look=a.json", "--repeat=1", "--warmup=0")
        (name, point), = self.records().items()
        self.assertEqual(name, "floor/look/48x27/march/3")
        self.assertEqual([point["settings"][key] for key in ["ev100", "tone_curve"]], [6, "agx"])
        self.assertEqual(point["ev100"], 6)
        # What it says of lamps is another measurement.
        self.write_look(lamps=[{"name": "spot", "intensity": 1}])
        result = self.sweep("--look=a.json", "--planes=3,4", "--repeat=1", "--warmup=0")
        self.assertIn("2 points: 2 measured (0 of them before)", result.stdout)

    def test_wrong_usage(self):
        self.write_look(sky={"model": "auto"})
        self.expect_error(BAD_INPUT, ["a.json", "/sky"], "sweep", "floor.gltf", "-o", "out", "--look=a.json")
        self.write_look()
        self.expect_error(USAGE, ["--look", "one scene"], "sweep", "floor.gltf", "other.gltf", "-o", "out",
                          "--look=a.json")
        self.expect_error(USAGE, ["--look", "preset"], "sweep", "floor.gltf", "--preset=pessoa2007", "-o",
                          "out", "--look=a.json")


class GoingOn(SweepTest):
    def test_a_second_run_measures_what_is_new(self):
        self.sweep(*QUICK, "--planes=2,4", "--beams=clipped")
        before = self.records()
        result = self.sweep(*QUICK, "--planes=2,4,8", "--beams=clipped")
        self.assertIn("3 points: 3 measured (2 of them before)", result.stdout)
        after = self.records()
        for name, record in before.items():
            self.assertEqual(record, after[name])
        # The reference was not drawn again.
        self.assertEqual(len(list((self.folder / "out/references").iterdir())), 1)
        result = self.sweep(*QUICK, "--planes=2,4,8", "--beams=clipped", "--fresh")
        self.assertIn("3 points: 3 measured (0 of them before)", result.stdout)
        # Another scene of the same name is another scene.
        self.write_scene("floor.gltf", make_floor(scale=2.0))
        result = self.sweep(*QUICK, "--planes=2", "--beams=clipped")
        self.assertIn("1 points: 1 measured (0 of them before)", result.stdout)

    def test_interrupts_keep_what_was_measured(self):
        arguments = ["sweep", "floor.gltf", "-o", "out", "--size=64x36", "--beams=clipped",
                     "--planes=1:200:1", "--repeat=3", "--reference-visibility=none"]
        process = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        end = time.monotonic() + 120
        while process.poll() is None and time.monotonic() < end:
            pictures = self.folder / "out/pictures"
            if pictures.is_dir() and len(list(pictures.iterdir())) >= 2:
                process.send_signal(signal.SIGINT)
                break
            time.sleep(0.01)
        _, stderr = process.communicate(timeout=120)
        self.assertEqual(process.returncode, -signal.SIGINT, stderr)
        self.assertIn("interrupted", stderr)
        done = len(self.records())
        self.assertGreaterEqual(done, 1)
        self.assertLess(done, 200)
        self.assertIn("<table", (self.folder / "out/report.html").read_text())
        self.assertEqual(sorted(path.name for path in (self.folder / "out").iterdir()),
                         ["pictures", "references", "report.html", "sweep.csv", "sweep.json"])
        result = self.expect_done(*arguments[:-3], "--planes=1:4:1", *arguments[-2:])
        self.assertRegex(result.stdout, rf"4 points: 4 measured \({min(done, 4)} of them before\)")

    def test_on_a_terminal_it_says_what_is_left(self):
        main, end = os.openpty()
        process = subprocess.Popen(
            [PROGRAM, "sweep", "floor.gltf", "-o", "out", "--size=64x36", "--beams=clipped",
             "--planes=1:256:1", "--repeat=9", "--reference-visibility=none"],
            cwd=self.folder, stdout=subprocess.DEVNULL, stderr=end)
        os.close(end)
        said = b""
        while b" left" not in said:
            said += os.read(main, 4096)
        process.send_signal(signal.SIGTERM)
        process.wait(timeout=120)
        os.close(main)
        self.assertRegex(said.decode(), r"measuring  \d+/256  \d+ s, about \d+ (s|min) left")

    def test_results_that_are_none_are_not_taken(self):
        (self.folder / "out").mkdir()
        self.write("out/sweep.json", b"{\"context\": 3}")
        self.expect_error(BAD_INPUT, ["sweep.json", "--fresh"], "sweep", "floor.gltf", "-o", "out",
                          *QUICK, "--planes=2")
        self.sweep(*QUICK, "--planes=2", "--fresh", "--beams=clipped")


class Failures(SweepTest):
    def test_a_scene_that_fails_leaves_the_others(self):
        self.write("broken.gltf", b"{")
        self.expect_error(JOB_FAILED, ["partial", "1 of 2 points"], "sweep", "broken.gltf",
                          "floor.gltf", "-o", "out", *QUICK, "--planes=4", "--beams=clipped")
        records = list(self.records().values())
        self.assertEqual([each["status"] for each in records], ["failed", "measured"])
        self.assertIn("broken.gltf", records[0]["message"])
        told = self.expect_error(JOB_FAILED, ["2 of 4 points"], "sweep", "broken.gltf", "floor.gltf",
                                 "-o", "out", *QUICK, "--planes=4,5", "--beams=clipped")
        self.assertEqual(told.count("broken.gltf"), 1, told)
        self.assertIn("failed", (self.folder / "out/report.html").read_text())
        # Alone it is an error like any other.
        self.expect_error(BAD_INPUT, ["broken.gltf"], "sweep", "broken.gltf", "-o", "b", *QUICK)

    def test_records_can_be_told_apart(self):
        (self.folder / "other").mkdir()
        shutil.copy(self.folder / "floor.gltf", self.folder / "other/floor.gltf")
        for second in ["floor.gltf", "other/floor.gltf"]:
            self.expect_error(USAGE, [second, "'floor'", "rename"], "sweep", "floor.gltf", second,
                              "-o", "out", *QUICK)
        # What is asked for twice is measured once, and cameras of one name are two.
        scene = make_floor()
        add_node(scene, name="side", camera=0, translation=[0, 3, 7])
        self.write_scene("floor.gltf", scene)
        self.sweep("--size=16x9,16x9", "--repeat=1", "--warmup=0", "--planes=4,4", "--beams=clipped,clipped",
                   "--camera=side", "--camera=0", "--camera=all")
        self.assertEqual(sorted(self.records()), ["floor/side#0/16x9/clipped/4",
                                                  "floor/side#1/16x9/clipped/4"])

    def test_a_reference_of_another_view_is_refused(self):
        self.sweep(*QUICK, "--planes=2", "--beams=clipped", "--camera=all")
        first, second = (self.folder / "out/references").iterdir()
        shutil.copy(first, second)
        errors = self.expect_error(JOB_FAILED, ["partial"], "sweep", "floor.gltf", "-o", "out",
                                   *QUICK, "--planes=4", "--beams=clipped", "--camera=all")
        self.assertIn("reference of another camera", errors)
        self.assertEqual(sorted(each["status"] for each in self.records().values()),
                         ["failed", "measured", "measured", "measured"])

    def test_no_room_keeps_the_earlier_results(self):
        self.sweep(*QUICK, "--planes=2", "--beams=clipped")
        before = (self.folder / "out/sweep.json").read_bytes()
        self.expect_error(JOB_FAILED, ["cannot be written"], "sweep", "floor.gltf", "-o", "out",
                          *QUICK, "--planes=4", "--beams=clipped",
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (200, 200)))
        self.assertEqual((self.folder / "out/sweep.json").read_bytes(), before)

    def test_wrong_usage(self):
        for words, arguments in [
            (["--planes", "1..65536"], ["--planes=0"]),
            (["--planes", "1..65536"], ["--planes=8:99999"]),
            (["--planes", "256"], ["--planes=1:1000:1"]),
            (["--planes"], ["--planes=64:8"]),
            (["--planes"], ["--planes=8:64:1x"]),
            (["--planes"], ["--planes=8,"]),
            (["--beams", "planes, "], ["--beams=fog"]),
            (["--tolerance", "0..1"], ["--tolerance=2"]),
            (["--size", "16384"], ["--size=16x9,0x5"]),
            (["none of the cameras", "side"], ["--camera=nowhere"]),
            (["no scene has a camera 'nowhere'"], ["--camera=side", "--camera=nowhere"]),
            (["--repeat"], ["--repeat=0"]),
            (["--max-point-seconds"], ["--max-point-seconds=0"]),
            (["--planes"], ["--preset=pessoa2007", "--planes=8"]),
            (["--preset"], ["--preset=pessoa"]),
        ]:
            self.expect_error(USAGE, words, "sweep", "floor.gltf", "-o", "out", *arguments)
        self.expect_error(USAGE, ["--output"], "sweep", "floor.gltf")
        self.assertFalse((self.folder / "out").exists())
        self.write("file", b"")
        self.expect_error(JOB_FAILED, ["file"], "sweep", "floor.gltf", "-o", "file/out", *QUICK)


class Skies(CommandTest):
    VIEWS = ["space-far", "space-near", "entering", "inside", "sunset", "night-limb"]

    def sweep(self, *arguments):
        return self.expect_done("sweep", "--preset=pinheiro2014", "--size=48x27", "--repeat=2",
                                "--warmup=0", "-o", "out", *arguments)

    def records(self):
        text = (self.folder / "out/sweep.json").read_text()
        return {each["name"]: each for each in json.loads(text)["benchmarks"]}

    def test_six_viewpoints_beside_the_thesis(self):
        models = ["auto-once", "single-2008", "chapman", "chapman-better"]
        result = self.sweep("--sky=" + ",".join(models))
        for model, thesis in [("single-2008", r"6240 +14\.08"), ("chapman", r"0 +0\.0014")]:
            self.assertRegex(result.stdout, rf"(?m)^{model} +{thesis}  ")
        self.assertIn("24 pictures, 0 failed", result.stdout)
        records = self.records()
        self.assertEqual(list(records), [f"{view}/{model}/48x27" for model in models
                                         for view in self.VIEWS])
        for name, record in records.items():
            self.assertEqual((record["status"], record["repetitions"]), ("measured", 2), name)
            self.assertGreater(record["sky_gpu_ms"]["median"], 0)
            for picture in ["picture", "difference", "reference"]:
                self.assertTrue((self.folder / "out" / record[picture]).is_file(), picture)
            self.assertLess(record["own"]["reference_relative_rms"], 1e-4)
        inside = [records[f"inside/{model}/48x27"]["own"]["relative_median"] for model in models]
        self.assertLess(inside[0], 1e-3)
        self.assertLess(inside[1], 1e-2)
        self.assertLess(inside[3], 0.2 * inside[2])
        # What a model leaves out is seen in the light of all.
        self.assertGreater(records["inside/auto-once/48x27"]["whole"]["relative_median"], 0.05)
        # Two volumes of 32 x 64 x 256 texels and a plane of 256 x 64, of 8 and 16 bytes.
        tables = records["inside/single-2008/48x27"]["memory_bytes"]
        self.assertAlmostEqual(tables / (2 * 8 * 32 * 64 * 256 + 16 * 256 * 64), 1, delta=1e-3)
        self.assertLess(records["inside/chapman/48x27"]["memory_bytes"], 2048)
        with open(self.folder / "out/sweep.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        for row in rows:
            record = records[row["name"]]
            self.assertEqual(float(row["sky_gpu_ms"]), record["sky_gpu_ms"]["median"])
            self.assertEqual(float(row["relative_p95@own"]), record["own"]["relative_p95"])
            self.assertEqual(float(row["flip_mean@whole"]), record["whole"]["flip_mean"])
        page = (self.folder / "out/report.html").read_text(encoding="utf-8")
        self.assertEqual(page.count("<section>"), 8)
        self.assertEqual(page.count("data:image/png;base64,"), 6 * (1 + 2 * 4))
        self.assertNotIn("http", page.replace("http://www.w3.org", ""))
        # References are kept: once scattered with haze and without, and all orders.
        kept = sorted((self.folder / "out/references").iterdir())
        self.assertEqual(len(kept), 18)
        before = [path.stat().st_mtime_ns for path in kept]
        self.sweep("--sky=chapman")
        self.assertEqual([path.stat().st_mtime_ns for path in kept], before)

    def test_wrong_usage(self):
        for words, arguments in [
            (["--sky", "'blue'", "chapman-better"], ["--preset=pinheiro2014", "--sky=blue"]),
            (["--planes", "pinheiro2014"], ["--preset=pinheiro2014", "--planes=8"]),
            (["--haze", "pinheiro2014"], ["--preset=pinheiro2014", "--haze=0.1"]),
            (["scenes", "pinheiro2014"], ["a.glb", "--preset=pinheiro2014"]),
            (["scenes"], []),
            (["--sky", "--preset pinheiro2014"], ["a.glb", "--sky=auto"]),
        ]:
            self.expect_error(USAGE, words, "sweep", "-o", "out", *arguments)
        self.assertFalse((self.folder / "out").exists())


class Report(SweepTest):
    # Counts what was painted, in a copy of the page.
    COUNT_PIXELS = b"""<script>
        document.querySelectorAll('canvas').forEach((canvas) => {
            const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
            const colors = new Set();
            for (let i = 0; i < pixels.length; i += 4) {
                if (pixels[i + 3] > 250) { colors.add(pixels.slice(i, i + 3).join()); }
            }
            canvas.dataset.colors = colors.size;
        });
        </script>"""

    def browse(self, page):
        """The page as a browser without a network has made it, and what it had to say."""
        browser = shutil.which("chromium") or shutil.which("chromium-browser")
        self.assertIsNotNone(browser, "no chromium; tools/setup.sh --tests installs it")
        result = subprocess.run(
            [browser, "--headless=new", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr",
             f"--user-data-dir={self.folder}/profile", "--proxy-server=127.0.0.1:9",
             "--dump-dom", pathlib.Path(self.folder / page).as_uri()],
            capture_output=True, text=True, errors="replace", timeout=120, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)
        said = [line for line in result.stderr.splitlines() if "CONSOLE" in line]
        return result.stdout, said

    def test_in_a_browser(self):
        self.sweep(*QUICK, "--planes=2:8", "--beams=planes,clipped", "--camera=all")
        page = (self.folder / "out/report.html").read_bytes()
        self.write("out/counted.html", page.replace(b"</body>", self.COUNT_PIXELS + b"</body>"))
        document, said = self.browse("out/counted.html")
        self.assertEqual(said, [])
        # Two views, two charts each; every point in both of them.
        self.assertIn('data-charts="4"', document)
        self.assertIn('data-points="24"', document)
        colors = [int(n) for n in re.findall(r'data-colors="(\d+)"', document)]
        self.assertEqual(len(colors), 4)
        self.assertTrue(all(n >= 4 for n in colors), colors)
        table = document[document.index('<table id="points"'):]
        self.assertEqual(table[:table.index("</table>")].count("<tr"), 1 + 12)
        for record in self.records().values():
            self.assertIn(record["view"], table)
            error = f"{record['errors'][0]['display_rmse_percent']:.3g}"
            self.assertIn(f"<td>{error}</td>", table)
        self.assertGreaterEqual(document.count("data:image/png;base64,"), 2 * 12)
        self.assertNotIn("without-script\"", document)

        # Without scripts, the same table and pictures are there, and a word on the charts.
        plain = re.sub(r"<script.*?</script>", "", page.decode(), flags=re.DOTALL)
        self.assertIn(table[:table.index("</table>")], plain)
        self.assertIn("The charts need JavaScript", plain)
        self.assertEqual(plain.count("data:image/png"), document.count("data:image/png"))


if __name__ == "__main__":
    unittest.main()
