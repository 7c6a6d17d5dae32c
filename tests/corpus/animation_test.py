"""Where animated nodes are, computed from the files anew and compared with the loader's answer.

Every animated model of other people's glTF files (RIBALTA_GLTF_ASSETS, or ../shared/assets/gltf
beside the checkout) and of the samples, each animation at ten times. POSE_NODES names the program
that prints the loader's. Nothing here is taken from it: Python reads the JSON, the buffers and the
keys, and multiplies the matrices."""

import base64
import bisect
import json
import math
import os
import pathlib
import struct
import subprocess
import unittest
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
ASSETS = pathlib.Path(os.environ.get("RIBALTA_GLTF_ASSETS", ROOT / "../shared/assets/gltf"))
TOLERANCE = 1e-4
COMPONENTS = {5120: ("b", 127), 5121: ("B", 255), 5122: ("h", 32767), 5123: ("H", 65535),
              5126: ("f", None)}
WIDTHS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}
IDENTITY = [1.0, 0, 0, 0, 0, 1.0, 0, 0, 0, 0, 1.0, 0, 0, 0, 0, 1.0]


class Model:
    def __init__(self, path):
        self.path = path
        content = path.read_bytes()
        self.bin = b""
        if content[:4] == b"glTF":
            length = struct.unpack("<I", content[12:16])[0]
            self.json = json.loads(content[20 : 20 + length])
            self.bin = content[28 + length :]
        else:
            self.json = json.loads(content)
        self.buffers = {}

    def buffer(self, index):
        if index not in self.buffers:
            uri = self.json["buffers"][index].get("uri")
            if uri is None:
                self.buffers[index] = self.bin
            elif uri.startswith("data:"):
                self.buffers[index] = base64.b64decode(uri.split(",", 1)[1])
            else:
                self.buffers[index] = (self.path.parent / urllib.parse.unquote(uri)).read_bytes()
        return self.buffers[index]

    def read(self, index):
        """The accessor's elements, lists of floats; without sparse parts, which no animation
        here has."""
        accessor = self.json["accessors"][index]
        assert "sparse" not in accessor
        letter, scale = COMPONENTS[accessor["componentType"]]
        width = WIDTHS[accessor["type"]]
        view = self.json["bufferViews"][accessor["bufferView"]]
        element = struct.Struct(f"<{width}{letter}")
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", element.size)
        data = self.buffer(view["buffer"])
        elements = [list(element.unpack_from(data, start + i * stride))
                    for i in range(accessor["count"])]
        if scale is not None:
            elements = [[max(value / scale, -1.0) for value in each] for each in elements]
        return elements

    def order(self):
        """The drawn scene's nodes with their parents, each before what hangs on it."""
        nodes = self.json["nodes"]
        roots = self.json["scenes"][self.json.get("scene", 0)].get("nodes", [])
        placed = []

        def visit(node, parent):
            placed.append((node, parent))
            own = len(placed) - 1
            for child in nodes[node].get("children", []):
                visit(child, own)

        for root in roots:
            visit(root, -1)
        return placed


def unit(q):
    length = math.sqrt(sum(x * x for x in q))
    return [x / length for x in q]


def slerp(a, b, t):
    """As the specification writes it, by the arc cosine."""
    a, b = unit(a), unit(b)
    d = sum(x * y for x, y in zip(a, b))
    angle = math.acos(min(1.0, abs(d)))
    if angle < 1e-5:
        return unit([x + t * (math.copysign(1.0, d) * y - x) for x, y in zip(a, b)])
    u = math.sin(angle * (1 - t)) / math.sin(angle)
    v = math.copysign(1.0, d) * math.sin(angle * t) / math.sin(angle)
    return [u * x + v * y for x, y in zip(a, b)]


def sample(times, values, way, path, now):
    cubic = way == "CUBICSPLINE"
    value = (lambda k: values[3 * k + 1]) if cubic else (lambda k: values[k])
    if now <= times[0] or now >= times[-1]:
        found = value(0 if now <= times[0] else len(times) - 1)
        return unit(found) if path == "rotation" else found
    k = bisect.bisect_right(times, now) - 1
    span = times[k + 1] - times[k]
    t = (now - times[k]) / span
    if way == "STEP":
        found = value(k)
    elif not cubic:
        if path == "rotation":
            return slerp(value(k), value(k + 1), t)
        found = [(1 - t) * a + t * b for a, b in zip(value(k), value(k + 1))]
    else:
        found = [(2 * t**3 - 3 * t**2 + 1) * v0 + span * (t**3 - 2 * t**2 + t) * out
                 + (-2 * t**3 + 3 * t**2) * v1 + span * (t**3 - t**2) * into
                 for v0, out, v1, into in zip(value(k), values[3 * k + 2], value(k + 1),
                                              values[3 * k + 3])]
    return unit(found) if path == "rotation" else found


def matrix_of(translation, rotation, scale):
    x, y, z, w = rotation
    columns = [[1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
               [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
               [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)]]
    matrix = []
    for column, factor in zip(columns, scale):
        matrix += [factor * value for value in column] + [0.0]
    return matrix + list(translation) + [1.0]


def multiply(a, b):
    return [sum(a[4 * k + row] * b[4 * column + k] for k in range(4))
            for column in range(4) for row in range(4)]


def world_matrices(model, order, animation, now):
    moved = {}
    for channel, times, values, way in animation:
        node, path = channel["target"].get("node"), channel["target"]["path"]
        if node is not None and path in ("translation", "rotation", "scale"):
            moved[node, path] = sample(times, values, way, path, now)
    world = []
    for node, parent in order:
        source = model.json["nodes"][node]
        if "matrix" in source:
            local = source["matrix"]
        else:
            local = matrix_of(
                moved.get((node, "translation"), source.get("translation", [0, 0, 0])),
                moved.get((node, "rotation"), unit(source.get("rotation", [0, 0, 0, 1]))),
                moved.get((node, "scale"), source.get("scale", [1, 1, 1])))
        world.append(multiply(world[parent], local) if parent >= 0 else local)
    return [number for matrix in world for number in matrix]


def keys_of(model, animation):
    cache = {}

    def read(index):
        if index not in cache:
            cache[index] = model.read(index)
        return cache[index]

    keys = []
    for channel in animation["channels"]:
        sampler = animation["samplers"][channel["sampler"]]
        if channel["target"]["path"] != "weights":
            keys.append((channel, [t[0] for t in read(sampler["input"])], read(sampler["output"]),
                         sampler.get("interpolation", "LINEAR")))
    return keys


class AnimatedModels(unittest.TestCase):
    def compare(self, path):
        """Returns how many numbers were compared."""
        model = Model(path)
        order = model.order()
        compared = 0
        for index, animation in enumerate(model.json["animations"]):
            keys = keys_of(model, animation)
            if not keys:
                continue
            end = max(times[-1] for _, times, _, _ in keys)
            # Off the keys, on the last, before the first and after the end.
            times = [-0.5, end, 1.25 * end] + [end * (i + 0.37) / 7 for i in range(7)]
            result = subprocess.run(
                [os.environ["POSE_NODES"], path, str(index), *map(repr, times)],
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False, timeout=60)
            self.assertEqual(result.returncode, 0, f"{path}: {result.stderr}")
            lines = result.stdout.splitlines()
            self.assertEqual(len(lines), len(times))
            for now, line in zip(times, lines):
                theirs = [float(number) for number in line.split()]
                ours = world_matrices(model, order, keys, now)
                self.assertEqual(len(theirs), len(ours), path)
                scale = max(1.0, max(map(abs, ours)))
                worst = max(abs(a - b) for a, b in zip(ours, theirs))
                self.assertLess(worst, TOLERANCE * scale, f"{path}: animation {index}, {now} s")
                compared += len(ours)
        return compared

    def test_arena(self):
        """All of its 128 animations together, as one action a lamp is meant."""
        path = ROOT / "samples/scenes/arena.glb"
        model = Model(path)
        order = model.order()
        times = [0.8 * i + 0.05 for i in range(10)]
        everything = []
        for animation in model.json["animations"]:
            everything += keys_of(model, animation)
        result = subprocess.run([os.environ["POSE_NODES"], path, "-1", *map(repr, times)],
                                stdout=subprocess.PIPE, text=True, check=True, timeout=60)
        compared = 0
        for now, line in zip(times, result.stdout.splitlines()):
            theirs = [float(number) for number in line.split()]
            ours = world_matrices(model, order, everything, now)
            self.assertEqual(len(theirs), len(ours))
            self.assertLess(max(abs(a - b) for a, b in zip(ours, theirs)), TOLERANCE)
            compared += len(ours)
        self.assertGreater(compared, 10000)

    def test_other_peoples_models(self):
        if not (ASSETS / "manifest.csv").exists():
            self.skipTest(f"no models in {ASSETS}; set RIBALTA_GLTF_ASSETS")
        models, compared = 0, 0
        for path in sorted(ASSETS.glob("**/*.gl[tb]*")):
            if "broken" in path.parts or path.suffix not in (".gltf", ".glb"):
                continue
            text = Model(path).json
            # What the loader refuses, it says so.
            if not text.get("animations") or "EXT_meshopt_compression" in text.get(
                    "extensionsRequired", []):
                continue
            models += 1
            with self.subTest(model=str(path)):
                compared += self.compare(path)
        print(f"{models} models, {compared} numbers")
        self.assertGreater(models, 20)


if __name__ == "__main__":
    unittest.main()
