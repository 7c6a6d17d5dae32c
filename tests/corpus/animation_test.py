"""Where animated nodes and joints are, what shape skinned and morphed meshes have, and what lamps,
cameras and materials are when animated by pointers, computed from the files anew and compared with
the loader's answer.

Every animated, skinned or morphed model of other people's glTF files (RIBALTA_GLTF_ASSETS, or ../shared/assets/gltf
beside the checkout) and of the samples, each animation at ten times. POSE_NODES names the program
that prints the loader's. Nothing here is taken from it: Python reads the JSON, the buffers and the
keys, multiplies the matrices, and moves the vertices."""

import base64
import bisect
import json
import math
import os
import pathlib
import random
import struct
import subprocess
import tempfile
import unittest
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
ASSETS = pathlib.Path(os.environ.get("RIBALTA_GLTF_ASSETS", ROOT / "../shared/assets/gltf"))
TOLERANCE = 1e-4
COMPONENTS = {5120: ("b", 127), 5121: ("B", 255), 5122: ("h", 32767), 5123: ("H", 65535),
              5125: ("I", None), 5126: ("f", None)}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
CORNERS = 40  # looked at of a primitive, as POSE_NODES has it
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
        self.accessors = {}

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
        """The accessor's elements, lists of numbers."""
        accessor = self.json["accessors"][index]
        letter, scale = COMPONENTS[accessor["componentType"]]
        width, count = WIDTHS[accessor["type"]], accessor["count"]
        element = struct.Struct(f"<{width}{letter}")

        def unpack(view, offset, stride, packed, number):
            view = self.json["bufferViews"][view]
            start = view.get("byteOffset", 0) + offset
            stride = view.get("byteStride", packed.size) if stride else packed.size
            data = self.buffer(view["buffer"])
            return [list(packed.unpack_from(data, start + i * stride)) for i in range(number)]

        if "bufferView" in accessor:
            elements = unpack(accessor["bufferView"], accessor.get("byteOffset", 0), True, element,
                              count)
        else:
            elements = [[0] * width for _ in range(count)]
        if "sparse" in accessor:
            sparse = accessor["sparse"]
            where, what = sparse["indices"], sparse["values"]
            indices = unpack(where["bufferView"], where.get("byteOffset", 0), False,
                             struct.Struct("<" + COMPONENTS[where["componentType"]][0]),
                             sparse["count"])
            values = unpack(what["bufferView"], what.get("byteOffset", 0), False, element,
                            sparse["count"])
            for (at,), value in zip(indices, values):
                elements[at] = value
        if scale is not None and accessor.get("normalized"):
            elements = [[max(value / scale, -1.0) for value in each] for each in elements]
        return elements

    def cached(self, index):
        if index not in self.accessors:
            self.accessors[index] = self.read(index)
        return self.accessors[index]

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
    return world


def transform(matrix, point):
    return [sum(matrix[4 * k + row] * point[k] for k in range(3)) + matrix[12 + row]
            for row in range(3)]


def is_skinned(primitive):
    return "JOINTS_0" in primitive["attributes"] and "WEIGHTS_0" in primitive["attributes"]


def joint_matrices(model, skin, world_of):
    joints = skin["joints"]
    if "inverseBindMatrices" in skin:
        binds = model.cached(skin["inverseBindMatrices"])
    else:
        binds = [IDENTITY] * len(joints)
    return [multiply(world_of[joint], bind) for joint, bind in zip(joints, binds)]


def weights_of(model, node, targets, animation, now):
    source = model.json["nodes"][node]
    weights = source.get("weights", model.json["meshes"][source["mesh"]].get("weights"))
    for channel, times, values, way in animation:
        if channel["target"].get("node") == node and channel["target"]["path"] == "weights":
            row = len(values) // len(times) // (3 if way == "CUBICSPLINE" else 1)
            rows = [[each[0] for each in values[i : i + row]]
                    for i in range(0, len(values), row)]
            weights = sample(times, rows, way, "weights", now)
    return weights or [0.0] * targets


def influences_of(model, primitive, vertex):
    pairs = []
    for n in range(16):
        attributes = primitive["attributes"]
        if f"JOINTS_{n}" not in attributes:
            break
        pairs += zip(model.cached(attributes[f"JOINTS_{n}"])[vertex],
                     model.cached(attributes[f"WEIGHTS_{n}"])[vertex])
    total = sum(weight for _, weight in pairs)
    return [(joint, weight / total) for joint, weight in pairs if weight]


def corners_of(model, primitive, weights, joints, world):
    """Some corners in world space; None where Python cannot read the mesh."""
    attributes = primitive["attributes"]
    if "KHR_draco_mesh_compression" in primitive.get("extensions", {}) or \
            primitive.get("mode", 4) != 4:
        return None
    positions = model.cached(attributes["POSITION"])
    if "indices" in primitive:
        indices = [each[0] for each in model.cached(primitive["indices"])]
    else:
        indices = list(range(len(positions)))
    found = [float(len(indices))]
    for vertex in indices[:: (len(indices) + CORNERS - 1) // CORNERS]:
        point = list(positions[vertex])
        for weight, target in zip(weights, primitive.get("targets", [])):
            if weight and "POSITION" in target:
                moved = model.cached(target["POSITION"])[vertex]
                point = [a + weight * b for a, b in zip(point, moved)]
        if joints:
            placed = [0.0, 0.0, 0.0]
            for joint, weight in influences_of(model, primitive, vertex):
                at = transform(joints[joint], point)
                placed = [a + weight * b for a, b in zip(placed, at)]
            found += placed
        else:
            found += transform(world, point)
    return found


def shapes(model, order, animation, now, world):
    """For every deformed node of the scene its weights, joint matrices and corners."""
    world_of = {node: matrix for (node, _), matrix in zip(order, world)}
    result = []
    for node, _ in order:
        source = model.json["nodes"][node]
        if "mesh" not in source:
            continue
        primitives = model.json["meshes"][source["mesh"]]["primitives"]
        targets = max(len(each.get("targets", [])) for each in primitives)
        skinned = "skin" in source and any(map(is_skinned, primitives))
        if not targets and not skinned:
            continue
        weights = weights_of(model, node, targets, animation, now)
        joints = (joint_matrices(model, model.json["skins"][source["skin"]], world_of)
                  if skinned else [])
        result.append((weights, [number for matrix in joints for number in matrix],
                       [corners_of(model, each, weights, joints, world_of[node])
                        for each in primitives]))
    return result


def keys_of(model, animation):
    cache = {}

    def read(index):
        if index not in cache:
            cache[index] = model.read(index)
        return cache[index]

    keys = []
    for channel in animation["channels"]:
        sampler = animation["samplers"][channel["sampler"]]
        if channel["target"]["path"] in ("translation", "rotation", "scale", "weights"):
            keys.append((channel, [t[0] for t in read(sampler["input"])], read(sampler["output"]),
                         sampler.get("interpolation", "LINEAR")))
    return keys


def loaders_answer(path, animation, times):
    result = subprocess.run(
        [os.environ["POSE_NODES"], path, str(animation), *map(repr, times)],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False, timeout=120)
    if result.returncode != 0:
        raise AssertionError(f"{path}: {result.stderr}")
    return [json.loads(line) for line in result.stdout.splitlines()]


LIGHTS = "/extensions/KHR_lights_punctual/lights/"
STRENGTH = "/extensions/KHR_materials_emissive_strength/emissiveStrength"
# Pointer, components (0: on or off), and what the values lie between: always in range, so that
# nothing is mended but what splines overshoot, which the wide ranges of what may be mended allow.
POINTERS = [
    (LIGHTS + "0/intensity", 1, 500, 900), (LIGHTS + "0/color", 3, 0.4, 0.6),
    (LIGHTS + "0/range", 1, 50, 90), (LIGHTS + "0/spot/innerConeAngle", 1, 0.2, 0.3),
    (LIGHTS + "0/spot/outerConeAngle", 1, 0.6, 0.8), (LIGHTS + "1/intensity", 1, 5, 9),
    (LIGHTS + "1/color", 3, 0.4, 0.6), (LIGHTS + "1/range", 1, 50, 90),
    (LIGHTS + "2/intensity", 1, 500, 900), (LIGHTS + "2/color", 3, 0.4, 0.6),
    ("/cameras/0/perspective/yfov", 1, 0.5, 0.8), ("/cameras/0/perspective/aspectRatio", 1, 1, 2),
    ("/cameras/0/perspective/znear", 1, 0.5, 0.8), ("/cameras/0/perspective/zfar", 1, 50, 80),
    ("/cameras/1/orthographic/xmag", 1, 5, 8), ("/cameras/1/orthographic/ymag", 1, 5, 8),
    ("/cameras/1/orthographic/znear", 1, 1, 2), ("/cameras/1/orthographic/zfar", 1, 50, 80),
    ("/materials/0/pbrMetallicRoughness/baseColorFactor", 4, 0.4, 0.6),
    ("/materials/0/emissiveFactor", 3, 0.4, 0.6), ("/materials/0" + STRENGTH, 1, 50, 90),
    ("/nodes/0/translation", 3, -9, 9), ("/nodes/0/rotation", 4, -1, 1),
    ("/nodes/0/scale", 3, 0.5, 2), ("/nodes/1/translation", 3, -9, 9),
    ("/nodes/2/extensions/KHR_node_visibility/visible", 0, 0, 1)]


class PointerScene:
    """Lamps of each kind, one of them on two nodes, cameras of both, a material; all animated."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.data = b""
        self.keys = {}
        punctual, pointer = "KHR_lights_punctual", "KHR_animation_pointer"
        self.json = {
            "asset": {"version": "2.0"}, "scene": 0,
            "extensionsUsed": [punctual, pointer, "KHR_node_visibility",
                               "KHR_materials_emissive_strength"],
            "extensions": {punctual: {"lights": [
                {"type": "spot", "spot": {}}, {"type": "point"}, {"type": "directional"}]}},
            "cameras": [
                {"type": "perspective", "perspective": {"yfov": 1, "aspectRatio": 1, "znear": 1,
                                                        "zfar": 9}},
                {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 1,
                                                          "zfar": 9}}],
            "materials": [{"pbrMetallicRoughness": {},
                           "extensions": {"KHR_materials_emissive_strength": {}}}],
            "accessors": [], "bufferViews": [],
            "animations": [{"samplers": [], "channels": []}]}
        places = self.accessor("VEC3", "f", [[0, 0, 0], [1, 0, 0], [0, 1, 0]])
        self.json["meshes"] = [{"primitives": [{"attributes": {"POSITION": places},
                                                "material": 0}]}]
        lamps = [{"extensions": {punctual: {"light": light}}} for light in (0, 0, 1, 2)]
        self.json["nodes"] = [{"mesh": 0, "children": [1]}, lamps[0], {"children": [4]},
                              *lamps[1:], {"camera": 0}, {"camera": 1}]
        self.json["scenes"] = [{"nodes": [0, 2, 3, 5, 6, 7]}]
        for channel in POINTERS:
            self.animate(pointer, *channel)
        self.json["buffers"] = [{
            "byteLength": len(self.data), "uri": "data:application/octet-stream;base64," +
            base64.b64encode(self.data).decode()}]

    def accessor(self, kind, letter, elements):
        codes = {"f": 5126, "B": 5121}
        content = b"".join(struct.pack(f"<{len(each)}{letter}", *each) for each in elements)
        self.data += b"\0" * (-len(self.data) % 4)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.data),
                                         "byteLength": len(content)})
        self.data += content
        self.json["accessors"].append({"bufferView": len(self.json["bufferViews"]) - 1,
                                       "componentType": codes[letter], "type": kind,
                                       "count": len(elements)})
        return len(self.json["accessors"]) - 1

    def animate(self, extension, pointer, width, low, high):
        number = self.random.uniform
        way = self.random.choice(["STEP", "LINEAR", "CUBICSPLINE"]) if width else "STEP"
        times = [1.5 * i + number(0, 1) for i in range(4)]
        values = []
        for _ in times:
            value = [self.random.randint(0, 1)] if not width else \
                [number(low, high) for _ in range(width)]
            slope = [[0.1 * number(low - high, high - low) for _ in value] for _ in range(2)]
            values += [slope[0], value, slope[1]] if way == "CUBICSPLINE" else [value]
        kind = {0: "SCALAR", 1: "SCALAR", 3: "VEC3", 4: "VEC4"}[width]
        animation = self.json["animations"][0]
        animation["samplers"].append({
            "input": self.accessor("SCALAR", "f", [[time] for time in times]),
            "output": self.accessor(kind, "f" if width else "B", values), "interpolation": way})
        animation["channels"].append({
            "sampler": len(animation["samplers"]) - 1,
            "target": {"path": "pointer", "extensions": {extension: {"pointer": pointer}}}})
        self.keys[pointer] = (times, values, way)

    def at(self, pointer, now):
        times, values, way = self.keys[pointer]
        single = [struct.unpack("<f", struct.pack("<f", time))[0] for time in times]
        path = "rotation" if pointer.endswith("/rotation") else ""
        return sample(single, values, way, path, now)

    def answer(self, now):
        """As POSE_NODES prints it."""
        def light(index, spot=False):
            numbers = self.at(f"{LIGHTS}{index}/color", now)
            numbers = numbers + self.at(f"{LIGHTS}{index}/intensity", now)
            numbers += self.at(f"{LIGHTS}{index}/range", now) if index < 2 else [0.0]
            if spot:
                numbers += self.at(LIGHTS + "0/spot/innerConeAngle", now)
                numbers += self.at(LIGHTS + "0/spot/outerConeAngle", now)
            return numbers

        perspective, box = "/cameras/0/perspective/", "/cameras/1/orthographic/"
        factor = self.at("/materials/0/emissiveFactor", now)
        strength = self.at("/materials/0" + STRENGTH, now)[0]
        first = matrix_of(*(self.at("/nodes/0/" + part, now)
                            for part in ("translation", "rotation", "scale")))
        second = multiply(first, matrix_of(self.at("/nodes/1/translation", now), [0, 0, 0, 1],
                                           [1, 1, 1]))
        shown = float(self.at("/nodes/2/extensions/KHR_node_visibility/visible", now)[0] != 0)
        return {
            "nodes": first + second + 6 * IDENTITY,
            "shown": [1.0, 1.0, shown, shown, 1.0, 1.0, 1.0, 1.0],
            # In the order of the nodes: what hangs on another stands behind it.
            "lamps": light(0, True) + light(1) + light(0, True) + light(2),
            "cameras": [number for path in (
                perspective + "znear", perspective + "zfar", perspective + "yfov",
                perspective + "aspectRatio", box + "znear", box + "zfar", box + "xmag",
                box + "ymag") for number in self.at(path, now)],
            "materials": self.at("/materials/0/pbrMetallicRoughness/baseColorFactor", now) +
            [strength * each for each in factor]}


class AnimatedModels(unittest.TestCase):
    def compare_numbers(self, ours, theirs, what):
        self.assertEqual(len(theirs), len(ours), what)
        scale = max([1.0, *map(abs, ours)])
        worst = max([0.0, *(abs(a - b) for a, b in zip(ours, theirs))])
        self.assertLess(worst, TOLERANCE * scale, what)
        self.compared += len(ours)

    def compare_pose(self, model, order, keys, now, theirs, what):
        world = world_matrices(model, order, keys, now)
        self.compare_numbers([number for matrix in world for number in matrix], theirs["nodes"],
                             f"{what}: nodes")
        ours = shapes(model, order, keys, now, world)
        self.assertEqual(len(ours), len(theirs["deformers"]), what)
        for (weights, joints, corners), other in zip(ours, theirs["deformers"]):
            self.compare_numbers(weights, other["weights"], f"{what}: weights")
            self.compare_numbers(joints, other["joints"], f"{what}: joints")
            self.assertEqual(len(corners), len(other["primitives"]), what)
            for mine, its in zip(corners, other["primitives"]):
                if mine is not None:
                    self.compare_numbers(mine, its, f"{what}: corners")
                    self.corners += len(mine) // 3

    def compare(self, path):
        """Counts in self.compared how many numbers were."""
        model = Model(path)
        order = model.order()
        if any("skin" in node or "mesh" in node for node in model.json.get("nodes", [])):
            rest = loaders_answer(path, "rest", [0])[0]
            self.compare_pose(model, order, [], 0.0, rest, f"{path}: at rest")
        for index, animation in enumerate(model.json.get("animations", [])):
            keys = keys_of(model, animation)
            if not keys:
                continue
            end = max(times[-1] for _, times, _, _ in keys)
            # Off the keys, on the last, before the first and after the end.
            times = [-0.5, end, 1.25 * end] + [end * (i + 0.37) / 7 for i in range(7)]
            answers = loaders_answer(path, index, times)
            self.assertEqual(len(answers), len(times))
            for now, theirs in zip(times, answers):
                self.compare_pose(model, order, keys, now, theirs,
                                  f"{path}: animation {index}, {now} s")

    def setUp(self):
        self.compared = 0
        self.corners = 0

    def test_arena(self):
        """All of its 128 animations together, as one action a lamp is meant."""
        path = ROOT / "samples/scenes/arena.glb"
        model = Model(path)
        order = model.order()
        times = [0.8 * i + 0.05 for i in range(10)]
        everything = []
        for animation in model.json["animations"]:
            everything += keys_of(model, animation)
        for now, theirs in zip(times, loaders_answer(path, -1, times)):
            self.compare_pose(model, order, everything, now, theirs, f"{path}: {now} s")
        self.assertGreater(self.compared, 10000)

    def test_pointers(self):
        for seed in range(8):
            scene = PointerScene(seed)
            with tempfile.TemporaryDirectory() as folder, self.subTest(seed=seed):
                path = pathlib.Path(folder) / "pointers.gltf"
                path.write_text(json.dumps(scene.json))
                times = [-0.5, 9.0] + [0.8 * i + 0.05 for i in range(9)]
                for now, theirs in zip(times, loaders_answer(path, 0, times)):
                    for what, ours in scene.answer(now).items():
                        self.assertEqual(len(ours), len(theirs[what]), what)
                        for i, (mine, its) in enumerate(zip(ours, theirs[what])):
                            self.compare_numbers([mine], [its], f"{path}: {now} s: {what}[{i}]")
        self.assertGreater(self.compared, 10000)

    def test_other_peoples_models(self):
        if not (ASSETS / "manifest.csv").exists():
            self.skipTest(f"no models in {ASSETS}; set RIBALTA_GLTF_ASSETS")
        models = 0
        for path in sorted(ASSETS.glob("**/*.gl[tb]*")):
            if "broken" in path.parts or path.suffix not in (".gltf", ".glb"):
                continue
            text = Model(path).json
            # What the loader refuses, it says so.
            if "EXT_meshopt_compression" in text.get("extensionsRequired", []):
                continue
            targets = any("targets" in primitive for mesh in text.get("meshes", [])
                          for primitive in mesh["primitives"])
            if not (text.get("animations") or text.get("skins") or targets):
                continue
            models += 1
            with self.subTest(model=str(path)):
                self.compare(path)
        print(f"{models} models, {self.compared} numbers, {self.corners} of them corners")
        self.assertGreater(models, 25)
        self.assertGreater(self.corners, 5000)


if __name__ == "__main__":
    unittest.main()
