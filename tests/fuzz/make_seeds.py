#!/usr/bin/env python3
"""Makes the seed corpora of the fuzzing targets: small files of every kind that the import reads,
each of its own making or cut from the sample scenes. Usage: make_seeds.py FOLDER"""

import base64
import json
import pathlib
import struct
import sys
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Scene:
    """A glTF with one buffer, put together by hand."""

    def __init__(self):
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
                     "nodes": [{"mesh": 0}]}
        self.bytes = b""

    def view(self, content, **more):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        self.json.setdefault("bufferViews", []).append(
            {"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(content), **more})
        self.bytes += content
        return len(self.json["bufferViews"]) - 1

    def accessor(self, kind, component, numbers, view_more=None, **more):
        code = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}[component]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}[kind]
        content = struct.pack(f"<{len(numbers)}{code}", *numbers)
        self.json.setdefault("accessors", []).append(
            {"bufferView": self.view(content, **(view_more or {})), "componentType": component,
             "type": kind, "count": len(numbers) // width, **more})
        return len(self.json["accessors"]) - 1

    def triangle(self, **primitive):
        attributes = {"POSITION": self.accessor("VEC3", 5126, [0, 0, 0, 1, 0, 0, 0, 1, 0])}
        attributes.update(primitive.pop("attributes", {}))
        self.json["meshes"] = [{"primitives": [{"attributes": attributes, **primitive}]}]
        return self.json["meshes"][0]["primitives"][0]

    def parts(self):
        """The JSON of a GLB, and its binary chunk."""
        document = dict(self.json)
        if self.bytes:
            document["buffers"] = [{"byteLength": len(self.bytes)}]
        return json.dumps(document, separators=(",", ":")).encode(), self.bytes

    def gltf(self):
        document = dict(self.json)
        if self.bytes:
            uri = "data:;base64," + base64.b64encode(self.bytes).decode()
            document["buffers"] = [{"byteLength": len(self.bytes), "uri": uri}]
        return json.dumps(document, separators=(",", ":")).encode()


def png():
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(
            ">I", zlib.crc32(kind + content))

    header = struct.pack(">IIBBBBB", 2, 2, 8, 6, 0, 0, 0)
    rows = zlib.compress(b"".join(b"\0" + b"\xff\x80\x10\xff" * 2 for _ in range(2)))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", rows) +
            chunk(b"IEND", b""))


def scenes():
    made = {}

    made["bare"] = scene = Scene()
    scene.triangle()

    for mode in range(7):
        made[f"mode{mode}"] = scene = Scene()
        scene.triangle(mode=mode, indices=scene.accessor("SCALAR", 5123, [0, 1, 2, 0, 1, 2]))

    made["attributes"] = scene = Scene()
    scene.triangle(attributes={
        "NORMAL": scene.accessor("VEC3", 5120, [0, 0, 127, 0, 0, 127, 0, 0, 127], normalized=True),
        "TANGENT": scene.accessor("VEC4", 5126, [1, 0, 0, 1] * 3),
        "TEXCOORD_0": scene.accessor("VEC2", 5123, [0, 0, 65535, 0, 0, 65535], normalized=True),
        "TEXCOORD_1": scene.accessor("VEC2", 5126, [0, 0, 1, 0, 0, 1]),
        "COLOR_0": scene.accessor("VEC4", 5121, [255] * 12, normalized=True),
        "JOINTS_0": scene.accessor("VEC4", 5121, [0, 1, 0, 0] * 3),
        "WEIGHTS_0": scene.accessor("VEC4", 5126, [0.5, 0.5, 0, 0] * 3)})

    made["sparse"] = scene = Scene()
    scene.triangle()
    scene.json["accessors"][0]["sparse"] = {
        "count": 1, "indices": {"bufferView": scene.view(b"\1\0"), "componentType": 5123},
        "values": {"bufferView": scene.view(struct.pack("<3f", 2, 2, 2))}}

    made["material"] = scene = Scene()
    primitive = scene.triangle(material=0)
    primitive["attributes"]["TEXCOORD_0"] = scene.accessor("VEC2", 5126, [0, 0, 1, 0, 0, 1])
    slot = {"index": 0, "texCoord": 0, "extensions": {
        "KHR_texture_transform": {"offset": [0, 0], "rotation": 1, "scale": [1, 1]}}}
    scene.json.update(
        images=[{"bufferView": scene.view(png()), "mimeType": "image/png"}],
        samplers=[{"magFilter": 9729, "minFilter": 9987, "wrapS": 33071, "wrapT": 33648}],
        textures=[{"source": 0, "sampler": 0}],
        materials=[{"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1],
                                             "baseColorTexture": slot, "metallicFactor": 0.5,
                                             "roughnessFactor": 0.5,
                                             "metallicRoughnessTexture": slot},
                    "normalTexture": {**slot, "scale": 1},
                    "occlusionTexture": {**slot, "strength": 1}, "emissiveTexture": slot,
                    "emissiveFactor": [1, 1, 1], "alphaMode": "MASK", "alphaCutoff": 0.5,
                    "doubleSided": True, "extensions": {
                        "KHR_materials_emissive_strength": {"emissiveStrength": 2},
                        "KHR_materials_unlit": {}}}])

    made["lamps"] = scene = Scene()
    scene.triangle()
    punctual = "KHR_lights_punctual"
    scene.json["extensionsUsed"] = [punctual]
    scene.json["extensions"] = {punctual: {"lights": [
        {"type": "spot", "color": [1, 0.5, 0], "intensity": 100, "range": 5,
         "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.3},
         "extras": {"light_map": "gobo.png", "light_map_rotation": 45, "beam_shape": "pyramid"}},
        {"type": "point"}, {"type": "directional", "intensity": 3}]}}
    scene.json["nodes"] += [{"extensions": {punctual: {"light": i}},
                             "translation": [0, i, 0]} for i in range(3)]
    scene.json["scenes"][0]["nodes"] += [1, 2, 3]

    made["cameras"] = scene = Scene()
    scene.triangle()
    scene.json["cameras"] = [
        {"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1, "zfar": 9,
                                                "aspectRatio": 2}},
        {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0, "zfar": 9}}]
    scene.json["nodes"][0]["children"] = [1, 2]
    scene.json["nodes"] += [{"camera": 0, "rotation": [0, 0, 0, 1], "scale": [1, 2, 3]},
                            {"camera": 1, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0,
                                                     1]}]

    made["animation"] = scene = Scene()
    scene.triangle()
    times = scene.accessor("SCALAR", 5126, [0, 1], min=[0], max=[1])
    turns = scene.accessor("VEC4", 5122, [0, 0, 0, 32767, 0, 0, 32767, 0], normalized=True)
    moves = scene.accessor("VEC3", 5126, [0] * 18)
    scene.json["animations"] = [{
        "name": "turn",
        "samplers": [{"input": times, "output": turns, "interpolation": "LINEAR"},
                     {"input": times, "output": moves, "interpolation": "CUBICSPLINE"}],
        "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}},
                     {"sampler": 1, "target": {"node": 0, "path": "translation"}}]}]

    made["pointers"] = scene = Scene()
    scene.triangle(material=0)
    punctual, image_based = "KHR_lights_punctual", "EXT_lights_image_based"
    scene.json["materials"] = [{"pbrMetallicRoughness": {}}]
    scene.json["cameras"] = [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}]
    scene.json["extensions"] = {
        punctual: {"lights": [{"type": "spot", "spot": {}}]},
        image_based: {"lights": [{"irradianceCoefficients": [[1, 2, 3]] * 9, "intensity": 2,
                                  "rotation": [0, 0, 0, 1], "specularImages": [[0] * 6]}]}}
    scene.json["scenes"][0]["extensions"] = {image_based: {"light": 0}}
    scene.json["nodes"][0].update({"camera": 0, "extensions": {punctual: {"light": 0}}})
    times = scene.accessor("SCALAR", 5126, [0, 1])
    numbers = scene.accessor("SCALAR", 5126, [0.5, 2])
    animation = {"samplers": [], "channels": []}
    for pointer, output in [
            (f"/extensions/{punctual}/lights/0/spot/innerConeAngle", numbers),
            (f"/extensions/{punctual}/lights/0/intensity", numbers),
            ("/cameras/0/perspective/znear", numbers),
            ("/nodes/0/extensions/KHR_node_visibility/visible",
             scene.accessor("SCALAR", 5121, [1, 0])),
            ("/materials/0/pbrMetallicRoughness/baseColorFactor",
             scene.accessor("VEC4", 5126, [0] * 8))]:
        animation["samplers"].append({"input": times, "output": output, "interpolation": "STEP"})
        animation["channels"].append({
            "sampler": len(animation["samplers"]) - 1,
            "target": {"path": "pointer",
                       "extensions": {"KHR_animation_pointer": {"pointer": pointer}}}})
    scene.json["animations"] = [animation]

    made["skin"] = scene = Scene()
    scene.triangle(attributes={
        "JOINTS_0": scene.accessor("VEC4", 5123, [0, 1, 0, 0] * 3),
        "WEIGHTS_0": scene.accessor("VEC4", 5121, [255, 0, 0, 0] * 3, normalized=True)})
    identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    scene.json["skins"] = [{"joints": [1, 2], "skeleton": 1,
                            "inverseBindMatrices": scene.accessor("MAT4", 5126, identity * 2)}]
    scene.json["nodes"] = [{"mesh": 0, "skin": 0, "children": [1]}, {"children": [2]}, {}]

    made["morph"] = scene = Scene()
    scene.triangle(targets=[{"POSITION": scene.accessor("VEC3", 5126, [0, 0, 1] * 3),
                             "NORMAL": scene.accessor("VEC3", 5126, [0, 1, 0] * 3)}])
    scene.json["meshes"][0]["weights"] = [0.5]

    made["ies"] = scene = Scene()
    scene.triangle()
    profile = next(ies_files())[1].encode()
    scene.json["extensionsUsed"] = ["EXT_lights_ies"]
    scene.json["extensions"] = {"EXT_lights_ies": {"lights": [
        {"bufferView": scene.view(profile), "mimeType": "application/x-ies-lm-63"}]}}
    scene.json["nodes"][0]["extensions"] = {
        "EXT_lights_ies": {"light": 0, "multiplier": 2, "color": [1, 0.5, 0]}}

    made["extensions"] = scene = Scene()
    scene.triangle(material=0, extensions={"KHR_materials_variants": {
        "mappings": [{"material": 1, "variants": [0]}]}})
    scene.json["extensionsUsed"] = ["KHR_materials_variants", "EXT_mesh_gpu_instancing",
                                    "KHR_node_visibility"]
    scene.json["extensions"] = {"KHR_materials_variants": {"variants": [{"name": "red"}]}}
    scene.json["materials"] = [
        {"extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 1},
                        "KHR_materials_sheen": {"sheenColorFactor": [1, 0, 0]},
                        "KHR_materials_ior": {"ior": 1.4},
                        "KHR_materials_specular": {"specularFactor": 0.5},
                        "KHR_materials_transmission": {"transmissionFactor": 1},
                        "KHR_materials_anisotropy": {"anisotropyStrength": 0.5}}},
        {"extensions": {"KHR_materials_pbrSpecularGlossiness": {
            "diffuseFactor": [1, 1, 1, 1], "specularFactor": [1, 1, 1], "glossinessFactor": 1}}}]
    scene.json["nodes"][0]["extensions"] = {
        "EXT_mesh_gpu_instancing": {"attributes": {
            "TRANSLATION": scene.accessor("VEC3", 5126, [0, 0, 0, 1, 1, 1]),
            "ROTATION": scene.accessor("VEC4", 5126, [0, 0, 0, 1] * 2),
            "SCALE": scene.accessor("VEC3", 5126, [1, 1, 1] * 2)}},
        "KHR_node_visibility": {"visible": True}}
    return made


def read_glb(path):
    content = path.read_bytes()
    length = struct.unpack_from("<I", content, 12)[0]
    return json.loads(content[20:20 + length]), content[28 + length:]


def draco_streams(count):
    """The sample scenes' smallest, and their primitives."""
    found = []
    for path in sorted((ROOT / "samples/scenes").glob("*.glb")):
        document, binary = read_glb(path)
        for mesh in document["meshes"]:
            for primitive in mesh["primitives"]:
                draco = primitive.get("extensions", {}).get("KHR_draco_mesh_compression")
                if draco:
                    view = document["bufferViews"][draco["bufferView"]]
                    start = view.get("byteOffset", 0)
                    found.append((binary[start:start + view["byteLength"]], draco["attributes"],
                                  primitive, document["accessors"]))
    found.sort(key=lambda each: len(each[0]))
    return found[:count]


def draco_scene(stream, ids, primitive, accessors):
    scene = Scene()
    view = scene.view(stream)
    keys = ("componentType", "type", "count", "normalized")
    scene.json["accessors"] = []

    def copy(index):
        scene.json["accessors"].append({k: accessors[index][k] for k in keys
                                        if k in accessors[index]})
        return len(scene.json["accessors"]) - 1

    draco = "KHR_draco_mesh_compression"
    scene.json["extensionsUsed"] = scene.json["extensionsRequired"] = [draco]
    scene.json["meshes"] = [{"primitives": [{
        "attributes": {name: copy(index) for name, index in primitive["attributes"].items()},
        "indices": copy(primitive["indices"]),
        "extensions": {draco: {"bufferView": view, "attributes": ids}}}]}]
    return scene


def pictures():
    frame = b"\xff\xc2\0\x11\x08\0\2\0\2\3\1\x11\0\2\x11\1\3\x11\1"
    yield "png", png()
    yield "jpeg", (b"\xff\xd8\xff\xe0\0\x04ab" + frame +
                   b"\xff\xda\0\x0c\3\1\0\2\x11\3\x11\0\x3f\0\x12\xff\xd9")
    yield "tiff", b"II*\0\x08\0\0\0\2\0" + struct.pack("<HHIIHHII", 256, 4, 1, 2, 257, 4, 1, 2)
    yield "tiff_big", b"MM\0*\0\0\0\x08\0\2" + struct.pack(">HHIIHHII", 256, 4, 1, 2, 257, 4, 1, 2)
    yield "exr", (b"v/1\1\2\0\0\0dataWindow\0box2i\0\x10\0\0\0" + struct.pack("<4i", 0, 0, 1, 1) +
                  b"displayWindow\0box2i\0\x10\0\0\0" + struct.pack("<4i", 0, 0, 1, 1) + b"\0")
    yield "hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n\2\2\0\2"
    for kind, body in [("VP8 ", b"\0\0\0\x9d\1\x2a\2\0\2\0"), ("VP8L", b"\x2f\1\x40\0\0"),
                       ("VP8X", b"\0\0\0\0\1\0\0\1\0\0")]:
        chunk = kind.encode() + struct.pack("<I", len(body)) + body + b"\0" * 8
        yield "webp_" + kind.strip().lower(), b"RIFF" + struct.pack("<I", len(chunk) + 4) + (
            b"WEBP" + chunk)


def ies_files():
    def text(head, kind, vertical, horizontal):
        values = " ".join(str(10 * (i + 1)) for i in range(len(vertical) * len(horizontal)))
        return (f"{head}\n1 -1 1 {len(vertical)} {len(horizontal)} {kind} 2 0 0 0\n1 1 50\n"
                f"{' '.join(map(str, vertical))}\n{' '.join(map(str, horizontal))}\n{values}\n")

    yield "round", text("IESNA:LM-63-2002\n[TEST] a\nTILT=NONE", 1, [0, 45, 90], [0])
    yield "quarter", text("IESNA91\nTILT=NONE", 1, [0, 90, 180], [0, 45, 90])
    yield "half", text("IES:LM-63-2019\nTILT=NONE", 1, [0, 90], [0, 90, 180])
    yield "half90", text("IESNA:LM-63-1995\nTILT=NONE", 1, [0, 90], [90, 180, 270])
    yield "around", text("IESNA:LM-63-1995\nTILT=NONE", 1, [0, 90], [0, 120, 240])
    yield "type_b", text("IESNA91\nTILT=INCLUDE\n1\n2\n0 90\n1 0.5", 2, [-90, 0, 90], [0, 90])
    yield "type_a", text("old\nTILT=lamp.tlt", 3, [-45, 45], [-90, 0, 90])


def meshopt_streams():
    """By hand, after the extension's appendix A: what a packed view says, then its bytes."""
    def head(mode, filter_, count, stride):
        return bytes([mode + 3 * filter_, (count - 1) % 256, (count - 1) // 256, stride - 1])

    # Four bytes an element: each a group of 16 values that do not change (header 0), then the tail,
    # 32 bytes long, that ends in the first element.
    still = b"\xa0" + b"\0" * 4 + b"\0" * 28 + b"\1\2\3\4"
    for filter_ in (0, 1, 3):
        yield f"attributes{filter_}", head(0, filter_, 16, 4) + still
    yield "quaternions", (head(0, 2, 16, 8) + b"\xa0" + b"\0" * 8 + b"\0" * 24 +
                          b"\1\2\3\4\5\6\7\x08")
    table = bytes([0x00, 0x76, 0x87, 0x56, 0x67, 0x78, 0xA9, 0x86, 0x65, 0x89, 0x68, 0x98, 0x01,
                   0x69, 0, 0])
    yield "triangles", head(1, 0, 6, 2) + b"\xe1\xf0\x10" + table
    yield "indices", head(2, 0, 6, 2) + b"\xd1" + b"\0\4\4\4\4\4" + b"\0" * 4


def looks():
    for path in sorted((ROOT / "samples/looks").glob("*.json")):
        yield path.stem, path.read_bytes()
    yield "empty", b"{}"


def write(folder, name, content):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(content)


def main(folder):
    for name, scene in scenes().items():
        write(folder / "gltf", name, scene.gltf())
        document, binary = scene.parts()
        write(folder / "glb", name, struct.pack("<H", len(document)) + document + binary)
    for i, (stream, ids, primitive, accessors) in enumerate(draco_streams(6)):
        write(folder / "draco", f"stream{i}", stream + bytes([len(ids)]))
        document, binary = draco_scene(stream, ids, primitive, accessors).parts()
        write(folder / "glb", f"draco{i}", struct.pack("<H", len(document)) + document + binary)
    for name, content in pictures():
        write(folder / "picture", name, content)
    for name, content in meshopt_streams():
        write(folder / "meshopt", name, content)
    for name, content in ies_files():
        write(folder / "ies", name, content.encode())
    for name, content in looks():
        write(folder / "look", name, content)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: make_seeds.py FOLDER")
    main(pathlib.Path(sys.argv[1]))
