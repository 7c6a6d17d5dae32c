"""Runs the program and makes small scenes, for the tests of the command line. Tests nothing itself."""

import base64
import json
import os
import pathlib
import shutil
import struct
import subprocess
import tempfile
import unittest
import zlib

PROGRAM = os.environ["RIBALTA"]
SCENES = pathlib.Path(__file__).resolve().parents[2] / "samples/scenes"
# Far more than any case takes, on a busy machine and without a GPU.
LIMIT_SECONDS = 300

DONE, JOB_FAILED, USAGE, BAD_INPUT, NO_OPENGL = range(5)


class CommandTest(unittest.TestCase):
    """Has a folder of its own, self.folder, in which the program runs."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ribalta_cli_"))
        self.addCleanup(shutil.rmtree, self.folder)

    def run_command(self, *arguments, **options):
        options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
        environment = {**os.environ, **options.pop("environment", {})}
        return subprocess.run(
            [PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            text=True,
            errors="replace",
            env=environment,
            timeout=LIMIT_SECONDS,
            check=False,
            **options,
        )

    def expect_done(self, *arguments, **options):
        """Returns the finished process."""
        result = self.run_command(*arguments, **options)
        self.assertEqual(result.returncode, DONE, f"{arguments}: {result.stderr}")
        return result

    def expect_error(self, exit_code, words, *arguments, **options):
        """The last line, and no other, is an error that holds all the words. Returns stderr."""
        result = self.run_command(*arguments, **options)
        self.assertEqual(result.returncode, exit_code, f"{arguments}: {result.stderr}")
        lines = result.stderr.splitlines()
        errors = [line for line in lines if "error:" in line]
        self.assertEqual(len(errors), 1, result.stderr)
        self.assertEqual(errors[0], lines[-1])
        self.assertTrue(errors[0].startswith("ribalta: error: "), errors[0])
        for word in words:
            self.assertIn(word, errors[0])
        return result.stderr

    def write(self, name, content):
        (self.folder / name).write_bytes(content)
        return name

    def write_scene(self, name, scene):
        return self.write(name, json.dumps(scene).encode())

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())


def data_uri(content):
    return "data:application/octet-stream;base64," + base64.b64encode(content).decode()


def make_floor(camera=True, spot=True, scale=1.0):
    """A glTF of a floor of 4 x 4 m, lit from 5 m above, seen from the side; all of it `scale` times
    as large."""
    corners = [(-2, 0, -2), (-2, 0, 2), (2, 0, 2), (2, 0, -2)]
    positions = b"".join(struct.pack("<3f", *(scale * c for c in corner)) for corner in corners)
    texcoords = struct.pack("<8f", 0, 0, 0, 1, 1, 1, 1, 0)
    indices = struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    content = positions + texcoords + indices
    scene = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "floor"}],
        "meshes": [
            {
                "name": "floor",
                "primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2}],
            }
        ],
        "buffers": [{"uri": data_uri(content), "byteLength": len(content)}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 48},
            {"buffer": 0, "byteOffset": 48, "byteLength": 32},
            {"buffer": 0, "byteOffset": 80, "byteLength": 12},
        ],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": 5126,
                "count": 4,
                "type": "VEC3",
                "min": [-2 * scale, 0, -2 * scale],
                "max": [2 * scale, 0, 2 * scale],
            },
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"},
        ],
    }
    if camera:
        lens = {"yfov": 0.9, "znear": 0.05 * scale, "zfar": 100 * scale}
        scene["cameras"] = [{"type": "perspective", "perspective": lens}]
        add_node(scene, name="side", camera=0, translation=[0, 2 * scale, 8 * scale])
    if spot:
        lamp = {"type": "spot", "intensity": 1000 * scale * scale, "spot": {"outerConeAngle": 0.3}}
        extension = "KHR_lights_punctual"
        scene["extensionsUsed"] = [extension]
        scene["extensions"] = {extension: {"lights": [lamp]}}
        down = [-(0.5**0.5), 0, 0, 0.5**0.5]
        add_node(
            scene,
            name="lamp",
            translation=[0, 5 * scale, 0],
            rotation=down,
            extensions={extension: {"light": 0}},
        )
    return scene


def add_node(scene, **node):
    scene["scenes"][0]["nodes"].append(len(scene["nodes"]))
    scene["nodes"].append(node)


def add_accessor(scene, width, numbers):
    """Of floats, `width` an element; returns its index."""
    content = struct.pack(f"<{len(numbers)}f", *numbers)
    scene["buffers"].append({"uri": data_uri(content), "byteLength": len(content)})
    scene["bufferViews"].append({"buffer": len(scene["buffers"]) - 1, "byteLength": len(content)})
    scene["accessors"].append({"bufferView": len(scene["bufferViews"]) - 1,
                               "type": {1: "SCALAR", 3: "VEC3", 4: "VEC4"}[width],
                               "componentType": 5126, "count": len(numbers) // width})
    return len(scene["accessors"]) - 1


def make_moving_floor():
    """In 1 s the lamp swings to the side and back, the floor rises and the camera comes nearer."""
    scene = make_floor()

    def animation(name, node, times, places):
        index = next(i for i, each in enumerate(scene["nodes"]) if each["name"] == node)
        sampler = {"input": add_accessor(scene, 1, times),
                   "output": add_accessor(scene, 3, places)}
        target = {"node": index, "path": "translation"}
        return {"name": name, "samplers": [sampler],
                "channels": [{"sampler": 0, "target": target}]}

    scene["animations"] = [
        animation("swing", "lamp", [0, 0.5, 1], [0, 5, 0, 1.5, 5, 0, 0, 5, 0]),
        animation("rise", "floor", [0, 1], [0, 0, 0, 0, 0.5, 0]),
        animation("dolly", "side", [0, 1], [0, 2, 8, 0.5, 2, 6]),
    ]
    return scene


def add_pointers(scene, channels):
    """An animation of 1 s more, of KHR_animation_pointer: {pointer: (first, last)}."""
    extension = "KHR_animation_pointer"
    animation = {"name": "pointers", "samplers": [], "channels": []}
    times = add_accessor(scene, 1, [0, 1])
    for pointer, (first, last) in channels.items():
        output = add_accessor(scene, len(first), [*first, *last])
        animation["samplers"].append({"input": times, "output": output})
        animation["channels"].append({
            "sampler": len(animation["samplers"]) - 1,
            "target": {"path": "pointer", "extensions": {extension: {"pointer": pointer}}}})
    scene.setdefault("animations", []).append(animation)
    scene["extensionsUsed"].append(extension)
    # A file that insists on it is drawn, too.
    scene["extensionsRequired"] = [extension]
    return scene


LIGHT = "/extensions/KHR_lights_punctual/lights/0"
# The last ones are what single precision holds exactly.
DIALS = {
    LIGHT + "/intensity": ([1000], [100]), LIGHT + "/color": ([1, 1, 1], [1, 0.25, 0.125]),
    LIGHT + "/spot/outerConeAngle": ([0.3], [0.15625]),
    "/cameras/0/perspective/yfov": ([0.9], [0.625]),
    "/materials/0/pbrMetallicRoughness/baseColorFactor": ([1, 1, 1, 1], [0.25, 0.75, 0.25, 1])}


def make_dialed_floor(channels=None):
    scene = make_floor()
    scene["materials"] = [{"pbrMetallicRoughness": {"metallicFactor": 0}}]
    scene["meshes"][0]["primitives"][0]["material"] = 0
    return add_pointers(scene, channels or DIALS)


def add_texture(scene, uri):
    """Paints the floor with a picture that glows by itself."""
    scene["images"] = [{"uri": uri}]
    scene["textures"] = [{"source": 0}]
    scene["materials"] = [{"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0}}]
    scene["meshes"][0]["primitives"][0]["material"] = 0
    return scene


def make_png(width, height, color=(200, 100, 50)):
    """An RGB picture of one colour, made a row at a time."""

    def chunk(kind, content):
        return (
            struct.pack(">I", len(content))
            + kind
            + content
            + struct.pack(">I", zlib.crc32(kind + content))
        )

    packer = zlib.compressobj(1)
    row = b"\0" + bytes(color) * width
    pixels = b"".join(packer.compress(row) for _ in range(height)) + packer.flush()
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", pixels) + chunk(b"IEND", b"")
    )


def read_png(path):
    """(width, height, rows) of an 8-bit RGB picture, a row being bytes R, G, B, R, ..."""
    content = pathlib.Path(path).read_bytes()
    assert content.startswith(b"\x89PNG\r\n\x1a\n"), f"{path} is no PNG"
    at, packed, width, height = 8, b"", 0, 0
    while at < len(content):
        length, kind = struct.unpack(">I4s", content[at : at + 8])
        body = content[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color, *_ = struct.unpack(">IIBBBBB", body)
            assert (depth, color) == (8, 2), f"{path} is not 8-bit RGB"
        elif kind == b"IDAT":
            packed += body
        at += length + 12
    return width, height, unfilter(zlib.decompress(packed), 3 * width)


def unfilter(content, stride):
    """The rows of a PNG with 3 bytes a pixel (PNG specification, section 9)."""
    rows = []
    above = bytearray(stride)
    for start in range(0, len(content), stride + 1):
        kind = content[start]
        row = bytearray(content[start + 1 : start + 1 + stride])
        for i in range(stride):
            a = row[i - 3] if i >= 3 else 0
            b = above[i]
            c = above[i - 3] if i >= 3 else 0
            p = a + b - c
            paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            row[i] = (row[i] + (0, a, b, (a + b) // 2, paeth)[kind]) % 256
        rows.append(bytes(row))
        above = row
    return rows
