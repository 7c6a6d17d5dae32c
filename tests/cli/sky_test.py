"""Numbers of the sky for listed rays: what is written, and what a bad list is told."""

import csv
import io
import json
import math
import unittest

from command import BAD_INPUT, JOB_FAILED, SCENES, USAGE, CommandTest

HEADER = "alt_km,mu,mu_s,nu\n"
ZENITH = "0,1,0.5,0.5\n"
NEW = [name + color for name in ("T_", "L_", "Lg_") for color in "rgb"]


# Air, ground and sun that make no sense, and what is said of them.
NONSENSE = [
    ("--air-top=-10", ["-10", "above the ground"]),
    ("--air-top=0", ["above the ground"]),
    ("--air-top=1e9", ["6.36e+07 m"]),
    ("--planet-radius=0", ["0", "1000..1e+09 m"]),
    ("--planet-radius=Earth", ["'Earth'", "not a number"]),
    ("--rayleigh-scattering=-1e-6", ["r is -1e-06", "0..1 1/m"]),
    ("--rayleigh-scattering=1e-6,-2e-6,1e-6", ["g is -2e-06"]),
    ("--rayleigh-scattering=1e-6,2e-6", ["'1e-6,2e-6'", "three of them: R,G,B"]),
    ("--rayleigh-height=0", ["0", "1..1e+06 m"]),
    ("--rayleigh-height=8000,1200", ["'8000,1200'"]),
    ("--mie-scattering=-4e-6", ["r is -4e-06"]),
    ("--mie-extinction=-3e-6", ["r is -3e-06"]),
    ("--mie-height=nan", ["'nan'"]),
    ("--mie-g=1", ["is 1", "0.9999"]),
    ("--mie-g=-1.5", ["is -1.5"]),
    ("--ground-albedo=0.1,1.2,0", ["g is 1.2", "0..1"]),
    ("--sun-illuminance=-1", ["r is -1", "lux"]),
]


class Tables(CommandTest):
    def table(self, points, *options):
        """The rows that the program writes for a file of that content."""
        self.write("points.csv", points.encode())
        text = self.expect_done("sky", "--points", "points.csv", "-o", "-", *options).stdout
        return list(csv.DictReader(io.StringIO(text)))

    def test_closed_form_under_the_sun(self):
        # Straight up, where sunlight comes straight down: phase tau exp(-tau).
        [row] = self.table(HEADER + "0,1,1,1\n", "--orders=1", "--rayleigh-only")
        for color, coefficient in zip("rgb", (5.8e-6, 13.5e-6, 33.1e-6)):
            tau = coefficient * 8000 * -math.expm1(-7.5)
            expected = 3 / (8 * math.pi) * tau * math.exp(-tau)
            self.assertAlmostEqual(float(row["T_" + color]) / math.exp(-tau), 1, places=9)
            self.assertAlmostEqual(float(row["L_" + color]) / expected, 1, places=9)
            self.assertEqual(row["L_" + color], row["Lg_" + color])

    def test_appends_to_the_columns_there_are(self):
        points = "\ufeffname,nu,T_r,mu,alt_km,mu_s\r\n\"a, b\",-1,7,-1,10,1\r\n\r\n c ,0.5,,1,0,.5\r\n"
        self.write("points.csv", points.encode())
        self.expect_done("sky", "--points", "points.csv", "-o", "out.csv", "--orders", 1)
        with open(self.folder / "out.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(rows[0]), ["name", "nu", "mu", "alt_km", "mu_s", *NEW])
        self.assertEqual([row["name"] for row in rows], ["a, b", " c "])
        self.assertEqual(rows[0]["alt_km"], "10")
        # It looks down: the ground is lit.
        self.assertGreater(float(rows[0]["Lg_r"]), 2 * float(rows[0]["L_r"]))
        self.assertEqual(self.files(), ["out.csv", "points.csv"])

    def test_rays_that_end(self):
        points = "alt_km,mu,mu_s,nu,d_km\n0,1,.5,.5,0\n0,1,.5,.5,1\n0,1,.5,.5,\n0,1,.5,.5,inf\n"
        nothing, near, *endless = self.table(points, "--orders=1")
        self.assertEqual(float(nothing["T_b"]), 1)
        self.assertEqual(float(nothing["L_b"]), 0)
        self.assertLess(float(near["L_b"]), float(endless[0]["L_b"]))
        self.assertEqual(endless[0], {**endless[1], "d_km": ""})

    def test_more_orders_are_more_light(self):
        lights = [float(self.table(HEADER + ZENITH, f"--orders={n}")[0]["L_b"]) for n in (1, 2, 3)]
        self.assertEqual(lights, sorted(set(lights)))
        self.assertLess(lights[2], 2 * lights[0])

    def test_models_of_the_literature(self):
        small = "--table-size=16x32x32x4"
        [reference] = self.table(HEADER + ZENITH, "--orders=2")
        [once] = self.table(HEADER + ZENITH, "--orders=1")
        [clean] = self.table(HEADER + ZENITH, "--orders=1", "--rayleigh-only")
        for right, off, options in [
            (reference, 0.06, ["--model=bruneton", "--orders=2", small]),
            (reference, 0.06, ["--model=bruneton", "--orders=2", small, "--precision=single",
                               "--irradiance-size=32x8", "--transmittance-size=128x32"]),
            (once, 0.02, ["--model=single", small]),
            (once, 0.08, ["--model=single", "--texels=2008", "--table-size=16x64x64x1"]),
            (clean, 0.04, ["--model=single", small, "--rayleigh-only"]),
            (clean, 0.05, ["--model=chapman"]),
            (clean, 0.002, ["--model=chapman", "--chapman=better", "--segments=100"]),
        ]:
            [row] = self.table(HEADER + ZENITH, *options)
            for name in NEW:
                self.assertAlmostEqual(float(row[name]) / float(right[name]), 1, delta=off,
                                       msg=f"{options} {name}")

    def test_the_closed_form_with_other_air(self):
        # As under the sun above, with each number of the air another one.
        air = {"r": 2e-6, "g": 4e-6, "b": 9e-6}
        [row] = self.table(HEADER + "0,1,1,1\n", "--orders=1", "--rayleigh-only",
                           "--rayleigh-scattering=2e-6,4e-6,9e-6", "--rayleigh-height=20e3",
                           "--planet-radius=3e6", "--air-top=100e3")
        for color, coefficient in air.items():
            tau = coefficient * 20e3 * -math.expm1(-5)
            self.assertAlmostEqual(float(row["T_" + color]) / math.exp(-tau), 1, places=9)
            expected = 3 / (8 * math.pi) * tau * math.exp(-tau)
            self.assertAlmostEqual(float(row["L_" + color]) / expected, 1, places=9)
        # Haze alone, which absorbs a quarter of what it takes; its phase function straight on.
        [row] = self.table(HEADER + "0,1,1,1\n", "--orders=1", "--rayleigh-scattering=0",
                           "--mie-scattering=3e-5", "--mie-extinction=4e-5", "--mie-height=3000",
                           "--mie-g=-0.5")
        tau = 4e-5 * 3000 * -math.expm1(-20)
        phase = 3 / (8 * math.pi) * 0.75 * 2 / (2.25 * 2.25**1.5)
        self.assertAlmostEqual(float(row["T_g"]) / math.exp(-tau), 1, places=9)
        self.assertAlmostEqual(float(row["L_g"]) / (phase * 0.75 * tau * math.exp(-tau)), 1,
                               places=8)

    def test_the_ground_reflects_what_it_is_said_to(self):
        down = HEADER + "0,-1,1,-1\n"
        for albedo, colors in [("0.3", (0.3, 0.3, 0.3)), ("0,0.5,1", (0, 0.5, 1))]:
            [row] = self.table(down, "--orders=1", "--rayleigh-scattering=0", "--mie-scattering=0",
                               f"--ground-albedo={albedo}")
            for color, part in zip("rgb", colors):
                self.assertAlmostEqual(float(row["Lg_" + color]), part / math.pi, places=9)

    def test_haze_absorbs_its_share(self):
        up = HEADER + "0,1,1,1\n"
        [double] = self.table(up, "--orders=1", "--mie-scattering=8e-6")
        [same] = self.table(up, "--orders=1", "--mie-scattering=8e-6", "--mie-extinction=8.88e-6")
        for name in NEW:
            self.assertAlmostEqual(float(double[name]) / float(same[name]), 1, places=12)
        [earth] = self.table(up, "--orders=1")
        [given] = self.table(up, "--orders=1", "--mie-scattering=4e-6", "--mie-g=0.8",
                             "--rayleigh-scattering=5.8e-6,13.5e-6,33.1e-6", "--air-top=60000")
        self.assertEqual(given, earth)

    def test_models_take_the_same_air(self):
        small = "--table-size=16x32x32x4"
        air = ["--rayleigh-height=12e3", "--rayleigh-scattering=1e-5", "--planet-radius=2e6"]
        haze = ["--mie-scattering=1e-5", "--mie-height=2000", "--ground-albedo=0.4"]
        [once] = self.table(HEADER + ZENITH, "--orders=1", *air, *haze)
        [clean] = self.table(HEADER + ZENITH, "--orders=1", *air, "--rayleigh-only")
        for right, off, options in [
            (once, 0.001, ["--model=auto", "--orders=1", *haze]),
            (once, 0.03, ["--model=bruneton", "--orders=1", small, *haze]),
            (once, 0.03, ["--model=single", small, *haze]),
            (clean, 0.01, ["--model=chapman", "--chapman=better"]),
        ]:
            [row] = self.table(HEADER + ZENITH, *options, *air)
            for name in NEW:
                self.assertAlmostEqual(float(row[name]) / float(right[name]), 1, delta=off,
                                       msg=f"{options} {name}")

    def test_says_what_tables_took(self):
        self.write("points.csv", (HEADER + ZENITH).encode())
        told = self.expect_done("sky", "--points", "points.csv", "-o", "-", "--model=single",
                                "--table-size=8x16x16x4", "--verbose").stderr
        # Two of 8 x 16 x 64 texels and one of 256 x 64, of 8 and 16 bytes.
        self.assertIn("384 KB kept", told)
        self.assertIn("dispatches", told)

    def test_the_renderers_own_model_is_close_to_the_reference(self):
        [auto] = self.table(HEADER + ZENITH, "--model=auto", "--orders=2")
        [reference] = self.table(HEADER + ZENITH, "--orders=2")
        for name in NEW:
            self.assertAlmostEqual(float(auto[name]) / float(reference[name]), 1, delta=5e-3)
            self.assertNotEqual(auto[name], reference[name])


class Pictures(CommandTest):
    def render(self, *options):
        return self.expect_done("render", SCENES / "one_lamp.glb", "--size=64x48", "--verbose",
                                *options).stderr

    def test_only_where_it_is_asked_for(self):
        self.assertNotIn("sky", self.render())
        told = self.render("--sky=auto", "--sun=20,90", "--sky-orders=1")
        self.assertIn("sky_tables sky_view", told)
        self.assertIn("no shafts", told)
        self.assertNotIn("shafts", self.render("--sky=auto", "--sun=20,90", "--sky-orders=1",
                                               "--haze=0"))
        self.assertIn("sun_shadow[", told)
        self.assertNotIn("sun_shadow[", self.render("--sky=auto", "--sun=-5,90", "--sky-orders=1"))

    def test_counts_the_suns_shadow_maps(self):
        def counters(*options):
            self.render("--sky-orders=1", "--stats=stats.json", *options)
            counted = json.loads((self.folder / "stats.json").read_text())["counters"]
            return [counted["sun_" + name] for name in
                    ("shadow_maps_drawn", "shadow_maps_kept", "casters_drawn", "casters_culled")]

        drawn, kept, casters, _ = counters("--sky=auto", "--sun=20,90", "--repeat=3")
        self.assertGreater(drawn, 0)
        self.assertEqual(kept, 2 * drawn)
        self.assertGreaterEqual(casters, drawn)
        self.assertEqual(counters("--sky=auto", "--sun=20,90", "--repeat=3", "--redraw")[:2],
                         [3 * drawn, 0])
        self.assertEqual(counters("--sky=auto", "--sun=-5,90"), [0, 0, 0, 0])

    def test_says_where_the_sun_stands_by_default(self):
        self.assertIn("30,135", self.render("--sky=auto", "--sky-orders=1"))

    def test_the_files_directional_lamp_is_the_sun(self):
        # Turned by 30 degrees about x from shining along -z, then by 90 about y: from the west.
        half, other = math.sin(math.radians(-15)), math.cos(math.radians(-15))
        turn = math.sqrt(0.5)
        lamp = {"type": "directional", "name": "key", "intensity": 7}
        rotation = [turn * half, -turn * other, turn * half, turn * other]
        self.write("sun.gltf", json.dumps({
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "extensionsUsed": ["KHR_lights_punctual"],
            "extensions": {"KHR_lights_punctual": {"lights": [lamp]}},
            "nodes": [{"rotation": rotation,
                       "extensions": {"KHR_lights_punctual": {"light": 0}}}],
        }).encode())
        command = ["render", "sun.gltf", "--size=32x24", "--sky=auto", "--sky-orders=1"]
        told = self.expect_done(*command, "-o", "lamp.png").stderr
        self.assertIn("directional lamp 'key'", told)
        self.expect_done(*command, "-o", "told.png", "--sun=30,270")
        self.expect_done(*command, "-o", "else.png", "--sun=30,90")
        pictures = [(self.folder / name).read_bytes() for name in
                    ("lamp.png", "told.png", "else.png")]
        self.assertEqual(pictures[0], pictures[1])
        self.assertNotEqual(pictures[0], pictures[2])

    def test_sun_by_time_and_place(self):
        # The example of NREL's SPA, whose elevation before refraction is 39.872 degrees.
        place = ["--latitude=39.742476", "--longitude=-105.1786", "--sky-orders=1", "--sky=auto"]
        for time in ["2003-10-17T12:30:30-07:00", "2003-10-17T19:30:30Z",
                     "2003-10-17T19:30:30.0Z", "2003-10-18T01:00:30+0530"]:
            self.assertIn("at 39.87,194.3", self.render("--sun-time", time, *place))
        time = "--sun-time=2026-06-21T12:00Z"
        for words, options in [
            (["--sun-time", "'noon'", "2026-06-21T19:30Z"], ["--sun-time=noon", *place]),
            (["'2026-06-21T12:00'", "time zone"], ["--sun-time=2026-06-21T12:00", *place]),
            (["calendar"], ["--sun-time=2026-02-29T12:00Z", *place]),
            (["calendar"], ["--sun-time=2026-06-21T24:00Z", *place]),
            (["1900..2100"], ["--sun-time=1788-06-21T12:00Z", *place]),
            (["T19:30Z"], ["--sun-time=2026-06-21T12:00Zulu", *place]),
            (["T19:30Z"], ["--sun-time=2026-06-21T12:00:5Z", *place]),
            (["--latitude DEGREES"], [time, "--longitude=8", "--sky=auto"]),
            (["--longitude DEGREES"], [time, "--latitude=8", "--sky=auto"]),
            (["--latitude", "'91'", "-90..90"], [time, "--latitude=91", "--longitude=0",
                                                 "--sky=auto"]),
            (["--longitude", "'west'"], [time, "--latitude=1", "--longitude=west", "--sky=auto"]),
            (["--latitude", "--sun-time TIME"], ["--latitude=1", "--sky=auto"]),
            (["--sun", "--sun-time", "one of them"], [time, "--sun=20,90", *place]),
            (["--sun-time", "--sky auto"], [time, "--latitude=1", "--longitude=0"]),
        ]:
            self.expect_error(USAGE, words, "render", SCENES / "one_lamp.glb", "-o", "out.png",
                              *options)

    def test_models_of_the_literature(self):
        small = "--table-size=8x16x16x4"
        for told, options in [
            ("forward sky_tables sky ", ["--sky=bruneton", "--sky-orders=2", small]),
            ("forward sky_tables sky ", ["--sky=single", "--rayleigh-only", small]),
            ("forward sky ", ["--sky=chapman", "--chapman=better", "--segments=16"]),
        ]:
            self.assertIn(told, self.render("--sun=20,90", *options))

    def test_options(self):
        for words, options in [
            (["'blue'", "none, auto, bruneton, single, chapman"], ["--sky=blue"]),
            (["--table-size", "'8x8'", "four sizes"], ["--sky=bruneton", "--table-size=8x8"]),
            (["--table-size", "--sky chapman"], ["--sky=chapman", "--table-size=8x8x8x1"]),
            (["--chapman", "--sky auto"], ["--sky=auto", "--chapman=better"]),
            (["--sky-orders", "--sky single", "once"], ["--sky=single", "--sky-orders=2"]),
            (["--segments", "--sky none"], ["--segments=3"]),
            (["--rayleigh-only", "--sky auto"], ["--rayleigh-only"]),
            (["--sun", "'91,0'", "-90..90"], ["--sky=auto", "--sun=91,0"]),
            (["--sun", "'20'", "ELEVATION,AZIMUTH"], ["--sky=auto", "--sun=20"]),
            (["--sun", "'high,0'"], ["--sky=auto", "--sun=high,0"]),
            (["--altitude", "'-1'", "metres"], ["--sky=auto", "--altitude=-1"]),
            (["--sky-orders", "'0'", "1..20"], ["--sky=auto", "--sky-orders=0"]),
            (["--sun", "--sky auto"], ["--sun=20,0"]),
            (["--altitude", "--sky auto"], ["--altitude=100"]),
            (["--air-top", "--sky auto"], ["--air-top=50000"]),
            (["--mie-g", "--rayleigh-only"], ["--sky=auto", "--rayleigh-only", "--mie-g=0.5"]),
            (["--mie-g", "chapman"], ["--sky=chapman", "--mie-g=0.5"]),
            (["--mie-scattering", "4e-06", "3e-06", "absorption"],
             ["--sky=auto", "--mie-extinction=3e-6"]),
            *(([option.split("=")[0], *told], ["--sky=auto", option])
              for option, told in NONSENSE),
        ]:
            self.expect_error(USAGE, words, "render", SCENES / "one_lamp.glb", "-o", "out.png",
                              *options)
        self.assertEqual(self.files(), [])


class WrongUsage(CommandTest):
    def refuse(self, code, words, points, *options):
        self.write("points.csv", points.encode())
        self.expect_error(code, words, "sky", "--points", "points.csv", "-o", "out.csv", *options)
        self.assertEqual(self.files(), ["points.csv"])

    def test_options(self):
        good = HEADER + ZENITH
        self.refuse(USAGE, ["'fast'", "reference"], good, "--model=fast")
        for orders in ["0", "21", "many", "1.5"]:
            self.refuse(USAGE, [f"'{orders}'", "1..20"], good, f"--orders={orders}")
        for options, words in [
            (["--model=bruneton", "--table-size=32x128x32"], ["'32x128x32'", "four sizes"]),
            (["--model=bruneton", "--table-size=32x127x32x8"], ["'32x127x32x8'", "even"]),
            (["--model=single", "--table-size=1x8x8x1"], ["'1x8x8x1'", "at least 2"]),
            (["--model=single", "--table-size=8x8x4096x2"], ["at most 4096"]),
            (["--model=single", "--table-size=ax8x8x1"], ["'ax8x8x1'"]),
            (["--model=bruneton", "--transmittance-size=256"], ["'256'", "two sizes"]),
            (["--model=bruneton", "--irradiance-size=1x16"], ["'1x16'", "2..4096"]),
            (["--model=bruneton", "--precision=double"], ["--precision", "double"]),
            (["--model=chapman", "--chapman=best"], ["--chapman", "best"]),
            (["--model=chapman", "--segments=0"], ["--segments"]),
            (["--model=chapman", "--orders=2"], ["--orders", "chapman", "once"]),
            (["--model=single", "--orders=4"], ["--orders", "single", "once"]),
            (["--model=chapman", "--table-size=8x8x8x1"], ["--table-size", "chapman"]),
            (["--model=single", "--irradiance-size=8x8"], ["--irradiance-size", "single"]),
            (["--model=bruneton", "--segments=8"], ["--segments", "bruneton"]),
            (["--model=bruneton", "--texels=2008"], ["--texels", "bruneton"]),
            (["--model=single", "--texels=2017"], ["--texels", "single"]),
            (["--model=auto", "--texels=exact"], ["--texels", "auto"]),
            (["--chapman=better"], ["--chapman", "reference"]),
            (["--precision=half"], ["--precision", "reference"]),
            (["--model=chapman", "--mie-height=900"], ["--mie-height", "chapman"]),
            (["--rayleigh-only", "--mie-scattering=0"], ["--mie-scattering", "--rayleigh-only"]),
        ]:
            self.refuse(USAGE, words, good, *options)
        for option, words in NONSENSE:
            self.refuse(USAGE, [option.split("=")[0], *words], good, option)
        self.expect_error(USAGE, ["--points"], "sky", "-o", "out.csv")
        self.expect_error(USAGE, ["--output"], "sky", "--points", "points.csv")
        self.expect_error(JOB_FAILED, ["nowhere", "folder"], "sky", "--points", "points.csv",
                          "-o", "nowhere/out.csv")

    def test_too_little_memory(self):
        # 2 of 4096^3 texels of 8 bytes, and for more orders 2 more while they are made.
        for model, orders, megabytes in [("single", 1, 1048577), ("bruneton", 2, 2097152)]:
            self.refuse(JOB_FAILED, [f"would take {megabytes} MB", "MB are free", "--table-size"],
                        HEADER + ZENITH, f"--model={model}", f"--orders={orders}",
                        "--table-size=4096x4096x1024x4")

    def test_missing_file(self):
        self.expect_error(BAD_INPUT, ["nothing.csv"], "sky", "--points", "nothing.csv", "-o", "-")

    def test_lists(self):
        place = ["points.csv", "line 3"]
        for row, words in [
            ("0,up,1,1", ["column mu", "'up'", "-1..1"]),
            ("0,1.1,1,1", ["column mu", "'1.1'"]),
            ("0,1,nan,1", ["column mu_s", "'nan'"]),
            ("-1,1,1,1", ["column alt_km", "'-1'", "km"]),
            ("0,1,1,0.5", ["column nu", "0.5", "1..1"]),
            ("0,1,1", ["has 3 values", "4 columns"]),
            ("0,1,1,1,1", ["has 5 values"]),
        ]:
            self.refuse(BAD_INPUT, place + words, HEADER + ZENITH + row + "\n")
        self.refuse(BAD_INPUT, ["line 2", "column d_km", "'far'"],
                    "alt_km,mu,mu_s,nu,d_km\n0,1,1,1,far\n")

    def test_headers(self):
        self.refuse(BAD_INPUT, ["line 1", "no column nu", "alt_km,mu,mu_s,nu"], "alt_km,mu,mu_s\n")
        self.refuse(BAD_INPUT, ["line 1", "more than one column mu"], "alt_km,mu,mu,mu_s,nu\n")
        self.refuse(BAD_INPUT, ["no rays"], HEADER)
        self.refuse(BAD_INPUT, ["no rays"], "")


if __name__ == "__main__":
    unittest.main()
